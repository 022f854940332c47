"""Clips whose pictures say which one they are, made once per session."""

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.media.encode import write_clip

RATE_HZ = 48_000
CLICKS_S = (0.75, 2.3, 3.90625)
BITS = 10


def numbered_pictures(
    count: int, height: int = 180, width: int = 320
) -> Iterator[NDArray[np.uint8]]:
    """Yield pictures with their number as ten vertical bars, lowest bit left."""
    edges = np.arange(BITS + 1) * width // BITS
    for number in range(count):
        picture = np.zeros((height, width, 3), np.uint8)
        for bit in range(BITS):
            if number >> bit & 1:
                picture[:, edges[bit] : edges[bit + 1]] = 255
        yield picture


def number_in(rgb: NDArray[np.uint8]) -> int:
    """Read the number back."""
    height, width = rgb.shape[:2]
    middles = (2 * np.arange(BITS) + 1) * width // (2 * BITS)
    bits = rgb[height // 2, middles, 0] > 128
    return int(np.sum(bits << np.arange(BITS)))


def clicks(duration_s: float, rate_hz: int = RATE_HZ) -> NDArray[np.float32]:
    """Return stereo sound with a Gaussian click (sd 0.2 ms) at each CLICKS_S."""
    time_s = np.arange(round(duration_s * rate_hz)) / rate_hz
    sound = sum(np.exp(-0.5 * ((time_s - at_s) / 2e-4) ** 2) for at_s in CLICKS_S)
    return np.repeat(0.8 * np.asarray(sound, np.float32)[:, None], 2, axis=1)


def write_plain(
    path: Path,
    pictures: list[av.VideoFrame],
    codec: str = "libx264",
    rate: int = 30,
    pts: list[int] | None = None,
    rotation_deg: float = 0.0,
    **tags: int,
) -> Path:
    """Encode av frames as they are, without the room's own writer."""
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=rate)
        stream.width, stream.height = pictures[0].width, pictures[0].height
        stream.pix_fmt = pictures[0].format.name
        if rotation_deg:
            stream.set_display_rotation(rotation_deg)
        for name, value in tags.items():
            setattr(stream.codec_context, name, value)
        for number, frame in enumerate(pictures):
            frame.pts = pts[number] if pts else number
            frame.time_base = Fraction(1, rate)
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    return path


@pytest.fixture(scope="session")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """5 s, 320 x 180, 30 fps, numbered pictures, clicks in stereo at 48 kHz."""
    path = tmp_path_factory.mktemp("media") / "numbered.mp4"
    write_clip(
        path,
        numbered_pictures(150),
        frame_rate_hz=30.0,
        audio=clicks(5.0),
        audio_rate_hz=RATE_HZ,
    )
    return path
