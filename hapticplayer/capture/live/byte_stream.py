"""Sources that send bytes: a port or a pipe, a decoder, and the count of samples.

A decoder is given bytes and returns readings; it knows no clock and no port.
"""

import errno
import os
import select
from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np

from hapticplayer.capture.live.source import Samples, SourceLost
from hapticplayer.clock import Clock
from hapticplayer.devices.serial_line import open_serial
from hapticplayer.errors import InputError, Message
from hapticplayer.model.limits import MAX_LINE_BYTES

BITS_OF_A_BYTE = 10
_MOST_BYTES = 1 << 16
_NO_PORT = Message("check the cable and the name, see /dev/serial/by-id")
_UNREAD_S, _UNREAD_BYTES = 3.0, 500


class Reading(NamedTuple):
    """A sample among the bytes that were given to a decoder.

    Attributes:
        end: how many of the given bytes belong to it and to what came before.
        size: bytes of the sample on its line.
        stamp_s: of the sender's clock; NaN without one.
        values: acceleration and angular rate, in the units that the source declares.
    """

    end: int
    size: int
    stamp_s: float
    values: tuple[float, ...]


class Decoder(Protocol):
    """Finds the samples in bytes, wherever these begin and whatever they hold."""

    def feed(self, data: bytes) -> list[Reading]:
        """The readings that end in these bytes."""
        ...


class ByteLink(Protocol):
    """Where bytes come from."""

    byte_s: float

    def read(self, timeout_s: float) -> bytes:
        """What has come, after waiting until then for something; raises SourceLost."""
        ...

    def close(self) -> None:
        """Let go of it."""
        ...


class Descriptor:
    """A pipe or port that is open; what it sends is read without waiting.

    Args:
        descriptor: of it.
        name: for people.
        byte_s: that a byte takes on its line.
    """

    def __init__(self, descriptor: int, name: str, byte_s: float = 0.0) -> None:
        self.byte_s = byte_s
        self._descriptor, self._name = descriptor, name

    def read(self, timeout_s: float) -> bytes:
        try:
            ready, _, _ = select.select([self._descriptor], [], [], max(0.0, timeout_s))
            if not ready:
                return b""
            data = os.read(self._descriptor, _MOST_BYTES)
        except (OSError, ValueError) as problem:
            raise self._lost(Message("was unplugged or closed")) from problem
        if not data and not self._descriptor:
            raise InputError("has ended", where=self._name)
        if not data:
            raise self._lost(Message("has ended"))
        return data

    def write(self, data: bytes) -> None:
        """Send a command; raises SourceLost."""
        try:
            os.write(self._descriptor, data)
        except (OSError, ValueError) as problem:
            raise self._lost(Message("was unplugged or closed")) from problem

    def close(self) -> None:
        if self._descriptor > 0:  # standard input is not ours
            os.close(self._descriptor)
        self._descriptor = -1

    def _lost(self, what: Message) -> SourceLost:
        remedy = Message("connect it again")
        return SourceLost(what, where=self._name, remedy=remedy)


def open_port(path: str, baud: int) -> Descriptor:
    """A serial port, see `open_serial`; raises InputError."""
    try:
        return Descriptor(open_serial(path, baud), path, BITS_OF_A_BYTE / baud)
    except ValueError as problem:
        raise InputError(
            "{reason}",
            where=path,
            remedy="give a usual rate, such as baud=115200",
            reason=problem,
        ) from None
    except OSError as problem:
        is_denied = problem.errno in (errno.EACCES, errno.EPERM)
        remedy = Message("add yourself to the group dialout and log in again")
        raise InputError(
            "cannot be opened ({reason})",
            where=path,
            remedy=remedy if is_denied else _NO_PORT,
            reason=problem,
        ) from problem


class SampleCount:
    """Stamps for samples without any: their number times the nominal period.

    What was lost on the way shows as a gap in the arrivals, and is counted too.

    Args:
        rate_hz: nominal; None measures it in the first moments, which are left out.
        usual_hz: rates that the source can have; a measured one becomes the nearest.
    """

    _MEASURED_S, _NEAR = 1.5, 0.1
    _LOST_S, _LOST_PERIODS, _DRIFT = 0.1, 3.0, 0.01

    def __init__(self, rate_hz: float | None, usual_hz: Sequence[float] = ()) -> None:
        self._period_s = 1.0 / rate_hz if rate_hz else 0.0
        self._usual_hz, self._begin_s = usual_hz, 0.0
        self._count = 0
        self._least_s, self._least_at_s = np.inf, 0.0

    def stamps(self, count: int, arrival_s: float) -> list[float]:
        """Stamps of samples that came together, the last of them now.

        NaN while the rate is measured.
        """
        if not self._period_s and not self._measured(count, arrival_s):
            return [np.nan] * count
        last_s = (self._count + count - 1) * self._period_s
        allowed_s = max(self._LOST_S, self._LOST_PERIODS * self._period_s)
        delay_s = arrival_s - last_s
        least_s = self._least_s + self._DRIFT * (arrival_s - self._least_at_s)
        if delay_s > least_s + allowed_s:
            self._count += round((delay_s - self._least_s) / self._period_s)
            delay_s = self._least_s
        if delay_s < least_s or not np.isfinite(least_s):
            self._least_s, self._least_at_s = delay_s, arrival_s
        first, self._count = self._count, self._count + count
        return [number * self._period_s for number in range(first, self._count)]

    def _measured(self, count: int, arrival_s: float) -> bool:
        """Whether the period is known now."""
        if not self._count:
            self._begin_s, self._count = arrival_s, 1  # the others came before
            return False
        self._count += count
        lasted_s = arrival_s - self._begin_s
        if lasted_s < self._MEASURED_S:
            return False
        rate_hz = (self._count - 1) / lasted_s
        near = [one for one in self._usual_hz if abs(one / rate_hz - 1.0) < self._NEAR]
        nearest_hz = min(near, key=lambda one: abs(one - rate_hz), default=rate_hz)
        self._period_s, self._count = 1.0 / nearest_hz, 0
        return False


class ByteSource:
    """A source of samples from bytes.

    Args:
        link: that they come by.
        decoder: that finds samples in them.
        clock: of the arrivals.
        count: of samples without stamps.
        where: for people.
        remedy: when bytes come that hold no sample.

    Attributes:
        is_stamped: whether samples carry the time of the sender's clock; else they are
            counted.
    """

    def __init__(
        self,
        link: ByteLink,
        decoder: Decoder,
        clock: Clock,
        count: SampleCount,
        where: str,
        remedy: Message,
    ) -> None:
        self._link, self._decoder, self._clock = link, decoder, clock
        self._count, self._where, self._remedy = count, where, remedy
        self.is_stamped = False
        self._unread, self._unread_since_s = 0, clock.now_s()
        self._read_s = self._unread_since_s

    def read(self, timeout_s: float) -> Samples:
        data = self._link.read(timeout_s)
        before_s, now_s = self._read_s, self._clock.now_s()
        self._read_s = now_s
        readings = self._decoder.feed(data) if data else []
        self._refuse_unreadable(len(data), bool(readings), now_s)
        if not readings:
            return Samples.of(())
        # a line that is faster than its baud, as a USB port may be, is no slower than this
        byte_s = min(self._link.byte_s, (now_s - before_s) / len(data))
        found = [
            (now_s - (len(data) - one.end + one.size) * byte_s, one) for one in readings
        ]
        stamps = self._stamps(readings, found[-1][0])
        rows = [
            (arrival_s, stamp_s, *one.values)
            for (arrival_s, one), stamp_s in zip(found, stamps, strict=True)
            if np.isfinite(stamp_s)
        ]
        return Samples.of(rows)

    def _stamps(self, readings: list[Reading], arrival_s: float) -> list[float]:
        own = [one.stamp_s for one in readings]
        self.is_stamped = self.is_stamped or bool(np.isfinite(own).any())
        if self.is_stamped:
            return own
        return self._count.stamps(len(readings), arrival_s)

    def _refuse_unreadable(self, size: int, is_read: bool, now_s: float) -> None:
        if is_read:
            self._unread, self._unread_since_s = 0, now_s
            return
        self._unread += size
        if self._unread > _UNREAD_BYTES and now_s - self._unread_since_s > _UNREAD_S:
            raise SourceLost(
                "sends bytes that hold no sample",
                where=self._where,
                remedy=self._remedy,
            )

    def close(self) -> None:
        self._link.close()


class LineSplitter:
    """Cuts bytes into lines, wherever they begin; a line that is too long is left out.

    Args:
        is_partial: the first line may lack its beginning, and is left out.
    """

    def __init__(self, is_partial: bool = True) -> None:
        self._rest, self._skips = b"", is_partial

    def feed(self, data: bytes) -> list[tuple[int, int, str]]:
        """Each line that ends here: bytes of the data up to its end, its size, text."""
        lines, end = [], 0
        *whole, rest = data.replace(b"\r", b"\n").split(b"\n")
        for part in whole:
            end += len(part) + 1
            line, self._rest = self._rest + part, b""
            if self._skips or len(line) > MAX_LINE_BYTES:
                self._skips = False
            elif line.strip():
                lines.append((end, len(line) + 1, line.decode("ascii", "replace")))
        self._rest += rest
        if len(self._rest) > MAX_LINE_BYTES:
            self._rest, self._skips = b"", True
        return lines
