"""Streams that nobody shows are not read."""

from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.video import VideoDecoder

PICTURES, RATE_HZ, SOUNDS = 30, 15, 3
SOUND_HZ = 48_000


@pytest.fixture(scope="module")
def crowded(tmp_path_factory):
    """A clip with one picture stream, three languages and subtitles."""
    path = tmp_path_factory.mktemp("crowded") / "clip.mkv"
    rng = np.random.default_rng(4)
    with av.open(str(path), "w") as file:
        video = file.add_stream("libx264", rate=RATE_HZ)
        video.width, video.height, video.pix_fmt = 96, 64, "yuv420p"
        sounds = [file.add_stream("pcm_s16le", rate=SOUND_HZ) for _ in range(SOUNDS)]
        for sound in sounds:
            sound.layout = "stereo"
        count = SOUND_HZ // RATE_HZ
        for number in range(PICTURES):
            picture = rng.integers(0, 256, (64, 96, 3)).astype(np.uint8)
            file.mux(video.encode(av.VideoFrame.from_ndarray(picture, "rgb24")))
            for sound in sounds:
                noise = rng.integers(-9000, 9000, (1, 2 * count)).astype(np.int16)
                frame = av.AudioFrame.from_ndarray(noise, "s16", "stereo")
                frame.sample_rate, frame.pts = SOUND_HZ, number * count
                frame.time_base = Fraction(1, SOUND_HZ)
                file.mux(sound.encode(frame))
        for stream in (video, *sounds):
            file.mux(stream.encode(None))
    return path


def packets(container, index):
    """Return the packets of one stream, and how many the demuxer gave in all."""
    given = [p for p in container.demux() if p.size]
    mine = [(p.pts, bytes(p)) for p in given if p.stream.index == index]
    return mine, len(given)


@pytest.mark.parametrize("decoder", [VideoDecoder, AudioDecoder])
def test_a_decoder_reads_its_own_stream_and_no_other(crowded, decoder):
    index = 0 if decoder is VideoDecoder else 1
    with av.open(str(crowded)) as whole:
        all_mine, everything = packets(whole, index)
    assert everything >= (1 + SOUNDS) * PICTURES
    with decoder(crowded) as made:
        made._container.seek(0)
        mine, read = packets(made._container, index)
    assert read == len(mine) == len(all_mine)
    assert mine == all_mine
