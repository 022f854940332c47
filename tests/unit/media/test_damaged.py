"""Damaged files end in a MediaError or play on; nothing else gets out."""

from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.telemetry import read_telemetry_packets
from hapticplayer.media.video import VideoDecoder
from tests.faults.media_cases import mutated
from tests.unit.media.conftest import clicks, numbered_pictures


@pytest.fixture(scope="module")
def noisy_clip(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """2 s with pictures that do not compress, so that damage meets them."""
    rng = np.random.default_rng(8)
    path = tmp_path_factory.mktemp("noisy") / "clip.mp4"
    noise = rng.integers(0, 256, (30, 96, 128, 3)).astype(np.uint8)
    write_clip(path, noise, frame_rate_hz=15.0, audio=clicks(2.0))
    return path.read_bytes()


def play(path: Path) -> None:
    with VideoDecoder(path) as decoder:
        last_s = -np.inf
        for frame in decoder.frames():
            assert frame.pts_s > last_s
            last_s = frame.pts_s
            FrameConverter().convert(frame, 64, 48)
        decoder.seek(1.0)
        decoder.next_frame()


def listen(path: Path) -> None:
    with AudioDecoder(path) as decoder:
        while (block := decoder.next_block()) is not None:
            assert np.isfinite(block.media_s)
        decoder.seek(0.5)
        decoder.next_block()


def test_damage_is_survived(tmp_path: Path, noisy_clip: bytes) -> None:
    rng = np.random.default_rng(6)
    path = tmp_path / "damaged.mp4"
    refusals = []
    for _ in range(30):
        path.write_bytes(mutated(noisy_clip, rng))
        for use in (probe, play, listen, read_telemetry_packets):
            try:
                use(path)
            except MediaError as error:
                refusals.append(str(error))
    assert 0 < len(refusals) < 100
    assert not any("\n" in refusal for refusal in refusals)


def test_frames_without_times_follow_each_other(tmp_path: Path) -> None:
    """AVI holds H.264 with B frames but not their times of presentation."""
    path = tmp_path / "clip.avi"
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=30)
        stream.width, stream.height, stream.pix_fmt = 320, 180, "yuv420p"
        for number, picture in enumerate(numbered_pictures(60)):
            frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
            frame.pts = number
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    with VideoDecoder(path) as decoder:
        times_s = [frame.pts_s for frame in decoder.frames()]
        assert decoder.damaged == 0
    assert len(times_s) == 60
    assert np.diff(times_s).min() > 0.0
    # three frames: what reordering can move a picture by
    assert np.abs(times_s - np.arange(60) / 30).max() < 3.5 / 30
