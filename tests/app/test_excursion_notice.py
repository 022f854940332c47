"""The window says when a sequence would push a hand far out, or hardly plays."""

import json
import shutil

from hapticplayer.playback.source import open_source


def test_a_sequence_that_would_push_far_is_announced(window, sequence, tmp_path):
    strong = shutil.copytree(sequence, tmp_path / "strong")
    path = strong / "sequence.json"
    description = json.loads(path.read_text())
    excursion = description["feedbacks"]["realistic"]["excursion"]
    excursion["hands"]["relaxed"].update(reach=0.96, reach_at_s=1.25)
    path.write_text(json.dumps(description))
    window.session.show_source(open_source(strong))
    assert "would reach 96 % of the workspace with a relaxed hand" in (
        window.messages.text()
    )
    window.session.show_source(open_source(sequence))
    assert window.messages.text() == ""


def test_a_track_in_milliseconds_is_announced(window, sequence, tmp_path):
    force = tmp_path / "force.csv"
    force.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n500,1,0,0\n2000,0,0,0\n")
    source = open_source(sequence, force)
    window.session.show_source(source)
    assert "it looks like milliseconds" in window.messages.text()
