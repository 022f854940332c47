"""A recorder that records nothing, in a state that a test chooses."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from hapticplayer.capture.live.recorder_state import RecorderState
from hapticplayer.capture.recorded import Gap, SourceClockLine, Stream, Take
from hapticplayer.errors import Message
from hapticplayer.model import MotionTrack
from hapticplayer.sequence.take_overview import TakeOverview

TIME_S = np.arange(0.0, 8.0, 0.01)
SWAYING = np.stack(
    [2.0 * np.sin(3 * TIME_S), np.cos(5 * TIME_S), 9.8 + 0 * TIME_S], axis=1
)
_SILENT = Message(
    "{stream}: nothing for {stall_s:.1f} s; the other streams continue",
    stream="imu",
    stall_s=0.5,
)
STATE = RecorderState(
    elapsed_s=8.0,
    frame=np.full((90, 160, 3), (20, 120, 220), np.uint8),
    level_db=-18.0,
    time_s=TIME_S,
    accel_mps2=SWAYING,
    rate_radps=0.1 * SWAYING,
    camera_hz=29.97,
    imu_hz=100.2,
    frames=240,
    dropped_frames=2,
    samples=800,
    dropped_samples=3,
    gaps=(Gap("imu", 3.0, 3.5, 50),),
    marks_s=(4.0,),
    free_bytes=12_300_000_000,
    notices=(_SILENT,),
    is_over=False,
)


class StillRecorder:
    """Gives the state that it has; counts marks and stops."""

    def __init__(self, state: RecorderState = STATE, folder: Path = Path()) -> None:
        self.state, self.folder, self.stops = state, folder, 0

    def snapshot(self) -> RecorderState:
        return self.state

    def mark(self) -> float:
        marks_s = (*self.state.marks_s, self.state.elapsed_s)
        self.state = replace(self.state, marks_s=marks_s)
        return self.state.elapsed_s

    def stop(self) -> Path:
        self.stops += 1
        return self.folder


def silent_source(how: str = "") -> SimpleNamespace:
    """A source that gives nothing by itself."""
    declares = SimpleNamespace(axes="x,y,z")
    return SimpleNamespace(
        how=Message(how), listener=None, declares=declares, text="csv:-"
    )


def take(*, has_camera: bool = True) -> Take:
    """The description of a take."""
    return Take(
        began="2026-11-27T15:00:00+00:00",
        is_finished=True,
        camera=Stream("/dev/video0", "monotonic", 0.0, 240, 2) if has_camera else None,
        imu=Stream("wt901:/dev/ttyUSB0", "source", 0.001, 800, 3),
        clock=SourceClockLine(0.2, 1.00004, 0.0012),
        marks_s=[1.2, 0.4],
    )


def overview(taps_s: tuple[float, ...] = (0.5, 1.0, 1.5)) -> TakeOverview:
    """What such a take holds."""
    count = len(TIME_S)
    up, level = (
        np.tile([0.0, 0.0, 9.8], (count, 1)),
        np.tile([1.0, 0, 0, 0], (count, 1)),
    )
    motion = MotionTrack(
        TIME_S, SWAYING - up, up, 1.0, level, None, np.ones(count, bool)
    )
    at_s = np.arange(0.0, 8.0, 0.001)
    heard = (at_s, np.abs(np.sin(2 * at_s)))
    return TakeOverview(take(), 8.0, heard, motion, taps_s, 0.0042)
