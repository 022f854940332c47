"""Numbers and dates in the window's language."""

import pytest

from app.experimenter.library_page import LibraryPage
from app.player.health import sync
from app.plots.playhead_plot import PlayheadPlot
from app.widgets.texts import date_text, local, quoted
from hapticplayer.model import SyncStats

DAYS = {"en": "2026-07-09", "de": "09.07.2026", "fr": "09/07/2026"}


@pytest.mark.parametrize(
    ("code", "said"),
    [("en", "p50 -0.25 of 1.5, done."), ("de", "p50 -0,25 of 1,5, done.")],
)
def test_only_points_within_numbers_change(spoken, code, said):
    spoken(code)
    assert local("p50 -0.25 of 1.5, done.") == said


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
    assert [text for _, text in ticks] == ["-5", "-2,5", "0", "2,5", "5"]
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
