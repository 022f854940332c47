"""A clip that plays at another pace than it was recorded is known by its metadata."""

import re
from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.media.pace import pace_of

RATE_HZ = 30


def clip(path, steps=None, **metadata):
    """Write 60 frames with the given steps (in frames of 1/30 s) and metadata."""
    steps = steps or [1] * 60
    flags = {"movflags": "use_metadata_tags"}
    with av.open(str(path), "w", container_options=flags) as file:
        file.metadata.update({k.replace("_", "."): v for k, v in metadata.items()})
        stream = file.add_stream("libx264", rate=RATE_HZ)
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuv420p"
        for number in np.cumsum(steps) - steps[0]:
            picture = np.full((48, 64, 3), int(number) % 200, np.uint8)
            frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
            frame.pts, frame.time_base = int(number), Fraction(1, RATE_HZ)
            file.mux(stream.encode(frame))
        file.mux(stream.encode(None))
    return path


def with_box(path, kind: bytes, content: bytes):
    box = (8 + len(content)).to_bytes(4, "big") + kind + content
    path.write_bytes(path.read_bytes() + box)
    return path


def sony(captured: str, shown: str) -> bytes:
    text = f'<VideoFrame videoCodec="x" captureFps="{captured}" formatFps="{shown}"/>'
    return bytes(4) + text.encode()


@pytest.mark.parametrize(
    ("captured", "slowed"), [("240.000000", 8.0), ("120", 4.0), ("1.0", 1 / 30)]
)
def test_an_android_phone_tells_its_rate_of_capture(tmp_path, captured, slowed):
    path = clip(tmp_path / "clip.mp4", com_android_capture_fps=captured)
    found = pace_of(path)
    assert found.slowed == pytest.approx(slowed, rel=0.02)
    assert "recorded at" in found.why


@pytest.mark.parametrize("captured", ["30.000000", "29.97", "", "nan", "a lot"])
def test_a_clip_at_its_own_pace_raises_no_question(tmp_path, captured):
    path = clip(tmp_path / "clip.mp4", com_android_capture_fps=captured)
    assert pace_of(path) is None


def test_low_light_is_no_slow_motion(tmp_path):
    steps = [1] * 40 + [2] * 20
    path = clip(tmp_path / "clip.mp4", steps, com_android_capture_fps="30.0")
    assert pace_of(path) is None


def test_an_iphone_tells_a_time_lapse(tmp_path):
    path = clip(tmp_path / "clip.mov", com_apple_photos_captureMode="Time-lapse")
    found = pace_of(path)
    assert found.slowed is None
    assert "time lapse" in found.why


@pytest.mark.parametrize(
    ("captured", "shown", "slowed"),
    [("119.88p", "23.98p", 5.0), ("1p", "25p", 0.04), ("29.97p", "29.97p", None)],
)
def test_a_sony_tells_both_rates(tmp_path, captured, shown, slowed):
    path = with_box(clip(tmp_path / "clip.mp4"), b"meta", sony(captured, shown))
    found = pace_of(path)
    assert (found and found.slowed) == (slowed and pytest.approx(slowed, rel=0.01))


def gopro(media_type: int, rate: str) -> bytes:
    """Settings as a HERO writes them; the rate of normal video is empty."""
    size = len(rate).to_bytes(1, "big")
    settings = b"MTYPB\x01\x00\x01" + bytes([media_type, 0, 0, 0])
    padded = rate.encode() + bytes(-len(rate) % 4)
    return (
        settings
        + b"RATEc"
        + size
        + b"\x00\x01"
        + padded
        + b"SROTf\x04\x00\x01"
        + bytes(4)
    )


def box(kind: bytes, content: bytes) -> bytes:
    return (8 + len(content)).to_bytes(4, "big") + kind + content


@pytest.mark.parametrize(
    ("media_type", "rate", "why", "slowed"),
    [
        (0, "", None, None),
        (1, "0_5SEC", "at 2 frames per second and plays at 30", 2 / 30),
        (1, "10SEC", "at 0.1 frames", 1 / 300),
        (0, "15X", "TimeWarp .*15X", None),
        (1, "", "time lapse", None),
    ],
)
def test_a_gopro_tells_time_lapse_and_timewarp(tmp_path, media_type, rate, why, slowed):
    settings = box(b"udta", box(b"GPMF", gopro(media_type, rate)))
    path = with_box(clip(tmp_path / "clip.mp4"), b"moov", settings)
    found = pace_of(path)
    assert (found and found.slowed) == (slowed and pytest.approx(slowed, rel=0.02))
    assert why is None if found is None else re.search(why, found.why)


def test_a_samsung_tells_that_a_part_is_slow(tmp_path):
    part = b"Super_SlowMotion_Data" + bytes(40) + b"SEFH" + bytes(20) + b"SEFT"
    found = pace_of(with_box(clip(tmp_path / "clip.mp4"), b"sefd", part))
    assert found.slowed is None
    assert "Super Slow-mo" in found.why


@pytest.mark.parametrize(("rate", "slowed"), [(0.25, 4.0), (2.0, 0.5), (1.0, None)])
def test_an_edit_list_that_stretches_time_is_known(tmp_path, rate, slowed):
    path = clip(tmp_path / "clip.mp4")
    content = bytearray(path.read_bytes())
    at = content.find(b"elst") + 20
    content[at : at + 4] = round(65536 * rate).to_bytes(4, "big")
    path.write_bytes(content)
    found = pace_of(path)
    assert (found and found.slowed) == slowed
