import threading
from dataclasses import replace

import pytest

from app.experimenter.analysis import AnalysisPage, AnalysisWindow
from hapticplayer import cli
from hapticplayer.clock import SystemClock
from hapticplayer.errors import InputError
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.study.analysis.analysis import STATISTICS
from hapticplayer.study.analysis.statistic import Statistic
from hapticplayer.study.creation import create_study


@pytest.fixture
def failures() -> list[str]:
    return []


@pytest.fixture
def make_page(application, qtbot, failures):
    made = []

    def make(read=lambda _progress: simulated_answers(6, seed=1)) -> AnalysisPage:
        page = AnalysisPage("Rides", read, failures.append, SystemClock())
        qtbot.addWidget(page)
        page.resize(1000, 800)
        page.show()
        made.append(page)
        return page

    yield make
    for page in made:
        page.close_jobs()


def test_the_report_is_shown_with_its_figures_and_can_be_saved(
    make_page, wait_for, tmp_path, failures
):
    page = make_page()
    assert not page.save_button.isEnabled()
    page.analyse_button.click()
    assert not page.analyse_button.isEnabled()
    wait_for(lambda: not page.is_busy)
    shown = page.text.toPlainText()
    assert "6 participants" in shown
    assert "ready for publication" in page.note.text()
    assert "Kendall's W" in shown
    assert shown.count("\ufffc") == 3  # an embedded picture
    page.resize(800, 600)
    wait_for(lambda: page.text.horizontalScrollBar().maximum() == 0)
    page.save(tmp_path / "report")
    wait_for(lambda: not page.is_busy)
    assert (tmp_path / "report" / "report.pdf").stat().st_size > 10_000
    assert failures == []


def test_a_report_without_a_valid_answer_is_not_to_be_published(make_page, wait_for):
    made = simulated_answers(6, seed=1)
    ratings = tuple(replace(one, value=None) for one in made.ratings)
    page = make_page(lambda _progress: replace(made, ratings=ratings))
    assert "publi" not in page.note.text()
    page.analyse_button.click()
    wait_for(lambda: not page.is_busy)
    assert page.note.text() == "No valid answer yet: there is nothing to publish."
    assert page.text.toPlainText().startswith("No valid answer yet: ")
    assert "\ufffc" not in page.text.toPlainText()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A study of six simulated participants."""
    made = tmp_path_factory.mktemp("studies") / "s"
    arguments = ["study", "simulate", str(made), "--participants", "6"]
    assert cli.main([*arguments, "--seed", "1"], None) == 0
    return made


def test_the_menu_opens_the_report_with_what_was_added(
    window, folder, monkeypatch, wait_for
):
    """Also with a statistic that came later."""
    entry = Statistic("dummy", "Number of answers", lambda *_: {"n": {"n": 7.5}})
    monkeypatch.setitem(STATISTICS, "dummy", entry)
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: folder)
    window.study_menu.analyse()
    (report,) = window.findChildren(AnalysisWindow)
    page = report.page
    wait_for(lambda: not page.is_busy)
    shown = page.text.toPlainText()
    for text in ("6 participants", "Number of answers", "7.5"):
        assert text in shown
    assert shown.count("\ufffc") == 3
    assert not report.messages.isVisible()
    for action in window.menuBar().actions():
        if action.text() == "&Study":
            names = [one.text() for one in action.menu().actions()]
    assert "&Analyse study\u2026" in names
    window.close()
    assert not report.isVisible()


def test_a_study_that_nobody_took_part_in_says_so_in_its_window(
    window, tmp_path, monkeypatch, wait_for
):
    study = create_study(tmp_path / "s")
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.study_menu.analyse()
    (report,) = window.findChildren(AnalysisWindow)
    wait_for(report.messages.isVisible)
    assert "participant" in report.messages.text()


def test_a_study_that_cannot_be_analysed_is_reported(make_page, wait_for, failures):
    def read(_progress):
        raise InputError("there is no participant")

    page = make_page(read)
    page.analyse_button.click()
    wait_for(lambda: not page.is_busy)
    assert [str(one) for one in failures] == ["there is no participant"]
    assert page.analyse_button.isEnabled()
    assert not page.save_button.isEnabled()


def test_the_work_can_be_stopped(make_page, wait_for, failures):
    may_go_on = threading.Event()

    def read(_progress):
        may_go_on.wait(20.0)
        return simulated_answers(6, seed=1)

    page = make_page(read)
    page.analyse_button.click()
    page.job_bar.cancelled.emit()
    may_go_on.set()
    wait_for(lambda: not page.is_busy)
    assert page.text.toPlainText() == ""
    assert failures == []
