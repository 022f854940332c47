"""Figures and curves of a rendering, before it is written and after."""

import numpy as np
import pytest

from hapticplayer import storage
from hapticplayer.capture.mounting import axes_text, device_axes
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import Cancelled, HapticPlayerError
from hapticplayer.model import ClockMap, ForceTrack, Mapping
from hapticplayer.model.mapping import M_AD
from hapticplayer.sequence import comparison, editing
from hapticplayer.sequence.build import write_sequence
from hapticplayer.sequence.excursion import LIMITS, predict
from hapticplayer.structures import read_json

FOUND = comparison.SPANS


@pytest.fixture
def folder(tmp_path, tiny_clip, swing):
    log, _ = swing
    recording = Recording(log, ClockMap(offset_s=-3.0), "test camera", (), {})
    return write_sequence(tiny_clip, recording, tmp_path / "ride")


def assert_same(one, other):
    assert one.figures == other.figures
    assert one.preset == other.preset
    assert np.array_equal(one.curves.force_n, other.curves.force_n)
    assert np.array_equal(one.curves.excursion_m, other.curves.excursion_m)


def test_a_preview_is_what_is_then_written(folder):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    mapping = Mapping(M_AD, (0.5, 0.9, 1.3), soft_knee_n=2.0, lever_arm_m=(0, 0, 0.4))
    found = comparison.previewed_rendering(folder, mapping, preset="equal")
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before
    editing.set_mapping(folder, mapping, preset="equal")
    stored = comparison.stored_rendering(folder)
    assert_same(found, stored)
    assert stored.mapping.gain_n_per_mps2 == (0.5, 0.9, 1.3)


def test_the_offered_gain_is_the_one_that_is_fitted(folder):
    offered = comparison.stored_rendering(folder).fitted_gain_n_per_mps2
    fitted = comparison.previewed_rendering(folder, Mapping(), fits_gain=True)
    assert fitted.mapping.gain_n_per_mps2 == offered
    assert fitted.mapping.gain_n_per_mps2 != Mapping().gain_n_per_mps2


def test_excursions_of_earlier_versions_are_predicted_now(folder):
    path = folder / "sequence.json"
    description = read_json(path, dict)
    kept = comparison.stored_rendering(folder)
    del description["feedbacks"]["realistic"]["excursion"]
    storage.replace_json(path, description)
    assert_same(comparison.stored_rendering(folder), kept)

    def cancelled(_share, _step):
        raise Cancelled

    with pytest.raises(Cancelled):
        comparison.stored_rendering(folder, progress=cancelled)


@pytest.mark.parametrize("duration_s", [0.4, 7.3, 700.0])
def test_curves_keep_peaks_wherever_they_are(duration_s):
    time_s = np.linspace(0.0, duration_s, 4001)
    force_n = np.zeros((4001, 3), np.float32)
    peaks = {0: 5, 1: 2000, 2: 3990}
    for axis, row in peaks.items():
        force_n[row - 4 : row + 5, axis] = 3.0 - axis
    track = ForceTrack(time_s=time_s, force_n=force_n, provenance={})
    curves = comparison.curves_of(track, duration_s)
    assert curves.force_n.shape == (FOUND, 3, 2)
    assert np.all(curves.force_n[..., 0] <= curves.force_n[..., 1])
    for axis, row in peaks.items():
        high = curves.force_n[:, axis, 1]
        assert high.max() == pytest.approx(3.0 - axis, rel=0.02)
        at = int(time_s[row] / duration_s * FOUND)
        assert abs(int(high.argmax()) - at) <= 2


def test_the_drawn_excursion_is_the_predicted_reach():
    time_s = np.arange(0.0, 8.0, 0.01)
    force_n = np.zeros((len(time_s), 3), np.float32)
    force_n[:, 0] = 1.2 * np.sin(2.0 * np.pi * 0.4 * time_s)
    track = ForceTrack(time_s=time_s, force_n=force_n, provenance={})
    curves = comparison.curves_of(track, 8.0)
    reach = predict(track, 8.0).hands["relaxed"].reach
    furthest = float(curves.excursion_m.max()) / LIMITS.workspace_m
    assert furthest == pytest.approx(reach, rel=0.01)


@pytest.mark.parametrize("text", ["x,z,-y", "-x,y,-z", "y,z,x"])
def test_axes_come_back_as_their_text(text):
    assert axes_text(device_axes(text)) == text


def test_a_rotation_comes_back_to_six_digits(rng):
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    axes *= np.sign(np.linalg.det(axes))
    np.testing.assert_allclose(device_axes(axes_text(axes)), axes, atol=2e-6)


@pytest.mark.parametrize("text", ["", "x,y", "x,x,y", "x,y,-z", "1,0,0,0,1,0,0,0,2"])
def test_axes_that_no_device_has_are_refused(text):
    with pytest.raises(HapticPlayerError):
        device_axes(text)
