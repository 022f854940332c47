"""Live sources: an IMU on a port, a phone in the network, another program.

A person names one as NAME:PLACE[,OPTION=VALUE], such as `wt901:/dev/ttyUSB0,baud=115200`
or `phyphox:http://192.168.1.20:8080`. A source is a row with a small class; other packages
and extras add theirs with a function `live_sources()`.

What a source does not declare (unit, sign, axes) is asked once and kept for it.
"""

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple, Protocol, cast

import numpy as np
from numpy.typing import NDArray

from hapticplayer import extension
from hapticplayer.capture.agreement import own_axes
from hapticplayer.capture.choices import ACCEL_UNITS, RATE_UNITS, LogChoices, factor
from hapticplayer.capture.live import source_answers
from hapticplayer.capture.live.source_answers import Declaration
from hapticplayer.capture.live.source_clock import (
    COUNTED_SIGMA,
    QUARTZ_SIGMA,
    SourceClock,
)
from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.capture.recording import Recording
from hapticplayer.clock import Clock
from hapticplayer.devices.options import Parse, one_of
from hapticplayer.errors import InputError, Message, UsageError, entry_named
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_ACCELERATION_MPS2, MAX_ANGULAR_RATE_RADPS

LIVE_OPTION = "--imu"
CHECKED_S = 30.0
"""The last samples, which tell whether the answers about a source are right."""

_WINDOW_S, _LATE_S, _EVENLY_S, _MOST_DRIFT = 3.0, 0.5, 0.05, 2e-4
_BACK_S = 0.5
"""Stamps that go back by less come out of order; by more the clock restarted."""
USUAL_DELAY_S = 0.001
_BACKLOG_S = 60.0
"""That a source may have kept before it is heard: its first samples are so late."""


class Samples(NamedTuple):
    """Samples of one read, oldest first; perhaps none.

    Attributes:
        arrival_s: (n,) on the machine's monotonic clock: when the last byte came, less the
            time that the bytes of the sample take on their line.
        stamp_s: (n,) on the source's own clock, strictly increasing; where it has none, the
            number of the sample times its nominal period.
        accel_mps2: (n, 3) specific force in the source's axes.
        rate_radps: (n, 3) angular rate in the source's axes; NaN where it was not measured.
    """

    arrival_s: Floats
    stamp_s: Floats
    accel_mps2: Floats
    rate_radps: Floats

    @classmethod
    def of(cls, rows: Iterable[tuple[float, ...]]) -> "Samples":
        """Of rows with arrival, stamp, acceleration and rate: 8 numbers each."""
        table = np.array(list(rows), dtype=np.float64).reshape(-1, 8)
        return cls(table[:, 0], table[:, 1], table[:, 2:5], table[:, 5:8])

    def where(self, kept: NDArray[Any]) -> "Samples":
        """Those of a mask or of indices."""
        return Samples(*(part[kept] for part in self))

    def in_frame_a(self, axes: str) -> "Samples":
        """In frame A, by the axes that a source declares: right, front and up."""
        turn = axes_matrix(axes).T
        return self._replace(
            accel_mps2=self.accel_mps2 @ turn, rate_radps=self.rate_radps @ turn
        )


class SourceLost(InputError):  # noqa: N818 - what has happened
    """A source was unplugged, closed, or sends nothing that can be read.

    It may be opened again, with a new clock.
    """


class ClockRestarted(SourceLost):
    """A source sends on, by a clock that stood still or restarted."""


class LiveSource(Protocol):
    """An open source."""

    def read(self, timeout_s: float) -> Samples:
        """What has come, after waiting until then for something; raises SourceLost."""
        ...

    def close(self) -> None:
        """Let go of it; may be called again."""
        ...


Ask = Callable[[Message], bool]
"""Whether a person allows something, such as that the network is listened to."""


@dataclass(frozen=True, slots=True)
class SourceOptions:
    """What a person wrote behind the name of a source.

    Attributes:
        source: its name.
        text: after it and a colon.
        choices: answers about its numbers.
        ask: for what it must not do unasked.
    """

    source: str
    text: str
    choices: LogChoices = field(default_factory=LogChoices)
    ask: Ask = lambda _question: False

    def fields(self, named: Mapping[str, Parse]) -> dict[str, Any]:
        """The options behind the place, by name; `allow` is one of every source."""
        known = {**named, "allow": _yes_or_no}
        found: dict[str, Any] = {}
        for part in filter(None, self.text.split(",")[1:]):
            name, _, value = part.partition("=")
            if name not in known or name in found:
                raise UsageError(
                    "{source} does not understand {part!r}; give each of {known} once, "
                    "such as {name}=VALUE",
                    source=self.source,
                    part=part[:80],
                    known=", ".join(known),
                    name=next(iter(known)),
                )
            found[name] = known[name](name, value)
        return found

    def place(self, example: str) -> str:
        """The place, which has to be given."""
        text = self.text.partition(",")[0]
        if not text or "=" in text:
            raise UsageError(
                "{source} needs a place; give one, such as {option} {source}:{example}",
                source=self.source,
                option=LIVE_OPTION,
                example=example,
            )
        return text

    def allow(self, question: Message) -> None:
        """Raise UsageError unless a person allows it, by `allow=yes` or when asked."""
        if "allow=yes" in self.text.split(",") or self.ask(question):
            return
        raise UsageError(
            "{source}: {question} Allow it with {option} {source}:{text},allow=yes",
            source=self.source,
            question=question,
            option=LIVE_OPTION,
            text=self.text,
        )


def _yes_or_no(_name: str, value: str) -> str:
    return one_of(value, ("yes", "no"))


Open = Callable[[SourceOptions, Clock], LiveSource]


@dataclass(frozen=True, slots=True)
class SourceRow:
    """A kind of source.

    Attributes:
        name: as people write it.
        text: for people.
        home: of the function that opens it, as module:name; see `Open`.
        declares: its axes, sign and units.
        example: of a place.
        options: that may follow it, for people.
        least_delay_s: what its link may take at least, which no envelope shows.
    """

    name: str
    text: Message
    home: str
    declares: Declaration = field(default_factory=Declaration)
    example: str = ""
    options: str = ""
    least_delay_s: float = USUAL_DELAY_S


_HERE = "hapticplayer.capture.live"
_PORT = "/dev/ttyUSB0"
_BOARD = Message("the board's axes")
_FIRMWARE = Message("the firmware's axes: x forward, y right, z down")

_PHONE = Declaration(
    axes_words=Message("the phone's axes: x right, y top, z out of the screen")
)
_WIFI_S = 0.006
"""A wireless link takes 2 to 10 ms at least."""

SOURCES: tuple[SourceRow, ...] = (
    SourceRow("wt901", Message("WitMotion WT901 and others with its protocol"), f"{_HERE}.serial_imus:open_wt901",
        Declaration(axes_words=Message("x right, y front, z up, as printed on it")), _PORT, "`baud` (9600), `rate` (100 or 200: sets it, after asking)"),
    SourceRow("razor", Message("Razor-AHRS, text"), f"{_HERE}.serial_imus:open_razor",
        Declaration("y,x,-z", _FIRMWARE), _PORT, "`baud` (57600)"),
    SourceRow("razor-binary", Message("Razor-AHRS, binary"), f"{_HERE}.serial_imus:open_razor_binary",
        Declaration("y,x,-z", _FIRMWARE), _PORT, "`baud` (57600)"),
    SourceRow("ultimate-imu", Message("SparkFun Ultimate IMU, text of its stock firmware"), f"{_HERE}.serial_imus:open_ultimate_imu",
        Declaration(axes_words=_BOARD), _PORT, "`baud` (57600)"),
    SourceRow("csv", Message("Lines of CSV on standard input (`-`) or a port"), f"{_HERE}.serial_imus:open_csv",
        Declaration(axes_words=_BOARD), "-", "`baud` (115200)"),
    SourceRow("phyphox", Message("phyphox on a phone, which is asked"), f"{_HERE}.phones:open_phyphox",
        _PHONE, "192.168.1.20:8080", least_delay_s=_WIFI_S),
    SourceRow("sensor-server", Message("SensorServer on an Android phone, by WebSocket"), f"{_HERE}.phones:open_sensor_server",
        _PHONE, "192.168.1.20:8080", least_delay_s=_WIFI_S),
    SourceRow("sensor-logger", Message("Sensor Logger on a phone, which posts to this machine"), f"{_HERE}.phones:open_sensor_logger",
        replace(_PHONE, accel_sign=""), "8000", "`allow=yes` (listens to the network unasked)", least_delay_s=_WIFI_S),
    SourceRow("lsl", Message("A stream of LSL, by its name or type"), f"{_HERE}.lsl_source:open_lsl",
        Declaration(axes_words=Message("the stream's axes")), "NAME"),
)  # fmt: skip
"""Those of the core, in the order in which they are listed."""


def live_sources() -> tuple[SourceRow, ...]:
    """Those of the core and of extensions."""
    return tuple(extension.rows("live_sources", SourceRow, SOURCES))


def new_clock(text: str, *, is_stamped: bool) -> SourceClock:
    """A clock for the stamps of a source, which knows how far its rate may be off."""
    name = text.partition(":")[0]
    delays = (row.least_delay_s for row in live_sources() if row.name == name)
    least_s = next(delays, USUAL_DELAY_S)
    return SourceClock(QUARTZ_SIGMA if is_stamped else COUNTED_SIGMA, least_s)


def serial_ports() -> list[str]:
    """The ports of this machine that a board may be on, by their lasting names."""
    named = sorted(Path("/dev/serial/by-id").glob("*"))
    known = {one.resolve() for one in named}
    kinds = (Path("/dev").glob(f"tty{kind}*") for kind in ("USB", "ACM"))
    others = sorted(one for found in kinds for one in found if one not in known)
    return [str(one) for one in (*named, *others)]


class OpenedSource:
    """A source whose numbers are in SI, by what it declares and a person has answered.

    Attributes:
        text: as a person named it.
        row: its kind.
        declares: with the answers of a person in place.
        listener: is handed what was read, in the thread that reads; None for nobody.
    """

    def __init__(
        self,
        text: str,
        row: SourceRow,
        inner: LiveSource,
        choices: LogChoices,
        again: Callable[[], LiveSource] | None = None,
    ) -> None:
        self.text, self.row, self._inner, self._choices = text, row, inner, choices
        self._again = again
        self.declares = source_answers.answered(row.declares, choices)
        self.listener: Callable[[Samples], None] | None = None
        self._to_si = (
            factor(self.declares.accel_unit, ACCEL_UNITS, "accel-unit"),
            factor(self.declares.rate_unit, RATE_UNITS, "rate-unit"),
        )
        self.forget_clock()

    @property
    def how(self) -> Message:
        """What a person does at the other end to start it; "" for nothing."""
        return cast(Message, getattr(self._inner, "how", Message("")))

    @property
    def is_stamped(self) -> bool:
        """Whether its samples carry the time of its own clock; else they are counted."""
        return bool(getattr(self._inner, "is_stamped", True))

    def new_clock(self) -> SourceClock:
        return new_clock(self.text, is_stamped=self.is_stamped)

    def forget_clock(self) -> None:
        """Take what comes next by a clock that begins anew."""
        self._recent: deque[Samples] = deque()
        self._last_s = -np.inf
        self._window, self._before_s, self._best_s = (-np.inf, np.inf), np.inf, np.inf
        self._first_s = np.inf

    def open_again(self) -> None:
        """Open what was lost, with a new clock; what a person has allowed still holds.

        Raises:
            InputError: while it cannot be opened.
        """
        self._inner.close()
        if self._again is None:
            raise InputError("cannot be opened again", where=self.text)
        self._inner = self._again()
        self.forget_clock()

    def read(self, timeout_s: float) -> Samples:
        """See `LiveSource`."""
        samples = self._in_si(self._inner.read(timeout_s))
        if len(samples.stamp_s):
            self._recent.append(samples)
            while self._recent[0].arrival_s[-1] < samples.arrival_s[-1] - CHECKED_S:
                self._recent.popleft()
        if self.listener is not None:
            self.listener(samples)
        return samples

    def _in_si(self, samples: Samples) -> Samples:
        samples = samples.where(np.isfinite(samples.stamp_s))
        if self.is_stamped and len(samples.stamp_s):
            samples = self._without_early(samples)
            self._refuse_another_clock(samples)
        if not len(samples.stamp_s):
            return samples
        samples = samples.where(self._in_order(samples.stamp_s))
        accel, rate = own_axes((samples.accel_mps2, samples.rate_radps), self._choices)
        sign = -1.0 if self.declares.accel_sign == "-" else 1.0
        with np.errstate(all="ignore"):  # what overflows is left out
            accel, rate = accel * (sign * self._to_si[0]), rate * self._to_si[1]
            rate[~(np.abs(rate) <= MAX_ANGULAR_RATE_RADPS).all(axis=1)] = np.nan
            is_sane = np.all(np.abs(accel) <= MAX_ACCELERATION_MPS2, axis=1)
        samples = samples._replace(accel_mps2=accel, rate_radps=rate)
        return samples.where(np.asarray(is_sane))

    def _without_early(self, samples: Samples) -> Samples:
        """Those that do not come before they were measured, as with a garbled stamp.

        Raises ClockRestarted where the last one does: its clock was set.
        """
        delay_s = samples.arrival_s - samples.stamp_s
        least_s = self._best_s - _LATE_S
        if not np.isfinite(least_s):
            self._first_s = min(self._first_s, float(delay_s[0]))
            least_s = self._first_s - _BACKLOG_S
        if delay_s[-1] < least_s:
            raise ClockRestarted(
                "its clock jumped ahead by {early_s:.3g} s",
                where=self.text,
                remedy="see that nothing sets it, and the unit of its times",
                early_s=least_s - float(delay_s[-1]),
            )
        return samples.where(delay_s >= least_s)

    def _refuse_another_clock(self, samples: Samples) -> None:
        """Raise ClockRestarted where it stood still, as in a pause of its app.

        Then its samples come later for good, and evenly; those of a link that was down
        come less and less late.
        """
        delay_s = float(np.min(samples.arrival_s - samples.stamp_s))
        now_s = float(samples.arrival_s[-1])
        begin_s, least_s = self._window
        if now_s - begin_s < _WINDOW_S:
            self._window = begin_s, min(least_s, delay_s)
            return
        late_s = min(least_s, self._before_s) - self._best_s
        if late_s > _LATE_S and abs(least_s - self._before_s) < _EVENLY_S:
            raise ClockRestarted(
                "its clock stood still for {late_s:.1f} s",
                where=self.text,
                remedy="do not pause its app; record again",
                late_s=late_s,
            )
        drift_s = _MOST_DRIFT * _WINDOW_S
        self._best_s = min(self._best_s + drift_s, least_s)
        self._window, self._before_s = (now_s, delay_s), least_s

    def _in_order(self, stamp_s: Floats) -> NDArray[np.bool_]:
        """A mask of the stamps that are later than all before."""
        if stamp_s.max() < self._last_s - _BACK_S:
            raise ClockRestarted(
                "its clock restarted", where=self.text, remedy="connect it again"
            )
        before = np.maximum.accumulate(np.concatenate([[self._last_s], stamp_s]))
        self._last_s = float(before[-1])
        return np.asarray(stamp_s > before[:-1])

    def _last_samples(self) -> Samples:
        parts = zip(*(Samples.of(()), *self._recent), strict=True)
        return Samples(*(np.concatenate(part) for part in parts))

    def check_gravity(self) -> None:
        """Raise InputError where the last half minute holds none."""
        source_answers.refuse_gravity_free(self._last_samples().accel_mps2, self.text)

    def checked(self) -> Recording:
        """The last half minute, checked at rest and in turns; see `source_answers`."""
        recent = self._last_samples()
        values = recent.accel_mps2, recent.rate_radps
        declares, choices = self.row.declares, self._choices
        return source_answers.checked(
            recent.stamp_s, values, declares, choices, self.text
        )

    def close(self) -> None:
        """See `LiveSource`."""
        self._inner.close()


def open_source(
    text: str,
    clock: Clock,
    choices: LogChoices | None = None,
    ask: Ask = lambda _question: False,
) -> OpenedSource:
    """Open what a person named.

    Args:
        text: NAME:PLACE[,OPTION=VALUE].
        clock: that stamps arrivals.
        choices: answers of a person; they are kept for this source, which is why they are
            given once.
        ask: for what must not happen unasked.

    Raises:
        LogQuestion: when an answer is missing.
        InputError: when it cannot be opened.
    """
    name, _, place = text.partition(":")
    known = {row.name: row for row in live_sources()}
    row = entry_named(known, name, Message("the source"))
    choices = source_answers.with_kept(text, choices or LogChoices())
    source_answers.ask_for_missing(row.declares, choices, text)
    opening = cast(Open, extension.load(row.home))
    inner = opening(SourceOptions(name, place, choices, ask), clock)
    source_answers.keep(text, choices)
    allowed = SourceOptions(name, place, choices, lambda _question: True)
    return OpenedSource(text, row, inner, choices, lambda: opening(allowed, clock))
