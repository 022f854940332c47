"""The simulated Falcon as seen through a socket: device, silencer, test controls."""

import math
import os
import select
import socket
from collections.abc import Callable
from functools import partial

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.capabilities import SIMULATED
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceReading, Vector
from hapticplayer.simulation.falcon.packets import (
    MAX_BYTES,
    SERIAL_MASK,
    Control,
    ScriptedEvent,
    command_bytes,
    pack_control,
    read_reply,
)

_ZERO: Vector = (0.0, 0.0, 0.0)
# More than a socket buffer holds; bounds the time of one exchange all the same.
_MOST_REPLIES = 1024
# An answer that is older was not the last: the loop or the device stalled.
_FRESH_S = 0.002
_PATIENCE_S = 10.0  # a cold start of the interpreter on a busy machine


class RemoteFalcon:
    """A `HapticDevice` at the other end of a SOCK_SEQPACKET pair; never blocks.

    Every exchange writes a command and takes the newest reply that has arrived,
    normally the one to the command before. A device that has stopped listening is not
    an error here: `replied_s` then does not advance. The descriptor belongs to this
    object from now on.
    """

    name = "simulated"
    capabilities = SIMULATED

    def __init__(self, descriptor: int) -> None:
        self._end = _end_of(descriptor)
        self._send, self._receive = self._end.send, self._end.recv
        self._serial = 1  # the first command has 2, so that stale answers do not match
        self._newest: DeviceReading | None = None
        self._malformed = 0

    def open(self) -> None:
        """Wait for the device's first answer; the only call here that waits.

        Raises:
            DeviceError: when there is no device at the other end, or it does not answer.
        """
        hello = pack_control(Control(ScriptedEvent.HELLO))
        if not _write(self._send, hello):
            raise _unplugged()
        waiting = select.poll()
        waiting.register(self._end, select.POLLIN)
        waiting.poll(1e3 * _PATIENCE_S)
        if not self._collect(self._serial, math.inf):
            raise _unplugged()
        if self._newest is None:
            raise DeviceError(
                "the simulated Falcon did not answer within {patience_s:.0f} s; "
                "try again, and run 'hapticplayer doctor' if it stays so",
                patience_s=_PATIENCE_S,
            )

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force and return the newest answer.

        Before the first answer the reading is the centre, not homed, as old as
        the first exchange.

        Raises:
            DeviceError: when the other end is gone.
        """
        before = self._serial
        self._serial = serial = before % SERIAL_MASK + 1  # never 0
        try:
            self._send(command_bytes(serial, now_s, force_n))
        except BlockingIOError:
            pass  # the device does not listen; the age of its answers shows it
        except OSError:
            raise _unplugged() from None
        if not self._collect(before, now_s - _FRESH_S):
            raise _unplugged()
        if self._newest is None:
            self._newest = DeviceReading(_ZERO, 0, is_homed=False, replied_s=now_s)
        if self._malformed:
            return self._newest._replace(malformed=self._malformed)
        return self._newest

    def close(self) -> None:
        """Leave zero and hang up; the device ends when all others have done so too."""
        if self._end.fileno() >= 0:
            _write(self._send, command_bytes(0, SystemClock().now_s(), _ZERO))
        self._end.close()

    def _collect(self, awaited: int, fresh_s: float) -> bool:
        """Take the answers that have come; False when the other end is gone.

        Behind a fresh answer to the command `awaited` (a serial number) there is none:
        to ask again would cost a call and an exception at every tick.
        """
        for _ in range(_MOST_REPLIES):
            try:
                data = self._receive(MAX_BYTES)
            except BlockingIOError:
                return True
            except OSError:
                return False
            if not data:
                return False
            reply = read_reply(data)
            if reply is None:
                self._malformed += 1
                continue
            self._malformed = 0
            serial, self._newest = reply
            if serial == awaited and self._newest.replied_s >= fresh_s:
                return True
        return True


def silence(descriptor: int) -> Callable[[], bool]:
    """Return a function that writes one zero force, for a guard process.

    The function never blocks. It returns False when the device is gone, and True
    otherwise, even if the device has stopped listening and the zero found no place in
    its queue: the guard calls again. The descriptor is the end that the dead process
    used; it stays the caller's.
    """
    os.set_blocking(descriptor, False)
    clock: Clock = SystemClock()

    def write_zero() -> bool:
        data = command_bytes(0, clock.now_s(), _ZERO)
        return _write(partial(os.write, descriptor), data)

    return write_zero


class Controls:
    """What a test can do to the device from outside; every call is one packet.

    The descriptor is an end of the pair, or of the pair behind `--control`, and belongs
    to this object from now on. Each method raises DeviceError when the device is gone.
    """

    def __init__(self, descriptor: int) -> None:
        self._end = _end_of(descriptor)

    def let_go(self) -> None:
        """Take the hand away."""
        self._send(ScriptedEvent.LET_GO)

    def grasp(self) -> None:
        """Put the hand back, where the grip is."""
        self._send(ScriptedEvent.GRASP)

    def press(self, buttons: int) -> None:
        """Press the buttons of this bit mask, and release the others."""
        self._send(ScriptedEvent.BUTTONS, buttons)

    def unplug(self) -> None:
        """End the device without a word."""
        self._send(ScriptedEvent.UNPLUG)

    def stall(self, duration_s: float) -> None:
        """Let the device neither listen nor answer for so long."""
        self._send(ScriptedEvent.STALL, duration_s)

    def corrupt(self, count: int) -> None:
        """Falsify the next replies."""
        self._send(ScriptedEvent.CORRUPT, count)

    def lose_homing(self) -> None:
        """Let the device say from now on that its position is invalid."""
        self._send(ScriptedEvent.LOSE_HOMING)

    def close(self) -> None:
        """Hang up."""
        self._end.close()

    def _send(self, event: ScriptedEvent, value: float = 0.0) -> None:
        if not _write(self._end.send, pack_control(Control(event, value))):
            raise _unplugged()


def _end_of(descriptor: int) -> socket.socket:
    end = socket.socket(fileno=descriptor)
    end.setblocking(False)
    return end


def _write(send: Callable[[bytes], int], data: bytes) -> bool:
    try:
        send(data)
    except BlockingIOError:
        return True  # the device is there and does not listen
    except OSError:
        return False
    return True


def _unplugged() -> DeviceError:
    return DeviceError(
        "the simulated Falcon was unplugged: its process has ended; "
        "choose the device again to start a new one"
    )
