"""A Haply Inverse3 as a haptic device: one command a tick, one answer for each."""

import math
import os
import socket
from collections.abc import Callable
from typing import Protocol

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.descriptor_passing import hand_over, take_over
from hapticplayer.devices.options import DeviceOptions, service_options
from hapticplayer.devices.websocket import OPENING_S, Connection, text_frame
from hapticplayer.errors import DeviceError, Message, message_of
from hapticplayer.extras.inverse3.extension import INVERSE3
from hapticplayer.extras.inverse3.protocol import (
    FIELDS,
    ZERO,
    Inverse3State,
    command,
    complaint,
    configuration,
    refusal,
    state_of,
)
from hapticplayer.model.device import DeviceReading, Vector

DEFAULT = "127.0.0.1:10001"
TITLE = "Haply's Inverse Service"
DOUBT_S = 0.1
DOUBT_N = 0.5
"""A grip that stays at the same place, to the last digit, for so long under a force that
has changed by so much, is a service that repeats itself: no hand is as stiff."""
UNREADABLE_GRIP = Message(
    "the buttons of the wireless grip cannot be read; stop with Esc, and look at the grip "
    "in Haply's own program"
)
_MOST_OWED = 4
_MOST_READ = 64


class ServiceConnection(Protocol):
    """An open connection to the service; all methods raise DeviceError."""

    def fileno(self) -> int:
        """Return its descriptor."""

    def send(self, text: str) -> None:
        """Send a message."""

    def receive(self, timeout_s: float = 0.0) -> str | bytes:
        """Return the next message, "" when none has come in time."""

    def close(self) -> None:
        """Close it; may be called again."""


class Inverse3Driver:
    """A `HapticDevice`; a tick sends one command and takes the answers that have come.

    A command waits for the answers to those before it, so that none plays late; only
    zero does not wait.

    Args:
        connect: returns an open connection.
        line: along which the guard gets the connection.
        clock: for the wait in `open`.
    """

    name = "inverse3"
    capabilities = INVERSE3

    def __init__(
        self,
        connect: Callable[[], ServiceConnection],
        line: int = -1,
        clock: Clock | None = None,
    ) -> None:
        self._connect, self._line = connect, line
        self._clock = clock or SystemClock()
        self._link: ServiceConnection | None = None
        self._device, self._field = "", FIELDS[0]
        self._owed = 0
        self._reading: DeviceReading | None = None
        self._notice: Message | str = ""
        self._still = _Stillness()

    def open(self) -> None:
        """Connect, and put the origin into the middle; raises DeviceError."""
        self.close()
        link = self._connect()
        try:
            state = self._first(link)
            self._device, self._field = state.device, state.field or FIELDS[0]
            link.send(configuration(self._device))
        except DeviceError:
            link.close()
            raise
        self._link, self._owed, self._reading = link, 1, None
        self._notice, self._still = "", _Stillness()
        zero = command(self._device, self._field, ZERO)
        hand_over(self._line, link.fileno(), text_frame(zero))

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force and return the newest answer; raises DeviceError when gone."""
        link = self._link
        if link is None:
            raise DeviceError("the Inverse3 is not open; choose the device again")
        if not math.isfinite(force_n[0] + force_n[1] + force_n[2]):
            force_n = ZERO
        reading = self._listen(link, force_n, now_s)
        if self._owed < (_MOST_OWED if force_n == ZERO else 1):
            link.send(command(self._device, self._field, force_n))
            self._owed += 1
        return reading

    def close(self) -> None:
        """Leave zero and hang up; may be called again."""
        link, self._link = self._link, None
        if link is None:
            return
        try:
            link.send(command(self._device, self._field, ZERO))
        except DeviceError:
            return  # it is gone, and its force with it
        finally:
            link.close()

    def _first(self, link: ServiceConnection) -> Inverse3State:
        until_s, said = self._clock.now_s() + OPENING_S, None
        while (left_s := until_s - self._clock.now_s()) > 0.0:
            text = link.receive(left_s)
            state = state_of(text) if text else None
            if state is not None:
                return _only(state)
            if text and (error := complaint(text)):
                raise _reported(error, TITLE)
            said = (refusal(text, TITLE) if text else None) or said
        if said:
            raise DeviceError(said)
        raise DeviceError(
            "Haply's Inverse Service has no Inverse3; connect its cable and supply, and "
            "choose the device again"
        )

    def _listen(
        self, link: ServiceConnection, force_n: Vector, now_s: float
    ) -> DeviceReading:
        reading = self._reading or DeviceReading(ZERO, 0, False, now_s)
        for _ in range(_MOST_READ):
            text = link.receive()
            if not text:
                break
            self._owed = max(0, self._owed - 1)
            state = state_of(text, self._device)
            if state is None:  # also where another device answers
                if not self._notice and (error := complaint(text)):
                    self._notice = message_of(_reported(error, TITLE))
                reading = reading._replace(malformed=reading.malformed + 1)
            elif state.error:
                raise _reported(state.error)
            elif self._still.is_doubtful(state.position_m, force_n, now_s):
                continue
            else:
                if state.buttons is None:
                    self._notice = UNREADABLE_GRIP
                reading = DeviceReading(
                    state.position_m, state.buttons or 0, state.is_ready, now_s
                )
        if reading.notice is not self._notice:
            reading = reading._replace(notice=self._notice)
        self._reading = reading
        return reading


def _only(state: Inverse3State) -> Inverse3State:
    if state.devices > 1:
        raise DeviceError(
            "Haply's Inverse Service has {count} Inverse3; leave one connected, and "
            "choose the device again",
            count=state.devices,
        )
    if state.error:
        raise _reported(state.error)
    return state


def _reported(error: str, who: str = "the Inverse3") -> DeviceError:
    return DeviceError(
        "{who} reports the error {code}; look at it in Haply's own program, and choose "
        "the device again",
        who=who,
        code=error,
    )


class _Stillness:
    """Doubts a position that stays exactly the same while the force changes.

    The doubt lasts until the position changes: a force that comes back proves nothing.
    """

    def __init__(self) -> None:
        self._position_m: Vector | None = None
        self._since_s, self._force_n, self._is_doubted = 0.0, ZERO, False

    def is_doubtful(self, position_m: Vector, force_n: Vector, now_s: float) -> bool:
        if position_m != self._position_m:
            self._position_m, self._since_s = position_m, now_s
            self._force_n, self._is_doubted = force_n, False
            return False
        is_pushed = math.dist(force_n, self._force_n) > DOUBT_N
        self._is_doubted |= is_pushed and now_s - self._since_s > DOUBT_S
        return self._is_doubted


def inverse3_options(text: str) -> DeviceOptions:
    """The service of this machine, or at HOST:PORT; raises DeviceError."""
    return service_options(text, DEFAULT, INVERSE3)


def make(line: int, options: DeviceOptions) -> Inverse3Driver:
    url = f"ws://{options.address}"
    return Inverse3Driver(lambda: Connection(url, TITLE), line)


def silence(line: int, _options: object = None) -> Callable[[], bool]:
    """A sender of zero through the loop's own connection, for the guard."""
    held: list[tuple[int, bytes]] = []  # as long as the guard lives

    def write_zero() -> bool:
        newest = take_over(line)
        if newest is not None:
            held[:] = [newest]
        try:
            for descriptor, frame in held:
                with socket.socket(fileno=os.dup(descriptor)) as end:
                    end.send(frame, socket.MSG_DONTWAIT)
        except BlockingIOError:
            return True  # it does not listen; the guard calls again
        except OSError:
            return False
        return True

    return write_zero
