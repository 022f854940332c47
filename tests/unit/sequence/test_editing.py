"""Whatever stops a change, one whole state of the sequence is there."""

from functools import partial

import numpy as np
import pytest

from hapticplayer import storage
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import Cancelled, SequenceError, UsageError, no_progress
from hapticplayer.model import ClockMap, Mapping
from hapticplayer.sequence import (
    editing,
    library,
    open_sequence,
    verify_sequence,
)
from hapticplayer.sequence.build import write_sequence
from hapticplayer.sequence.comparison import previewed_rendering
from hapticplayer.sequence.force_csv import read_force_csv


@pytest.fixture
def folder(tmp_path, tiny_clip, still_log):
    recording = Recording(still_log, ClockMap(), "test")
    return write_sequence(tiny_clip, recording, tmp_path / "seq")


@pytest.fixture
def csv(tmp_path):
    path = tmp_path / "push.csv"
    path.write_text("time_s,fx_n,fy_n,fz_n\n0,0,1.5,0\n0.4,0,0,0\n")
    return path


def names(folder) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_track_is_added_by_name_and_removed_with_its_file(folder, csv):
    before = names(folder)
    editing.add_track(folder, "push", partial(read_force_csv, csv))
    verify_sequence(folder)
    track = open_sequence(folder).tracks["push"]
    assert track.at(np.array([0.2]))[0].tolist() == [0.0, 1.5, 0.0]
    (entry,) = [t for t in library.read_entry(folder).tracks if t.name == "push"]
    assert entry.peak_n == 1.5
    assert 0.0 < entry.reach < 1.0
    editing.rename_track(folder, "push", "Pull")
    assert "Pull" in open_sequence(folder).tracks
    editing.remove_track(folder, "Pull")
    verify_sequence(folder)
    assert names(folder) == before


@pytest.mark.parametrize("stop", ["cancel", "disk"])
def test_a_stopped_change_leaves_the_old_state(folder, csv, stop, monkeypatch):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}

    def full(*_):
        raise SequenceError("writing failed (No space left on device)")

    def cancelled(_fraction, _step):
        raise Cancelled

    progress = cancelled if stop == "cancel" else no_progress
    if stop == "disk":
        monkeypatch.setattr(storage, "replace_json", full)
    for change in (
        lambda: editing.add_track(
            folder, "push", partial(read_force_csv, csv), progress=progress
        ),
        lambda: editing.set_mapping(folder, Mapping(), progress=progress),
    ):
        with pytest.raises((Cancelled, SequenceError)):
            change()
        assert {p.name: p.read_bytes() for p in folder.iterdir()} == before


@pytest.mark.parametrize(
    "name",
    [
        "",
        "realistic",
        "None",
        "Delayed",
        "shuffled",
        "edited",
        "a/b",
        "../x",
        "x" * 41,
        ".",
    ],
)
def test_names_that_cannot_be_are_refused(folder, csv, name):
    with pytest.raises(UsageError):
        editing.add_track(folder, name, partial(read_force_csv, csv))


def test_the_three_tracks_of_every_sequence_stay(folder):
    for name in ("realistic", "random", "none"):
        with pytest.raises(UsageError, match="needs its track"):
            editing.remove_track(folder, name)
    with pytest.raises(UsageError):
        editing.rename_track(folder, "unknown", "x")
    with pytest.raises(UsageError):
        editing.rename_sequence(folder, "  ")


def test_a_gain_scales_the_force_as_previewed(folder):
    before, mapping = open_sequence(folder), Mapping(gain_n_per_mps2=0.2)
    found = previewed_rendering(folder, mapping).figures
    editing.set_mapping(folder, mapping)
    after = open_sequence(folder)
    real = after.tracks["realistic"]
    np.testing.assert_allclose(
        real.force_n, before.tracks["realistic"].force_n / 2.0, atol=1e-7
    )
    played_n = np.linalg.norm(real.force_n[real.time_s <= 2.0], axis=1)
    assert found.peak_n == pytest.approx(played_n.max())
    assert (
        after.tracks["random"].provenance["seed"]
        == (before.tracks["random"].provenance["seed"])
    )


def test_the_library_lists_what_is_damaged_and_finds_free_names(folder, tmp_path):
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "sequence.json").write_text('{"schema": 1}')
    (tmp_path / ".hidden").mkdir()
    found = {entry.folder.name: entry for entry in library.entries(tmp_path)}
    assert sorted(found) == ["broken", "seq"]
    assert found["broken"].problem
    assert not found["seq"].problem
    assert library.entries(tmp_path / "nowhere") == []
    assert library.free_name(tmp_path, "seq") == tmp_path / "seq-2"
    assert library.free_name(tmp_path, "../..//") == tmp_path / "sequence"
