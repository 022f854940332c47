"""A recording on a disk of its own that fills up; see test_record_disk.

Runs in a mount namespace of its own: `python record_disk.py low|full FOLDER`.
"""

import json
import os
import sys
from pathlib import Path

from hapticplayer.capture import read_recording
from hapticplayer.capture.live import disk_watch
from hapticplayer.capture.live.recorder import Recorder
from hapticplayer.capture.live.source import open_source
from hapticplayer.capture.recorded import parts_of, read_take
from hapticplayer.clock import SystemClock
from hapticplayer.media.clip_info import probe
from tests.faults.study_disk import fill, mount
from tests.material import recording

CLOCK = SystemClock()
SIZE, ROOM = "4m", 1_300_000


def recorded(disk: Path, board: recording.Board) -> Recorder:
    """A recording that has begun on a disk with little room."""
    mount(disk, f"size={SIZE}")
    disk_watch.LOW_BYTES, disk_watch.FILM_BYTES, disk_watch.LOG_BYTES = (
        ROOM,
        1 << 20,
        1 << 17,
    )
    source = open_source(board.source, CLOCK)
    camera = recording.camera("640x480")
    made = Recorder(disk / "take", camera, None, source, CLOCK)
    made.start()
    return made


def wait_until(made: Recorder, condition) -> None:
    """Raise AssertionError after some time."""
    until_s = CLOCK.now_s() + 20.0
    while not condition(made.snapshot(with_frame=False)):
        assert CLOCK.now_s() < until_s, made.snapshot(with_frame=False).notices
        CLOCK.sleep_until(CLOCK.now_s() + 0.05)


def told(words: str):
    """Whether a notice holds them."""
    return lambda state: any(words in one for one in state.notices)


def low(disk: Path, made: Recorder) -> None:
    """Others take room, but for little."""
    room = os.statvfs(disk).f_bavail * 4096 - ROOM - 100_000
    (disk / "others").write_bytes(bytes(max(0, room)))
    wait_until(made, told("camera: ends here"))
    samples = made.snapshot(with_frame=False).samples
    wait_until(made, lambda state: state.samples > samples + 300)
    made.stop()


def full(disk: Path, made: Recorder) -> None:
    """Others take all the room there is; they leave once it has ended."""
    wait_until(made, lambda state: state.frames > 40)
    filler = fill(disk)
    wait_until(made, told("is full"))
    wait_until(made, lambda state: state.is_over)
    made.stop()
    filler.unlink()


def main(scenario: str, disk: Path) -> dict:
    """What is there in the end."""
    board = recording.Board()
    made = recorded(disk, board)
    {"low": low, "full": full}[scenario](disk, made)
    board.unplug()
    is_finished = read_take(made.folder).is_finished
    clip, log, _ = parts_of(made.folder)
    take, imu = read_take(made.folder), read_recording(log).imu
    return {
        "is_finished": is_finished,
        "notices": take.notices,
        "told": [str(one) for one in made.snapshot(with_frame=False).notices],
        "gaps": [one.stream for one in take.gaps],
        "film_s": probe(clip).duration_s,
        "motion_s": float(imu.time_s[-1]),
    }


if __name__ == "__main__":
    sys.stdout.write(json.dumps(main(sys.argv[1], Path(sys.argv[2]))))
