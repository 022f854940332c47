"""One driver for devices without a position, commanded up to a few hundred times a second.

Game pads, wheels and vibrating toys differ in their bytes (`Translator`) and in how they
are reached (`Port`). Pace, refreshing, the thread that writes, and the zero on every way
out are the same for all, and are here.
"""

import atexit
import contextlib
import logging
import math
import threading
from collections.abc import Callable
from typing import Protocol

from hapticplayer.devices.capabilities import FULL_N
from hapticplayer.errors import DeviceError, Message
from hapticplayer.model.device import DeviceCapabilities, DeviceReading, Vector

_MOST_READ = 16
_STOP_S = 0.5
TAKING_S = 0.15
"""A device that has not taken a command for so long is silent. Until then it plays at its
own rate: nothing that is decided meanwhile would reach it any earlier."""
_MIDDLE: Vector = (0.0, 0.0, 0.0)
SPLIT_HZ = 10.0
HOLD_S = 0.03
"""A short jolt stays on the small motor for so long, or it would not spin up."""
FULL_LEVEL = 255


STOPPED_S = 0.02
"""A stop does not wait for its turn; a force that only passes zero is none."""


class Port(Protocol):
    """One open device; all methods raise DeviceError.

    Attributes:
        translator: of forces and reports, for as long as the port is open.
        is_quiet: whether its silence means nothing: it says nothing by itself, and owes
            no answer; then accepting a command is the sign of life.
        pace_s: shortest time from one command to the next that it states; 0 for none,
            then that of its `rate_hz`.
        is_owed: whether an answer to the last stop may still come.
        notice: what it has reported last and a person should read.
    """

    @property
    def translator(self) -> "Translator":
        """See above."""

    @property
    def is_quiet(self) -> bool:
        """See above."""

    @property
    def pace_s(self) -> float:
        """See above."""

    @property
    def is_owed(self) -> bool:
        """See above."""

    @property
    def notice(self) -> str:
        """See above."""

    def write(self, command: bytes) -> None:
        """Send a command; may take as long as the device takes it, some ms."""

    def read(self) -> bytes:
        """Return the next report, b"" when there is none; never waits."""

    def close(self) -> None:
        """Let go of the device; may be called again."""


class QuietPort:
    """What says nothing by itself, neither its pace."""

    is_quiet, is_owed, pace_s = True, False, 0.0
    notice: Message | str = ""


class Translator(Protocol):
    """From forces to commands and from reports to buttons, in one device's bytes."""

    off: bytes

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the command for a force, `off` for none and for no number."""

    def buttons(self, report: bytes) -> int | None:
        """Return the pressed buttons as a mask of 16 bits; None for nonsense."""


class Writer(Protocol):
    """Where commands go.

    Attributes:
        is_waiting: whether the device has not yet taken the last command.
        taken: how many it has taken.
    """

    taken: int

    @property
    def is_waiting(self) -> bool:
        """See above."""

    def post(self, command: bytes) -> None:
        """Send a command; raises DeviceError when the device is gone."""

    def stop(self) -> None:
        """Send nothing more; the port stays open."""


class NewestWriter:
    """Never waits; of commands that were posted meanwhile only the last is sent."""

    def __init__(self, port: Port) -> None:
        self._port = port
        self._newest: bytes | None = None
        self._problem: DeviceError | None = None
        self._is_stopping = False
        self.is_waiting, self.taken = False, 0
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._write, name="device", daemon=True)
        self._thread.start()

    def post(self, command: bytes) -> None:
        """Leave a command for the thread."""
        if self._problem is not None:
            raise self._problem
        with self._changed:
            self._newest, self.is_waiting = command, True
            self._changed.notify()

    def stop(self) -> None:
        """Let the thread end after what it is doing."""
        with self._changed:
            self._is_stopping = True
            self._changed.notify()
        self._thread.join(_STOP_S)

    def _write(self) -> None:
        while True:
            with self._changed:
                self.is_waiting = self._newest is not None
                while self._newest is None and not self._is_stopping:
                    self._changed.wait()
                if self._is_stopping:
                    return
                command, self._newest = self._newest, None
            assert command is not None
            try:
                self._port.write(command)
            except DeviceError as problem:
                self._problem = problem
                return
            except Exception as problem:  # a thread's top: it would be lost
                logging.getLogger(__name__).exception("a command failed")
                self._problem = DeviceError(
                    "the device driver failed ({reason}); report this, and "
                    "choose the device again",
                    reason=repr(problem)[:200],
                )
                return
            self.taken += 1


class PacedDriver:
    """A `HapticDevice` without a place: it reads as homed, in the middle.

    Args:
        name: of the device.
        capabilities: its record; commands go out at its `rate_hz` at most, or at the
            pace that the port states.
        open_port: finds and opens it; raises DeviceError with what to do.
        refresh_s: an unchanged command is sent again after so long, unless it
            is `off`.
        make_writer: `NewestWriter`; tests write in their own thread.
    """

    def __init__(
        self,
        name: str,
        capabilities: DeviceCapabilities,
        open_port: Callable[[], Port],
        refresh_s: float,
        make_writer: Callable[[Port], Writer] = NewestWriter,
    ) -> None:
        self.name, self.capabilities = name, capabilities
        self.open_port, self.make_writer = open_port, make_writer
        self._period_s, self._refresh_s = 1.0 / capabilities.rate_hz, refresh_s
        self._port: Port | None = None
        self._writer: Writer | None = None
        self._reading: DeviceReading | None = None
        self._sent, self._sent_s = b"", 0.0
        self._taken, self._taken_s, self._off_s = 0, 0.0, math.inf

    def open(self) -> None:
        """Find the device; raises DeviceError with what to do."""
        self.close()
        self._port = self.open_port()
        self._reading = None
        self._sent, self._sent_s = self._port.translator.off, 0.0
        atexit.register(self.close)

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force, return pressed buttons; raises DeviceError when it is gone."""
        port = self._port
        if port is None:
            raise DeviceError("the device is not open; choose the device again")
        writer = self._writer
        if writer is None:  # not earlier, so that it runs with the loop's scheduling
            writer = self._writer = self.make_writer(port)
        reading = self._listen(port, writer, now_s)
        command, off = port.translator.command(force_n, now_s), port.translator.off
        age_s = now_s - self._sent_s
        is_refreshing = command != off and age_s >= self._refresh_s
        self._off_s = min(self._off_s, now_s) if command == off else math.inf
        is_stop = now_s - self._off_s >= STOPPED_S
        is_due = is_stop or age_s >= (port.pace_s or self._period_s)
        if (command != self._sent or is_refreshing) and is_due:
            writer.post(command)
            self._sent, self._sent_s = command, now_s
        return reading

    @property
    def is_owed(self) -> bool:
        """Whether the loop has to listen on before it ends."""
        return self._port is not None and self._port.is_owed

    def close(self) -> None:
        """Switch the device off and let go of it; may be called again."""
        atexit.unregister(self.close)
        port, writer = self._port, self._writer
        self._port = self._writer = None
        if port is None:
            return
        if writer is not None:
            writer.stop()
        try:
            port.write(port.translator.off)
        except DeviceError:
            return  # it is gone, and its force with it
        finally:
            port.close()

    def _listen(self, port: Port, writer: Writer, now_s: float) -> DeviceReading:
        reading = self._reading or DeviceReading(_MIDDLE, 0, False, now_s)
        if port.is_quiet and self._is_taking(writer, now_s):
            reading = reading._replace(is_homed=True, replied_s=now_s)
        for _ in range(_MOST_READ):
            report = port.read()
            if not report:
                break
            buttons = port.translator.buttons(report)
            if buttons is not None:
                reading = DeviceReading(_MIDDLE, buttons, True, now_s)
            else:
                reading = reading._replace(malformed=reading.malformed + 1)
        if reading.notice is not port.notice:
            reading = reading._replace(notice=port.notice)
        self._reading = reading
        return reading

    def _is_taking(self, writer: Writer, now_s: float) -> bool:
        """Whether the device takes its commands, at its own rate."""
        if not writer.is_waiting or writer.taken != self._taken:
            self._taken, self._taken_s = writer.taken, now_s
        return now_s - self._taken_s < TAKING_S


def silencer(open_port: Callable[[], Port]) -> Callable[[], bool]:
    """The switch-off for the guard, which opens the device for itself.

    For devices that several programs can open: so it works beside a loop that stands
    still, and after its death.
    """
    opened: list[Port] = []
    with contextlib.suppress(
        DeviceError
    ):  # then the loop has none either, and reports it
        opened.append(open_port())  # now and not when time is short

    def write_zero() -> bool:
        try:
            if not opened:
                opened.append(open_port())
            opened[0].write(opened[0].translator.off)
        except DeviceError:
            if opened:
                opened.pop().close()
            return False
        return True

    return write_zero


class Rumble:
    """From force to two motors: how strong, and how rough.

    The large motor turns slowly and follows the magnitude of the force; the small one
    turns fast and follows what in that magnitude changes faster than about 10 Hz.
    """

    def __init__(self) -> None:
        self._slow_n = self._rough_n = 0.0
        self._last_s: float | None = None

    def levels(self, force_n: Vector, now_s: float) -> tuple[int, int]:
        """Return levels (large, small) of 0 to 255; zero force is zero at once."""
        x, y, z = force_n
        size_n = math.hypot(x, y, z)
        if not 0.0 < size_n < math.inf:
            self._slow_n = self._rough_n = 0.0
            self._last_s = now_s
            return 0, 0
        elapsed_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        share = -math.expm1(-2.0 * math.pi * SPLIT_HZ * elapsed_s)
        self._slow_n += share * (size_n - self._slow_n)
        fading = math.exp(-elapsed_s / HOLD_S)
        self._rough_n = max(abs(size_n - self._slow_n), fading * self._rough_n)
        return _level(size_n), _level(self._rough_n)


def _level(force_n: float) -> int:
    return min(FULL_LEVEL, round(FULL_LEVEL * force_n / FULL_N))
