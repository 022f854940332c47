"""A short clip, and the demo."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from tests.e2e.command import hapticplayer
from tests.once import made_once


@pytest.fixture(scope="session")
def clip(tmp_path_factory) -> Path:
    """Two seconds without sound."""
    path = tmp_path_factory.mktemp("clip") / "plain.mp4"
    grey = (np.full((72, 128, 3), 3 * k, dtype=np.uint8) for k in range(60))
    write_clip(path, grey, frame_rate_hz=30)
    return path


@pytest.fixture(scope="session")
def demo(tmp_path_factory) -> Path:
    """The demo with small frames."""
    from hapticplayer.extras.rides import recordings as demos

    whole = demos.simulate

    def small(scene, seed):
        return replace(whole(scene, seed), width=160, height=90, frame_rate_hz=10)

    def draw(target):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(demos, "simulate", small)
            done = hapticplayer("simulate", "demo", "-o", target)
        assert done.returncode == 0, done.stderr

    return made_once(tmp_path_factory, "demo", draw)
