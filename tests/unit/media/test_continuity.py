"""Dropped frames are distinguished from frames that were never meant to be there."""

from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.media.video import VideoDecoder

RATE_HZ = 25
EVEN = list(range(40))
UNEVEN = [n for n in EVEN if n % 7 not in (2, 3) and n % 5 != 4]


def clip(path, numbers):
    """Write pictures that stay until the next; x264 puts B frames between them."""
    with av.open(str(path), "w") as file:
        stream = file.add_stream("libx264", rate=RATE_HZ)
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuv420p"
        stream.time_base = stream.codec_context.time_base = Fraction(1, 1000)
        for number in numbers:
            picture = av.VideoFrame.from_ndarray(
                np.full((48, 64, 3), 5 * number, np.uint8), format="rgb24"
            )
            picture.time_base = Fraction(1, 1000)
            picture.pts = number * 1000 // RATE_HZ
            file.mux(stream.encode(picture))
        file.mux(stream.encode(None))
    return path


def damage_of(path):
    with VideoDecoder(path) as decoder:
        count = sum(1 for _ in decoder.frames())
        return count, decoder.damaged


@pytest.mark.parametrize("container", ["mp4", "mov", "mkv"])
@pytest.mark.parametrize("numbers", [EVEN, UNEVEN], ids=["even", "uneven"])
def test_a_whole_clip_has_no_holes(tmp_path, container, numbers):
    path = clip(tmp_path / f"clip.{container}", numbers)
    assert damage_of(path) == (len(numbers), 0)


def test_after_seeks_a_whole_clip_has_no_holes_either(tmp_path):
    with VideoDecoder(clip(tmp_path / "clip.mp4", EVEN)) as decoder:
        for media_s in (1.2, 0.1, 1.5, 0.7):
            decoder.seek(media_s)
            list(decoder.frames())
        assert decoder.damaged == 0


@pytest.mark.parametrize("gone", [range(20, 30), range(3, 4)])
def test_packets_that_are_gone_leave_a_hole(tmp_path, gone):
    """Repacked without some pictures, with the times of the others."""
    whole, lossy = clip(tmp_path / "whole.mp4", EVEN), tmp_path / "lossy.mkv"
    with av.open(str(whole)) as source, av.open(str(lossy), "w") as target:
        stream = target.add_stream_from_template(source.streams.video[0])
        for packet in source.demux(video=0):
            if packet.dts is None:
                continue
            if round(packet.pts * packet.time_base * RATE_HZ) not in gone:
                packet.stream = stream
                target.mux(packet)
    assert damage_of(lossy)[1] >= 1
