from pathlib import Path

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from tests.unit.media.conftest import number_in, numbered_pictures, write_plain

BT601, BT709 = (0.299, 0.114), (0.2126, 0.0722)
FLAT_RGB = (200, 60, 40)


def limited_yuv(
    rgb: tuple[int, int, int], kr_kb: tuple[float, float]
) -> tuple[int, int, int]:
    """Y'CbCr of ITU-R BT.601 / BT.709, 8 bit, limited range."""
    kr, kb = kr_kb
    red, green, blue = (value / 255 for value in rgb)
    luma = kr * red + (1 - kr - kb) * green + kb * blue
    return (
        round(16 + 219 * luma),
        round(128 + 112 * (blue - luma) / (1 - kb)),
        round(128 + 112 * (red - luma) / (1 - kr)),
    )


def flat_frame(width: int, height: int, yuv: tuple[int, int, int]) -> av.VideoFrame:
    frame = av.VideoFrame(width, height, "yuv420p")
    for plane, value in zip(frame.planes, yuv, strict=True):
        plane.update(bytes([value]) * plane.buffer_size)
    return frame


def shown(decoder: VideoDecoder) -> NDArray[np.uint8]:
    frame = decoder.next_frame()
    assert frame is not None
    return FrameConverter().convert(frame, decoder.width, decoder.height).as_rgb()


def test_all_pictures_come_in_order(clip: Path) -> None:
    with VideoDecoder(clip) as decoder:
        numbers, times_s = [], []
        for frame in decoder.frames():
            picture = FrameConverter().convert(frame, 320, 180)
            numbers.append(number_in(picture.as_rgb()))
            times_s.append(frame.pts_s)
            assert frame.duration_s == pytest.approx(1 / 30)
        assert decoder.next_frame() is None
        assert decoder.damaged == 0
    assert numbers == list(range(150))
    assert times_s == pytest.approx(np.arange(150) / 30)


def test_seek_is_exact_at_random_positions(clip: Path) -> None:
    rng = np.random.default_rng(20)
    with VideoDecoder(clip) as decoder:
        for media_s in rng.uniform(0.0, 5.0, 20):
            decoder.seek(media_s)
            frame = decoder.next_frame()
            assert frame is not None
            assert frame.pts_s <= media_s < frame.pts_s + frame.duration_s
            rgb = FrameConverter().convert(frame, 320, 180).as_rgb()
            assert number_in(rgb) == int(media_s * 30)
            following = decoder.next_frame()
            if following is not None:
                assert following.pts_s == pytest.approx(frame.pts_s + 1 / 30)


def test_seek_to_the_time_of_each_picture_returns_that_picture(clip: Path) -> None:
    with VideoDecoder(clip) as decoder:
        times_s = [frame.pts_s for frame in decoder.frames()]
        for number in (0, 1, 59, 60, 61, 100, 149):
            decoder.seek(times_s[number])
            assert number_in(shown(decoder)) == number


@pytest.mark.parametrize(("media_s", "number"), [(-3.0, 0), (5.0, 149), (900.0, 149)])
def test_seek_outside_returns_the_nearest_picture(
    clip: Path, media_s: float, number: int
) -> None:
    with VideoDecoder(clip) as decoder:
        decoder.seek(media_s)
        assert number_in(shown(decoder)) == number


@pytest.mark.parametrize(
    ("suffix", "codec"), [("mkv", "libx264"), ("webm", "libvpx"), ("avi", "mpeg4")]
)
def test_seek_is_exact_in_other_containers(
    tmp_path: Path, suffix: str, codec: str
) -> None:
    frames = [
        av.VideoFrame.from_ndarray(picture, format="rgb24").reformat(format="yuv420p")
        for picture in numbered_pictures(90, 90, 160)
    ]
    path = write_plain(tmp_path / f"clip.{suffix}", frames, codec)
    with VideoDecoder(path) as decoder:
        for media_s in np.random.default_rng(3).uniform(0.05, 2.95, 8):
            decoder.seek(media_s)
            # half a millisecond: Matroska rounds its times
            wanted = {int((media_s - 5e-4) * 30), int((media_s + 5e-4) * 30)}
            assert number_in(shown(decoder)) in wanted


def test_variable_frame_rate_holds_a_picture_until_the_next(tmp_path: Path) -> None:
    frames = [
        av.VideoFrame.from_ndarray(picture, format="rgb24").reformat(format="yuv420p")
        for picture in numbered_pictures(6)
    ]
    pts = [0, 1, 2, 30, 31, 60]
    path = write_plain(tmp_path / "vfr.mp4", frames, pts=pts)
    with VideoDecoder(path) as decoder:
        for media_s, number in [(0.5, 2), (0.99, 2), (1.0, 3), (1.9, 4), (2.01, 5)]:
            decoder.seek(media_s)
            assert number_in(shown(decoder)) == number


def test_media_time_starts_with_the_first_picture(tmp_path: Path) -> None:
    frames = [
        av.VideoFrame.from_ndarray(picture, format="rgb24").reformat(format="yuv420p")
        for picture in numbered_pictures(30)
    ]
    path = write_plain(tmp_path / "late.mkv", frames, pts=list(range(60, 90)))
    with VideoDecoder(path) as decoder:
        first = decoder.next_frame()
        assert first is not None
        assert first.pts_s == pytest.approx(0.0, abs=1e-9)
        decoder.seek(0.5)
        assert number_in(shown(decoder)) == 15
    assert probe(path).duration_s == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize(
    ("height", "kr_kb", "tag"),
    [
        (480, BT601, None),
        (718, BT601, None),
        (720, BT709, None),
        (240, BT709, 1),
        (720, BT601, 5),
        (720, BT601, 6),
    ],
)
def test_flat_colour_comes_back(
    tmp_path: Path, height: int, kr_kb: tuple[float, float], tag: int | None
) -> None:
    frames = [flat_frame(256, height, limited_yuv(FLAT_RGB, kr_kb)) for _ in range(2)]
    tags = {} if tag is None else {"colorspace": tag}
    path = write_plain(tmp_path / "flat.mp4", frames, **tags)
    with VideoDecoder(path) as decoder:
        rgb = shown(decoder)
    # 8-bit Y'CbCr resolves R, G, B to about 2 levels; the wrong matrix is off by
    # more than 10 in one of them
    assert np.abs(rgb.reshape(-1, 3).astype(int) - FLAT_RGB).max() <= 3


def test_full_range_is_not_stretched(tmp_path: Path) -> None:
    """Phones write luma 0 to 255 and tag it so."""
    luma, blue, red = limited_yuv(FLAT_RGB, BT709)
    full = tuple(
        round(value)
        for value in (
            (luma - 16) * 255 / 219,
            128 + (blue - 128) * 255 / 224,
            128 + (red - 128) * 255 / 224,
        )
    )
    frames = [flat_frame(256, 720, full) for _ in range(2)]  # type: ignore[arg-type]
    path = write_plain(tmp_path / "full.mp4", frames, color_range=2, colorspace=1)
    with VideoDecoder(path) as decoder:
        rgb = shown(decoder)
    assert np.abs(rgb.reshape(-1, 3).astype(int) - FLAT_RGB).max() <= 3


def test_written_colours_come_back(tmp_path: Path) -> None:
    path = tmp_path / "flat.mp4"
    picture = np.full((180, 320, 3), FLAT_RGB, np.uint8)
    write_clip(path, [picture] * 3, frame_rate_hz=25.0)
    with VideoDecoder(path) as decoder:
        assert np.abs(shown(decoder).astype(int) - FLAT_RGB).max() <= 3


@pytest.mark.parametrize(
    ("asked", "got"),
    [((640, 360), (640, 360)), ((161, 91), (160, 91)), ((1, 1), (2, 2))],
)
def test_conversion_scales_to_even_widths(
    clip: Path, asked: tuple[int, int], got: tuple[int, int]
) -> None:
    with VideoDecoder(clip) as decoder:
        frame = decoder.next_frame()
        assert frame is not None
        picture = FrameConverter().convert(frame, *asked)
    assert (picture.width, picture.height) == got
    assert picture.stride_bytes >= 4 * picture.width
    assert len(picture.pixels) >= picture.stride_bytes * picture.height
    alpha = np.frombuffer(picture.pixels, np.uint8)[3 : 4 * picture.width : 4]
    assert (alpha == 255).all()


def test_picture_outlives_its_decoder(clip: Path) -> None:
    with VideoDecoder(clip) as decoder:
        decoder.seek(3.0)
        frame = decoder.next_frame()
        assert frame is not None
        picture = FrameConverter().convert(frame, 320, 180)
    del decoder, frame
    assert number_in(picture.as_rgb()) == 90


def test_picture_that_is_too_large_is_refused(clip: Path) -> None:
    with VideoDecoder(clip) as decoder:
        frame = decoder.next_frame()
        assert frame is not None
        with pytest.raises(MediaError, match="too large"):
            FrameConverter().convert(frame, 100_000, 100_000)


@pytest.mark.parametrize("turn_deg", [90, 180, 270])
def test_rotated_clip_is_shown_upright(tmp_path: Path, turn_deg: int) -> None:
    upright = np.zeros((128, 96, 3), np.uint8)
    upright[:32, :48] = 255  # white only at the top left
    stored = np.ascontiguousarray(np.rot90(upright, -turn_deg // 90))
    frame = av.VideoFrame.from_ndarray(stored, format="rgb24")
    path = write_plain(
        tmp_path / "phone.mp4",
        [frame.reformat(format="yuv420p")],
        rotation_deg=turn_deg,
    )
    info = probe(path)
    assert (info.width, info.height) == (96, 128)
    with VideoDecoder(path) as decoder:
        assert (decoder.width, decoder.height) == (96, 128)
        rgb = shown(decoder)
    assert rgb.shape == upright.shape
    assert np.abs(rgb.astype(int) - upright).mean() < 5.0


def test_damaged_packets_are_skipped_and_counted(tmp_path: Path, clip: Path) -> None:
    content = bytearray(clip.read_bytes())
    with av.open(str(clip)) as container:
        for entry in container.streams.video[0].index_entries[70:75]:
            content[entry.pos : entry.pos + entry.size] = b"\xff" * entry.size
    path = tmp_path / "damaged.mp4"
    path.write_bytes(content)
    with VideoDecoder(path) as decoder:
        frames = list(decoder.frames())
        assert decoder.damaged >= 5
        assert 140 <= len(frames) < 150
        assert np.diff([frame.pts_s for frame in frames]).min() > 0.0


def test_clip_without_a_decodable_picture_is_refused(
    tmp_path: Path, clip: Path
) -> None:
    content = bytearray(clip.read_bytes())
    with av.open(str(clip)) as container:
        for entry in container.streams.video[0].index_entries:
            content[entry.pos : entry.pos + entry.size] = b"\xff" * entry.size
    path = tmp_path / "noise.mp4"
    path.write_bytes(content)
    with pytest.raises(MediaError, match="none of its frames"):
        VideoDecoder(path)
    with pytest.raises(MediaError, match="none of its frames"):
        probe(path)


def test_clip_without_video_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "sound.wav"
    with av.open(str(path), "w") as container:
        sound = container.add_stream("pcm_s16le", rate=48_000)
        frame = av.AudioFrame.from_ndarray(
            np.zeros((1, 4800), np.int16), format="s16", layout="mono"
        )
        frame.sample_rate = 48_000
        container.mux(sound.encode(frame))
    with pytest.raises(MediaError, match="no video"):
        VideoDecoder(path)


def test_probe_reports_the_clip(clip: Path) -> None:
    info = probe(clip)
    assert info.duration_s == pytest.approx(5.0, abs=1e-3)
    assert (info.width, info.height) == (320, 180)
    assert info.frame_rate_hz == pytest.approx(30.0)
    assert info.frame_count == 150
    assert (info.has_audio, info.audio_rate_hz) == (True, 48_000)
    assert not info.has_telemetry
