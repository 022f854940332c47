"""The simulated Falcon's chip in a process of its own, as the bus sees it.

A real Falcon does not share an interpreter with its driver; this one doesn't either,
so that what is measured of the driver is the driver.
"""

import errno
import os
import select
import socket
import weakref
from collections.abc import Callable

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.simulation.usb.chip import UsbFault
from hapticplayer.simulation.usb.wire import (
    MAX_BYTES,
    NO_ANSWER,
    Answer,
    Kind,
    Request,
    pack_request,
    unpack_answer,
)

_SLACK_S = 0.1
"""For a process that has not come to its turn; then it counts as a stalled device."""
_CONTROL_S = 5.0
_GONE = "No such device (it may have been disconnected)"


class RemoteChip:
    """Does what `Chip` does, through a descriptor; one thread may read, one write.

    Args:
        descriptor: one end of a SOCK_SEQPACKET pair; it belongs to this object.
        clock: for time limits.
    """

    def __init__(self, descriptor: int, clock: Clock | None = None) -> None:
        self.is_plugged = True
        self._clock = clock or SystemClock()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            attach = socket.socket(fileno=descriptor)
            attach.setblocking(False)
            message = pack_request(Request(Kind.ATTACH))
            socket.send_fds(attach, [message], [theirs.fileno()])
        # two numbers, closed with this object: no bus has a place to close it
        self._out = _Line(attach.detach(), self._clock)
        self._in = _Line(ours.detach(), self._clock)

    def control(self, request: int, value: int, index: int) -> None:
        """Make a vendor request."""
        words = (request, value, index)
        self._do(self._out, Request(Kind.CONTROL, words=words), _CONTROL_S)

    def write(self, data: bytes, timeout_s: float) -> int:
        """Send bytes; return how many were taken before the time was over."""
        request = Request(Kind.OUT, timeout_s=timeout_s, data=data)
        answer = self._do(self._out, request, timeout_s)
        return answer.taken if answer is not None else 0

    def read(self, timeout_s: float) -> bytes | None:
        """Return the next packet, or None when the time is over."""
        request = Request(Kind.IN, timeout_s=timeout_s)
        answer = self._do(self._in, request, timeout_s)
        return answer.data if answer is not None else None

    def _do(self, line: "_Line", request: Request, timeout_s: float) -> Answer | None:
        try:
            answer = line.ask(request, timeout_s + _SLACK_S)
        except OSError as problem:
            self.is_plugged = False
            raise UsbFault(errno.ENODEV, _GONE) from problem
        if answer is None or answer.problem == errno.ETIMEDOUT:
            return None
        if answer.problem:
            self.is_plugged = answer.problem != errno.ENODEV
            raise UsbFault(answer.problem, os.strerror(answer.problem))
        return answer


class _Line:
    """Requests one after the other, each with its answer."""

    def __init__(self, descriptor: int, clock: Clock) -> None:
        os.set_blocking(descriptor, False)
        weakref.finalize(self, os.close, descriptor)
        self._end, self._clock = descriptor, clock
        self._poll = select.poll()
        self._poll.register(descriptor, select.POLLIN)
        self._serial = NO_ANSWER

    def ask(self, request: Request, timeout_s: float) -> Answer | None:
        """Return the answer, None if it does not come; raises OSError at the end."""
        self._serial = self._serial % 0xFFFFFFFF + 1
        try:
            os.write(self._end, pack_request(request._replace(serial=self._serial)))
        except BlockingIOError:
            return None  # the process is there and does not listen
        deadline_s = self._clock.now_s() + timeout_s
        while (left_s := deadline_s - self._clock.now_s()) > 0.0:
            if not self._poll.poll(1e3 * left_s):
                return None
            data = os.read(self._end, MAX_BYTES)
            if not data:
                raise ConnectionResetError
            answer = unpack_answer(data)
            if answer.serial == self._serial:  # else to one that was given up
                return answer
        return None


def silence(descriptor: int) -> Callable[[], bool]:
    """Return what writes one zero frame beside a program that holds the device.

    Args:
        descriptor: of the same line, inherited by the guard; it stays the caller's.
    """
    os.set_blocking(descriptor, False)
    frame = encode_command((0, 0, 0))
    message = pack_request(Request(Kind.OUT, NO_ANSWER, 0.005, data=frame))

    def write_zero() -> bool:
        try:
            os.write(descriptor, message)
        except BlockingIOError:
            return True  # it does not listen; the guard calls again
        except OSError:
            return False
        return True

    return write_zero
