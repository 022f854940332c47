"""Ratings while a clip plays, on a virtual clock: rows, limits, files that are damaged."""

import json

import numpy as np
import pytest

from hapticplayer.errors import StudyError
from hapticplayer.study.creation import change_definition, new_definition
from hapticplayer.study.definition import RatingKind
from hapticplayer.study.live_ratings import FIGURES, read_ratings
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_export import export_study
from tests.unit.study.test_definition import parse
from tests.unit.study.test_runner import RunningSession


def worded(text):
    return {language: f"{text} {language}" for language in ("en", "fr", "de")}


SLIDER = {
    "key": "match",
    "kind": "slider",
    "text": worded("match"),
    "least": -50,
    "most": 50,
    "by": ["mouse", "wheel"],
}
FMS = {
    "key": "fms",
    "kind": "number",
    "text": worded("sick"),
    "least": 0,
    "most": 20,
    "every_s": 60,
    "stop_at": 15,
    "rest": worded("rest"),
}
VECTION = {
    "key": "vection",
    "kind": "held-key",
    "text": worded("moving"),
    "hold": "v",
}
ALL = [SLIDER, FMS, VECTION]


@pytest.fixture
def running(study, template, manual_clock):
    study = change_definition(study, {**template, "while_watching": ALL})
    made = RunningSession(study, manual_clock)
    made.to_trials()
    made.runner.proceed()
    yield made
    made.runner.close()


def sampled(running, seconds):
    """Let so much of the clip pass, with a sample each 20 ms."""
    for _ in range(round(50 * seconds)):
        running.clock.advance(0.02)
        running.runner.watching.sample()


def tracks(running):
    notices = []
    session = running.study.session(running.code)
    found = {one.rating.key: one for one in read_ratings(session, notices)}
    return found, notices


def test_a_clip_has_fifty_rows_a_second_at_its_own_time(running):
    first_s = running.stage.first_frame_s
    sampled(running, 2.0)
    running.runner.watching.change("match", 20.0)
    sampled(running, 2.0)
    running.end_clip()
    found, notices = tracks(running)
    slider = found["match"]
    assert not notices
    assert len(slider.value) == 4 * 50 + 1  # and the change
    assert np.abs(slider.media_s - (slider.monotonic_s - first_s)).max() < 2e-6
    assert slider.value[[0, -1]].tolist() == [0.0, 20.0]
    assert slider.media_s[slider.value == 20.0][0] == pytest.approx(1.988)


def test_a_held_key_has_onset_and_share_of_the_time(running):
    watching = running.runner.watching
    sampled(running, 3.0)
    watching.change("vection", 1.0)
    sampled(running, 2.0)
    watching.change("vection", 0.0)
    sampled(running, 3.0)
    running.end_clip()
    held = tracks(running)[0]["vection"]
    figures = {name: one[0](held) for name, one in FIGURES[held.rating.kind].items()}
    assert figures["onset_s"] == pytest.approx(2.988)
    assert figures["held_s"] == pytest.approx(2.0)
    assert figures["share"] == pytest.approx(2.0 / 7.98, abs=2e-3)


def test_a_number_is_asked_for_each_minute_until_it_is_given(running):
    watching = running.runner.watching
    sampled(running, 59.9)
    assert watching.asking is None
    sampled(running, 0.2)
    assert watching.asking.key == "fms"
    watching.give("fms", 7)
    assert watching.asking is None
    sampled(running, 60.0)
    assert watching.asking.key == "fms"
    running.end_clip()
    number = tracks(running)[0]["fms"]
    assert np.isnan(number.value).tolist() == [True, False, True]
    assert number.media_s.round(1).tolist() == [60.0, 60.1, 120.0]
    assert running.kind is PageKind.QUESTIONS


def test_a_limit_ends_clip_and_force_and_offers_a_break(running):
    sampled(running, 61.0)
    running.runner.watching.give("fms", 15)
    running.runner.poll()
    assert (running.kind, running.stage.halts) == (PageKind.PAUSED, 1)
    assert running.runner.page.text == "rest en"
    (trial,) = running.contents("trial")
    assert (trial["is_valid"], trial["reasons"]) == (False, ["limit:fms"])
    assert running.stage.is_stopped
    running.runner.proceed()
    assert running.kind is PageKind.QUESTIONS  # about the clip as far as it went
    assert not running.stage.is_stopped


def test_an_interrupted_clip_keeps_its_ratings_beside_the_next(running):
    sampled(running, 1.0)
    running.runner.halt("escape")
    running.runner.proceed()
    running.play()
    names = sorted(p.name for p in running.study.session_folder(running.code).iterdir())
    assert [n for n in names if "vection" in n] == [
        "ratings-01-1-vection.csv",
        "ratings-01-2-vection.csv",
    ]


def test_damaged_and_foreign_files_of_ratings_are_named(running):
    sampled(running, 1.0)
    running.end_clip()
    folder = running.study.session_folder(running.code)
    path = folder / "ratings-01-1-match.csv"
    lines = path.read_text().splitlines()
    whole = len(lines) - 1
    ahead = "9e8,0,1"  # its time is damaged, and those behind it are not
    spoilt = [*lines[:5], "nonsense", "1e300,0,1", lines[2], ahead, *lines[5:], "5,5"]
    path.write_text("\n".join(spoilt))
    (folder / "ratings-99-1-match.csv").write_text("")
    found, notices = tracks(running)
    assert len(found["match"].value) == whole
    assert len(notices) == 2
    assert "4 rows are damaged" in notices[0] + notices[1]
    assert "ratings-99-1-match.csv: is not of this session" in " ".join(notices)


def test_a_full_disk_marks_the_trial_and_the_clip_goes_on(running, monkeypatch):
    def no_room(*_args):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("hapticplayer.study.watching.write_whole", no_room)
    sampled(running, 1.0)
    running.end_clip()
    (trial,) = running.contents("trial")
    assert trial["reasons"] == ["ratings_incomplete"]
    assert running.kind is PageKind.QUESTIONS


def test_ratings_are_tables_and_columns_of_the_data(running, tmp_path):
    sampled(running, 1.0)
    running.runner.watching.change("match", 30.0)
    running.end_clip()
    running.runner.answer({"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1})
    running.runner.close()
    export_study(running.study, tmp_path / "csv", "csv")
    head, first, *_ = (tmp_path / "csv" / "trials.csv").read_text().splitlines()
    row = dict(zip(head.split(","), first.split(","), strict=True))
    assert (row["match.last"], row["match.most"]) == ("30.0", "30.0")
    assert (row["vection.onset_s"], row["vection.held_s"]) == ("", "0.0")
    rows = (tmp_path / "csv" / "while_watching.csv").read_text().splitlines()
    assert len(rows) == 1 + 50 + 50 + 1  # head, slider, key, and the change


SPOILT = [
    ({**SLIDER, "hold": "v"}, r"while_watching\[0\].hold: is not used in ratings by"),
    ({**SLIDER, "by": []}, r"while_watching\[0\].by: missing entry 'by'"),
    ({**SLIDER, "by": ["nose"]}, "'nose' moves no slider"),
    ({**SLIDER, "by": ["grip-x", "joystick-y"]}, "has two axes"),
    ({**SLIDER, "most": -50}, "must be more than least"),
    ({**FMS, "stop_at": 21}, "must be between 0 and 20"),
    ({**FMS, "stop_at": None}, "rest: is not used without stop_at"),
    ({**FMS, "every_s": None}, "missing entry 'every_s'"),
    ({**VECTION, "hold": "space"}, "must be a letter"),
    ({**VECTION, "key": "realism"}, "duplicate key 'realism'"),
    ({**VECTION, "text": {"en": "x"}}, "missing entry 'de'"),
]


@pytest.mark.parametrize(("rating", "reason"), SPOILT)
def test_a_rating_that_cannot_be_is_refused(template, rating, reason):
    with pytest.raises(StudyError, match=reason):
        parse({**template, "while_watching": [rating]})


def test_two_ratings_do_not_share_what_moves_them(template):
    other = {**SLIDER, "key": "other", "by": ["keys", "wheel"]}
    with pytest.raises(StudyError, match="'wheel' is used by another rating"):
        parse({**template, "while_watching": [SLIDER, other]})


def test_two_clips_in_one_trial_are_not_rated_meanwhile():
    made = {**json.loads(new_definition("two-interval")), "while_watching": [VECTION]}
    with pytest.raises(StudyError, match="while_watching: is not used in"):
        parse(made)


def test_every_kind_of_rating_has_figures():
    assert set(FIGURES) == set(RatingKind)
