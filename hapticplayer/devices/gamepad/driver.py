"""A game pad as a haptic device: it shakes, and knows no place."""

import atexit
import contextlib
import threading
from collections.abc import Callable
from typing import Protocol

from hapticplayer.devices.capabilities import GAMEPAD
from hapticplayer.devices.gamepad.ports import Port, open_pad
from hapticplayer.devices.gamepad.reports import buttons_of, motors_report
from hapticplayer.devices.gamepad.rumble import Rumble
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceReading, Vector

REPORT_PERIOD_S = 0.010
REFRESH_S = 0.5
_MOST_READ = 16
_STOP_S = 0.5
_MIDDLE: Vector = (0.0, 0.0, 0.0)
_OFF = (0, 0)


class Outlet(Protocol):
    """Where reports go."""

    def post(self, report: bytes) -> None:
        """Send a report; raises DeviceError when the pad is gone."""

    def stop(self) -> None:
        """Send nothing more; the port stays open."""


class ThreadedOutlet:
    """Never waits; of reports that were posted meanwhile only the last is sent."""

    def __init__(self, port: Port) -> None:
        self._port = port
        self._newest: bytes | None = None
        self._problem: DeviceError | None = None
        self._is_stopping = False
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._write, name="pad", daemon=True)
        self._thread.start()

    def post(self, report: bytes) -> None:
        """Leave a report for the thread."""
        if self._problem is not None:
            raise self._problem
        with self._changed:
            self._newest = report
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
                while self._newest is None and not self._is_stopping:
                    self._changed.wait()
                if self._is_stopping:
                    return
                report, self._newest = self._newest, None
            assert report is not None
            try:
                self._port.write(report)
            except DeviceError as problem:
                self._problem = problem
                return


class GamepadDriver:
    """A `HapticDevice` without a place: it reads as homed, in the middle.

    Pads on USB report 250 times a second by themselves; that is the ear for buttons and
    for the cable.
    """

    name = "gamepad"
    capabilities = GAMEPAD

    def __init__(
        self,
        open_port: Callable[[], Port] = open_pad,
        make_outlet: Callable[[Port], Outlet] = ThreadedOutlet,
    ) -> None:
        self._open_port, self._make_outlet = open_port, make_outlet
        self._port: Port | None = None
        self._outlet: Outlet | None = None
        self._reading: DeviceReading | None = None
        self._rumble = Rumble()
        self._told, self._told_s = _OFF, 0.0

    def open(self) -> None:
        """Find the pad; raises DeviceError with what to do."""
        self.close()
        self._port = self._open_port()
        self._reading, self._rumble = None, Rumble()
        self._told, self._told_s = _OFF, 0.0
        atexit.register(self.close)

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Shake with a force, return what is pressed; raises DeviceError when gone."""
        port = self._port
        if port is None:
            raise DeviceError("the game pad is not open; choose the device again")
        outlet = self._outlet
        if outlet is None:  # not earlier, so that it runs with the loop's scheduling
            outlet = self._outlet = self._make_outlet(port)
        reading = self._listen(port, now_s)
        levels = self._rumble.levels(force_n, now_s)
        age_s = now_s - self._told_s
        is_news = levels != self._told or (levels != _OFF and age_s >= REFRESH_S)
        if is_news and age_s >= REPORT_PERIOD_S:
            outlet.post(motors_report(port.layout, *levels))
            self._told, self._told_s = levels, now_s
        return reading

    def close(self) -> None:
        """Switch the motors off and let go; may be called again."""
        atexit.unregister(self.close)
        port, outlet = self._port, self._outlet
        self._port = self._outlet = None
        if port is None:
            return
        if outlet is not None:
            outlet.stop()
        try:
            port.write(motors_report(port.layout, *_OFF))
        except DeviceError:
            return  # it is gone, and its motors with it
        finally:
            port.close()

    def _listen(self, port: Port, now_s: float) -> DeviceReading:
        reading = self._reading or DeviceReading(_MIDDLE, 0, False, now_s)
        for _ in range(_MOST_READ):
            report = port.read()
            if not report:
                break
            buttons = buttons_of(port.layout, report)
            if buttons is not None:
                reading = DeviceReading(_MIDDLE, buttons, True, now_s)
            else:
                reading = reading._replace(malformed=reading.malformed + 1)
        self._reading = reading
        return reading


def make(_line: int) -> GamepadDriver:
    """Return the driver of the pad that is plugged in."""
    return GamepadDriver()


def silence(_line: int, open_port: Callable[[], Port] = open_pad) -> Callable[[], bool]:
    """Return what switches a pad's motors off, for the guard.

    A pad can be opened by several programs; so this works beside a loop that stands
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
            opened[0].write(motors_report(opened[0].layout, *_OFF))
        except DeviceError:
            if opened:
                opened.pop().close()
            return False
        return True

    return write_zero
