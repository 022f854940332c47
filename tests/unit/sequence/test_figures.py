"""RMS, peak, saturation and reach of a track, before and after a change."""

import json
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.model import ForceTrack
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.comparison import stored_rendering
from hapticplayer.sequence.description import ExcursionEntry, HandEntry
from hapticplayer.sequence.editing import set_mapping
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.figures import force_figures, sequence_figures
from hapticplayer.sequence.library import read_entry


def steps(level_n, extra_s=()):
    """A second at a level towards the user, then rest until 8 s and a blow after."""
    corners_s = np.array([0.0, 1.0, 1.0001, 8.0, 8.1, 8.2])
    time_s = np.union1d(corners_s, extra_s)
    z = np.interp(time_s, corners_s, [level_n, level_n, 0.0, 0.0, 9.0, 0.0])
    return ForceTrack(time_s, np.stack([0 * z, 0 * z, z], axis=1))


def test_figures_are_those_of_the_time_of_the_clip():
    found = force_figures(steps(4.5), 4.0)
    assert found.peak_n == 4.5
    assert found.rms_n == pytest.approx(4.5 * np.sqrt(0.25), rel=1e-3)
    assert found.saturated_share == pytest.approx(0.25, abs=1e-3)
    hands = predict(steps(4.5), 4.0).hands
    assert found.reaches == {name: one.reach for name, one in hands.items()}
    assert found.trips == ()


def test_many_entries_in_a_span_do_not_count_more():
    dense = force_figures(steps(3.0, np.arange(0.0, 1.0, 0.001)), 4.0)
    plain = force_figures(steps(3.0), 4.0)
    assert (dense.rms_n, dense.saturated_share) == pytest.approx((plain.rms_n, 0.0))


def test_the_limit_is_that_of_the_mapping():
    assert force_figures(steps(3.0), 4.0, 3.0).saturated_share > 0.24


def test_a_given_prediction_is_taken():
    hand = HandEntry(0.5, trip="runaway")
    given = ExcursionEntry({"firm": hand}, far=0.6, rms_10s_n=0.0, thermal_share=0.0)
    found = force_figures(steps(1.0), 4.0, prediction=given)
    assert (found.reaches, found.trips) == ({"firm": 0.5}, ("firm",))


def test_library_rendering_page_and_notes_have_one_figure(sequence_folder):
    strong = replace(
        open_sequence(sequence_folder).mapping, gain_n_per_mps2=5.0, force_limit_n=0.2
    )
    set_mapping(sequence_folder, strong, preset="faithful")
    page = stored_rendering(sequence_folder).figures
    assert page.saturated_share > 0.01
    listed = read_entry(sequence_folder)
    (force,) = (one for one in listed.findings if one.name == "force")
    assert force.value == page.saturated_share
    assert force.more["peak_n"] == page.peak_n
    (track,) = (one for one in listed.tracks if one.name == "realistic")
    assert (track.peak_n, track.rms_n) == pytest.approx((page.peak_n, page.rms_n))


def test_commands_say_them_before_and_after(sequence_folder, capsys):
    first = sequence_figures(open_sequence(sequence_folder))
    words = ["--gain", "0.2", "--in-place", "--json"]
    assert cli.main(["render", str(sequence_folder), *words]) == 0
    said = json.loads(capsys.readouterr().out)["figures"]
    assert said["before"]["peak_n"] == first.peak_n
    assert said["after"]["rms_n"] == pytest.approx(first.rms_n / 2.0)
    assert said["after"]["reaches"]["relaxed"] < first.reaches["relaxed"]
    pulse = ["pulse", "--start", "1", "--end", "1.2", "--param", "amplitude=4"]
    assert cli.main(["effects", str(sequence_folder), "add", *pulse]) == 0
    lines = capsys.readouterr().out.splitlines()[-2:]
    assert [line.split()[0] for line in lines] == ["before", "after"]
    second = sequence_figures(open_sequence(sequence_folder))
    assert f"peak {second.peak_n:.2f} N" in lines[1]
    assert second.peak_n > 3.0 > first.peak_n
