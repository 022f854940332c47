"""A packed video carries its force for other programs, too."""

import numpy as np

from hapticplayer.extras.formats import thinning
from hapticplayer.sequence import open_sequence, sharing
from hapticplayer.sequence.force_formats import read_force
from hapticplayer.sequence.packed import read_packed
from hapticplayer.sequence.unpack import unpack


def test_the_file_holds_hjif_of_the_realistic_force(sequence_folder, tmp_path):
    sharing.share(sequence_folder, tmp_path / "ride.mkv")
    one = read_packed(tmp_path / "ride.mkv").attached["force_realistic.hjif"]
    assert one.media_type == "haptics/hjif"
    (tmp_path / "force.hjif").write_bytes(one.content)
    back = read_force(tmp_path / "force.hjif").track
    track = open_sequence(sequence_folder).tracks["realistic"]
    at_s = np.arange(0.0, 0.9, 0.001)
    assert np.abs(track.at(at_s) - back.at(at_s)).max() <= 0.0101
    listed = sharing.shared_contents(sequence_folder).attached
    assert len(one.content) in [part.size_bytes for part in listed]
    unpack(tmp_path / "ride.mkv", tmp_path / "back")
    assert not list((tmp_path / "back").glob("*.hjif"))


def test_a_force_that_does_not_fit_is_left_out(sequence_folder, monkeypatch):
    monkeypatch.setattr(thinning, "MAX_CORNERS", 1)
    assert sharing.force_for_others(sequence_folder) == ()
