import itertools
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.errors import MediaError
from hapticplayer.media.audio import AudioBlock, AudioDecoder
from hapticplayer.media.encode import write_clip
from tests.unit.media.conftest import CLICKS_S, clicks, numbered_pictures, write_plain


def blocks_of(decoder: AudioDecoder) -> list[AudioBlock]:
    return list(iter(decoder.next_block, None))


def click_s(blocks: list[AudioBlock], near_s: float, rate_hz: int) -> float:
    """Centre of gravity of the energy within 2 ms of `near_s`."""
    weights, times = [], []
    for block in blocks:
        time_s = block.media_s + np.arange(len(block.samples)) / rate_hz
        is_near = np.abs(time_s - near_s) < 2e-3
        times.append(time_s[is_near])
        weights.append(np.square(block.samples[is_near, 0], dtype=np.float64))
    return float(np.average(np.concatenate(times), weights=np.concatenate(weights)))


def test_whole_sound_is_contiguous(clip: Path) -> None:
    with AudioDecoder(clip) as decoder:
        blocks = blocks_of(decoder)
        assert decoder.next_block() is None
    assert blocks[0].media_s == 0.0
    for before, after in itertools.pairwise(blocks):
        end_s = before.media_s + len(before.samples) / 48_000
        assert after.media_s == pytest.approx(end_s, abs=1e-9)
    total = sum(len(block.samples) for block in blocks)
    assert 5.0 * 48_000 <= total < 5.0 * 48_000 + 2048  # AAC pads to 1024


def test_blocks_are_interleaved_float32(clip: Path) -> None:
    with AudioDecoder(clip) as decoder:
        block = decoder.next_block()
    assert block is not None
    assert block.samples.dtype == np.float32
    assert block.samples.shape[1] == 2
    assert block.samples.flags.c_contiguous
    assert not block.samples.flags.writeable


@pytest.mark.parametrize("from_s", [0.0, 0.7, 0.7421, 1.9, 2.25, 3.9])
def test_clicks_keep_their_place_after_a_seek(clip: Path, from_s: float) -> None:
    with AudioDecoder(clip) as decoder:
        decoder.seek(from_s)
        blocks = blocks_of(decoder)
    half_a_sample = 0.5 / 48_000 + 1e-9
    assert blocks[0].media_s == pytest.approx(from_s, abs=half_a_sample)
    for at_s in CLICKS_S:
        if at_s > from_s + 2e-3:
            # a tenth of a sample: what AAC does to a click of 0.2 ms
            assert click_s(blocks, at_s, 48_000) == pytest.approx(at_s, abs=2e-6)


def test_sound_after_a_seek_equals_the_sound_without(clip: Path) -> None:
    with AudioDecoder(clip) as decoder:
        whole = np.concatenate([block.samples for block in blocks_of(decoder)])
        for from_s in np.random.default_rng(4).uniform(0.0, 4.5, 6):
            decoder.seek(from_s)
            first = decoder.next_block()
            assert first is not None
            start = round(first.media_s * 48_000)
            # the codec's overlap has settled: equal to the last bits of float32
            np.testing.assert_allclose(
                first.samples, whole[start : start + len(first.samples)], atol=1e-5
            )


@pytest.mark.parametrize("rate_hz", [44_100, 48_000, 22_050])
@pytest.mark.parametrize("channels", [1, 2])
def test_resampled_clicks_keep_their_place(
    tmp_path: Path, rate_hz: int, channels: int
) -> None:
    path = tmp_path / "clip.mp4"
    write_clip(
        path,
        numbered_pictures(120),
        frame_rate_hz=30.0,
        audio=clicks(4.0, rate_hz)[:, :channels],
        audio_rate_hz=rate_hz,
    )
    with AudioDecoder(path) as decoder:
        blocks = blocks_of(decoder)
        decoder.seek(2.0)
        late_blocks = blocks_of(decoder)
    for at_s in CLICKS_S[:2]:
        # a quarter of a sample at the lower rate; 22 kHz band-limits the click
        assert click_s(blocks, at_s, 48_000) == pytest.approx(at_s, abs=1.2e-5)
    assert click_s(late_blocks, 2.3, 48_000) == pytest.approx(2.3, abs=1.2e-5)


@pytest.mark.parametrize(("codec", "channels"), [("aac", 2), ("aac", 1), ("opus", 2)])
def test_sound_of_the_wanted_format_bypasses_the_resampler(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, codec: str, channels: int
) -> None:
    path = tmp_path / "sound.mkv"
    t = np.arange(48_000) / 48_000
    tones = [0.3 * np.sin(2 * np.pi * f * t) for f in (440, 660)][:channels]
    layout = ("mono", "stereo")[channels - 1]
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=48_000, layout=layout)
        rows = np.stack(tones, axis=1).astype(np.float32).reshape(1, -1)
        frame = av.AudioFrame.from_ndarray(rows, format="flt", layout=layout)
        frame.rate, frame.time_base = 48_000, Fraction(1, 48_000)
        container.mux(stream.encode(frame))
        container.mux(stream.encode(None))
    resampler = av.AudioResampler("flt", layout, 48_000)
    with av.open(str(path)) as container:
        frames = [f for d in container.decode(audio=0) for f in resampler.resample(d)]
        frames += resampler.resample(None)
    wanted = np.concatenate([f.to_ndarray().reshape(-1, channels) for f in frames])
    monkeypatch.setattr("hapticplayer.media.audio.AudioResampler", None)
    with AudioDecoder(path, channels=channels) as decoder:
        found = np.concatenate([block.samples for block in blocks_of(decoder)])
    assert len(found) >= 48_000
    np.testing.assert_array_equal(found, wanted[-len(found) :])


def sound_file(
    path: Path, runs: list[tuple[float, NDArray[np.float32]]], codec: str
) -> Path:
    """Write runs of sound at given times beside two seconds of video."""
    with av.open(str(path), "w") as container:
        video = container.add_stream("libx264", rate=30)
        video.width, video.height, video.pix_fmt = 64, 48, "yuv420p"
        sound = container.add_stream(codec, rate=48_000, layout="stereo")
        for number in range(60):
            picture = av.VideoFrame(64, 48, "yuv420p")
            picture.pts, picture.time_base = number, Fraction(1, 30)
            container.mux(video.encode(picture))
        for start_s, samples in runs:
            for first in range(0, len(samples), 1024):
                chunk = samples[first : first + 1024]
                packed = np.ascontiguousarray((chunk * 32767).astype(np.int16))
                frame = av.AudioFrame.from_ndarray(
                    packed.reshape(1, -1), format="s16", layout="stereo"
                )
                frame.sample_rate = 48_000
                frame.pts = round(start_s * 48_000) + first
                frame.time_base = Fraction(1, 48_000)
                container.mux(sound.encode(frame))
        container.mux(video.encode())
        container.mux(sound.encode(None))
    return path


def test_gap_shows_in_the_times(tmp_path: Path) -> None:
    tone = np.full((9600, 2), 0.5, np.float32)
    path = sound_file(
        tmp_path / "gap.mkv", [(0.0, tone), (1.0, tone)], codec="pcm_s16le"
    )
    with AudioDecoder(path) as decoder:
        blocks = blocks_of(decoder)
        starts = [block.media_s for block in blocks]
        assert any(start == pytest.approx(1.0, abs=1e-6) for start in starts)
        assert not any(0.2 + 1e-6 < start < 1.0 - 1e-6 for start in starts)
        decoder.seek(0.6)
        first = decoder.next_block()
    assert first is not None
    assert first.media_s == pytest.approx(1.0, abs=1e-6)


def test_matroska_times_do_not_jitter(tmp_path: Path) -> None:
    path = sound_file(tmp_path / "clip.mkv", [(0.0, clicks(2.0))], codec="pcm_s16le")
    with AudioDecoder(path) as decoder:
        blocks = blocks_of(decoder)
    lengths = np.array([len(block.samples) for block in blocks])
    ends_s = [block.media_s for block in blocks[1:]]
    assert ends_s == pytest.approx(np.cumsum(lengths)[:-1] / 48_000, abs=1e-9)
    assert click_s(blocks, 0.75, 48_000) == pytest.approx(0.75, abs=2e-6)


def test_sound_before_the_first_picture_is_not_heard(tmp_path: Path) -> None:
    path = tmp_path / "late.mkv"
    with av.open(str(path), "w") as container:
        video = container.add_stream("libx264", rate=30)
        video.width, video.height, video.pix_fmt = 64, 48, "yuv420p"
        sound = container.add_stream("pcm_s16le", rate=48_000, layout="mono")
        samples = (clicks(2.0)[:, :1].T * 32767).astype(np.int16)
        frame = av.AudioFrame.from_ndarray(samples, format="s16", layout="mono")
        frame.sample_rate, frame.pts = 48_000, 0
        container.mux(sound.encode(frame))
        for number in range(15, 60):
            picture = av.VideoFrame(64, 48, "yuv420p")
            picture.pts, picture.time_base = number, Fraction(1, 30)
            container.mux(video.encode(picture))
        container.mux(video.encode())
    with AudioDecoder(path) as decoder:
        blocks = blocks_of(decoder)
    assert blocks[0].media_s == pytest.approx(0.0, abs=1e-5)
    assert click_s(blocks, 0.25, 48_000) == pytest.approx(0.25, abs=2e-5)


def test_clip_without_sound_is_refused(tmp_path: Path) -> None:
    path = write_plain(tmp_path / "mute.mp4", [av.VideoFrame(64, 48, "yuv420p")])
    with pytest.raises(MediaError, match="holds no sound"):
        AudioDecoder(path)


def test_odd_number_of_channels_is_a_wrong_call(clip: Path) -> None:
    with pytest.raises(ValueError, match="3 channels"):
        AudioDecoder(clip, channels=3)
