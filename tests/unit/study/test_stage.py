"""Trials on the real player: what was played is reported, and what was wrong with it."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.limiter import Limits as ForceLimits
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source
from hapticplayer.rendering import shifted_and_scaled
from hapticplayer.study import session_setup
from hapticplayer.study.analysis.conduct_report import COUNTED, SYNC
from hapticplayer.study.definition import Checks, Condition, PlaybackLimits
from hapticplayer.study.player_stage import PlayerStage
from hapticplayer.study.preflight import run_checks

SECONDS, RATE_HZ = 1.0, 25
LOOSE = PlaybackLimits(1.0, 1e6, 1.0, 1e6)  # a busy machine is no fault here
NOTHING = Checks(device=False, sound=False, disk_free_mb=0, scheduling=("normal",))


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "clip.mp4"
    pictures = (np.full((72, 128, 3), 9 * i, np.uint8) for i in range(RATE_HZ))
    write_clip(path, pictures, frame_rate_hz=RATE_HZ)
    push = ForceTrack([0.0, SECONDS], [[0, 1.0, 0], [0, 1.0, 0]])
    still = ForceTrack([0.0, SECONDS], np.zeros((2, 3)))
    tracks = {"realistic": push, "none": still}
    return Source("clip", path, probe(path), tracks, None, "realistic")


def stage_of(source, device, limits=LOOSE, checks=NOTHING):
    clock = SystemClock()
    player = Player(clock, outputs=[device], audio=None)
    return PlayerStage(player, {"clip": source}, source, (limits, checks), clock), clock


def run(stage, clock, until=lambda stage: stage.is_over()):
    while not until(stage):
        clock.sleep_until(stage.player.poll())


def test_a_trial_plays_its_force_and_tells_what_was_sent(source):
    stage, clock = stage_of(source, "simulated")
    try:
        stage.player.wait_ready()
        for feedback, force_n in (("realistic", 1.0), ("none", 0.0)):
            stage.prepare(Condition("clip", feedback))
            stage.begin()
            run(stage, clock)
            played = stage.played()
            assert list(stage.player.snapshot().source.tracks) == [feedback]
            assert not any(reason.startswith("clip") for reason in played.reasons)
            figures = played.playback
            assert figures["media_s"] == pytest.approx(SECONDS, abs=0.1)
            assert figures["frames_shown"] + figures["frames_dropped"] >= 23
            assert figures["ticks"] > 100
            assert {*COUNTED, *SYNC} <= figures.keys()  # which reports read
            # the first 90 ms fade in
            assert figures["force_rms_n"][1] == pytest.approx(force_n, abs=0.25)
            assert figures["force_rms_n"][0] == pytest.approx(0.0, abs=0.05)
    finally:
        stage.player.close()


def test_a_stop_is_a_fault_and_rearming_restores_the_force(source):
    stage, clock = stage_of(source, "simulated")
    player = stage.player
    try:
        player.wait_ready()
        stage.prepare(Condition("clip", "realistic"))
        stage.begin()
        run(stage, clock, lambda _s: player.snapshot().leading.mode is Mode.FOLLOWING)
        stage.halt()
        assert player.snapshot().leading.mode is Mode.TRIPPED
        run(
            stage,
            clock,
            lambda _s: player.snapshot().leading.tick["mode"] == Mode.TRIPPED,
        )
        played = stage.played("paused")
        assert not played.is_valid
        assert played.reasons[0] == "paused"
        assert "fault:stopped" in played.reasons
        stage.rearm()
        stage.prepare(Condition("clip", "realistic"))
        stage.begin()
        run(stage, clock, lambda _s: player.snapshot().leading.mode is Mode.FOLLOWING)
    finally:
        player.close()


def test_a_trial_whose_ticks_could_not_be_recorded_is_not_valid(source, monkeypatch):
    stage, clock = stage_of(source, "simulated")
    try:
        stage.player.wait_ready()
        stage.prepare(Condition("clip", "none"))
        stage.begin()
        run(stage, clock)
        assert "record_incomplete" not in stage.played().reasons
        now = stage.player.snapshot()
        leading = replace(now.leading, record_problem="No space left")
        full = replace(now, outputs=(leading,))
        monkeypatch.setattr(stage.player, "snapshot", lambda: full)
        assert "record_incomplete" in stage.played().reasons
    finally:
        stage.player.close()


@pytest.mark.parametrize(
    ("change", "is_valid"),
    [
        ({"fault": "stopped: device not responding; test it"}, False),
        ({"note": "nobody listens", "is_unheard": True}, False),
        ({"note": "a rig moves only with the realistic feedback"}, True),
    ],
)
def test_a_fault_of_a_second_output_is_in_the_record(
    source, monkeypatch, change, is_valid
):
    stage, clock = stage_of(source, "simulated")
    try:
        stage.player.wait_ready()
        stage.prepare(Condition("clip", "none"))
        stage.begin()
        run(stage, clock)
        now = stage.player.snapshot()
        second = replace(now.leading, name="rig", **change)
        both = replace(now, outputs=(now.leading, second))
        monkeypatch.setattr(stage.player, "snapshot", lambda: both)
        played = stage.played()
        assert ("output_fault:rig" not in played.reasons) is is_valid
        assert list(played.playback["output_faults"]) == ["rig"]
    finally:
        stage.player.close()


def test_limits_make_a_playback_invalid(source):
    strict = PlaybackLimits(dropped_share=-1.0)
    stage, clock = stage_of(
        source, "none", strict, msgspec.structs.replace(NOTHING, device=True)
    )
    try:
        stage.prepare(Condition("clip", "none"))
        stage.begin()
        run(stage, clock)
        assert stage.played().reasons == ("frames_dropped", "no_device")
    finally:
        stage.player.close()


@pytest.mark.parametrize("reconstruction", list(Reconstruction))
def test_a_shifted_and_scaled_force_is_the_same_force_later(reconstruction):
    times = np.arange(0.0, 2.0, 0.01)
    force = np.sin(times)[:, None] * [1.0, -2.0, 0.5]
    track = ForceTrack(times, force, reconstruction)
    shifted = shifted_and_scaled(track, 0.3, 0.5)
    at_s = 0.3 + (np.arange(150) + 0.4) * 0.01  # never where a held value changes
    assert shifted.at(at_s) == pytest.approx(0.5 * track.at(at_s - 0.3), abs=1e-6)
    early = shifted_and_scaled(track, -0.4, 1.0)
    assert early.at(at_s - 0.4) == pytest.approx(track.at(at_s), abs=1e-6)
    assert shifted_and_scaled(track, 0.0, 1.0) is track


def test_a_session_shows_the_demonstration_of_the_device(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    made = session_setup.demonstration_source()
    track = made.tracks[session_setup.NAME]
    cap_n = ForceLimits().force_cap_n
    assert track.force_n.max(axis=0) == pytest.approx([cap_n] * 3, rel=1e-3)
    assert track.force_n.min(axis=0) == pytest.approx([-cap_n] * 3, rel=1e-3)
    assert made.clip.duration_s == pytest.approx(track.time_s[-1], abs=0.05)
    assert made.clip.width == session_setup.WIDTH


def test_checks_say_what_is_missing(tmp_path):
    player = Player(ManualClock(), outputs=["none"], audio=None)
    screen = {"width_px": 1920, "height_px": 1080, "refresh_hz": 60.0, "screens": 2}
    wanted = Checks(disk_free_mb=10**9)
    silent = {"volume_percent": 0, "is_sound_heard": False}
    found = run_checks(player, wanted, tmp_path, screen, **silent)
    bad = [check.name for check in found if not check.is_good]
    assert bad == ["device", "homed", "scheduling", "sound", "volume", "disk"]
    heard = {"volume_percent": 70, "is_sound_heard": True}
    found = run_checks(player, NOTHING, tmp_path, screen, **heard)
    assert all(check.is_good for check in found)
    player.close()
