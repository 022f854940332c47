"""The guide, the system check and the report of a problem, inside the window."""

import getpass
import re
import zipfile
from pathlib import Path

import pytest
from PySide6.QtCore import QUrl

from app.player import help_pages
from app.player.guide import GuideWindow, read_guide, slug
from app.player.help_pages import CheckPage, ReportPage
from app.player.problem_report import without_names, without_texts
from hapticplayer.errors import InputError, Message, message_of
from hapticplayer.facilities import FACILITIES
from hapticplayer.shipped import shipped

LINK = re.compile(r"\]\(([\w-]+\.md)?(?:#([\w-]+))?\)")


@pytest.fixture
def guide(application, qtbot):
    made = GuideWindow(None)
    qtbot.addWidget(made)
    made.show()
    return made


def titles(guide):
    tops = [guide.tree.topLevelItem(n) for n in range(guide.tree.topLevelItemCount())]
    return [top.text(0) for top in tops]


def test_every_document_is_a_page_and_what_people_do_comes_first(guide):
    pages = list(dict.fromkeys(one.page for one in guide.sections))
    assert set(pages) == {path.name for path in shipped("docs").glob("*.md")}
    assert pages[:2] == ["play.md", "import.md"]
    assert len(titles(guide)) == len(pages)


def test_sections_are_short_enough_to_be_shown_at_once(guide):
    assert max(len(one.text) for one in guide.sections) < 20_000
    assert "<!--" not in "".join(one.text for one in guide.sections)


def test_words_lead_to_the_sections_that_hold_them(guide):
    guide.search.setText("three taps")
    assert titles(guide)
    assert "tap" in guide.page.toPlainText().lower()
    assert guide.page.textCursor().selectedText().lower() == "three"
    guide.search.setText("xyzzy")
    assert guide.nothing.isVisible()
    assert guide.page.toPlainText() == ""
    guide.search.clear()
    assert not guide.nothing.isVisible()


def test_links_between_pages_lead_to_their_heading(guide):
    headings = {
        (one.page, slug(title))
        for one in guide.sections
        for title in re.findall(r"^#+ (.+?)\s*$", one.text, re.MULTILINE)
    }
    followed = 0
    for section in guide.sections:
        for page, anchor in LINK.findall(section.text):
            if anchor:
                assert (page or section.page, anchor) in headings, section.title
                followed += 1
    assert followed > 10
    guide.follow(QUrl("formats.md#when-a-log-does-not-explain-itself"))
    assert "When a log does not explain itself" in guide.page.toPlainText()


def test_a_guide_without_documents_has_no_pages(qtbot, application, tmp_path):
    assert read_guide(tmp_path) == []
    made = GuideWindow(None, tmp_path)
    qtbot.addWidget(made)
    assert made.tree.topLevelItemCount() == 0


def test_the_menu_opens_one_guide_only(window):
    window.commands.guide.trigger()
    window.commands.guide.trigger()
    (page,) = window.findChildren(GuideWindow)
    page.close()


def test_the_system_check_names_what_it_has_looked_at(window, wait_for):
    window.commands.system_check.trigger()
    page = window.findChild(CheckPage)
    wait_for(lambda: "Python" in page.text.toPlainText())
    assert "ok" in page.text.toPlainText()
    page.close()


def test_each_text_of_the_system_check_can_be_translated(monkeypatch, window, wait_for):
    def say(text):
        return f"<{text.template}>" if isinstance(text, Message) else text

    monkeypatch.setattr(help_pages, "translated", say)
    window.commands.system_check.trigger()
    page = window.findChild(CheckPage)
    wait_for(lambda: "Python" in page.text.toPlainText())
    said = page.text.toPlainText()
    for text in ("ok", "sound", FACILITIES["memfd"].gives, "{what} ({proof})"):
        assert f"<{text}>" in said
    page.close()


@pytest.fixture
def report(window, wait_for):
    """A report after a refusal with a name in it, and a fault."""
    gateway = window.session.gateway
    gateway.report(
        InputError("has {count} gaps", where="/rides/anna/ride with ben.mp4", count=3)
    )
    try:
        int("anna")
    except ValueError as problem:
        gateway.report(problem)
    window.commands.report_problem.trigger()
    page = window.findChild(ReportPage)
    wait_for(page.save_button.isEnabled)
    return page


def test_a_report_shows_all_that_it_saves(report, tmp_path):
    report.notes.setPlainText("The wheel shook.")
    report.save(tmp_path / "report.zip")
    assert "Saved" in report.status.text()
    with zipfile.ZipFile(tmp_path / "report.zip") as kept:
        texts = {name: kept.read(name).decode() for name in kept.namelist()}
    shown = report.text.toPlainText()
    assert all(text.strip() in shown for text in texts.values())
    assert texts["words.txt"] == "The wheel shook.\n"
    assert "hapticplayer: " in texts["program.txt"]
    report.save(tmp_path / "report.zip")  # nothing is replaced
    assert "exists" in report.status.text()


def test_a_report_names_no_person_and_no_file(report):
    shown = report.text.toPlainText()
    assert "has 3 gaps" in shown
    assert "ValueError" in shown
    assert "tests/app/test_help.py" in shown
    for private in ("anna", "ben", ".mp4", str(Path.home())):
        assert private not in shown, private


def test_texts_in_messages_are_left_out_and_numbers_stay():
    what = Message("{name!r} has {n:.1f} s", name="Anna", n=2.0)
    assert without_texts(what) == "[...] has 2.0 s"
    problem = InputError("is wrong", where="/a/b", remedy="choose {x}", x=Message("it"))
    assert without_texts(message_of(problem)) == "[...]: is wrong; choose it"
    assert without_texts("a plain text with Anna") == "[...]"


def test_home_and_user_have_no_names(monkeypatch):
    monkeypatch.setattr(getpass, "getuser", lambda: "anna")
    home = Path.home()
    said = without_names(f"{home}/x, /{'home'}/ben/y, user anna, annals")
    assert said == "~/x, ~/y, user [...], annals"
