"""The demonstration of the device: a force along each axis, shown by a disc."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.haptics.limiter import Limits
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack
from hapticplayer.playback.source import Source
from hapticplayer.storage import cache_root

NAME = "demonstration"
RATE_HZ, WIDTH, HEIGHT = 25, 640, 360
PULSE_S, REST_S = 1.6, 0.6
_TRACK_HZ = 100
# right, left, up, down, towards the person, away: frame D
_DIRECTIONS = np.array(
    [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float
)
DURATION_S = REST_S + len(_DIRECTIONS) * (PULSE_S + REST_S)
_GROUND, _DISC = np.array([20, 23, 27]), np.array([74, 168, 255])
_RADIUS_PX, _TRAVEL_PX, _GROWTH = 40.0, 110.0, 0.7


def demonstration_force() -> ForceTrack:
    time_s = np.arange(0.0, DURATION_S, 1.0 / _TRACK_HZ)
    force_n = Limits().force_cap_n * _pulses(time_s)
    return ForceTrack(time_s, force_n.astype(np.float32), provenance={"feedback": NAME})


def demonstration_source() -> Source:
    """Return the demonstration as a source; its clip is made on first use."""
    path = cache_root() / f"{NAME}-{__version__}.mp4"
    if not path.exists():
        write_clip(path, _frames(), frame_rate_hz=RATE_HZ)
    tracks = {NAME: demonstration_force()}
    return Source(NAME, path, probe(path), tracks, None, NAME)


def _pulses(time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the force (N, 3) as a share of the cap."""
    into_s = time_s - REST_S
    number = np.floor_divide(into_s, PULSE_S + REST_S).astype(int)
    within = np.mod(into_s, PULSE_S + REST_S) / PULSE_S
    share = np.where((into_s >= 0.0) & (within < 1.0), np.sin(np.pi * within) ** 2, 0.0)
    direction = _DIRECTIONS[np.clip(number, 0, len(_DIRECTIONS) - 1)]
    return np.asarray(share[:, None] * direction)


def _frames() -> Iterator[NDArray[np.uint8]]:
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    for right, up, near in _pulses(np.arange(0.0, DURATION_S, 1.0 / RATE_HZ)):
        centre_x = WIDTH / 2 + _TRAVEL_PX * right
        centre_y = HEIGHT / 2 - _TRAVEL_PX * up
        radius = _RADIUS_PX * (1.0 + _GROWTH * near)
        inside = np.clip(radius - np.hypot(x - centre_x, y - centre_y), 0.0, 1.0)
        frame = _GROUND + inside[..., None] * (_DISC - _GROUND)
        yield frame.astype(np.uint8)
