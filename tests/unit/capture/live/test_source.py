import numpy as np
import pytest

from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.live import recorder
from hapticplayer.capture.live.source import (
    ClockRestarted,
    OpenedSource,
    Samples,
    SourceLost,
    SourceRow,
    live_sources,
    open_source,
)
from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.extras.rides.motion_scenes import simulate_motion


class Sent:
    """A source that gives what a test sends, once each."""

    def __init__(self, *parts, rest=None):
        self.parts, self.rest = list(parts), rest

    def read(self, timeout_s):
        if self.rest is not None and not self.parts:
            self.rest.sleep_until(self.rest.now_s() + timeout_s)
            return Samples.of(())
        return self.parts.pop(0)

    def close(self):
        """Nothing is held."""


ROW = SourceRow("board", Message("A board"), "")


@pytest.fixture(scope="module")
def motion():
    """A hand for 15 s, at rest for 5 s before, as a source sends it."""
    imu = simulate_motion("handheld-brisk", 3, duration_s=15.0).imu
    noise = np.random.default_rng(1).normal(0.0, 0.01, (2, 1000, 3))
    accel = np.concatenate(
        [imu.specific_force_mps2[0] + noise[0], imu.specific_force_mps2]
    )
    accel[:1000] *= 9.81 / np.linalg.norm(imu.specific_force_mps2[0])
    rate = np.concatenate([noise[1], imu.angular_rate_radps])
    time_s = np.arange(len(accel)) / 200.0
    return Samples(time_s + 100.0, time_s, accel, rate)


def opened(samples, **answers):
    return OpenedSource("board:x", ROW, Sent(samples), LogChoices(**answers))


def answer_of(question, start):
    """The answer of a question that begins so, as a choice."""
    words = next(one for one in question.answers if one.startswith(start))
    key, _, value = words.split()[0].partition("=")
    return {key.replace("-", "_"): value}


def test_a_source_that_agrees_with_gravity_is_believed(motion):
    source = opened(motion)
    source.read(0.0)
    found = source.checked()
    assert found.provenance["is_rate_compared"]
    assert found.imu.specific_force_mps2 == pytest.approx(motion.accel_mps2, abs=1e-3)


@pytest.mark.parametrize(
    ("change", "key"),
    [
        (lambda s: s._replace(accel_mps2=s.accel_mps2 * 0.7), "accel-unit=1.4"),
        (lambda s: s._replace(rate_radps=s.rate_radps * [-1, 1, 1]), "rate-axes="),
        (
            lambda s: s._replace(rate_radps=np.degrees(s.rate_radps)),
            "rate-unit=deg/s",
        ),
    ],
)
def test_gravity_shows_a_wrong_answer_and_the_right_one_is_kept(motion, change, key):
    wrong = change(motion)
    source = opened(wrong)
    source.read(0.0)
    with pytest.raises(LogQuestion, match=key) as asked:
        source.checked()
    source = opened(wrong, **answer_of(asked.value, key))
    right = source.read(0.0)
    assert right.accel_mps2 == pytest.approx(motion.accel_mps2, rel=0.02, abs=0.1)
    assert right.rate_radps == pytest.approx(motion.rate_radps, rel=0.02, abs=0.1)
    source.checked()


def test_acceleration_without_gravity_is_refused(motion):
    free = np.random.default_rng(2).normal(0.0, 1.5, motion.accel_mps2.shape)
    source = opened(motion._replace(accel_mps2=free))
    source.read(0.0)
    with pytest.raises(
        InputError, match="gravity was removed; choose its acceleration"
    ):
        source.checked()
    with pytest.raises(InputError, match="gravity was removed"):
        source.check_gravity()


@pytest.mark.realtime
@pytest.mark.parametrize(
    ("gravity", "words"),
    [(1.0, "decide with --read-as accel-unit=g"), (0.0, "removed")],
)
def test_a_recorder_tells_where_gravity_contradicts(
    motion, tmp_path, monkeypatch, gravity, words
):
    monkeypatch.setattr(recorder, "CHECK_AT_S", 0.2)
    monkeypatch.setattr(recorder, "GRAVITY_AT_S", 0.1)
    wrong = motion._replace(accel_mps2=gravity * motion.accel_mps2 / 9.80665)
    clock = SystemClock()
    source = OpenedSource("board:x", ROW, Sent(wrong, rest=clock), LogChoices())
    made = recorder.Recorder(tmp_path / "take", None, None, source, clock)
    made.start()
    until_s, told = clock.now_s() + 10.0, ""
    while words not in told and clock.now_s() < until_s:
        clock.sleep_until(clock.now_s() + 0.05)
        told = " ".join(made.snapshot().notices)
    made.stop()
    assert told.count(words) == 1


def rows(*stamps):
    return Samples.of((stamp, stamp, 0.0, 0.0, 9.8, 0.0, 0.0, 0.0) for stamp in stamps)


def test_stamps_come_out_increasing_or_end_the_source():
    source = OpenedSource(
        "board:x",
        ROW,
        Sent(rows(1.0, 1.0, 1.2), rows(1.1, 1.3), rows(0.0)),
        LogChoices(),
    )
    assert source.read(0.0).stamp_s.tolist() == [1.0, 1.2]
    assert source.read(0.0).stamp_s.tolist() == [1.3]
    with pytest.raises(SourceLost, match="its clock restarted"):
        source.read(0.0)


def at(arrival_s, stamp_s):
    return rows(stamp_s)._replace(arrival_s=np.array([arrival_s]))


def read_all(sent):
    source = OpenedSource("board:x", ROW, Sent(*sent), LogChoices())
    return np.concatenate([source.read(0.0).stamp_s for _ in sent])


def test_a_clock_that_stood_still_ends_the_source():
    """Its app was paused for 4 s: all later samples would be placed 4 s early."""
    times = np.arange(0.0, 40.0, 0.25)
    sent = [
        at(100.0 + t, t if t < 20.0 else t - 4.0) for t in times if not 20 <= t < 24
    ]
    with pytest.raises(SourceLost, match=r"stood still for 4.0 s; do not pause"):
        read_all(sent)


def test_a_link_that_was_down_catches_up_and_is_believed():
    sent = [at(100.0 + (t if t < 20.0 else max(t, 30.0 + 0.3 * (t - 20.0))), t) for t in np.arange(0.0, 60.0, 0.25)]  # fmt: skip
    assert len(read_all(sent)) == len(sent)


@pytest.mark.parametrize("begin_s", [1.0, 9.0])
@pytest.mark.parametrize("place", [1, 3])
@pytest.mark.parametrize("stamp_s", [1e9, 1e300, np.inf, np.nan, -np.inf])
def test_a_garbled_stamp_takes_no_other_samples_along(stamp_s, place, begin_s):
    sent = [rows(*(0.25 * k + 0.05 * j for j in range(4))) for k in range(60)]
    sent[round(4 * begin_s)].stamp_s[place] = stamp_s
    source = OpenedSource("board:x", ROW, Sent(*sent), LogChoices())
    found, restarts = [], 0
    for _ in sent:
        try:
            found += source.read(0.0).stamp_s.tolist()
        except ClockRestarted:
            restarts += 1
            source.forget_clock()
    assert restarts <= 1
    assert len(found) >= 4 * len(sent) - 5
    assert set(found) <= {one for part in sent for one in part.arrival_s}


def test_a_clock_that_was_set_ahead_is_another_one():
    times = np.arange(0.0, 20.0, 0.25)
    with pytest.raises(ClockRestarted, match=r"jumped ahead by 9\.5 s"):
        read_all([at(100.0 + t, t if t < 10.0 else t + 10.0) for t in times])


def test_samples_kept_before_a_source_was_heard_are_believed():
    sent = [at(100.0 + max(t, 20.0), t) for t in np.arange(0.0, 40.0, 0.25)]
    assert len(read_all(sent)) == len(sent)


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e300])
def test_samples_that_no_sensor_reads_are_left_out(value):
    samples = rows(1.0, 2.0, 3.0)
    samples.accel_mps2[0, 1] = value
    samples.rate_radps[1, 0] = value
    read = OpenedSource("board:x", ROW, Sent(samples), LogChoices()).read(0.0)
    assert read.stamp_s.tolist() == [2.0, 3.0]
    assert np.isnan(read.rate_radps[0]).all()


def test_an_unknown_source_and_a_missing_place_are_told():
    with pytest.raises(
        UsageError, match="the source 'wt9' not found; choose one of wt901"
    ):
        open_source("wt9:/dev/ttyUSB0", ManualClock())
    with pytest.raises(
        UsageError, match="needs a place; give one, such as --imu wt901:/dev"
    ):
        open_source("wt901", ManualClock())


@pytest.mark.parametrize("row", live_sources(), ids=lambda row: row.name)
def test_each_source_opens_by_its_row_or_says_what_to_do(row, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    with pytest.raises((InputError, UsageError), match=r";|decide with|Allow"):
        open_source(f"{row.name}:{tmp_path}/none,gain=1", ManualClock())
