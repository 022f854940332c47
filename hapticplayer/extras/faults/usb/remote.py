"""The simulated chip in a process of its own, as the bus sees it; and the wire between."""

import enum
import errno
import math
import os
import select
import socket
import struct
import weakref
from collections.abc import Callable
from typing import NamedTuple

from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.extras.faults.usb.chip import UsbFault

_REQUEST = struct.Struct("<cId3H")  # kind, serial, timeout s, three words
_ANSWER = struct.Struct("<Iii")  # serial, errno, bytes taken
MAX_BYTES = 4096
NO_ANSWER = 0
"""Serial of a request that wants no answer: a guard's."""


class UsbRequestKind(enum.Enum):
    """What is asked for."""

    ATTACH = b"a"  # + descriptor of line B
    CONTROL = b"c"  # the three words are request, value, index
    OUT = b"o"  # + bytes
    IN = b"i"


class UsbRequest(NamedTuple):
    """From the bus to the Falcon."""

    kind: UsbRequestKind
    serial: int = NO_ANSWER
    timeout_s: float = 0.0
    words: tuple[int, int, int] = (0, 0, 0)
    data: bytes = b""


class UsbAnswer(NamedTuple):
    """From the Falcon to the bus; `problem` is an errno, 0 for none."""

    serial: int
    problem: int = 0
    taken: int = 0
    data: bytes = b""


def pack_request(request: UsbRequest) -> bytes:
    """Return the bytes of a request."""
    head = _REQUEST.pack(
        request.kind.value, request.serial, request.timeout_s, *request.words
    )
    return head + request.data


def unpack_request(data: bytes) -> UsbRequest | None:
    """Return the request in these bytes, or None if they are none."""
    if len(data) < _REQUEST.size:
        return None
    kind, serial, timeout_s, *words = _REQUEST.unpack_from(data)
    if (
        kind not in {known.value for known in UsbRequestKind}
        or not 0.0 <= timeout_s < math.inf
    ):
        return None
    i, j, k = words
    return UsbRequest(
        UsbRequestKind(kind), serial, timeout_s, (i, j, k), data[_REQUEST.size :]
    )


def pack_answer(answer: UsbAnswer) -> bytes:
    head = _ANSWER.pack(answer.serial, answer.problem, answer.taken)
    return head + answer.data


def unpack_answer(data: bytes) -> UsbAnswer:
    """Return the answer in these bytes; raises struct.error when they are none."""
    serial, problem, taken = _ANSWER.unpack_from(data)
    return UsbAnswer(serial, problem, taken, data[_ANSWER.size :])


_SLACK_S = 0.1
"""For a process that has not come to its turn; then it counts as a stalled device."""
_CONTROL_S = 5.0
_GONE = "No such device (it may have been disconnected)"


class RemoteChip:
    """Does what `Chip` does, through a descriptor; one thread may read, one write.

    The descriptor is one end of a SOCK_SEQPACKET pair and belongs to this object.
    """

    def __init__(self, descriptor: int) -> None:
        self.is_plugged = True
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            attach = socket.socket(fileno=descriptor)
            attach.setblocking(False)
            message = pack_request(UsbRequest(UsbRequestKind.ATTACH))
            socket.send_fds(attach, [message], [theirs.fileno()])
        # two numbers, closed with this object: no bus has a place to close it
        self._out = _Line(attach.detach())
        self._in = _Line(ours.detach())

    def control(self, request: int, value: int, index: int) -> None:
        words = (request, value, index)
        self._do(self._out, UsbRequest(UsbRequestKind.CONTROL, words=words), _CONTROL_S)

    def write(self, data: bytes, timeout_s: float) -> int:
        """Send bytes; return how many were taken before the time was over."""
        request = UsbRequest(UsbRequestKind.OUT, timeout_s=timeout_s, data=data)
        answer = self._do(self._out, request, timeout_s)
        return answer.taken if answer is not None else 0

    def read(self, timeout_s: float) -> bytes | None:
        """Return the next packet, or None when the time is over."""
        request = UsbRequest(UsbRequestKind.IN, timeout_s=timeout_s)
        answer = self._do(self._in, request, timeout_s)
        return answer.data if answer is not None else None

    def _do(
        self, line: "_Line", request: UsbRequest, timeout_s: float
    ) -> UsbAnswer | None:
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

    def __init__(self, descriptor: int) -> None:
        os.set_blocking(descriptor, False)
        weakref.finalize(self, os.close, descriptor)
        self._end, self._clock = descriptor, SystemClock()
        self._poll = select.poll()
        self._poll.register(descriptor, select.POLLIN)
        self._serial = NO_ANSWER

    def ask(self, request: UsbRequest, timeout_s: float) -> UsbAnswer | None:
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
    """A writer of one zero frame beside a program that holds the device.

    The descriptor is inherited by the guard and stays the caller's.
    """
    os.set_blocking(descriptor, False)
    frame = encode_command((0, 0, 0))
    message = pack_request(UsbRequest(UsbRequestKind.OUT, NO_ANSWER, 0.005, data=frame))

    def write_zero() -> bool:
        try:
            os.write(descriptor, message)
        except BlockingIOError:
            return True  # it does not listen; the guard calls again
        except OSError:
            return False
        return True

    return write_zero
