"""After the sessions: who took part, texts, deleted participants, merged and exported data."""

import json
import shutil
from dataclasses import replace

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox
from shiboken6 import isValid

from app.experimenter.study import results
from app.experimenter.study.merge_page import MergePage
from app.experimenter.study.place_dialogs import PlaceDialog, export_dialog
from app.experimenter.study.results import StudyResults
from hapticplayer.clock import SystemClock
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.creation import create_study
from hapticplayer.study.journal import Journal
from hapticplayer.study.overview import UnreviewedText, study_overview
from hapticplayer.study.plan import describe
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.sites import MANIFEST, check_package, site_of
from hapticplayer.study.study_export import study_exporters
from hapticplayer.study.study_folder import begin_session, open_study

VALUES = {"realism": 4, "sensory": 3, "comfort": 5, "satisfaction": 4}
WORDS = {"tiring": "no, Anna", "label@random": "wobbly"}
TIRING = "Did anything tire you? What was it?"
LABEL = "Give it a name of your own, or describe it in a few words. (random)"


def half_session(study):
    """Write a session of one trial, which was not valid, and two answers in words."""
    session = begin_session(study, "en", {}, SystemClock())
    journal = Journal(session.folder / "answers.jsonl", SystemClock())
    condition = describe(session.plan.order[0])
    name = {"step": "trial-01", "attempt": 1, "condition": condition}
    played = {"outputs": ["simulated"]}
    reasons = ["frames_dropped", "fault:unplugged"]
    journal.append("trial-begin", **name)
    journal.append(
        "trial",
        **name,
        is_valid=False,
        reasons=reasons,
        playback=played,
        sound="",
    )
    journal.append("answers", **name, page="rating", values=VALUES)
    journal.append("answers", step="post-test", page="post-test", values=WORDS)
    journal.close()
    return session.code


@pytest.fixture
def study(tmp_path):
    return create_study(tmp_path / "study")


@pytest.fixture
def codes(study):
    """A whole session and half of one."""
    whole = write_scripted_session(
        study, {"age": 30}, lambda _c: VALUES, SystemClock(), origin={}
    )
    return whole, half_session(study)


@pytest.fixture
def page(application, qtbot, study, codes, wait_for):
    made = StudyResults(study.folder)
    qtbot.addWidget(made)
    made.show()
    wait_for(lambda: not made.jobs.is_busy)
    yield made
    made.close_jobs()


def row_of(page, code):
    rows = range(page.sessions.rowCount())
    row = next(r for r in rows if page.sessions.item(r, 0).text() == code)
    return [page.sessions.item(row, column).text() for column in range(6)]


def choose(page, code):
    rows = range(page.sessions.rowCount())
    page.sessions.selectRow(
        next(r for r in rows if page.sessions.item(r, 0).text() == code)
    )


def texts(page):
    rows = range(page.texts.rowCount())
    return {page.texts.item(r, 1).text(): page.texts.item(r, 2).text() for r in rows}


def test_sessions_tell_state_device_and_completeness(page, codes):
    whole, half = (row_of(page, code) for code in codes)
    assert whole[2:] == ["complete, simulated", "12 / 12", "", "\u2013"]
    assert half[2:] == ["not finished", "1 / 12", "1", "Simulated"]
    assert "Sessions: 2, complete: 1" in page.summary.text()
    choose(page, codes[1])
    told = page.details.text()
    assert told.startswith("Trial 1 (")
    assert "frames dropped, safety stop (" in told


def test_texts_are_read_and_approved(page, study, wait_for):
    assert texts(page) == {TIRING: "no, Anna", LABEL: "wobbly"}
    assert page.tabs.tabText(1) == "Text answers (2)"
    page.tabs.setCurrentIndex(1)
    assert not page.buttons["approve"].isEnabled()
    rows = [page.texts.item(row, 1).text() for row in range(2)]
    page.texts.selectRow(rows.index(LABEL))
    assert page.buttons["approve"].isEnabled()
    page.buttons["approve"].click()
    assert page.status.text() == ""
    wait_for(lambda: texts(page) == {TIRING: "no, Anna"})
    assert [t.question for t in study_overview(study.folder).unreviewed] == ["tiring"]


def test_all_texts_are_approved_at_once(page, study, codes, wait_for):
    assert "Read them" in page.texts_state.text()
    choose(page, codes[1])
    page.tabs.setCurrentIndex(1)
    page.texts.selectAll()
    page.buttons["approve"].click()
    wait_for(lambda: not texts(page) and not page.jobs.is_busy)
    assert not study_overview(study.folder).unreviewed
    assert page.texts_state.text() == "All answers in words are approved."
    assert not page.buttons["approve"].isEnabled()


def test_texts_of_trials_and_removed_questions_are_named(page):
    about = [
        UnreviewedText("CDFGHJ", name, "words") for name in ("tiring@trial-03", "gone")
    ]
    page.show_overview(replace(page.overview, unreviewed=tuple(about)))
    assert list(texts(page)) == [f"{TIRING} (trial 3)", "gone"]


def test_a_participant_is_deleted_after_saying_what_goes(
    page, study, codes, monkeypatch, wait_for
):
    asked, answers = [], iter([QMessageBox.StandardButton.Cancel])
    (study.folder / "report.txt").write_text(f"participant {codes[0]}")

    def answer(box):
        asked.append(box.text())
        return next(answers, QMessageBox.StandardButton.Yes)

    monkeypatch.setattr(QMessageBox, "exec", answer)
    choose(page, codes[0])
    page.buttons["delete"].click()
    assert codes[0] in open_study(study.folder).codes()
    assert f"Delete participant {codes[0]}?" in asked[0]
    assert "Answers to 12 trials" in asked[0]
    assert "consent" in asked[0]
    page.buttons["delete"].click()
    wait_for(lambda: page.sessions.rowCount() == 1)
    assert open_study(study.folder).codes() == [codes[1]]
    assert open_study(study.folder).deleted_count() == 1
    assert "report.txt" in page.status.text()
    assert "deleted: 1" in page.summary.text()


def test_an_unfinished_session_is_ended_with_a_reason(
    page, study, codes, monkeypatch, wait_for
):
    monkeypatch.setattr(results, "ask_text", lambda *_: "felt sick")
    choose(page, codes[0])
    assert not page.buttons["end"].isEnabled()
    choose(page, codes[1])
    page.buttons["end"].click()
    wait_for(lambda: row_of(page, codes[1])[2] == "ended early")
    assert study.session(codes[1]).state is SessionState.STOPPED


@pytest.fixture
def merging(page):
    """The page of copies, as the button opens it."""
    page.buttons["merge"].click()
    (made,) = page.findChildren(MergePage)
    yield made
    if isValid(made):
        made.done(0)


@pytest.fixture
def sites(study, codes, tmp_path):
    """A folder with the copies of two sites, and the code of each one's session."""
    made = {}
    for name in ("berlin", "rennes"):
        copy = tmp_path / "sites" / name
        shutil.copytree(study.folder, copy)
        made[name] = half_session(open_study(copy))
    return tmp_path / "sites", made


def test_sessions_of_all_sites_are_added_and_told(
    page, merging, sites, study, wait_for
):
    folder, made = sites
    merging.add([folder, folder / "berlin"])
    assert [one.site for one in merging.copies] == ["berlin", "rennes"]
    merging.site.clear()
    QTest.keyClicks(merging.site, "dinard")  # of the last one, which is selected
    merging.start.click()
    wait_for(lambda: not merging.jobs.is_busy)
    assert "added: 2; here already: 4; left out: 0" in merging.status.text()
    assert merging.table.item(1, 2).text().endswith("added: 1, here already: 2")
    told = merging.detail.toPlainText()
    assert "1 of 1 trials not valid" in told
    assert "1 trials on Simulated" in told
    found = {code: site_of(study.session_folder(code)) for code in study.codes()}
    assert found[made["rennes"]] == "dinard"
    merging.reject()
    wait_for(lambda: page.sessions.rowCount() == 4)
    assert row_of(page, made["berlin"])[3] == "1 / 12"


def test_one_stranger_among_copies_keeps_all_out(
    merging, sites, study, tmp_path, wait_for
):
    folder, _ = sites
    stranger = create_study(tmp_path / "other").folder
    before = study.codes()
    merging.add([folder, stranger])
    merging.start.click()
    wait_for(lambda: "is the study" in merging.status.text())
    assert str(stranger) in merging.status.text()
    assert study.codes() == before
    merging.remove.click()
    assert [one.folder for one in merging.copies] == [
        folder / "berlin",
        folder / "rennes",
    ]


def test_a_session_left_out_is_selected_with_its_reason(merging, sites, wait_for):
    folder, made = sites
    path = folder / "berlin" / "sessions" / made["berlin"] / "answers.jsonl"
    path.write_bytes(path.read_bytes().replace(b"4", b"5", 1))
    merging.add([folder])
    merging.start.click()
    wait_for(lambda: "left out: 1" in merging.status.text())
    assert merging.chosen().site == "berlin"
    assert merging.detail.toPlainText().startswith(f"{made['berlin']}: ")


def test_a_study_is_packed_for_other_sites(
    application, qtbot, sequence, tmp_path, wait_for
):
    keys = ("bike", "horse", "car-turning", "car-braking")
    study = create_study(tmp_path / "whole", folders=dict.fromkeys(keys, sequence))
    page = StudyResults(study.folder)
    qtbot.addWidget(page)
    wait_for(lambda: not page.jobs.is_busy)
    page.buttons["pack"].click()
    (dialog,) = page.findChildren(PlaceDialog)
    dialog.place.setText(str(tmp_path / "out"))
    dialog.make_button.click()
    wait_for(lambda: not page.jobs.is_busy)
    package = open_study(tmp_path / "out" / "whole-package")
    check_package(package)
    checksum = json.loads((package.folder / MANIFEST).read_bytes())["sha256"]
    assert checksum in page.status.text()
    page.close()


def test_a_study_without_its_sequences_says_what_to_choose(page, tmp_path, wait_for):
    page.pack("package", tmp_path / "package")
    wait_for(lambda: "choose its folder" in page.status.text())
    assert not (tmp_path / "package").exists()


@pytest.mark.parametrize("form", study_exporters())
def test_data_are_exported_to_the_place_of_the_form(
    page, qtbot, tmp_path, wait_for, form
):
    dialog = export_dialog(page.folder, page)
    dialog.wanted.connect(page.export)
    dialog.form.setCurrentIndex(dialog.form.findData(form))
    dialog.place.setText(str(tmp_path / "out"))
    assert str(tmp_path / "out" / f"study-{form}") in dialog.whole.text()
    dialog.make_button.click()
    wait_for(lambda: "Exported to" in page.status.text())
    assert any(path.is_file() for path in (tmp_path / "out").rglob("*"))
    assert "2 text answers were left out" in page.status.text()
    dialog.place.setText(str(tmp_path / "out "))
    assert not dialog.make_button.isEnabled()
    assert "exists" in dialog.problem.text()


def test_a_study_that_nobody_took_part_in_says_so(application, qtbot, study, wait_for):
    page = StudyResults(study.folder)
    qtbot.addWidget(page)
    wait_for(lambda: not page.jobs.is_busy)
    assert "Nobody has taken part" in page.summary.text()
    assert page.texts_state.text() == "No answers in words yet."
    assert not page.buttons["export"].isEnabled()
    assert page.buttons["merge"].isEnabled()
    page.close()


def test_the_menu_opens_the_sessions_and_they_the_report(
    window, study, codes, monkeypatch, wait_for
):
    opened = []
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    monkeypatch.setattr(window.study_menu, "open_report", opened.append)
    window.study_menu.show_results()
    (page,) = window.findChildren(StudyResults)
    wait_for(page.buttons["analyse"].isEnabled)
    page.buttons["analyse"].click()
    assert opened == [study.folder]
    page.close()
