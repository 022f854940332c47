"""The demonstration of the device, with a clip of a disc that shows the force."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.playback.source import Source
from hapticplayer.rendering.demonstration import demonstration
from hapticplayer.storage import cache_root

NAME = "demonstration"
RATE_HZ, WIDTH, HEIGHT = 25, 640, 360
STRENGTHS = (0.5, 1.0)
"""As shares of the largest force: a session has less time than the page of a device."""
_GROUND, _DISC = np.array([20, 23, 27]), np.array([74, 168, 255])
_RADIUS_PX, _TRAVEL_PX, _GROWTH = 40.0, 110.0, 0.7


def demonstration_source() -> Source:
    """The demonstration as a source; its clip is made on first use."""
    track, _steps = demonstration(FALCON, STRENGTHS)
    path = cache_root() / f"{NAME}-{__version__}.mp4"
    if not path.exists():
        write_clip(path, _frames(track), frame_rate_hz=RATE_HZ)
    return Source(NAME, path, probe(path), {NAME: track}, None, NAME)


def _frames(track: ForceTrack) -> Iterator[NDArray[np.uint8]]:
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    times = np.arange(0.0, track.time_s[-1], 1.0 / RATE_HZ)
    for right, up, near in track.at(times) / DEFAULT_FORCE_LIMIT_N:
        centre_x = WIDTH / 2 + _TRAVEL_PX * right
        centre_y = HEIGHT / 2 - _TRAVEL_PX * up
        radius = _RADIUS_PX * (1.0 + _GROWTH * near)
        inside = np.clip(radius - np.hypot(x - centre_x, y - centre_y), 0.0, 1.0)
        frame = _GROUND + inside[..., None] * (_DISC - _GROUND)
        yield frame.astype(np.uint8)
