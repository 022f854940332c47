"""Colours and shapes against the conversion of the ffmpeg program itself."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.media import VideoDecoder, probe

pytestmark = pytest.mark.skipif(
    shutil.which("ffmpeg") is None, reason="the program ffmpeg is not installed"
)

MATRICES = {"601": "smpte170m", "709": "bt709", "2020": "bt2020nc"}
MOST_LEVELS = 1.0


def ffmpeg(*arguments: str) -> bytes:
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", *arguments]
    return subprocess.run(command, check=True, capture_output=True).stdout


def clip(
    path: Path, size: str, matrix: str, colour_range: str, pixels: str, extra: str = ""
) -> Path:
    """Encode a smooth, colourful picture that is tagged as what it is."""
    scale = f"scale={size.replace('x', ':')}:out_color_matrix={MATRICES[matrix]}:out_range={colour_range}"
    chain = f"gblur=sigma=30,{scale},format={pixels}{extra}"
    ffmpeg(
        *("-f", "lavfi", "-i", f"testsrc2=size={size}:rate=5:duration=0.2"),
        *("-vf", chain, "-c:v", "libx264", "-crf", "10"),
        *("-colorspace", MATRICES[matrix], "-color_range", colour_range),
        *("-color_primaries", "bt709", "-color_trc", "bt709", str(path)),
    )
    return path


def reference(path: Path, width: int, height: int, source: str = "") -> np.ndarray:
    """Return what ffmpeg makes of the first picture, rotated and in square pixels."""
    scale = f"scale={width}:{height}{source}"
    raw = ffmpeg(
        *("-i", str(path), "-frames:v", "1", "-vf", f"{scale},format=rgb24"),
        *("-f", "rawvideo", "-"),
    )
    return np.frombuffer(raw, np.uint8).reshape(height, width, 3)


def shown(path: Path) -> np.ndarray:
    """Return what is painted, at the size as shown."""
    with VideoDecoder(path) as decoder:
        frame = decoder.next_frame()
        return decoder.convert(frame, decoder.width, decoder.height).as_rgb()


def levels_apart(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.abs(a.astype(int) - b.astype(int)).mean())


@pytest.mark.parametrize(
    ("colour_range", "pixels"),
    [("tv", "yuv420p"), ("pc", "yuv420p"), ("tv", "yuv420p10le")],
)
@pytest.mark.parametrize("matrix", MATRICES)
def test_tagged_colours_are_those_of_ffmpeg(tmp_path, matrix, colour_range, pixels):
    path = clip(tmp_path / "clip.mp4", "320x180", matrix, colour_range, pixels)
    ours = shown(path)
    assert levels_apart(ours, reference(path, 320, 180)) < MOST_LEVELS
    # and the test could tell: another matrix is several levels off
    other = "bt709" if matrix != "709" else "smpte170m"
    wrong = reference(path, 320, 180, f":in_color_matrix={other}")
    assert levels_apart(ours, wrong) > 2.0 * MOST_LEVELS


@pytest.mark.parametrize("size", ["322x182", "130x98", "332x180"])
def test_sizes_that_no_block_divides_are_those_of_ffmpeg(tmp_path, size):
    path = clip(tmp_path / "clip.mp4", size, "709", "tv", "yuv420p")
    width, height = map(int, size.split("x"))
    assert levels_apart(shown(path), reference(path, width, height)) < MOST_LEVELS


def test_an_odd_size_loses_at_most_a_column(tmp_path):
    path = clip(tmp_path / "clip.mp4", "321x181", "709", "tv", "yuv444p")
    ours = shown(path)
    assert ours.shape == (181, 322, 3)
    assert levels_apart(ours, reference(path, 322, 181)) < MOST_LEVELS


@pytest.mark.parametrize("aspect", ["4/3", "8/9"])
def test_pixels_that_are_not_square_become_so(tmp_path, aspect):
    path = clip(
        tmp_path / "clip.mp4", "240x180", "601", "tv", "yuv420p", f",setsar={aspect}"
    )
    info = probe(path)
    top, bottom = map(int, aspect.split("/"))
    assert (info.width, info.height) == (round(240 * top / bottom), 180)
    ours = shown(path)
    assert levels_apart(ours, reference(path, ours.shape[1], 180)) < MOST_LEVELS


@pytest.mark.parametrize("turn_deg", [90, 270])
def test_a_turned_clip_is_turned_as_ffmpeg_turns_it(tmp_path, turn_deg):
    lying = clip(tmp_path / "lying.mp4", "320x180", "709", "tv", "yuv420p")
    path = tmp_path / "turned.mp4"
    turn = ("-metadata:s:v", f"rotate={turn_deg}")
    ffmpeg("-i", str(lying), "-c", "copy", *turn, str(path))
    ours = shown(path)
    assert levels_apart(ours, reference(path, 180, 320)) < MOST_LEVELS
