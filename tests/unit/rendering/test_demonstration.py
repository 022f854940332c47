"""The demonstration of forces, and tracks for weaker devices."""

import itertools

import numpy as np
import pytest

from hapticplayer.devices import DEVICES
from hapticplayer.haptics.limiter import Limits
from hapticplayer.model import ForceTrack
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.rendering import adapted
from hapticplayer.rendering.demonstration import RISE_S, demonstration

FALCON = DEVICES["falcon"].capabilities
AXES = {"right": 0, "left": 0, "up": 1, "down": 1, "towards you": 2, "away from you": 2}
SIGNS = {"right": 1, "up": 1, "towards you": 1}


def device(axes=3, peak_n=9.0):
    return DeviceCapabilities(axes, peak_n, peak_n, 0.04, 1000.0, 0.001)


def test_every_direction_comes_at_every_strength_gentle_first():
    track, steps = demonstration(FALCON)
    assert len(steps) == 18
    assert [s.strength_n for s in steps] == sorted(s.strength_n for s in steps)
    assert steps[-1].strength_n == Limits().force_cap_n == DEFAULT_FORCE_LIMIT_N
    for step in steps:
        middle = np.array([(step.begin_s + step.end_s) / 2])
        expected = np.zeros(3)
        expected[AXES[step.direction]] = SIGNS.get(step.direction, -1) * step.strength_n
        np.testing.assert_allclose(track.at(middle)[0], expected, atol=1e-6)


def test_between_the_forces_there_is_none_and_nothing_is_sudden():
    track, steps = demonstration(FALCON)
    for before, after in itertools.pairwise(steps):
        assert after.begin_s - before.end_s > 0.5
        rest = track.at(np.array([before.end_s, after.begin_s]))
        np.testing.assert_allclose(rest, 0.0, atol=1e-6)
    assert not track.at(np.array([0.0, 0.5, track.end_s - 0.1])).any()
    slope = np.abs(np.diff(track.force_n, axis=0)).max() / 0.01
    assert (
        slope <= DEFAULT_FORCE_LIMIT_N * np.pi / 2 / RISE_S * 1.001
    )  # of half a cosine


def test_a_device_with_fewer_axes_is_shown_only_what_it_has():
    _, steps = demonstration(device(axes=2, peak_n=2.0))
    assert {s.direction for s in steps} == {"right", "left", "up", "down"}
    assert max(s.strength_n for s in steps) == 2.0
    track, steps = demonstration(device(axes=0))
    assert {s.direction for s in steps} == {"vibration"}
    assert len(steps) == 3
    assert track.peak_n() == pytest.approx(DEFAULT_FORCE_LIMIT_N)


def test_a_track_for_a_falcon_stays_the_same_object():
    track = ForceTrack([0.0, 1.0], [[1, 2, 3], [4, 5, 6]])
    assert adapted(track, FALCON) is track
    assert adapted(track, device(axes=0)) is track


def test_a_weaker_device_keeps_ratios_and_skips_missing_axes():
    track = ForceTrack([0.0, 1.0], [[1, 2, 3], [4.5, 0, 0]], provenance={"a": 1})
    weak = adapted(track, device(axes=2, peak_n=1.5))
    np.testing.assert_allclose(
        weak.force_n, [[1 / 3, 2 / 3, 0], [1.5, 0, 0]], rtol=1e-6
    )
    assert weak.provenance == {
        "a": 1,
        "device_scale": pytest.approx(1 / 3),
        "device_axes": 2,
    }
    one = adapted(track, device(axes=1))
    np.testing.assert_array_equal(one.force_n, [[1, 0, 0], [4.5, 0, 0]])
