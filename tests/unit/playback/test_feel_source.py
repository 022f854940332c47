"""A live source that is felt: from its samples to the newest force, on virtual time."""

import math

import pytest

from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.live.source import (
    SOURCES,
    ClockRestarted,
    OpenedSource,
    Samples,
    SourceLost,
)
from hapticplayer.clock import ManualClock
from hapticplayer.errors import UsageError
from hapticplayer.model import Mapping
from hapticplayer.playback.feel import Feel, FeelPhase
from tests.rigs import loaded

PERIOD_S, G = 0.01, 9.80665
REST = (0.0, 0.0, G, 0.0, 0.0, 0.0)
NAN = (math.nan,) * 3


class Inner:
    """A source whose samples a test sets."""

    def __init__(self):
        self.rows, self.is_lost, self.is_another = [], False, False

    def read(self, _timeout_s):
        if self.is_another:
            self.is_another = False
            raise ClockRestarted("its clock restarted", where="port")
        if self.is_lost:
            raise SourceLost("was unplugged or closed", where="port", remedy="connect")
        rows, self.rows = self.rows, []
        return Samples.of(rows)

    def close(self):
        pass


class Desk:
    """A sensor, a player that only keeps what it is given, and time in steps."""

    def __init__(self, mapping=None, mounting=""):
        self.clock, self.inner = ManualClock(), Inner()
        row = next(one for one in SOURCES if one.name == "csv")
        self.source = OpenedSource("csv:test", row, self.inner, LogChoices())
        self.live = self.stopped = None
        self.feel_ = Feel(self, self.source, mapping or Mapping(), self.clock, mounting)
        self.feel_.start(is_read=True)

    def feel(self, force):
        self.live = force
        self.track = force and loaded(force.scaled("one", (1.0, 1.0, 1.0)))

    def stop_force(self):
        self.stopped = True

    def send(self, *samples, seconds=PERIOD_S):
        """Send these in one read, again and again; what is shown afterwards."""
        for _ in range(round(seconds / PERIOD_S)):
            self.clock.advance(PERIOD_S)
            now_s, step_s = self.clock.now_s(), PERIOD_S / max(1, len(samples))
            ages_s = [step_s * back for back in range(len(samples))][::-1]
            self.inner.rows = [
                (now_s, now_s - age_s, *one)
                for age_s, one in zip(ages_s, samples, strict=True)
            ]
            self.source.read(0.0)
        return self.feel_.snapshot()

    def force_n(self):
        return self.track.force_at(self.clock.now_s() + 1.0)


def pushed(z_mps2):
    return (0.0, 0.0, G + z_mps2, 0.0, 0.0, 0.0)


@pytest.fixture
def desk():
    made = Desk()
    made.send(REST, seconds=1.6)
    return made


def test_a_sensor_has_to_rest_before_it_is_felt():
    desk = Desk()
    state = desk.send(pushed(5.0), (0.0, 5.0, G, 0.0, 3.0, 0.0), seconds=2.0)
    assert (state.phase, state.force_n) == (FeelPhase.WAITING, (0.0, 0.0, 0.0))
    assert desk.track.is_silent(desk.clock.now_s())
    assert "rest" in state.text
    state = desk.send(REST, seconds=1.0)
    assert 0.4 < state.rested_share < 1.0
    assert desk.send(REST, seconds=0.6).phase is FeelPhase.FELT


def test_the_newest_sample_of_a_read_is_felt_through_the_mapping(desk):
    state = desk.send(pushed(1.0), pushed(2.0))
    assert state.force_n == pytest.approx((0.0, 0.8, 0.0), abs=0.02)  # up is up
    assert state.acceleration_mps2 == pytest.approx((0.0, 0.0, 2.0), abs=0.05)
    assert desk.force_n() == pytest.approx(state.force_n, abs=1e-6)
    assert state.rate_hz == pytest.approx(100.0, abs=3.0)
    desk.feel_.set_mapping(Mapping(gain_n_per_mps2=1.0))
    assert desk.send(pushed(2.0)).force_n[1] == pytest.approx(2.0, abs=0.05)
    assert desk.send(pushed(90.0)).force_n[1] == pytest.approx(4.5, abs=1e-6)


def test_the_axes_of_a_mounting_turn_the_force():
    desk = Desk(mounting="-x,-y,z")  # facing backward
    desk.send(REST, seconds=1.6)
    state = desk.send((2.0, 0.0, G, 0.0, 0.0, 0.0))
    assert state.force_n == pytest.approx((-0.8, 0.0, 0.0), abs=0.02)


@pytest.mark.parametrize(
    "bad",
    [(*NAN, *NAN), (math.inf, 0, G, 0, 0, 0), (0, 0, 4000.0, 0, 0, 0)],
    ids=["nan", "inf", "spike"],
)
def test_samples_that_cannot_be_used_are_silence(desk, bad):
    before_n = desk.send(pushed(2.0)).force_n
    state = desk.send(bad, seconds=0.09)
    assert (state.phase, state.force_n) == (FeelPhase.FELT, before_n)
    state = desk.send(bad, seconds=0.03)
    assert state.phase is FeelPhase.SILENT
    assert desk.track.is_silent(desk.clock.now_s())
    assert desk.send(pushed(2.0)).phase is FeelPhase.FELT  # at once: the gap was short


def test_a_good_sample_before_a_bad_one_is_felt(desk):
    state = desk.send(pushed(2.0), (*NAN, *NAN))
    assert state.force_n[1] == pytest.approx(0.8, abs=0.02)


def test_an_angular_rate_counts_for_samples_between_two(desk):
    state = desk.send((*REST[:3], 0.0, 0.0, 1.0), (0.0, 0.0, G + 1.0, *NAN))
    assert state.force_n[1] == pytest.approx(0.4, abs=0.02)


def test_a_source_without_a_gyroscope_says_so():
    desk = Desk()
    state = desk.send((0.0, 0.0, G, *NAN), seconds=3.5)
    assert state.phase is FeelPhase.LOST
    assert "gyroscope" in state.text


def test_a_reading_in_another_unit_is_told_at_rest():
    desk = Desk()
    state = desk.send((0.0, 0.0, 1.0, 0.0, 0.0, 0.0), seconds=2.0)
    assert state.phase is FeelPhase.LOST
    assert "gravity is 9.8" in state.text


def test_a_long_silence_asks_for_another_rest(desk):
    desk.clock.advance(2.0)
    assert desk.feel_.snapshot().phase is FeelPhase.SILENT
    assert desk.send(pushed(2.0)).phase is not FeelPhase.FELT
    assert desk.send(REST, seconds=1.7).phase is FeelPhase.FELT


@pytest.mark.parametrize("step_s", [0.08, 0.3], ids=["slow", "in-batches"])
def test_a_source_in_jerks_says_so_until_it_is_silent(desk, step_s):
    said = []
    for _ in range(20):
        desk.clock.advance(step_s)
        desk.send(*[REST] * 10)
        said.append(desk.feel_.snapshot().text)
        desk.clock.advance(0.11)  # too long between two
        said.append(desk.feel_.snapshot().text)
    (only,) = set(said[20:])
    assert "set it to 100" in only
    desk.clock.advance(2.0)
    assert "nothing comes" in desk.feel_.snapshot().text


def test_a_source_that_is_lost_says_why():
    desk = Desk()
    desk.inner.is_lost = desk.inner.is_another = True  # which it reads beyond
    desk.feel_.start()  # with a thread of its own
    desk.feel_.stop()
    state = desk.feel_.snapshot()
    assert state.phase is FeelPhase.LOST
    assert "unplugged" in state.text


def test_after_the_end_nothing_is_felt_or_heard(desk):
    desk.feel_.stop_force()
    desk.feel_.stop()
    assert desk.stopped
    assert desk.live is None
    before = desk.feel_.summary()
    desk.send(pushed(1.0))
    assert desk.feel_.summary() == before
    assert before["felt_s"] == pytest.approx(0.08, abs=0.03)


def test_a_lever_arm_is_refused():
    with pytest.raises(UsageError, match="lever arm"):
        Desk(Mapping(lever_arm_m=(0.0, 0.0, 0.5)))
