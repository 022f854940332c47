"""The rig's side of the wire: ports, and what came of the packets at each of them."""

import select
import socket
import statistics
import struct
from collections import deque
from collections.abc import Iterator, Sequence
from typing import Any

from hapticplayer.clock import Clock, realtime_minus_monotonic_s
from hapticplayer.errors import InputError
from hapticplayer.extras.rigs.decode import DecodedPacket, decode

LOOPBACK = "127.0.0.1"
SILENT_AFTER_S = 0.5
_TIMESTAMPS = 35  # SO_TIMESTAMPNS, Linux: the kernel says when a packet came
_STAMP = struct.Struct("@qq")
_MOST_BYTES = 1024
_RECEIVE_BYTES = 1 << 20
_RECENT = 1000  # packets of which the rate is known


class SimulatedRig:
    """Holds the last pose for ever, as real ones do, and judges how it was left.

    Attributes:
        last: what the newest packet said; None before the first.
        packets: of a known format.
        unknown: packets of none.
        backwards: times at which the time in the packets went back from a pose that
            was not neutral.
        peak_mps2: largest acceleration.
    """

    def __init__(self) -> None:
        self.last: DecodedPacket | None = None
        self.packets = self.unknown = self.backwards = 0
        self.peak_mps2 = 0.0
        self.last_s = self._neutral_since_s = float("-inf")
        self._gaps_s: deque[float] = deque(maxlen=_RECENT)

    def hear(self, arrived_s: float, packet: bytes) -> DecodedPacket | None:
        """Take a packet; return what it said."""
        heard, before = decode(packet), self.last
        if heard is None:
            self.unknown += 1
            return None
        if before is not None:
            self._gaps_s.append(arrived_s - self.last_s)
            self.backwards += _went_back(before, heard)
        if heard.is_neutral and not (before and before.is_neutral):
            self._neutral_since_s = arrived_s
        self.packets += 1
        self.peak_mps2 = max(self.peak_mps2, *map(abs, heard.acceleration_mps2))
        self.last, self.last_s = heard, arrived_s
        return heard

    def report(self, now_s: float) -> dict[str, Any]:
        """The report for people; "neutral_s" is how long it was at last."""
        last, gaps = self.last, self._gaps_s
        is_neutral = last is not None and last.is_neutral
        return {
            "format": last.format if last else "",
            "packets": self.packets,
            "unknown": self.unknown,
            "rate_hz": round(1.0 / statistics.median(gaps), 1) if gaps else 0.0,
            "peak_mps2": round(self.peak_mps2, 3),
            "time_went_back": self.backwards,
            "is_silent": now_s - self.last_s > SILENT_AFTER_S,
            "is_neutral": is_neutral,
            "neutral_s": round(self.last_s - self._neutral_since_s, 3)
            if is_neutral
            else 0.0,
        }


def _went_back(before: DecodedPacket, heard: DecodedPacket) -> bool:
    times = before.time_s, heard.time_s
    if times[0] is None or times[1] is None:
        return False
    return times[1] < times[0] and not before.is_neutral


class PacketReceiver:
    """Sockets at several ports, and the rig behind each.

    Raises:
        InputError: when a port is taken.
    """

    def __init__(self, clock: Clock, ports: Sequence[int]) -> None:
        self._clock = clock
        self.rigs: dict[int, SimulatedRig] = {}
        self._ends: dict[int, socket.socket] = {}
        for port in ports:
            end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            end.setsockopt(socket.SOL_SOCKET, _TIMESTAMPS, 1)
            end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BYTES)
            try:
                end.bind((LOOPBACK, port))
            except OSError as problem:
                end.close()
                self.close()
                raise InputError(
                    "port {port} cannot be opened ({reason}); end what listens there",
                    port=port,
                    reason=problem,
                ) from problem
            end.setblocking(False)
            number = end.getsockname()[1]
            self._ends[number], self.rigs[number] = end, SimulatedRig()

    def listen(self, timeout_s: float) -> Iterator[tuple[int, float, DecodedPacket]]:
        """Yield (port, monotonic time of arrival, what it said) of what has come."""
        ready = select.select(list(self._ends.values()), [], [], timeout_s)[0]
        offset_s = realtime_minus_monotonic_s()
        for port, end in self._ends.items():
            while end in ready:
                try:
                    packet, ancillary, _, _ = end.recvmsg(_MOST_BYTES, 64)
                except BlockingIOError:
                    break
                arrived_s = _arrived_s(ancillary, offset_s) or self._clock.now_s()
                heard = self.rigs[port].hear(arrived_s, packet)
                if heard is not None:
                    yield port, arrived_s, heard

    def report(self) -> dict[int, dict[str, Any]]:
        now_s = self._clock.now_s()
        return {port: rig.report(now_s) for port, rig in self.rigs.items()}

    def close(self) -> None:
        for end in self._ends.values():
            end.close()


def _arrived_s(ancillary: Any, offset_s: float) -> float | None:
    for level, kind, data in ancillary:
        if (level, kind) == (socket.SOL_SOCKET, _TIMESTAMPS):
            seconds, nanoseconds = _STAMP.unpack(data)
            return float(seconds - offset_s + 1e-9 * nanoseconds)
    return None
