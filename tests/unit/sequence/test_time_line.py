"""The timeline of a sequence holds what its editor shows."""

import numpy as np
import pytest

from hapticplayer.errors import Cancelled, SequenceError
from hapticplayer.media.encode import write_clip
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import open_sequence, store
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.events import events_of, time_line_of
from tests.material.shaken import write_shaken_sequence


@pytest.fixture(scope="module")
def shaken(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shaken")
    pictures = (np.full((36, 64, 3), level, np.uint8) for level in range(50))
    write_clip(folder / "clip.mp4", pictures, frame_rate_hz=25)
    return write_shaken_sequence(folder / "clip.mp4", folder / "sequence")


def test_a_time_line_has_the_effects_and_events_of_the_sequence(shaken):
    effects = EffectList((Effect("mute", 0.2, 0.7), Effect("gain", 0.5, 1.0)))
    set_effects(shaken, effects)
    line = time_line_of(shaken)
    assert line.effects == effects
    assert line.events == events_of(shaken)
    assert len(line.loudness[0]) == 0  # the clip is silent
    assert line.problem == ""


def test_one_that_cannot_be_rendered_again_is_refused(shaken, monkeypatch):
    sequence = open_sequence(shaken)
    shared = store.Sequence(
        **{name: getattr(sequence, name) for name in ("folder", "title", "clip")},
        **{name: getattr(sequence, name) for name in ("tracks", "mapping")},
        description=sequence.description,
        motion=None,
    )
    monkeypatch.setattr(store, "open_sequence", lambda _folder: shared)
    with pytest.raises(SequenceError, match="without its motion"):
        time_line_of(shaken)


def test_reading_it_stops_when_asked_to(shaken):
    steps = []

    def stop_at_second(_done, step):
        steps.append(step)
        if len(steps) == 2:
            raise Cancelled

    with pytest.raises(Cancelled):
        time_line_of(shaken, progress=stop_at_second)
    assert len(steps) == 2
