"""Motion vectors of clips whose whole picture moves by a known step."""

from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.media.vectors import VectorDecoder, block_motion, is_between

WIDTH, HEIGHT = 192, 128
STEP_PX = np.array([3, -2])  # of what is shown, right and down, per frame
FRAMES = 12


def moving(path: Path, codec: str = "libx264", **options: str) -> Path:
    """Write a view of a smooth random picture that moves."""
    rng = np.random.default_rng(8)
    size = (HEIGHT + 4 * FRAMES + 8, WIDTH + 4 * FRAMES + 8)
    coarse = rng.uniform(0, 255, (size[0] // 4 + 2, size[1] // 4 + 2))
    scene = np.kron(coarse, np.ones((4, 4)))[: size[0], : size[1]].astype(np.uint8)
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=30, options=options)
        stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, "yuv420p"
        for number in range(FRAMES):
            x, y = 4 * FRAMES - STEP_PX[0] * number, 4 - STEP_PX[1] * number
            view = np.ascontiguousarray(scene[y : y + HEIGHT, x : x + WIDTH])
            frame = av.VideoFrame.from_ndarray(view, "gray").reformat(format="yuv420p")
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    return path


def frames_of(path: Path) -> list[DecodedFrame]:
    with VectorDecoder(path) as decoder:
        return list(decoder.frames())


def test_vectors_are_how_the_picture_moves(tmp_path):
    clip = moving(tmp_path / "moving.mp4", preset="veryfast", bf="0")

    first, *others = frames_of(clip)

    assert not len(block_motion(first, WIDTH, HEIGHT).before)
    for frame in others:
        before, after = block_motion(frame, WIDTH, HEIGHT)
        assert len(after) >= WIDTH * HEIGHT / 256
        flow = np.median(after - before, axis=0)
        np.testing.assert_allclose(flow, STEP_PX, atol=0.26)
    # the middle of the first block of 16 px lies between its pixels 7 and 8
    assert after.min() == pytest.approx(7.5)
    halved = block_motion(others[-1], WIDTH // 2, HEIGHT // 2)
    np.testing.assert_allclose(halved.after + 0.5, 0.5 * (after + 0.5))


def test_frames_not_in_between_refer_to_each_other(tmp_path):
    clip = moving(tmp_path / "moving.mp4", bf="2", **{"x264-params": "b-adapt=0"})
    frames = frames_of(clip)

    kept = [frame for frame in frames if not is_between(frame)]

    assert 3 <= len(kept) <= FRAMES / 2
    steps = np.diff([round(30 * frame.pts_s) for frame in kept])
    for step, frame in zip(steps, kept[1:], strict=True):
        before, after = block_motion(frame, WIDTH, HEIGHT)
        flow = np.median(after - before, axis=0)
        np.testing.assert_allclose(flow, step * STEP_PX, atol=0.26)


@pytest.mark.parametrize("quarter_turns", [1, 2, 3])
def test_vectors_turn_with_the_frame(tmp_path, monkeypatch, quarter_turns):
    clip = moving(tmp_path / "moving.mp4", preset="veryfast", bf="0")
    frame = frames_of(clip)[-1]
    plain = block_motion(frame, WIDTH, HEIGHT)
    monkeypatch.setattr(
        "hapticplayer.media.vectors.rotation_of", lambda _native: 90 * quarter_turns
    )

    size = (WIDTH, HEIGHT) if quarter_turns == 2 else (HEIGHT, WIDTH)
    turned = block_motion(frame, *size)

    # as numpy turns the pixels of the frame
    marks = np.zeros((HEIGHT, WIDTH))
    x, y = np.floor(plain.after[5]).astype(int)
    marks[y : y + 2, x : x + 2] = 1.0  # around the middle of a block
    row, column = np.argwhere(np.rot90(marks, quarter_turns)).mean(axis=0)
    np.testing.assert_allclose(turned.after[5], (column, row))
    assert len(turned.before) == len(plain.before)


def test_other_codecs_are_refused_with_the_way_out(tmp_path):
    clip = moving(tmp_path / "moving.mp4", "mpeg4")

    with pytest.raises(MediaError, match=r"mpeg4.*hapticplayer\[vision\]"):
        VectorDecoder(clip)
