"""Frames whose rotation is made up, with the errors that real ones have."""

import re
from dataclasses import fields, replace

import numpy as np
import pytest

from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.mounting import all_mountings, axes_matrix
from hapticplayer.capture.sync import synchronize as module
from hapticplayer.capture.sync.result import Pat, Synchronisation, SyncInput
from hapticplayer.capture.sync.synchronize import automatic, joined_findings
from hapticplayer.cli.recording_options import sync_text
from hapticplayer.errors import InputError, MediaError, UsageError
from hapticplayer.extras.frames import own_clock
from hapticplayer.extras.frames.synchronizing import (
    LONG_S,
    find_mounting,
    liveliest_s,
    spans_to_watch,
    synchronize_frames,
)
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.sequence.synchronizing import uncertainty

CLIP_S = 30.0
FRAME_S = 1 / 30.0
NOISE_RAD = 2e-4
FOCAL_GAIN = 0.9


class Ride:
    """Random angles about three axes, as a sum of sines."""

    def __init__(self, seed: int, rms_radps: float = 0.1) -> None:
        rng = np.random.default_rng(seed)
        self.hz = rng.uniform(0.2, 6.0, (40, 3))
        self.phase = rng.uniform(0.0, 2 * np.pi, (40, 3))
        self.size = rms_radps * np.sqrt(2 / 40) / (2 * np.pi * self.hz)

    def angles(self, time_s: np.ndarray) -> np.ndarray:
        """(N, 3) rad; small enough that they add."""
        waves = np.sin(2 * np.pi * self.hz * time_s[:, None, None] + self.phase)
        return (self.size * waves).sum(axis=1)

    def log(
        self,
        clock: ClockMap,
        axes: str = "x,y,z",
        rate_hz: float = 200.0,
        duration_s: float = CLIP_S,
    ) -> ImuLog:
        """What a logger wrote from 10 s before the clip to 15 s after it."""
        media_s = np.arange(-10.0, duration_s + 15.0, 1 / rate_hz)
        half_s = 0.5 / rate_hz
        rate = (self.angles(media_s + half_s) - self.angles(media_s - half_s)) * rate_hz
        rng = np.random.default_rng(5)
        rate = rate @ axes_matrix(axes) + rng.normal(0.02, 0.002, rate.shape)
        own_s = (media_s - clock.offset_s) / clock.rate
        return ImuLog(own_s, np.zeros_like(rate), rate, sampling=Sampling.AVERAGED)

    def frames(
        self, read_out_s: float = 0.0, row: float = -0.1, begin_s: float = 0.0
    ) -> FrameRotation:
        """What frames tell, with a focal gain, noise and a rolling shutter."""
        starts_s = np.arange(begin_s, begin_s + CLIP_S, FRAME_S)
        end_s = starts_s + FRAME_S

        def turned(at: float) -> np.ndarray:
            late_s = at * read_out_s
            return self.angles(end_s + late_s) - self.angles(starts_s + late_s)

        rng = np.random.default_rng(9)
        gains = np.array([FOCAL_GAIN, 1.0, FOCAL_GAIN])
        rotation_rad = gains * turned(row) + rng.normal(0.0, NOISE_RAD, (len(end_s), 3))
        return FrameRotation(
            starts_s,
            end_s,
            rotation_rad,
            np.ones(len(end_s)),
            np.full((len(end_s), 3), row),
            gains * (turned(0.5) - turned(-0.5)),
        )


class Nod(Ride):
    """Some seconds of it; before and after the camera is still."""

    def angles(self, time_s: np.ndarray) -> np.ndarray:
        """(N, 3) rad, around 5 s."""
        return super().angles(time_s) * np.exp(-(((time_s - 5.0) / 2.5) ** 4))[:, None]


class Bend(Ride):
    """A car that turns once, at 12 s; the road shakes it about all axes."""

    def __init__(self, seed: int) -> None:
        super().__init__(seed, rms_radps=0.008)
        self.turn_s = np.random.default_rng(seed).uniform(0.45, 0.5)

    def angles(self, time_s: np.ndarray) -> np.ndarray:
        """(N, 3) rad."""
        turn = 0.4 * np.tanh((time_s - 12.0) / self.turn_s)
        return super().angles(time_s) + turn[:, None] * np.array([0.0, 0.0, 1.0])


def error_s(found: Synchronisation, clock: ClockMap) -> float:
    """Error at the middle of the clip."""
    middle_s = CLIP_S / 2
    return found.media_s((middle_s - clock.offset_s) / clock.rate) - middle_s


@pytest.mark.parametrize(
    ("rate_hz", "offset_s", "drift_ppm", "axes"),
    [
        (200.0, 0.0, 0.0, "x,y,z"),
        (1000.0, 3.1, 20.0, "-x,-y,z"),
        (200.0, -37.3, 80.0, "-z,y,x"),
        (30.0, 52.1, -80.0, "y,-x,z"),
    ],
)
def test_offset_is_found_whatever_the_axes(rate_hz, offset_s, drift_ppm, axes) -> None:
    ride, clock = Ride(1), ClockMap(offset_s, 1.0 + 1e-6 * drift_ppm)

    found = synchronize_frames(ride.log(clock, axes, rate_hz), ride.frames())

    assert found.is_confident
    assert abs(error_s(found, clock)) < 0.001
    assert found.frames is not None
    assert found.frames.explained > 0.95


def test_clock_rate_of_a_long_clip_is_found() -> None:
    ride, clock = Ride(1), ClockMap(3.0, 1.0 + 80e-6)
    parts = [ride.frames(begin_s=begin_s) for begin_s, _ in spans_to_watch(400.0)]
    joined = (
        np.concatenate([getattr(one, f.name) for one in parts])
        for f in fields(FrameRotation)
        if f.name != "kind"
    )

    found = synchronize_frames(
        ride.log(clock, duration_s=400.0), FrameRotation(*joined)
    )

    assert found.drift_ppm == pytest.approx(80.0, abs=3.0 * found.drift_sigma_ppm)
    assert found.drift_sigma_ppm < 10.0


@pytest.mark.parametrize("read_out_s", [0.0, 0.012, 0.03])
def test_rolling_shutter_does_not_bias(read_out_s) -> None:
    ride, clock = Ride(2), ClockMap(1.5)

    found = synchronize_frames(ride.log(clock), ride.frames(read_out_s, row=-0.2))

    assert abs(error_s(found, clock)) < 0.0012
    assert abs(error_s(found, clock)) < 2.0 * found.offset_sigma_s
    assert found.frames is not None
    assert found.frames.read_out_s == pytest.approx(read_out_s, abs=0.005)


@pytest.mark.parametrize("seed", range(10, 14))
def test_log_of_another_ride_is_not_believed(seed) -> None:
    found = synchronize_frames(Ride(seed).log(ClockMap()), Ride(1).frames())

    assert found.clock_map.confidence < 0.1


def test_cut_and_gap_do_not_matter() -> None:
    ride, clock = Ride(3), ClockMap(4.0)
    frames, imu = ride.frames(), ride.log(clock)
    quality = frames.quality.copy()
    rotation_rad = frames.rotation_rad.copy()
    quality[300:340], rotation_rad[300:340] = 0.0, 0.4
    away = (imu.time_s > 10.0) & (imu.time_s < 12.0)
    imu = ImuLog(
        imu.time_s[~away],
        imu.specific_force_mps2[~away],
        imu.angular_rate_radps[~away],
        sampling=imu.sampling,
    )

    found = synchronize_frames(
        imu, replace(frames, quality=quality, rotation_rad=rotation_rad)
    )

    assert found.is_confident
    assert abs(error_s(found, clock)) < 0.001


@pytest.mark.parametrize("span_s", [(8.0, 20.0), (18.0, 60.0), (-20.0, 12.0)])
def test_log_of_a_part_of_the_clip_is_believed(span_s) -> None:
    ride, clock = Ride(3), ClockMap(4.0)
    imu = ride.log(clock)
    media_s = imu.time_s + clock.offset_s
    kept = (media_s < span_s[0]) | (media_s > span_s[1])
    imu = ImuLog(
        imu.time_s[kept],
        imu.specific_force_mps2[kept],
        imu.angular_rate_radps[kept],
        sampling=imu.sampling,
    )

    found = synchronize_frames(imu, ride.frames())

    assert found.is_confident
    assert abs(error_s(found, clock)) < 0.001


@pytest.mark.parametrize("drift_ppm", [-80.0, 0.0, 80.0])
def test_seconds_of_turning_are_enough_and_tell_no_clock_rate(drift_ppm) -> None:
    ride, clock = Nod(1, 0.5), ClockMap(7.0, 1.0 + 1e-6 * drift_ppm)

    found = synchronize_frames(ride.log(clock), ride.frames())

    assert found.is_confident
    log_s = (5.0 - clock.offset_s) / clock.rate
    assert abs(found.media_s(log_s) - 5.0) < 0.001
    assert abs(found.drift_ppm - drift_ppm) < 2.0 * found.drift_sigma_ppm


def test_slow_film_is_asked_for_its_frame_rate() -> None:
    ride = Ride(1)
    frames = ride.frames()
    slower = replace(frames, begin_s=frames.begin_s / 1.001, end_s=frames.end_s / 1.001)

    found = synchronize_frames(ride.log(ClockMap()), slower)

    assert not found.is_confident
    assert found.frames is not None
    assert "ppm" in found.frames.doubt
    assert found.frames.doubt.values["ppm"] == pytest.approx(1000.0, abs=300.0)


def test_turning_of_another_ride_is_not_believed() -> None:
    found = synchronize_frames(Nod(2, 0.5).log(ClockMap()), Nod(1, 0.5).frames())

    assert not found.is_confident


@pytest.mark.parametrize("seed", range(2, 6))
def test_same_bend_of_another_ride_is_not_believed(seed) -> None:
    frames = Bend(1).frames()
    near = frames.select((frames.begin_s >= 8.0) & (frames.end_s <= 16.0))

    own = synchronize_frames(Bend(1).log(ClockMap(2.0)), near)
    other = synchronize_frames(Bend(seed).log(ClockMap(2.0)), near)

    assert own.is_confident
    assert abs(own.media_s(10.0) - 12.0) < 0.004
    assert other.frames is not None
    assert other.frames.explained > 0.8
    assert not other.is_confident
    assert "one axis" in other.frames.doubt


class Swing(Ride):
    """The same swing again and again, as a test camera or a person who nods."""

    def angles(self, time_s: np.ndarray) -> np.ndarray:
        """(N, 3) rad, about one axis; it repeats after 2.5 s but for a little."""
        swing = 0.3 * np.sin(2 * np.pi * 0.4 * time_s) + 0.02 * np.sin(time_s)
        return swing[:, None] * np.array([0.0, 1.0, 0.0])


@pytest.mark.parametrize(
    ("known_s", "is_sure"), [(None, False), (0.02, True), (0.6, False)]
)
def test_the_recorders_clock_decides_between_equal_swings(known_s, is_sure) -> None:
    near_s = None if known_s is None else (known_s - 0.15, known_s + 0.15)
    imu = Swing(1).log(ClockMap())

    found = synchronize_frames(imu, Swing(1).frames(), is_own=True, near_s=near_s)

    assert found.is_confident == is_sure
    if is_sure:
        assert abs(error_s(found, ClockMap())) < 0.002


def test_a_bend_is_enough_for_the_own_log_of_a_clip() -> None:
    frames, imu = Bend(1).frames(), Bend(1).log(ClockMap())
    near = frames.select((frames.begin_s >= 8.0) & (frames.end_s <= 16.0))
    noise_rad = np.random.default_rng(6).normal(0.0, 3e-4, near.rotation_rad.shape)
    near = replace(near, rotation_rad=near.rotation_rad + noise_rad)

    one = own_clock.by_frames(SyncInput(imu, lambda: None, look=lambda: near))
    own = own_clock.by_frames(
        SyncInput(imu, lambda: None, own=ClockMap(), look=lambda: near)
    )

    assert not one.is_confident
    assert own.is_confident
    assert own.clock_map.offset_s == one.clock_map.offset_s


@pytest.mark.parametrize("slower", [1.2, 1 / 1.001])
def test_frames_played_at_another_rate_are_not_believed(slower) -> None:
    ride = Ride(1)
    frames = ride.frames()
    begin_s, end_s = slower * frames.begin_s, slower * frames.end_s
    slower = replace(frames, begin_s=begin_s, end_s=end_s)

    assert not synchronize_frames(ride.log(ClockMap()), slower).is_confident


@pytest.mark.parametrize("cut_s", [12.0, 20.0])
def test_clip_of_which_seconds_were_cut_out_is_not_believed(cut_s) -> None:
    ride = Ride(1)
    frames = ride.frames()
    kept = (frames.end_s < cut_s) | (frames.begin_s > cut_s + 5.0)
    earlier_s = np.where(frames.begin_s > cut_s, 5.0, 0.0)[kept]
    cut = frames.select(kept)
    cut = replace(cut, begin_s=cut.begin_s - earlier_s, end_s=cut.end_s - earlier_s)

    assert synchronize_frames(ride.log(ClockMap()), frames).is_confident
    found = synchronize_frames(ride.log(ClockMap()), cut)
    assert not found.is_confident
    assert found.frames is not None
    assert found.frames.doubt


def test_mirrored_frames_keep_their_time() -> None:
    ride, clock = Ride(1), ClockMap(2.0)
    frames = ride.frames()
    mirrored = frames.rotation_rad * np.array([1.0, -1.0, -1.0])

    found = synchronize_frames(ride.log(clock), replace(frames, rotation_rad=mirrored))

    # as if the logger were turned over: gravity has to say that it was not
    assert abs(error_s(found, clock)) < 0.001


def test_still_camera_or_no_gyro_is_refused() -> None:
    ride = Ride(1)
    frames, imu = ride.frames(), ride.log(ClockMap())
    blind = replace(frames, quality=np.zeros(len(frames)))
    no_gyro = replace(imu, angular_rate_radps=np.zeros((len(imu), 3)))

    with pytest.raises(InputError, match=r"only 0\.00 s of the video, at least 5 s"):
        synchronize_frames(imu, blind)
    with pytest.raises(InputError, match="no angular rate"):
        synchronize_frames(no_gyro, frames)
    still = replace(
        frames, rotation_rad=np.random.default_rng(3).normal(0, 1e-4, (len(frames), 3))
    )
    assert not synchronize_frames(imu, still).is_confident


def test_long_clips_are_looked_at_in_parts() -> None:
    assert spans_to_watch(50.0) == [(0.0, 50.0)]
    spans = spans_to_watch(3600.0)
    assert spans[0][0] == 0.0
    assert spans[-1][1] == pytest.approx(3600.0)
    assert sum(end - begin for begin, end in spans) <= LONG_S


# --- mounting --------------------------------------------------------------------------


@pytest.mark.parametrize("axes", all_mountings())
def test_mounting_is_found(axes) -> None:
    ride, clock = Ride(4), ClockMap(-3.0, 1.00003)

    found = find_mounting(ride.log(clock, axes), ride.frames(), clock)

    assert found.axes == axes
    assert found.ratio > 3.0


def test_mounting_is_told_when_synchronising() -> None:
    ride, clock = Ride(4), ClockMap(-3.0, 1.00003)

    found = synchronize_frames(ride.log(clock, "-x,z,y"), ride.frames())

    assert found.mounting is not None
    assert found.mounting.axes == "-x,z,y"
    assert found.mounting.is_clear
    words = sync_text(found.described())
    assert "  mounting -x,z,y by the frames, ratio" in words
    assert re.search(r"drift [+-][\d.]+ ± [\d.]+ ppm", words)
    assert re.search(r"read-out -?\d+ ± \d+ ms", words)


def test_turning_about_one_axis_does_not_tell_the_mounting() -> None:
    ride = Ride(4)
    ride.size[:, 1:] = 0.0

    found = find_mounting(ride.log(ClockMap()), ride.frames(), ClockMap())

    assert not found.is_clear


# --- together with pats ----------------------------------------------------------------


def by_pats(offset_s: float, confidence: float) -> Synchronisation:
    pats = tuple(Pat(offset_s + at, at, 0.01, 0.01) for at in (2.0, 2.5, 3.0))
    return Synchronisation(
        ClockMap(offset_s, 1.0, 0.003, confidence),
        "pats",
        pats=pats,
        offset_sigma_s=0.003,
        drift_sigma_ppm=50.0,
    )


@pytest.fixture(scope="module")
def found_by_frames() -> Synchronisation:
    ride = Ride(1)
    return synchronize_frames(ride.log(ClockMap(1.0)), ride.frames())


def with_confidence(found: Synchronisation, confidence: float) -> Synchronisation:
    return replace(found, clock_map=replace(found.clock_map, confidence=confidence))


def test_agreement_raises_the_confidence(found_by_frames) -> None:
    first = with_confidence(found_by_frames, 0.7)

    both = joined_findings(by_pats(1.004, 0.6), first)

    assert both.clock_map.confidence == pytest.approx(0.88)
    assert both.method == "frames"
    assert len(both.pats) == 3
    assert both.clock_map.offset_s == first.clock_map.offset_s
    assert both.mounting == first.mounting


def test_doubtful_frames_only_support_the_pats(found_by_frames) -> None:
    both = joined_findings(by_pats(1.004, 0.8), with_confidence(found_by_frames, 0.3))

    assert both.method == "pats"
    assert both.clock_map.offset_s == 1.004
    assert both.clock_map.confidence == pytest.approx(0.86)


def test_certain_ones_that_differ_are_a_question(found_by_frames) -> None:
    both = joined_findings(by_pats(1.1, 0.9), found_by_frames)

    assert not both.is_confident
    assert both.second is not None
    assert both.second.is_confident


@pytest.mark.parametrize(
    ("pats_sure", "frames_sure", "taken"),
    [(0.9, 0.2, "pats"), (0.2, 0.9, "frames"), (0.1, 0.3, "frames")],
)
def test_the_certain_one_is_taken(
    found_by_frames, pats_sure, frames_sure, taken
) -> None:
    other = with_confidence(found_by_frames, frames_sure)

    found = joined_findings(by_pats(7.0, pats_sure), other)

    assert found.method == taken
    assert found.is_confident == (max(pats_sure, frames_sure) > 0.5)


def test_auto_uses_what_there_is(found_by_frames, monkeypatch) -> None:
    imu = Ride(1).log(ClockMap(1.0))

    def missing() -> object:
        raise InputError("there is none")

    frames = Ride(1).frames()
    found = automatic(SyncInput(imu, missing, look=lambda: frames))
    assert found.method == "frames"
    assert found.is_confident

    monkeypatch.setattr(module, "by_pats", lambda _inputs: by_pats(2.0, 0.9))
    assert automatic(SyncInput(imu, missing, look=missing)).method == "pats"
    monkeypatch.undo()

    def unreadable() -> FrameRotation:
        raise MediaError("no vectors", remedy="install this")

    with pytest.raises(InputError, match=r"there is none; no vectors; install this"):
        automatic(SyncInput(imu, missing, look=unreadable))

    def dark() -> FrameRotation:
        raise InputError("too dark", remedy="use another method")

    with pytest.raises(InputError, match=r"there is none; too dark$"):
        automatic(SyncInput(imu, missing, look=dark))


def test_a_doubt_tells_of_both_methods(found_by_frames, monkeypatch) -> None:
    imu, doubtful = Ride(1).log(ClockMap(1.0)), with_confidence(found_by_frames, 0.3)
    seen = replace(doubtful.frames, doubt="was the video cut?")
    doubtful = replace(doubtful, frames=seen)

    def dark() -> FrameRotation:
        raise InputError("too dark")

    monkeypatch.setattr(module, "by_pats", lambda _inputs: by_pats(7.0, 0.4))
    alone = automatic(SyncInput(imu, lambda: None, look=dark))
    assert "taps are uncertain (confidence 0.40)" in uncertainty(alone, "ride.mp4")
    assert "too dark" in uncertainty(alone, "ride.mp4")

    words = uncertainty(joined_findings(by_pats(7.0, 0.4), doubtful), "ride.mp4")
    assert "taps are uncertain" in words
    assert "the gyro explains 99%" in words
    assert "was the video cut?" in words
    nowhere = replace(doubtful, frames=None)
    words = uncertainty(joined_findings(by_pats(7.0, 0.4), nowhere), "ride.mp4")
    assert "fits the log nowhere" in words
    no_pats = replace(by_pats(7.0, 0.0), pats=())
    words = uncertainty(joined_findings(no_pats, doubtful), "ride.mp4")
    assert "the frames are uncertain" in words
    assert "no three taps" in words


def test_a_log_without_a_gyro_is_refused_at_once() -> None:
    imu = Ride(1).log(ClockMap())
    no_gyro = replace(imu, angular_rate_radps=np.zeros((len(imu), 3)))

    with pytest.raises(InputError, match=r"no angular rate.*--sync pats"):
        own_clock.by_frames(SyncInput(no_gyro, lambda: None, look=pytest.fail))


def test_coarse_frames_are_less_certain(found_by_frames) -> None:
    ride, clock = Ride(1), ClockMap(1.0)
    frames = replace(ride.frames(), kind=FeatureKind.VECTORS)

    found = synchronize_frames(ride.log(clock), frames)

    assert found.is_confident
    assert found.is_coarse
    assert found.clock_map.confidence < 0.85 * found_by_frames.clock_map.confidence
    assert found.offset_sigma_s > 1.8 * found_by_frames.offset_sigma_s
    assert found.described()["frames"]["kind"] == "vectors"
    assert not found_by_frames.is_coarse
    # pats that are as certain are the more exact ones
    both = joined_findings(by_pats(1.004, 0.9), found)
    assert both.mounting is not None
    assert both.method == "pats"
    assert both.clock_map.confidence > 0.97
    assert both.is_coarse
    doubtful = joined_findings(by_pats(1.004, 0.3), found)
    assert doubtful.method == "frames"


def test_frames_need_a_clip() -> None:
    with pytest.raises(UsageError, match="needs a clip"):
        own_clock.by_frames(SyncInput(Ride(1).log(ClockMap()), lambda: None))


def test_the_liveliest_part_of_a_placed_log_is_watched():
    time_s = np.arange(-300, 6300) / 100.0
    rate = np.zeros((len(time_s), 3))
    rate[(time_s > 31.0) & (time_s < 39.0), 1] = 0.5
    rate[time_s < -1.0, 1] = 3.0  # before the clip
    begin_s, end_s = liveliest_s(ImuLog(time_s, rate + 9.8, rate), 60.0)
    assert (begin_s <= 31.0, end_s >= 39.0, end_s - begin_s) == (True, True, 12.0)
