"""Frames that follow each other use the same memory: counted in page faults."""

import subprocess
import sys

import pytest

CONVERT = """
import resource, sys, threading
from collections import deque
import numpy as np
from av.video.frame import VideoFrame
from hapticplayer.media.memory import keep_freed_memory
from hapticplayer.media.frames import DecodedFrame, FrameConverter

keep_freed_memory()
frames = [DecodedFrame(0.0, 0.0, VideoFrame.from_ndarray(
    np.full((1620, 1920), k, np.uint8), format="yuv420p")) for k in range(2)]
queue, faults = deque(maxlen=5), []

def decode():
    converter = FrameConverter()
    for number in range(80):
        if number == 40:
            faults.append(resource.getrusage(resource.RUSAGE_SELF).ru_minflt)
        queue.append(converter.convert(frames[number % 2], 1920, 1080))
    faults.append(resource.getrusage(resource.RUSAGE_SELF).ru_minflt)

thread = threading.Thread(target=decode)
thread.start()
thread.join()
print((faults[1] - faults[0]) / 40)
"""
PAGES = 1920 * 1080 * 4 / 4096


@pytest.mark.skipif(sys.platform != "linux", reason="of glibc")
def test_a_frame_costs_no_fresh_memory():
    done = subprocess.run(
        [sys.executable, "-c", CONVERT], capture_output=True, text=True, check=True
    )
    assert float(done.stdout) < 0.02 * PAGES


GIVE_BACK = """
from hapticplayer.media.memory import give_back_freed_memory, keep_freed_memory

def held_bytes():
    with open("/proc/self/smaps_rollup") as lines:
        return next(int(x.split()[1]) << 10 for x in lines if x.startswith("Anonymous"))

keep_freed_memory()
blocks, pins = [], []
for number in range(64):
    blocks.append(b"x" * (1 << 20))
    pins.append(b"y" * 1000)  # so that what is free lies about between
full = held_bytes()
blocks.clear()
freed = held_bytes()
give_back_freed_memory()
print(full, freed, held_bytes())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="of glibc")
def test_freed_memory_is_kept_until_it_is_given_back():
    done = subprocess.run(
        [sys.executable, "-c", GIVE_BACK], capture_output=True, text=True, check=True
    )
    full, freed, given_back = map(int, done.stdout.split())
    assert full - freed < 8 << 20
    assert full - given_back > 60 << 20
