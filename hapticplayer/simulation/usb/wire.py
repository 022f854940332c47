"""Messages between a USB bus that is not there and the process of its Falcon.

Like a usbfs node: whoever holds a descriptor of line A may write to the device, so a
guard can silence it beside a program that stands still. Packets from the device come
over a second line, which is handed over with ATTACH; so a read that waits never stands
in the way of a write. Each message is one packet of a SOCK_SEQPACKET pair.
"""

import enum
import math
import struct
from typing import NamedTuple

_REQUEST = struct.Struct("<cId3H")  # kind, serial, timeout s, three words
_ANSWER = struct.Struct("<Iii")  # serial, errno, bytes taken
MAX_BYTES = 4096
NO_ANSWER = 0
"""Serial of a request that wants no answer: a guard's."""


class Kind(enum.Enum):
    """What is asked for."""

    ATTACH = b"a"  # + descriptor of line B
    CONTROL = b"c"  # the three words are request, value, index
    OUT = b"o"  # + bytes
    IN = b"i"


class Request(NamedTuple):
    """From the bus to the Falcon."""

    kind: Kind
    serial: int = NO_ANSWER
    timeout_s: float = 0.0
    words: tuple[int, int, int] = (0, 0, 0)
    data: bytes = b""


class Answer(NamedTuple):
    """From the Falcon to the bus; `problem` is an errno, 0 for none."""

    serial: int
    problem: int = 0
    taken: int = 0
    data: bytes = b""


def pack_request(request: Request) -> bytes:
    """Return the bytes of a request."""
    head = _REQUEST.pack(
        request.kind.value, request.serial, request.timeout_s, *request.words
    )
    return head + request.data


def unpack_request(data: bytes) -> Request | None:
    """Return the request in these bytes, or None if they are none."""
    if len(data) < _REQUEST.size:
        return None
    kind, serial, timeout_s, *words = _REQUEST.unpack_from(data)
    if kind not in {known.value for known in Kind} or not 0.0 <= timeout_s < math.inf:
        return None
    i, j, k = words
    return Request(Kind(kind), serial, timeout_s, (i, j, k), data[_REQUEST.size :])


def pack_answer(answer: Answer) -> bytes:
    """Return the bytes of an answer."""
    head = _ANSWER.pack(answer.serial, answer.problem, answer.taken)
    return head + answer.data


def unpack_answer(data: bytes) -> Answer:
    """Return the answer in these bytes.

    Raises:
        struct.error: when they are none.
    """
    serial, problem, taken = _ANSWER.unpack_from(data)
    return Answer(serial, problem, taken, data[_ANSWER.size :])
