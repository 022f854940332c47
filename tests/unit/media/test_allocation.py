import platform
import subprocess
import sys
from pathlib import Path

import pytest

from hapticplayer.media import VideoDecoder
from tests.unit.media.conftest import numbered_pictures
from tests.unit.media.test_approach import KINDS, write_moving

COUNT_FAULTS = """
import resource, sys, threading
from hapticplayer.media import VideoDecoder, probe

def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt

def play():
    with VideoDecoder(sys.argv[1]) as decoder:
        frame = decoder.next_frame()
        kept = []
        for number in range(60):
            if number == 30:
                before = faults()
            kept = [*kept[-5:], decoder.convert(frame, 1280, 720)]
        print((faults() - before) / 30)

probe(sys.argv[1])
thread = threading.Thread(target=play)
thread.start()
thread.join()
"""


@pytest.mark.skipif(
    platform.libc_ver()[0] != "glibc", reason="what glibc does is meant"
)
def test_memory_of_pictures_is_used_again(tmp_path: Path) -> None:
    path = write_moving(tmp_path / "clip.mp4", KINDS["no b frames"], list(range(10)))
    command = [sys.executable, "-c", COUNT_FAULTS, str(path)]
    found = subprocess.run(command, capture_output=True, check=True, text=True)
    # a picture of 720p has 900 pages; given back and asked for again, each costs a fault
    assert float(found.stdout) < 45.0


def test_a_decoder_that_is_closed_leaves_the_others_alone(clip: Path) -> None:
    with VideoDecoder(clip) as decoder:
        VideoDecoder(clip).close()
        frame = decoder.next_frame()
        assert frame is not None
        rgb = decoder.convert(frame, 320, 180).as_rgb()
    expected = next(iter(numbered_pictures(1)))
    assert abs(rgb.astype(float) - expected).mean() < 3.0
