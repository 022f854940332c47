from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import Cancelled, InputError, MediaError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.video import VideoDecoder
from tests.unit.media.conftest import clicks, numbered_pictures


def test_progress_counts_the_seconds(tmp_path: Path) -> None:
    progress: list[float] = []
    write_clip(
        tmp_path / "clip.mp4",
        numbered_pictures(10),
        frame_rate_hz=25.0,
        progress=progress.append,
    )
    assert progress == pytest.approx(np.arange(1, 11) / 25.0)


def test_cancelling_leaves_nothing(tmp_path: Path) -> None:
    def stop(_written_s: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        write_clip(
            tmp_path / "clip.mp4",
            numbered_pictures(10),
            frame_rate_hz=25.0,
            progress=stop,
        )
    assert list(tmp_path.iterdir()) == []


def test_failure_keeps_the_older_file(tmp_path: Path) -> None:
    path = tmp_path / "clip.mp4"
    path.write_text("older")
    pictures = [np.zeros((48, 64, 3), np.uint8), np.zeros((48, 80, 3), np.uint8)]
    with pytest.raises(
        MediaError, match=r"shape \(48, 80, 3\), expected \(48, 64, 3\)"
    ):
        write_clip(path, pictures, frame_rate_hz=25.0)
    assert path.read_text() == "older"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("pictures", "sentence"),
    [
        ([], "no frames"),
        ([np.zeros((48, 64), np.uint8)], "shape"),
        ([np.zeros((47, 63, 3), np.uint8)], "cannot be written"),
    ],
)
def test_impossible_frames_are_refused(
    tmp_path: Path, pictures: list[np.ndarray], sentence: str
) -> None:
    with pytest.raises(MediaError, match=sentence):
        write_clip(tmp_path / "clip.mp4", pictures, frame_rate_hz=25.0)
    assert list(tmp_path.iterdir()) == []


def test_a_clip_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match=r"file: cannot be written"):
        write_clip(
            tmp_path / "file" / "clip.mp4", numbered_pictures(1), frame_rate_hz=25.0
        )


def test_a_key_frame_comes_at_least_every_two_seconds(clip: Path) -> None:
    with av.open(str(clip)) as container:
        stream = container.streams.video[0]
        keys = [
            float(packet.pts * packet.time_base)
            for packet in container.demux(stream)
            if packet.pts is not None and packet.is_keyframe
        ]
    assert keys[0] == 0.0
    assert np.diff([*keys, 5.0]).max() <= 2.0 + 1e-6


def test_index_stands_in_front(clip: Path) -> None:
    content = clip.read_bytes()
    assert content.index(b"moov") < content.index(b"mdat")


@pytest.mark.parametrize("rate_hz", [24.0, 29.97, 30000 / 1001, 59.94])
def test_odd_frame_rates_keep_their_times(tmp_path: Path, rate_hz: float) -> None:
    path = tmp_path / "clip.mp4"
    write_clip(path, numbered_pictures(40, 48, 80), frame_rate_hz=rate_hz)
    assert probe(path).frame_rate_hz == pytest.approx(rate_hz, abs=2e-3)
    with VideoDecoder(path) as decoder:
        times_s = [frame.pts_s for frame in decoder.frames()]
    # the container counts in ticks of about 20 us
    assert times_s == pytest.approx(np.arange(40) / rate_hz, abs=1e-4)


def test_sound_that_is_longer_than_the_pictures_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "clip.mp4"
    write_clip(
        path, numbered_pictures(10), frame_rate_hz=30.0, audio=clicks(2.0)[:, :1]
    )
    with av.open(str(path)) as container:
        sound = container.streams.audio[0]
        assert float(sound.duration * sound.time_base) >= 2.0


def test_sound_of_a_wrong_shape_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MediaError, match=r"expected \(n, 1\) or \(n, 2\)"):
        write_clip(
            tmp_path / "clip.mp4",
            numbered_pictures(2),
            frame_rate_hz=30.0,
            audio=np.zeros((100, 3), np.float32),
        )


def test_a_smaller_rate_factor_is_nearer_to_the_frames(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    noise = [rng.integers(60, 200, (48, 64, 1), np.uint8) for _ in range(5)]
    frames = [np.repeat(one, 3, axis=2) for one in noise]
    errors = {}
    for factor in (8.0, 30.0):
        path = tmp_path / f"{factor:g}.mp4"
        write_clip(path, frames, frame_rate_hz=25.0, rate_factor=factor)
        with VideoDecoder(path) as decoder:
            luma = [one.native.to_ndarray(format="gray") for one in decoder.frames()]
        wrong = np.array(luma, float) - np.array(noise, float)[..., 0]
        errors[factor] = wrong.std()
    assert errors[8.0] < 0.5 * errors[30.0]
