"""Telemetry of clips that were cut or joined stays with the frames it was recorded with."""

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.capture.recording import OtherPlace, Recording
from hapticplayer.capture.sync.result import SyncInput
from hapticplayer.capture.sync.synchronize import automatic, by_own_clock
from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.mp4 import ClipTrack, Edit, hidden_s, shown_at, tracks_of
from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.store import open_sequence
from hapticplayer.sequence.synchronizing import SyncChoices, contradicted
from tests.unit.capture.conftest import device, sensor

BURST_S = 6.25
RATE_HZ = 200.0


def payload(number: int, *, stamp_s: float | None = None, total: int | None = None):
    """A second of a camera that is shaken once, `BURST_S` after its start."""
    time_s = number + np.arange(200) / RATE_HZ
    force = np.tile((9.80665, 0.0, 0.0), (200, 1))
    force[np.abs(time_s - BURST_S) < 0.05, 0] += 12.0
    rate = np.stack([0.01 * np.sin(time_s), 0 * time_s, 0 * time_s], axis=1)
    stamp_s = 1.0 + number if stamp_s is None else stamp_s
    own = {"stamp_us": round(1e6 * stamp_s)} if stamp_s >= 0 else {}
    total = 200 * (number + 1) if total is None else total
    streams = [
        sensor("ACCL", force, total=total, **own),
        sensor("GYRO", rate, total=total, **own),
    ]
    if own:
        streams.append(sensor("SHUT", [[1.0]] * 30, **own))
    return device("HERO9 Black", *streams)


def clip(*pieces: tuple[range, float], **own) -> list[TelemetryPacket]:
    """Seconds of the recording, each piece with the media time of its first payload."""
    return [
        TelemetryPacket(begin_s + number - numbers[0], 1.0, payload(number, **own))
        for numbers, begin_s in pieces
        for number in numbers
    ]


def burst_s(recording: Recording) -> float:
    imu, clock = recording.imu, recording.clock_map
    excess = np.abs(np.linalg.norm(imu.specific_force_mps2, axis=1) - 9.80665)
    return float(np.mean(imu.time_s[excess > 6.0])) * clock.rate + clock.offset_s


def test_a_whole_clip_is_placed_by_its_stamps():
    recording = read_gopro(clip((range(14), 0.0)))
    assert burst_s(recording) == pytest.approx(BURST_S, abs=0.003)
    assert recording.placing.contradiction(14.0) is None


@pytest.mark.parametrize("is_stamped", [True, False])
@pytest.mark.parametrize("begin_s", [-0.3, -0.97, 1.7])
def test_a_cut_clip_is_placed_by_its_packets(begin_s, is_stamped):
    own = {} if is_stamped else {"stamp_s": -1.0}
    recording = read_gopro(clip((range(2, 12), begin_s), **own))
    assert burst_s(recording) == pytest.approx(begin_s - 2 + BURST_S, abs=0.003)
    placing = recording.placing
    assert placing.others[0].offset_s == pytest.approx(-begin_s)
    assert "the clip was cut" in placing.contradiction(10.0 + begin_s)


@pytest.mark.parametrize("is_stamped", [True, False])
def test_a_clip_cut_in_the_middle_keeps_both_parts_in_place(is_stamped):
    own = {} if is_stamped else {"stamp_s": -1.0}
    recording = read_gopro(clip((range(4), 0.0), (range(6, 12), 3.4), **own))
    assert burst_s(recording) == pytest.approx(3.4 - 6 + BURST_S, abs=0.003)
    assert np.diff(recording.imu.time_s).min() > 0.0
    assert "cut and joined" in recording.placing.contradiction(9.4)


@pytest.mark.parametrize("later_s", [1.0, 531.0])
def test_joined_recordings_need_no_decision(later_s):
    """Stamps begin again, or go on as those of another chapter."""
    packets = clip((range(5), 0.0))
    for number in range(9):
        content = payload(number, stamp_s=later_s + number)
        packets.append(TelemetryPacket(5.0 + number, 1.0, content))
    recording = read_gopro(packets)
    assert burst_s(recording) == pytest.approx(5.0 + BURST_S, abs=0.003)
    assert recording.placing.contradiction(14.0) is None


def test_a_later_chapter_is_placed_by_its_stamps():
    packets = [
        TelemetryPacket(n, 1.0, payload(n, stamp_s=531.0 + n, total=200 * (530 + n)))
        for n in range(9)
    ]
    recording = read_gopro(packets)
    assert burst_s(recording) == pytest.approx(BURST_S, abs=0.003)
    assert recording.placing.contradiction(9.0) is None


def test_a_clip_whose_times_were_changed_follows_its_packets():
    """Conformed from 25 to 24 frames per second: telemetry and video alike."""
    pace = 25 / 24
    packets = [TelemetryPacket(pace * n, pace, payload(n)) for n in range(14)]
    recording = read_gopro(packets)
    assert burst_s(recording) == pytest.approx(pace * BURST_S, abs=0.05)
    assert "its times were changed" in recording.placing.contradiction(14 * pace)


@pytest.mark.parametrize("duration_s", [9.0, 28.0])
def test_telemetry_of_another_length_is_doubted(duration_s):
    """An app kept all of it beside a part of the video, or slowed that down."""
    placing = read_gopro(clip((range(14), 0.0))).placing
    assert "the clip from 0 to" in placing.contradiction(duration_s)


def test_a_video_that_an_edit_list_trims_has_a_second_place():
    placing = read_gopro(clip((range(14), 0.0)), hidden_s=0.8).placing
    assert placing.others == (
        OtherPlace(Message("as the edit list cuts the video"), -0.8),
    )


def test_edits_tell_what_is_shown_when():
    edits = (Edit(0.3, None), Edit(4.0, 0.5), Edit(6.0, 8.0))
    assert shown_at(edits, 0.0, 1.0) == pytest.approx(-0.2)
    assert shown_at(edits, 3.0, 1.0) == pytest.approx(2.8)
    assert shown_at(edits, 5.0, 1.0) is None
    assert shown_at(edits, 9.0, 1.0) == pytest.approx(5.3)
    assert shown_at((Edit(20.0, 0.0, 0.5),), 4.0, 1.0) == pytest.approx(8.0)
    assert hidden_s(ClipTrack(edits=edits, delay_s=0.2)) == pytest.approx(0.3)


@pytest.fixture(scope="module")
def clip_of_10_s(tmp_path_factory):
    path = tmp_path_factory.mktemp("video") / "clip.mp4"
    grey = np.full((48, 64, 3), 90, np.uint8)
    write_clip(path, [grey] * 100, frame_rate_hz=10.0)
    return path


def with_edit(path, media_ms: int):
    """Let the telemetry's edit list begin later, as a cut by seeking leaves it."""
    content = bytearray(path.read_bytes())
    at = content.rfind(b"elst", 0, content.find(b"GoPro MET"))
    content[at + 16 : at + 20] = media_ms.to_bytes(4, "big")
    path.write_bytes(content)
    return path


def test_fractions_of_a_packet_are_cut_off_by_an_edit_list(tmp_path, clip_of_10_s):
    path = tmp_path / "cut.mp4"
    add_telemetry(clip_of_10_s, path, clip((range(2, 12), 0.0)))
    with_edit(path, 300)
    assert [t.edits[0].media_s for t in tracks_of(path) if t.mark == "gpmd"] == [0.3]
    recording = read_recording(path)
    assert burst_s(recording) == pytest.approx(BURST_S - 2.3, abs=0.003)
    assert recording.placing.others[0].offset_s == pytest.approx(0.3)


def contradicted_inputs(recording: Recording, look=None) -> SyncInput:
    def silent():
        raise InputError("it holds no sound")

    placing = recording.placing
    why = placing.contradiction(9.7)
    own = recording.clock_map
    return SyncInput(recording.imu, silent, None, own, look, None, why, placing.others)


@pytest.mark.parametrize("method", [automatic, by_own_clock])
def test_an_undecided_cut_is_a_question(method):
    found = method(contradicted_inputs(read_gopro(clip((range(2, 12), -0.3)))))
    assert not found.is_confident
    assert [one.offset_s for one in found.others] == pytest.approx([0.0, 0.3])


@pytest.mark.parametrize("name", ["cut_input_seek", "cut_lossless"])
def test_a_cut_gopro_clip_is_asked_about_and_then_right(tmp_path, case, name):
    video = case(f"gopro-cut/{name}.mp4")
    assert contradicted(read_recording(video), probe(video))
    with pytest.raises(UsageError, match=r"the clip was cut.*\(--offset 0\.000\)"):
        build_sequence(video, tmp_path / "asked")
    choices = Choices(sync=SyncChoices(offset_s=0.0))
    motion = open_sequence(
        build_sequence(video, tmp_path / "given", choices=choices)
    ).motion
    size = np.linalg.norm(motion.acceleration_mps2, axis=1)
    assert np.mean(motion.time_s[size > 6.0]) == pytest.approx(3.70, abs=0.02)
