"""The same video is known in any container; at other times it is another one."""

import shutil
import subprocess

import av
import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.identity import ANOTHER, RETIMED, SOUND_MOVED
from hapticplayer.media.opening import open_media
from hapticplayer.media.remux import (
    MATROSKA,
    MP4,
    other_head,
    remux,
    video_payload,
)
from tests.unit.media.conftest import numbered_pictures, write_plain

H264_DELIMITER, H264_FILLER, HEVC_DELIMITER = 9, 12, 35


def copied(source, target, *, video=lambda s: s, sound=lambda s: s, add=None):
    """Copy packets with times as functions (s) of theirs, `add` before each of video."""
    with av.open(str(source)) as clip, av.open(str(target), "w") as copy:
        kept = (*clip.streams.video, *clip.streams.audio)
        streams = {one.index: copy.add_stream_from_template(one) for one in kept}
        for packet in clip.demux(kept):
            if not packet.size:
                continue
            kind, base = packet.stream.type, packet.time_base
            made = packet
            if kind == "video" and add:
                made = av.Packet(add + bytes(packet))
                made.pts, made.dts, made.time_base = packet.pts, packet.dts, base
                made.is_keyframe = packet.is_keyframe
            moved = video if kind == "video" else sound
            made.pts = round(moved(float(packet.pts * base)) / base)
            made.dts = round(moved(float(packet.dts * base)) / base)
            made.duration = packet.duration
            made.stream = streams[packet.stream_index]
            copy.mux(made)
    return target


def difference(clip, other):
    return video_payload(clip).difference(video_payload(other))


def slower(at_s):
    return 2.0 * at_s


def later(at_s):
    return at_s + 3.0


def jumping(at_s):
    return at_s + 0.2 * (at_s > 2.5)


def swaying(at_s):
    """Every frame elsewhere, beginning, end and mean where they were."""
    return at_s + 0.05 * np.sin(2.0 * np.pi * at_s / 5.0)


def drifting(at_s):
    return 1.002 * at_s


@pytest.mark.parametrize("ending", ["mkv", "mp4"])
@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"video": slower, "sound": slower}, RETIMED),
        ({"video": slower}, RETIMED),
        ({"video": later, "sound": later}, RETIMED),
        ({"video": jumping, "sound": jumping}, RETIMED),
        ({"video": swaying}, RETIMED),
        ({"video": drifting, "sound": drifting}, RETIMED),
        ({"video": later}, RETIMED),
        ({"sound": later}, SOUND_MOVED),
        ({"sound": lambda at_s: at_s + 0.1}, SOUND_MOVED),
        ({"sound": drifting}, None),
        ({"sound": slower}, SOUND_MOVED),
        ({}, None),
    ],
)
def test_a_clip_that_was_retimed_is_another_one(clip, tmp_path, changes, why, ending):
    moved = copied(clip, tmp_path / f"moved.{ending}", **changes)
    assert difference(clip, moved) == why
    assert bool(other_head(moved, video_payload(clip))) == bool(why)


def test_a_clip_whose_beginning_is_hidden_is_another_one(clip, tmp_path):
    """An edit list trims it without a packet less, as `-ss 0.5 -c copy` does."""
    content = bytearray(clip.read_bytes())
    at = content.index(b"elst") + 16  # behind version, count and duration
    with open_media(clip) as container:
        second, third = container.streams.video[0].index_entries[1:3]
        ticks = 15 * (third.timestamp - second.timestamp)
    start = int.from_bytes(content[at : at + 4], "big")
    content[at : at + 4] = (start + ticks).to_bytes(4, "big")
    (tmp_path / "trimmed.mp4").write_bytes(content)
    assert difference(clip, tmp_path / "trimmed.mp4") == RETIMED


def test_a_clip_without_its_last_frames_is_another_one(clip, tmp_path):
    short = tmp_path / "short.mkv"
    with av.open(str(clip)) as source, av.open(str(short), "w") as copy:
        stream = copy.add_stream_from_template(source.streams.video[0])
        for packet in list(source.demux(video=0))[:-10]:
            if packet.size:
                packet.stream = stream
                copy.mux(packet)
    assert difference(clip, short) == ANOTHER
    assert other_head(short, video_payload(clip)) == RETIMED, "by its length"


def test_a_clip_that_began_late_may_begin_at_0(clip, tmp_path):
    """Every muxer moves the beginning to 0, none puts it off."""
    late = copied(clip, tmp_path / "late.mkv", video=later, sound=later)
    assert difference(late, clip) is None
    assert other_head(clip, video_payload(late)) is None
    assert other_head(late, video_payload(late)) is None


def test_another_sound_track_is_no_other_video(clip, tmp_path):
    silent = tmp_path / "silent.mkv"
    with av.open(str(clip)) as source, av.open(str(silent), "w") as copy:
        stream = copy.add_stream_from_template(source.streams.video[0])
        for packet in source.demux(video=0):
            if packet.size:
                packet.stream = stream
                copy.mux(packet)
    assert difference(clip, silent) is None
    assert difference(silent, clip) is None
    for one, other in ((clip, silent), (silent, clip)):
        assert other_head(one, video_payload(other)) is None


@pytest.mark.parametrize(
    "flags",
    [
        "frag_keyframe+empty_moov",
        "frag_keyframe",
        "frag_keyframe+empty_moov+delay_moov",
    ],
)
@pytest.mark.parametrize(
    "changes", [{}, {"sound": lambda at_s: at_s + 0.1}, {"video": later}]
)
def test_a_clip_in_fragments_keeps_its_identity(clip, tmp_path, flags, changes):
    """Of the first packet of its sound the muxer writes another time, of the others not."""
    moved = copied(clip, tmp_path / "moved.mp4", **changes)
    fragments = tmp_path / "fragments.mp4"
    with (
        av.open(str(moved)) as source,
        av.open(str(fragments), "w", options={"movflags": flags}) as copy,
    ):
        kept = (*source.streams.video, *source.streams.audio)
        streams = {one.index: copy.add_stream_from_template(one) for one in kept}
        for packet in source.demux(kept):
            if packet.size:
                packet.stream = streams[packet.stream_index]
                copy.mux(packet)
    is_same = not changes
    assert (difference(clip, fragments) is None) == is_same
    assert (other_head(fragments, video_payload(clip)) is None) == is_same


@pytest.mark.skipif(shutil.which("mkvmerge") is None, reason="needs mkvmerge")
def test_mpeg_4_part_2_is_the_same_in_mkvmerge(tmp_path):
    """It writes the header once more, before the first frame."""
    clip, again = tmp_path / "clip.mp4", tmp_path / "again.mkv"
    pictures = [
        av.VideoFrame.from_ndarray(one, format="rgb24").reformat(format="yuv420p")
        for one in numbered_pictures(40)
    ]
    write_plain(clip, pictures, codec="mpeg4")
    subprocess.run(["mkvmerge", "-q", "-o", again, clip], check=True)
    assert difference(clip, again) is None
    assert other_head(again, video_payload(clip)) is None


def changed_at(clip, target, at_s):
    """Change a bit of the key frame at or behind a time."""
    with open_media(clip) as container:
        video = container.streams.video[0]
        entries = [one for one in video.index_entries if one.is_keyframe]
        late = next(e for e in entries if e.timestamp * video.time_base >= at_s)
        end = late.pos + late.size  # an entry is of an open container
    content = bytearray(clip.read_bytes())
    content[end - 3] ^= 1
    target.write_bytes(content)
    return target


def test_a_clip_that_differs_behind_its_head_is_another_one(clip, tmp_path):
    """Of a clip elsewhere some key frames are compared, where the index tells their place."""
    payload = video_payload(clip)
    assert len(payload.keys) >= 2
    for at_s in (2.5, 4.0):
        changed = changed_at(clip, tmp_path / "changed.mp4", at_s)
        assert other_head(changed, payload) == ANOTHER
    again = tmp_path / "again.mkv"
    remux(clip, again, MATROSKA)
    assert other_head(again, payload) is None
    remux(changed, again, MATROSKA)
    assert other_head(again, payload) == ANOTHER


def test_key_frames_of_any_clip_are_few_and_evenly_spaced(tmp_path):
    picture = av.VideoFrame.from_ndarray(
        np.zeros((48, 64, 3), np.uint8), format="rgb24"
    )
    path = write_plain(
        tmp_path / "intra.mp4",
        [picture.reformat(format="yuvj420p")] * 1000,
        codec="mjpeg",
    )
    times_ms = [at_ms for at_ms, _ in video_payload(path).keys]
    assert 8 <= len(times_ms) < 16
    assert np.ptp(np.diff(times_ms)) < 1.0
    assert times_ms[-1] > 0.9 * 1000 / 0.03


@pytest.mark.parametrize("kind", [H264_DELIMITER, H264_FILLER])
def test_delimiters_do_not_count(clip, tmp_path, kind):
    unit = bytes((0, 0, 0, 2, kind, 0xF0))
    with_units = copied(clip, tmp_path / "units.mkv", add=unit)
    assert difference(clip, with_units) is None
    assert video_payload(with_units).head_sha256 == video_payload(clip).head_sha256
    other = copied(clip, tmp_path / "other.mkv", add=bytes((0, 0, 0, 2, 6, 0xF0)))
    assert difference(clip, other) == ANOTHER


@pytest.mark.parametrize(
    "add", [b"\0\0\0\x09", b"\xff\xff\xff\xff\x09", b"\0\0\0\0", b"\0"]
)
def test_lengths_that_are_wrong_count_as_they_are(clip, tmp_path, add):
    odd = copied(clip, tmp_path / "odd.mkv", add=add)
    assert difference(clip, odd) == ANOTHER


@pytest.mark.parametrize(
    "codec",
    [
        ("libx264", {"x264-params": "aud=1:bframes=3"}),
        ("libx265", {"x265-params": "aud=1:log-level=none"}),
    ],
    ids=["h264", "hevc"],
)
@pytest.mark.parametrize("kind", [MATROSKA, MP4])
def test_remuxers_keep_the_video(tmp_path, codec, kind):
    name, options = codec
    clip = tmp_path / "clip.mp4"
    with av.open(str(clip), "w") as container:
        stream = container.add_stream(name, rate=30, options=options)
        stream.width, stream.height, stream.pix_fmt = 320, 180, "yuv420p"
        for number, picture in enumerate(numbered_pictures(60)):
            frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
            frame.pts = number
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    packed = tmp_path / f"packed.{'mkv' if kind == MATROSKA else 'mp4'}"
    try:
        remux(clip, packed, kind)
    except MediaError:
        pytest.skip(f"no {name} here")
    assert difference(clip, packed) is None
    tried = 0
    for program, words in (
        ("mkvmerge", ["-q", "-o", "{to}", "{of}"]),
        ("ffmpeg", ["-v", "error", "-i", "{of}", "-c", "copy", "{to}"]),
    ):
        if shutil.which(program) is None:
            continue
        again = tmp_path / f"{program}.mkv"
        filled = [one.format(of=packed, to=again) for one in words]
        subprocess.run([program, *filled], check=True, capture_output=True)
        assert difference(clip, again) is None, program
        tried += 1
    if not tried:
        pytest.skip("needs mkvmerge or ffmpeg")
