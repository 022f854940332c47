"""Colours and shapes against the conversion of the ffmpeg program itself."""

import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder

pytestmark = pytest.mark.skipif(
    shutil.which("ffmpeg") is None, reason="the program ffmpeg is not installed"
)

MATRICES = {"601": "smpte170m", "709": "bt709", "2020": "bt2020nc"}
OF_SCALE = {**MATRICES, "2020": "bt2020"}
"""The same, as ffmpeg's scaler has named them through all its versions."""
TURNS = {90: (0, 1, -1, 0), 180: (-1, 0, 0, -1), 270: (0, -1, 1, 0)}
MATRIX_AT = 44
"""Bytes from the name of a track header to its matrix of 16.16 numbers."""
MOST_LEVELS = 1.0
SMOOTH = "gblur=sigma=30,{scale}"
DETAILED = "{scale},gblur=sigma=12:planes=6,noise=c0s=20:c0_seed=3"
"""Edges and grain down to the pixel in the luma; colours as soft as those of cameras,
for there is no one way to spread a colour sample over the four pixels that share it."""


def ffmpeg(*arguments: str) -> bytes:
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", *arguments]
    return subprocess.run(command, check=True, capture_output=True).stdout


def clip(
    path: Path,
    size: str,
    matrix: str,
    colour_range: str,
    pixels: str,
    extra: str = "",
    chain: str = SMOOTH,
) -> Path:
    """Encode a colourful picture that is tagged as what it is."""
    scale = f"scale={size.replace('x', ':')}:out_color_matrix={OF_SCALE[matrix]}:out_range={colour_range}"
    chain = chain.format(scale=f"{scale},format={pixels}") + extra
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


def painted_reference(path: Path, width: int, height: int) -> np.ndarray:
    """As `reference`, by linear interpolation and as a window wants it: B, G, R, -."""
    scale = f"scale={width}:{height}:flags=bilinear,format=bgra"
    raw = ffmpeg(
        *("-i", str(path), "-frames:v", "1", "-vf", scale, "-f", "rawvideo", "-")
    )
    return np.frombuffer(raw, np.uint8).reshape(height, width, 4)[:, :, 2::-1]


def shown(path: Path) -> np.ndarray:
    """Return what is painted, at the size as shown."""
    with VideoDecoder(path) as decoder:
        frame = decoder.next_frame()
        return FrameConverter().convert(frame, decoder.width, decoder.height).as_rgb()


def turn(path: Path, turn_deg: int) -> None:
    """Write into a clip that it is shown turned clockwise: ffmpeg's option changed."""
    content = bytearray(path.read_bytes())
    begin = content.index(b"tkhd") + MATRIX_AT
    a, b, c, d = TURNS[turn_deg]
    content[begin : begin + 20] = struct.pack(
        ">5i", a << 16, b << 16, 0, c << 16, d << 16
    )
    path.write_bytes(content)


def levels_apart(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.abs(a.astype(int) - b.astype(int)).mean())


@pytest.mark.parametrize("matrix", MATRICES)
def test_tagged_colours_are_those_of_ffmpeg(tmp_path, matrix):
    path = clip(tmp_path / "clip.mp4", "320x180", matrix, "tv", "yuv420p")
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


@pytest.mark.parametrize(
    ("colour_range", "pixels", "size"),
    [
        ("tv", "yuv420p", "322x182"),
        ("pc", "yuv420p", "320x180"),
        ("tv", "yuv420p10le", "320x180"),
        ("pc", "yuv420p10le", "322x182"),
        ("tv", "yuv444p", "322x182"),
    ],
)
@pytest.mark.parametrize("matrix", MATRICES)
def test_a_detailed_picture_is_that_of_ffmpeg(
    tmp_path, matrix, colour_range, pixels, size
):
    path = clip(
        tmp_path / "clip.mp4", size, matrix, colour_range, pixels, chain=DETAILED
    )
    width, height = map(int, size.split("x"))
    ours, theirs = shown(path), reference(path, width, height)
    assert levels_apart(ours, theirs) < MOST_LEVELS
    # and it is detailed: the neighbours of a pixel are many levels away
    assert np.abs(np.diff(theirs.astype(int), axis=1)).mean() > 5.0


@pytest.mark.parametrize("aspect", ["4/3", "8/9"])
def test_a_detailed_picture_is_stretched_as_ffmpeg_does(tmp_path, aspect):
    """Between two pixels there are several truths: this one is the linear one."""
    path = clip(
        tmp_path / "clip.mp4", "240x180", "601", "tv", "yuv420p",
        f",setsar={aspect}", DETAILED,
    )  # fmt: skip
    info = probe(path)
    top, bottom = map(int, aspect.split("/"))
    assert (info.width, info.height) == (round(240 * top / bottom), 180)
    ours = shown(path)
    theirs = painted_reference(path, ours.shape[1], 180)
    assert levels_apart(ours, theirs) < MOST_LEVELS


@pytest.mark.parametrize("turn_deg", [90, 180, 270])
def test_a_detailed_picture_is_turned_as_ffmpeg_turns_it(tmp_path, turn_deg):
    path = clip(
        tmp_path / "clip.mp4", "320x176", "709", "tv", "yuv420p", chain=DETAILED
    )
    lying = shown(path)
    turn(path, turn_deg)
    ours = shown(path)
    height, width = ours.shape[:2]
    assert (width, height) == ((320, 176) if turn_deg == 180 else (176, 320))
    assert levels_apart(ours, np.rot90(lying, -turn_deg // 90)) < MOST_LEVELS
    assert levels_apart(ours, reference(path, width, height)) < MOST_LEVELS


def test_a_detailed_odd_size_loses_at_most_a_column(tmp_path):
    path = clip(
        tmp_path / "clip.mp4", "321x181", "709", "tv", "yuv444p", chain=DETAILED
    )
    ours = shown(path)
    assert ours.shape == (181, 322, 3)
    theirs = painted_reference(path, 322, 181)
    assert levels_apart(ours, theirs) < MOST_LEVELS
