"""Numbers and dates in the window's language."""

import re
from itertools import product

import faces
import hearing
import pytest
from PySide6.QtWidgets import QLabel, QListWidget, QTableWidget, QWidget

from app.bridge.languages import translated
from app.experimenter.import_columns import ColumnMap
from app.experimenter.library_page import LibraryPage
from app.player.health import sync
from app.plots.playhead_plot import PlayheadPlot, clock_text
from app.widgets.texts import date_text, local, quoted, time_text
from hapticplayer.errors import Message
from hapticplayer.model import SyncStats

DAYS = {"en": "2026-07-09", "de": "09.07.2026", "fr": "09/07/2026"}


@pytest.mark.parametrize(
    ("code", "said"),
    [("en", "\u22120.25 of 1.5, done."), ("de", "\u22120,25 of 1,5, done.")],
)
def test_only_points_and_signs_of_numbers_change(spoken, code, said):
    spoken(code)
    assert local("-0.25 of 1.5, done.") == said
    assert local("2026-07-09, hw-1, 1e-05") == "2026-07-09, hw-1, 1e-05"


def test_the_engines_numbers_are_the_languages_too(spoken):
    spoken("de")
    said = Message("{name}: {at_s:.1f} s, {n} times", name="a-1.5.mp4", at_s=-3.5, n=2)
    assert translated(said) == "a-1.5.mp4: \u22123,5 s, 2 times"
    assert time_text(83.5) == "01:23,5"
    assert clock_text(83.5) == "1:23,5"


POINT = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.]|\.\d)")
# versions and addresses, paths, and what is typed so in every language
NO_NUMBER = re.compile(r"\d+\.\d+\.\d+|\S*/\S*\d\.\d\S*|\w=[\d.]+|0 1; 0\.5 2")


def shown(face):
    """Yield all texts of a page."""
    rows_of_files = {
        w for one in face.findChildren(ColumnMap) for w in one.findChildren(QWidget)
    }
    for widget in set(face.findChildren(QWidget)) - rows_of_files:
        yield hearing.heard(widget)[1]
        yield hearing.description(widget)
        yield hearing.value(widget)
        if isinstance(widget, QLabel):
            yield widget.text()
        if isinstance(widget, QTableWidget):
            cells = product(range(widget.rowCount()), range(widget.columnCount()))
            yield from (one.text() for at in cells if (one := widget.item(*at)))
        if isinstance(widget, QListWidget):
            yield from (widget.item(row).text() for row in range(widget.count()))


def test_no_page_has_a_decimal_point_in_german(dressed, make_window, source, tmp_path):
    dressed(language="de")
    window = make_window()
    window.session.show_source(source)
    wrong = {}
    for name, make in {
        "window": lambda: window,
        **faces.dialogs(window, tmp_path),
    }.items():
        face = make()
        found = {NO_NUMBER.sub("", text) for text in shown(face)}
        if found := {text for text in found if POINT.search(text)}:
            wrong[name] = found
        if face is not window:
            faces.close(face)
    assert wrong == {}


@pytest.mark.parametrize("code", DAYS)
def test_a_day_is_written_as_the_language_does_it(spoken, code):
    spoken(code)
    assert date_text("2026-07-09T12:00:00") == DAYS[code]  # of here
    assert date_text("") == ""
    assert date_text("long ago, in a camera") == "long ago, "


def test_french_marks_stand_off_from_what_they_quote(spoken):
    spoken("fr")
    assert quoted("Le parc") == "\u00ab\u00a0Le parc\u00a0\u00bb"
    spoken("de")
    assert quoted("Der Park") == "\u201eDer Park\u201c"


def test_two_numbers_with_commas_are_not_run_together(spoken):
    spoken("de")
    text = sync(SyncStats(10, -20.8, -5.4, 0.5)).text
    assert text.endswith("\u22125,4; +0,5 ms")


def test_the_axis_and_the_library_speak_it_too(spoken, qtbot, sequence):
    spoken("de")
    plot = PlayheadPlot("Kraft", (1.0,))
    qtbot.addWidget(plot)
    plot.set_half_range(5.0)
    ticks = plot.getPlotItem().getAxis("left")._tickLevels[0]
    minus = "\u2212"
    assert [text for _, text in ticks] == [f"{minus}5", f"{minus}2,5", "0", "2,5", "5"]
    page = LibraryPage(sequence.parent)
    qtbot.addWidget(page)
    assert page.details.tracks.item(0, 1).text().replace(",", "").endswith(" N")
    assert "," in page.details.tracks.item(0, 1).text()
    page.resize(960, 540)  # a usual screen at 200 %
    page.show()
    qtbot.wait(20)
    report = page.details.report
    assert report.document().size().width() <= report.viewport().width()
    page.close_jobs()
