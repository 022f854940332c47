"""The FT232R: a line to the board on one side, packets to USB on the other."""

import errno
import math
import threading
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon import ftdi
from hapticplayer.devices.falcon.ftdi import CTS, PAYLOAD_BYTES, Divisor
from hapticplayer.extras.faults.usb.board import Board

BITS_PER_BYTE = 10
_MODEM_FIXED, _LINE_IDLE = 0x01, 0x60
_SLICE_S = 0.0001
_WRITE_BYTES = 128  # the chip's buffer towards the board


class UsbFault(OSError):  # noqa: N818 - becomes the USB library's own error
    """What the bus reports; errno says which trouble it is."""


class Chip:
    """One Falcon on the bus, seen through its chip; safe for two threads.

    Attributes:
        most_payload: bytes of payload in a packet; fewer than 62 split answers.
        is_plugged: False from the moment of unplugging on.
        stalled_until_s: until then it neither takes nor gives a packet.
        requests: control requests (number, value, index) so far.
    """

    def __init__(self, board: Board, clock: Clock) -> None:
        self.board = board
        self.most_payload = PAYLOAD_BYTES
        self.is_plugged = True
        self.stalled_until_s = -math.inf
        self.requests: list[tuple[int, int, int]] = []
        self._clock = clock
        self._lock = threading.Lock()
        self._baud = ftdi.HELLO_BAUD.baud
        self._latency_s = 0.016
        self._event = -1
        self._dtr = False
        self._line_free_s = self._back_free_s = self._sent_s = clock.now_s()
        self._arrivals: deque[tuple[float, int]] = deque()  # when, byte
        self._sent_modem = _MODEM_FIXED

    def control(self, request: int, value: int, index: int) -> None:
        """Execute a vendor request."""
        with self._lock:
            self._check()
            now_s = self._clock.now_s()
            self.requests.append((request, value, index))
            if request == ftdi.RESET:
                self._reset(value)
            elif request == ftdi.MODEM and value & 0x100:
                is_high, was_high, self._dtr = (
                    bool(value & 1),
                    self._dtr,
                    bool(value & 1),
                )
                self.board.set_dtr(is_high=is_high, was_high=was_high, at_s=now_s)
            elif request == ftdi.BAUD:
                self._baud = Divisor(value, index).baud
            elif request == ftdi.EVENT:
                self._event = value & 0xFF if value & 0x100 else -1
            elif request == ftdi.LATENCY:
                self._latency_s = max(1, value & 0xFF) / 1000.0

    def write(self, data: bytes, timeout_s: float) -> int:
        """Take bytes for the board; as many as have room before the time is over."""
        deadline_s = self._clock.now_s() + timeout_s
        self._wait_until(min(self.stalled_until_s, deadline_s))
        with self._lock:
            self._check()
            now_s = self._clock.now_s()
            if now_s < self.stalled_until_s:
                return 0
            byte_s = BITS_PER_BYTE / self._baud
            start_s = max(now_s, self._line_free_s)
            for first in range(0, len(data), _WRITE_BYTES):
                part = data[first : first + _WRITE_BYTES]
                self._line_free_s = start_s = start_s + len(part) * byte_s
                self.send_back(self.board.receive(part, self._baud, start_s), start_s)
            return len(data)

    def read(self, timeout_s: float) -> bytes | None:
        """Return the next packet, or None when the time is over."""
        deadline_s = self._clock.now_s() + timeout_s
        while True:
            with self._lock:
                self._check()
                now_s = self._clock.now_s()
                due_s = max(self.due_s(), self.stalled_until_s)
                if due_s <= now_s:
                    return self._packet(now_s)
            if now_s >= deadline_s:
                return None
            # what is due may come earlier, when another thread writes
            soon_s = now_s + _SLICE_S if self._event >= 0 else due_s
            self._clock.sleep_until(min(due_s, deadline_s, soon_s))

    @contextmanager
    def held(self) -> Iterator[None]:
        """Let a test change what is behind it while nothing else does."""
        with self._lock:
            yield

    def unplug(self) -> None:
        """Pull the cable, whatever is going on; the board loses its firmware."""
        self.is_plugged = False

    def send_back(self, answer: bytes, at_s: float) -> None:
        """Put what the board says at a time on the line back."""
        byte_s = BITS_PER_BYTE / self._baud
        self._back_free_s = max(at_s, self._back_free_s)
        for byte in answer:
            self._back_free_s += byte_s
            self._arrivals.append((self._back_free_s, byte))

    def due_s(self) -> float:
        """Return when the next packet is ready, by the chip's four rules."""
        due_s = self._sent_s + self._latency_s
        arrivals = self._arrivals
        if len(arrivals) >= self.most_payload:
            due_s = min(due_s, arrivals[self.most_payload - 1][0])
        if not self._sent_modem & CTS:
            due_s = min(due_s, self.board.clear_to_send_at_s)
        if self._event >= 0:
            for place, (at_s, byte) in enumerate(arrivals):
                if byte == self._event and place:
                    return min(due_s, at_s)
        return due_s

    def _packet(self, now_s: float) -> bytes:
        payload = bytearray()
        arrivals = self._arrivals
        while arrivals and arrivals[0][0] <= now_s and len(payload) < self.most_payload:
            payload.append(arrivals.popleft()[1])
        self._sent_s = now_s
        is_clear = now_s >= self.board.clear_to_send_at_s
        self._sent_modem = _MODEM_FIXED | (CTS if is_clear else 0)
        return bytes((self._sent_modem, _LINE_IDLE)) + bytes(payload)

    def _reset(self, value: int) -> None:
        self._arrivals.clear()
        if value == ftdi.RESET_ALL:
            self._event, self._dtr = -1, False

    def _wait_until(self, until_s: float) -> None:
        if until_s > self._clock.now_s():
            self._clock.sleep_until(until_s)

    def _check(self) -> None:
        if not self.is_plugged:
            raise UsbFault(
                errno.ENODEV, "No such device (it may have been disconnected)"
            )
