import json
import os
import shutil

import av
import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.live.source_clock import SourceClock
from hapticplayer.capture.recorded import (
    CLIP,
    COLUMNS,
    COUNT,
    LOG,
    SourceClockLine,
    Stream,
    Take,
    finished,
    is_take,
    parts_of,
)
from hapticplayer.errors import InputError
from hapticplayer.media.clip_info import probe
from hapticplayer.storage import lock_folder

PPM = 40e-6
FIRST_S = -0.4
"""Media time of the first sample."""


def write_clip(path, *, is_killed):
    beside = path.with_suffix(".part")
    options = {"cluster_time_limit": "400", "flush_packets": "1"}
    with av.open(str(beside), "w", format="matroska", options=options) as file:
        stream = file.add_stream("mjpeg", rate=30)
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuvj420p"
        for number in range(90):
            picture = np.full((48, 64, 3), 2 * number, np.uint8)
            file.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        if is_killed:
            shutil.copy(beside, path)
    if not is_killed:
        shutil.copy(beside, path)
    beside.unlink()


@pytest.fixture
def make_take(tmp_path, rng):
    """A folder as the recorder leaves it, or as a kill does."""

    def make(*, is_killed=False, clip=True, **more):
        folder = tmp_path / "take"
        folder.mkdir()
        time_s = np.arange(600) / 200.0
        media_s = FIRST_S + time_s * (1 + PPM)
        arrival_s = media_s + 0.002 + rng.exponential(0.003, 600)
        accel = rng.normal((0.0, 0.0, 9.81), 0.05, (600, 3))
        table = np.column_stack(
            [time_s, accel, rng.normal(0, 0.02, (600, 3)), np.sort(arrival_s)]
        )
        rows = "\n".join(",".join(f"{one:.9g}" for one in row) for row in table)
        tail = "\n2.9999,0.1,0." if is_killed else "\n"
        (folder / LOG).write_text(f"{','.join(COLUMNS)}\n{rows}{tail}")
        if clip:
            write_clip(folder / CLIP, is_killed=is_killed)
        more = {"imu": Stream("wt901:/dev/ttyUSB0", "source"), **more}
        Take(
            began="2026-11-27T15:00:00+00:00",
            is_finished=not is_killed,
            camera=Stream("/dev/video0", "monotonic") if clip else None,
            clock=None if is_killed else SourceClockLine(FIRST_S, 1 + PPM, 0.002),
            **more,
        ).write(folder)
        return folder

    return make


def test_the_log_of_a_recording_is_in_media_time(make_take):
    recording = read_recording(make_take())
    assert recording.imu.time_s[0] == pytest.approx(FIRST_S)
    assert recording.imu.time_s[-1] == pytest.approx(FIRST_S + 599 / 200 * (1 + PPM))
    assert recording.clock_map.residual_s == 0.002
    assert recording.lag.text in recording.notes
    assert not any("arrival" in note for note in recording.notes)


def test_a_kill_leaves_a_recording_that_is_finished_later(make_take):
    folder = make_take(is_killed=True)
    assert probe_fails(folder)
    clip, log, _ = parts_of(folder)
    assert probe(clip).duration_s == pytest.approx(3.0, abs=0.6)
    recording = read_recording(log)
    assert len(recording.imu) == 600
    assert recording.imu.time_s[0] == pytest.approx(FIRST_S, abs=0.006)
    assert any("ended from outside" in one for one in finished(folder).notices)


@pytest.mark.parametrize("is_killed", [False, True])
def test_each_stretch_of_a_log_goes_by_its_own_clock(make_take, is_killed):
    """The sensor was unplugged for 1 s; its rows go on by arrivals that were 20 ms late."""
    begin_s, late_s = 4.02, 0.02
    later = SourceClockLine(FIRST_S - late_s, 1.0, 0.003, begin_s)
    folder = make_take(is_killed=is_killed, restarts=[later])
    rows = [
        f"{begin_s + k / 200:.6f},0,0,9.81,0,0,0,{FIRST_S - late_s + begin_s + k / 200 + 0.002 * (k % 3):.6f}\n"
        for k in range(600)
    ]
    log = (folder / LOG).read_text().rpartition("\n")[0]
    (folder / LOG).write_text("\n".join([log, "".join(rows)]))
    parts_of(folder)
    recording = read_recording(folder)
    media_s = FIRST_S - late_s + begin_s
    assert recording.imu.time_s[600] == pytest.approx(media_s, abs=0.001)
    assert recording.imu.time_s[-1] == pytest.approx(media_s + 599 / 200, abs=0.001)
    assert recording.imu.time_s[0] == pytest.approx(FIRST_S, abs=0.006)
    assert len(finished(folder).restarts) == 1


def test_a_killed_recording_of_counted_samples_has_their_rate(make_take):
    """A board without stamps that is 0.4 % faster than its rate says."""
    folder = make_take(is_killed=True, imu=Stream("wt901:/dev/ttyUSB0", COUNT))
    time_s = np.arange(20_000) / 200.0
    (folder / LOG).write_text(
        "\n".join(
            [
                ",".join(COLUMNS),
                *(f"{t:.9f},0,0,9.81,0,0,0,{t / 1.004 + 0.003:.6f}" for t in time_s),
                "",
            ]
        )
    )
    media_s = read_recording(parts_of(folder).log).imu.time_s
    assert media_s == pytest.approx(time_s / 1.004 + 0.003, abs=0.002)


@pytest.mark.parametrize("damage", [b"\0" * 50, b"1.0,2.0", b"1,x,0,0,0,0,0,1", b"nan,0,0,9.8,0,0,0,1", b"1e9,0,0,9.8,0,0,0,1", b",0,0,9.8,0,0,0,1", b"1,0,0,9.8,0,0,0,"])  # fmt: skip
def test_damaged_rows_of_a_killed_recording_are_counted(make_take, tmp_path, damage):
    folder = make_take(is_killed=True)
    head, first, *rows = (folder / LOG).read_bytes().split(b"\n")
    linked = tmp_path / "elsewhere"
    linked.write_bytes(content := b"\n".join([head, first, damage, *rows]))
    (folder / LOG).unlink()
    (folder / LOG).symlink_to(linked)
    assert len(read_recording(parts_of(folder).log).imu) == 600
    assert any("left out: 1." in one for one in finished(folder).notices)
    assert linked.read_bytes() == content


def test_a_kill_before_the_second_row_leaves_the_video(make_take):
    later = SourceClockLine(0.0, begin_s=0.004)
    folder = make_take(is_killed=True, restarts=[later])
    log = (folder / LOG).read_text().split("\n")
    (folder / LOG).write_text("\n".join([*log[:3], ""]))
    assert parts_of(folder).log is None


def test_names_that_are_not_utf_8_leave_a_readable_recording(make_take):
    folder = make_take(notices=["/tmp/caf\udce9 cannot be written \\udce9"])
    assert finished(folder).notices == ["/tmp/caf? cannot be written \\udce9"]


def test_a_clock_of_which_little_is_known_can_be_read_again(make_take):
    clock = SourceClock()
    clock.add(np.arange(0.0, 400.0, 2.0), np.maximum(np.arange(0.0, 400.0, 2.0), 390.0))
    line = SourceClockLine.of(clock, 0.0)
    assert read_recording(make_take(restarts=[line])).clock_map.residual_s == 60.0


def probe_fails(folder):
    try:
        return probe(folder / CLIP).duration_s < 0
    except InputError:
        return True


def test_a_recording_that_goes_on_is_left_alone(make_take):
    folder = make_take(is_killed=True)
    lock = lock_folder(folder)
    before = (folder / LOG).read_bytes()
    with pytest.raises(InputError, match="is being recorded"):
        parts_of(folder)
    os.close(lock)
    assert (folder / LOG).read_bytes() == before


def test_motion_alone_names_the_way_to_a_video(make_take):
    with pytest.raises(InputError, match=r"holds no video.*--camera.*--imu"):
        parts_of(make_take(clip=False))


def test_the_mounting_is_handed_on(make_take):
    folder = make_take(mounting="-x,y,-z")
    assert parts_of(folder) == (folder / CLIP, folder, "-x,y,-z")
    assert is_take(folder)
    assert not is_take(folder.parent)


def test_the_folder_of_a_simulated_ride_is_a_plain_log(make_take):
    folder = make_take()
    (folder / "recording.json").write_text('{"scenario": "bike", "seed": 1}')
    assert not is_take(folder)
    assert read_recording(folder / LOG).clock_map.confidence == 0.0
    (folder / CLIP).unlink()
    assert read_recording(folder).imu.time_s[0] == 0.0


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"version": 9}, "has version 9"),
        ({"clock": {"offset_s": 1e99}}, "offset_s"),
        ({"clock": {"offset_s": 0.0, "rate": 3.0}}, "rate"),
        ({"gaps": [{"stream": "imu"}]}, "begin_s"),
    ],
)
def test_a_description_by_others_is_checked(make_take, change, sentence):
    folder = make_take()
    path = folder / "recording.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with pytest.raises(InputError, match=sentence):
        parts_of(folder)
    with pytest.raises(InputError, match=sentence):
        read_recording(folder)
