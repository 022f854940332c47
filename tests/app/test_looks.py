"""Themes and languages: the window is rebuilt around the same player."""

import itertools
import os

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QScrollBar,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from app.player.remake import OpenWindow
from app.player.window import PlayerWindow
from app.widgets import theme
from app.widgets.buttons import text_button
from hapticplayer.playback.phases import Phase


@pytest.fixture
def shown(make_window, source, dressed, wait_for):
    window = make_window()
    window.session.show_source(source)
    made = OpenWindow(window)
    made.begin()
    yield made
    made.end()


def test_another_language_keeps_clip_and_place(shown, wait_for):
    shown.window.player.seek(1.0)
    player, before = shown.window.player, shown.window
    menu = shown.window.themes.languages
    menu.fill()
    next(a for a in menu.menu.actions() if a.data() == "de").trigger()
    wait_for(lambda: not shown.is_remaking)
    assert shown.window is not before
    assert shown.window.player is player
    assert player.snapshot().media_s == pytest.approx(1.0)
    assert shown.window.transport.play.accessibleName() == "Abspielen"
    wait_for(lambda: shown.window.surface.frame is not None)
    shown.window.transport.play.click()
    wait_for(lambda: player.snapshot().phase is Phase.PLAYING)


def test_a_session_is_watched_by_the_window_that_takes_the_place(
    shown, tmp_path, monkeypatch, wait_for
):
    gate, program = tmp_path / "gate", tmp_path / "session"
    os.mkfifo(gate)
    program.write_text(f"#!/bin/sh\ncat {gate} >&2\nexit 1\n")
    program.chmod(0o700)
    monkeypatch.setattr("app.experimenter.study_menu.sys.executable", str(program))
    before, reported = shown.window, []
    before.study_menu.process.start([])
    shown.window.settings.keep("look", theme.LIGHT)
    before.themes.changed.emit()
    wait_for(lambda: not shown.is_remaking)
    after = shown.window
    monkeypatch.setattr(
        after.study_menu, "report", lambda one, _over=None: reported.append(one)
    )
    assert after is not before
    assert after.study_menu.process.is_running
    gate.write_text("hapticplayer: it was the cable\n")
    wait_for(lambda: not after.study_menu.process.is_running)
    assert [str(problem) for problem in reported] == ["it was the cable"]


@pytest.mark.parametrize("look", list(theme.THEMES))
def test_another_look_colours_everything(shown, look, wait_for):
    shown.window.settings.keep("look", look)
    shown.window.themes.changed.emit()
    wait_for(lambda: not shown.is_remaking)
    assert shown.window.isVisible()
    panel = shown.window.transport.grab().toImage().pixelColor(2, 30).name()
    assert panel == theme.THEMES[look]["PANEL"]


def test_a_scroll_bar_of_high_contrast_is_white_on_black(application, qtbot):
    before = theme.name
    theme.use(theme.CONTRAST)
    try:
        bar = QScrollBar(Qt.Orientation.Vertical)
        qtbot.addWidget(bar)
        bar.setStyleSheet(theme.style_sheet())
        bar.setRange(0, 100)
        bar.setPageStep(100)
        bar.resize(14, 200)
        image = bar.grab().toImage()
    finally:
        theme.use(before)
    seen = [image.pixelColor(7, y).name() for y in range(200)]
    assert 60 < seen.count("#ffffff") < 140  # half of it can be moved
    assert seen.count("#000000") + seen.count("#ffffff") >= 196  # round ends


def test_english_again_after_german(shown, wait_for):
    for code, word in (("de", "Abspielen"), ("fr", "Lire"), ("en", "Play")):
        shown.window.settings.keep("language", code)
        shown.remake()
        wait_for(lambda: not shown.is_remaking)
        assert shown.window.transport.play.accessibleName() == word


def test_the_clip_plays_on_into_the_new_window(shown, long_source, wait_for):
    """No seek, no pause: one epoch of the clock from the old window to the new."""
    player, before = shown.window.player, shown.window
    before.session.show_source(long_source)
    player.play()
    wait_for(lambda: player.snapshot().phase is Phase.PLAYING)
    epoch, begun_s = player.snapshot().epoch, player.snapshot().media_s
    shown.window.settings.keep("look", theme.LIGHT)
    shown.remake()
    wait_for(lambda: not shown.is_remaking)
    after = shown.window
    assert after.surface.image is not None  # what the old one showed, at once
    assert after.stage.currentWidget() is after.surface
    assert player.snapshot().phase is Phase.PLAYING
    assert player.snapshot().epoch == epoch
    assert player.snapshot().media_s > begun_s
    wait_for(lambda: not isValid(before))  # with all of its widgets


def test_no_step_makes_the_whole_window(shown, wait_for):
    """The old window has its turn in between: its timers fire again and again."""
    turns = []
    timer = QTimer(interval=1, timeout=lambda: turns.append(shown.window))
    timer.start()
    before = shown.window
    shown.window.settings.keep("language", "fr")
    shown.remake()
    wait_for(lambda: not shown.is_remaking)
    timer.stop()
    assert turns.count(before) >= 8


def test_a_clip_opened_meanwhile_is_in_the_new_window(shown, clip, wait_for):
    shown.remake()
    shown.window.session.open_path(clip)
    wait_for(lambda: not shown.is_remaking)
    wait_for(lambda: shown.window.player.snapshot().source.path == clip)
    assert clip.stem in shown.window.windowTitle()


def test_the_last_of_two_wishes_counts(shown, wait_for):
    for code in ("de", "fr"):
        shown.window.settings.keep("language", code)
        shown.remake()
    wait_for(lambda: not shown.is_remaking)
    assert shown.window.transport.play.accessibleName() == "Lire"


def windows(qapp):
    return {one for one in qapp.topLevelWidgets() if isinstance(one, PlayerWindow)}


def test_closing_ends_what_is_being_made(shown, qapp, wait_for):
    before = windows(qapp)
    shown.window.settings.keep("look", theme.LIGHT)
    shown.remake()
    while not (made := windows(qapp) - before):
        qapp.processEvents()
    shown.end()
    assert not shown.is_remaking
    wait_for(lambda: not any(map(isValid, made)))


def lightness(colour: QColor) -> float:
    """Return the relative luminance of WCAG 2.2."""
    parts = (value / 255 for value in colour.getRgb()[:3])
    linear = [
        p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("role", ["primary", "stop"])
def test_high_contrast_gives_buttons_an_edge(dressed, qtbot, role):
    dressed(look=theme.CONTRAST)
    holder = QWidget()
    qtbot.addWidget(holder)
    QVBoxLayout(holder).addWidget(text_button("Text", "", role))
    holder.resize(200, 300)
    holder.show()
    image = holder.grab().toImage()
    ground = lightness(QColor(theme.BACKGROUND))
    spots = itertools.product(range(image.width()), range(image.height()))
    lit = [lightness(image.pixelColor(x, y)) for x, y in spots]
    strong = sum((light + 0.05) / (ground + 0.05) >= 7.0 for light in lit)
    assert strong >= 300  # what is round a button of 170 pixels
