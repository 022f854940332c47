"""Boards on a serial port, and lines of CSV: a decoder for each.

Sources: WITMOTION/WitStandardProtocol_JY901 (WT901); Razor-AHRS 1.4.2 by Peter Bartz
(Output.ino); ryowens84/Ultimate-IMU, main.cpp (2011).
"""

import datetime as dt
import math
import re
import struct
from collections.abc import Callable

from hapticplayer.capture.choices import TIME_UNITS, factor
from hapticplayer.capture.csv_table import LOG_COLUMNS, TIME
from hapticplayer.capture.live.byte_stream import (
    BITS_OF_A_BYTE,
    ByteSource,
    Decoder,
    Descriptor,
    LineSplitter,
    Reading,
    SampleCount,
    open_port,
)
from hapticplayer.capture.live.source import LiveSource, SourceOptions
from hapticplayer.capture.live.source_answers import Declaration, ask_for_missing
from hapticplayer.capture.log_tables import SENSORS
from hapticplayer.clock import Clock
from hapticplayer.devices.options import one_of
from hapticplayer.errors import Message, UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.ranges import Range
from hapticplayer.model.spellings import column_names, find_separator, plain

NO_RATE = (math.nan,) * 3
RAZOR_FRAME_S, RAZOR_COUNTS_PER_G, RAZOR_COUNTS_PER_DPS = 0.02, 256.0, 14.375
RAZOR_LINE = re.compile(r"#([AMG])-([RC])=(.*)")
RESCALED_RATE_DPS = 14.375
"""The Ultimate IMU's firmware divides a rate by it again when it skips a gyro read."""

_BAUD = Range(1200, 4_000_000, is_whole=True)
_OTHER_BAUD = Message("give its rate, such as baud=115200, and check its output")
_COLUMNS = Message(
    "begin with the line {names}, or name the columns (--read-as columns=ax,ay,az,...)",
    names=",".join(LOG_COLUMNS),
)
_STANDARD_INPUT, _PORT = Message("standard input"), "/dev/ttyUSB0"
_WT901_RATES = {"100": 0x09, "200": 0x0B}
_WT901_SAMPLE_BYTES, _WT901_PAUSE_S = 44, 0.1
_G = STANDARD_GRAVITY_MPS2


class Wt901Decoder:
    """Frames of 11 bytes: 55, kind, four numbers, sum of the ten before.

    Frames of one sample follow each other: time (50), acceleration (51), rate (52), others.
    """

    _SIZE = 11
    _TIME, _ACCEL, _RATE = 0x50, 0x51, 0x52
    _ACCEL_UNIT = 16.0 * _G / 32768.0
    _RATE_UNIT = math.radians(2000.0) / 32768.0

    def __init__(self) -> None:
        self._rest = b""
        self._stamp_s = math.nan
        self._accel: tuple[float, ...] = ()
        self._first = 0

    def feed(self, data: bytes) -> list[Reading]:
        before = len(self._rest)
        held, at = self._rest + data, 0
        found: list[Reading] = []
        while at + self._SIZE <= len(held):
            frame = held[at : at + self._SIZE]
            if frame[0] != 0x55 or sum(frame[:10]) & 0xFF != frame[10]:
                at += 1
                continue
            self._take(frame, at - before, found)
            at += self._SIZE
        self._rest = held[at:]
        self._first -= len(data)
        return found

    def _take(self, frame: bytes, at: int, found: list[Reading]) -> None:
        kind = frame[1]
        numbers = struct.unpack("<4h", frame[2:10])
        if kind in (self._TIME, self._ACCEL) and self._accel:
            found.append(self._sample(at, NO_RATE))  # no frame with its rate came
        if kind == self._TIME:
            self._stamp_s, self._first = _time_of_day_s(frame), at
        elif kind == self._ACCEL:
            self._accel = tuple(self._ACCEL_UNIT * one for one in numbers[:3])
            if math.isnan(self._stamp_s):
                self._first = at
        elif kind == self._RATE and self._accel:
            rate = tuple(self._RATE_UNIT * one for one in numbers[:3])
            found.append(self._sample(at + self._SIZE, rate))

    def _sample(self, end: int, rate: tuple[float, ...]) -> Reading:
        made = Reading(end, end - self._first, self._stamp_s, (*self._accel, *rate))
        self._accel, self._stamp_s = (), math.nan
        return made


def _time_of_day_s(frame: bytes) -> float:
    """Seconds since 2000 of a frame with a time; NaN for one that is none."""
    year, month, day, hour, minute, second = frame[2:8]
    milliseconds = int.from_bytes(frame[8:10], "little")
    try:
        when = dt.datetime(2000 + year, month, day, hour, minute, second, tzinfo=dt.UTC)
    except ValueError:
        return math.nan
    since = when - dt.datetime(2000, 1, 1, tzinfo=dt.UTC)
    return since.total_seconds() + 1e-3 * milliseconds


def _razor_si(accel: tuple[float, ...], rate: tuple[float, ...]) -> tuple[float, ...]:
    """Counts in SI; the firmware's acceleration is the negated specific force."""
    to_mps2 = -_G / RAZOR_COUNTS_PER_G
    to_radps = math.radians(1.0 / RAZOR_COUNTS_PER_DPS)
    return (*(to_mps2 * one for one in accel), *(to_radps * one for one in rate))


class RazorTextDecoder:
    """A line for each sensor, of which three are a sample: A, M, G."""

    def __init__(self) -> None:
        self._lines = LineSplitter()
        self._held: dict[str, tuple[float, ...]] = {}
        self._size = 0

    def feed(self, data: bytes) -> list[Reading]:
        found = []
        for end, size, text in self._lines.feed(data):
            match = RAZOR_LINE.fullmatch(text.strip())
            values = _numbers(match[3].split(",")) if match else ()
            if match is None or len(values) != 3:
                self._held, self._size = {}, 0
                continue
            if match[1] == "A":
                self._held, self._size = {}, 0
            self._held[match[1]], self._size = values, self._size + size
            if "A" in self._held and "G" in self._held:
                si = _razor_si(self._held["A"], self._held["G"])
                found.append(Reading(end, self._size, math.nan, si))
                self._held, self._size = {}, 0
        return found


class RazorBinaryDecoder:
    """Nine floats, acceleration, field and rate, without a head.

    They begin behind the answer to a request for it; frames that no sensor reads show that
    bytes were lost.

    Args:
        ask_again: requests another answer.
    """

    ASK = b"#s12"
    """Asks for it."""
    _ANSWER, _SIZE = b"#SYNCH12\r\n", 36
    _LEAST_COUNTS, _MOST_COUNTS = 1e-4, 40_000.0

    def __init__(self, ask_again: Callable[[], None] = lambda: None) -> None:
        self._ask_again = ask_again
        self._rest, self._is_aligned = b"", False

    def feed(self, data: bytes) -> list[Reading]:
        held, done = self._rest + data, len(data)
        found: list[Reading] = []
        while True:
            if not self._is_aligned:
                _, answer, after = held.partition(self._ANSWER)
                if not answer:
                    held = held[1 - len(self._ANSWER) :]
                    break
                held, self._is_aligned = after, True
            if len(held) < self._SIZE:
                break
            numbers = struct.unpack("<9f", held[: self._SIZE])
            if not all(map(self._is_count, numbers)):
                self._is_aligned = False
                self._ask_again()
                continue
            held = held[self._SIZE :]
            si = _razor_si(numbers[:3], numbers[6:])
            found.append(Reading(done - len(held), self._SIZE, math.nan, si))
        self._rest = held
        return found

    def _is_count(self, one: float) -> bool:
        return one == 0.0 or self._LEAST_COUNTS < abs(one) < self._MOST_COUNTS


class UltimateImuDecoder:
    """Ten cells: ms, rate in deg/s, acceleration in g, field in gauss; LF CR."""

    _NEAR_DPS, _FAST_DPS = 0.02, 20.0

    def __init__(self) -> None:
        self._lines = LineSplitter()
        self._rate_dps: tuple[float, ...] = (0.0, 0.0, 0.0)

    def feed(self, data: bytes) -> list[Reading]:
        found = []
        for end, size, text in self._lines.feed(data):
            cells = _numbers(text.split(","))
            if len(cells) != 10:
                continue
            rate_dps, accel = cells[1:4], tuple(_G * one for one in cells[4:7])
            rate = tuple(map(math.radians, rate_dps))
            if self._is_rescaled(rate_dps):
                rate = NO_RATE
            else:
                self._rate_dps = rate_dps
            found.append(Reading(end, size + 1, 1e-3 * cells[0], (*accel, *rate)))
        return found

    def _is_rescaled(self, rate_dps: tuple[float, ...]) -> bool:
        again = (one / RESCALED_RATE_DPS for one in self._rate_dps)
        return math.hypot(*self._rate_dps) > self._FAST_DPS and all(
            abs(one - other) < self._NEAR_DPS
            for one, other in zip(rate_dps, again, strict=True)
        )


class CsvDecoder:
    """Rows of numbers, their columns named by the first line or a person.

    Args:
        names: of the columns, as in `columns=`; () for those of the first line.
        time_to_s: the unit of the time column.
        is_partial: whether the first line may lack its beginning.
    """

    def __init__(
        self,
        names: tuple[str, ...] = (),
        time_to_s: float = 1.0,
        is_partial: bool = True,
    ) -> None:
        self._lines = LineSplitter(is_partial and bool(names))
        self._names, self._time_to_s = names, time_to_s

    def feed(self, data: bytes) -> list[Reading]:
        found = []
        for end, size, text in self._lines.feed(data):
            separator = find_separator(text)
            if not self._names:
                self._names = _named_columns(column_names(text, separator))
                continue
            decimal = "," if separator != "," and "," in text else "."
            spelt = plain(text.encode(), separator, decimal).decode("ascii", "replace")
            cells = _numbers(spelt.split(separator))
            if len(cells) != len(self._names):
                continue  # a row without all cells, or another header
            row = dict(zip(self._names, cells, strict=True))
            stamp_s = self._time_to_s * row.get("time", math.nan)
            values = tuple(
                row.get(name, math.nan)
                for name in (*SENSORS["accel"], *SENSORS["rate"])
            )
            found.append(Reading(end, size, stamp_s, values))
        return found


def _named_columns(titles: tuple[str, ...]) -> tuple[str, ...]:
    """The names of a header, () where it is not that of a log in SI units."""
    names = tuple("time" if title == TIME else title for title in titles)
    return names if {"time", *SENSORS["accel"]} <= set(names) else ()


def _numbers(cells: list[str]) -> tuple[float, ...]:
    """The numbers of cells, () where one is none."""
    try:
        return tuple(float(cell) if cell.strip() else math.nan for cell in cells)
    except ValueError:
        return ()


def open_wt901(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `Wt901Decoder`; its rate is set only if a person allows it."""
    fields = options.fields({
        "baud": _BAUD.parse,
        "rate": lambda _name, value: one_of(value, _WT901_RATES),
    })  # fmt: skip
    baud, rate = int(fields.get("baud", 9600)), fields.get("rate")
    if rate is not None:
        _allow_rate(options, baud, rate)
    port = open_port(options.place(_PORT), baud)
    for command in wt901_rate_commands(rate) if rate is not None else ():
        port.write(command)
        clock.sleep_until(clock.now_s() + _WT901_PAUSE_S)
    count = SampleCount(None, (0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200))
    return _byte_source(options, clock, port, Wt901Decoder(), count)


def _allow_rate(options: SourceOptions, baud: int, rate: str) -> None:
    if BITS_OF_A_BYTE * _WT901_SAMPLE_BYTES * int(rate) > baud:
        raise UsageError(
            "{source} cannot send {rate} samples per second at {baud} baud; set it to "
            "115200 baud with its maker's program, and give baud=115200",
            source=options.source,
            rate=rate,
            baud=baud,
        )
    options.allow(
        Message("{rate} samples per second are set in the sensor and kept.", rate=rate)
    )


def wt901_rate_commands(rate: str) -> tuple[bytes, ...]:
    """Unlock, write the register of the rate (03), save."""
    rate_code = bytes((0xFF, 0xAA, 0x03, _WT901_RATES[rate], 0x00))
    return bytes.fromhex("FFAA6988B5"), rate_code, bytes.fromhex("FFAA000000")


def open_razor(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `RazorTextDecoder`; calibrated sensors as text are asked for."""
    port = _port(options, 57600)
    port.write(b"#o1#osct")
    count = SampleCount(1.0 / RAZOR_FRAME_S)
    return _byte_source(options, clock, port, RazorTextDecoder(), count)


def open_razor_binary(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `RazorBinaryDecoder`."""
    port = _port(options, 57600)
    port.write(b"#o1#oscb" + RazorBinaryDecoder.ASK)
    count = SampleCount(1.0 / RAZOR_FRAME_S)
    decoder = RazorBinaryDecoder(lambda: port.write(RazorBinaryDecoder.ASK))
    return _byte_source(options, clock, port, decoder, count)


def open_ultimate_imu(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `UltimateImuDecoder`."""
    port = _port(options, 57600)
    return _byte_source(options, clock, port, UltimateImuDecoder(), SampleCount(None))


def open_csv(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `CsvDecoder`; the names of a log in SI declare its units, others do not."""
    choices = options.choices
    names = tuple(filter(None, choices.take("columns").split(",")))
    unit = choices.take("time_unit") or "s"
    if names:
        unknown = Declaration(accel_unit="", rate_unit="")
        ask_for_missing(unknown, choices, f"{options.source}:{options.text}")
    place = options.place("-")
    link = Descriptor(0, _STANDARD_INPUT) if place == "-" else _port(options, 115200)
    decoder = CsvDecoder(names, factor(unit, TIME_UNITS, "time-unit"), place != "-")
    count = SampleCount(choices.take_rate_hz())
    return _byte_source(options, clock, link, decoder, count)


def _port(options: SourceOptions, baud: int) -> Descriptor:
    fields = options.fields({"baud": _BAUD.parse})
    return open_port(options.place(_PORT), int(fields.get("baud", baud)))


def _byte_source(
    options: SourceOptions,
    clock: Clock,
    link: Descriptor,
    decoder: Decoder,
    count: SampleCount,
) -> ByteSource:
    where = f"{options.source}:{options.text}"
    remedy = _COLUMNS if isinstance(decoder, CsvDecoder) else _OTHER_BAUD
    return ByteSource(link, decoder, clock, count, where, remedy)
