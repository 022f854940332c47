import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.player import fullscreen
from app.widgets import layout
from hapticplayer.playback.phases import Phase


def key(window, code) -> None:
    QTest.keyClick(window.windowHandle(), code)


def beside_the_surface(window) -> list:
    return [
        window.menuBar(),
        window.messages,
        window.job_bar,
        window.plots,
        window.transport,
        window.health,
    ]


@pytest.fixture(autouse=True)
def _soon(monkeypatch):
    """Let the cursor go after 0.1 s."""
    monkeypatch.setattr(fullscreen, "CURSOR_STAYS_MS", 100)


@pytest.fixture
def full(playing, wait_for):
    key(playing, Qt.Key.Key_F)
    wait_for(lambda: playing.geometry() == playing.screen().geometry())
    return playing


def test_fullscreen_shows_the_clip_and_nothing_else(full, wait_for):
    assert full.isFullScreen()
    assert [w for w in beside_the_surface(full) if w.isVisible()] == []
    assert full.surface.isVisible()
    wait_for(lambda: full.surface.size() == full.screen().geometry().size())
    shown = full.player.snapshot().frames_shown
    wait_for(lambda: full.player.snapshot().frames_shown > shown)


def test_leaving_brings_everything_back(playing, wait_for, qtbot):
    before = playing.geometry()
    shown = [w for w in beside_the_surface(playing) if w.isVisible()]
    key(playing, Qt.Key.Key_F11)
    assert playing.fullscreen.is_on
    key(playing, Qt.Key.Key_F)
    wait_for(lambda: playing.geometry() == before)
    assert not playing.isFullScreen()
    assert [w for w in beside_the_surface(playing) if w.isVisible()] == shown
    qtbot.mouseDClick(playing.surface, Qt.MouseButton.LeftButton)
    assert playing.isFullScreen()
    qtbot.mouseDClick(playing.surface, Qt.MouseButton.LeftButton)
    assert not playing.isFullScreen()


def test_escape_leaves_fullscreen_and_pauses(full):
    key(full, Qt.Key.Key_Escape)
    assert not full.isFullScreen()
    assert full.player.snapshot().phase is Phase.PAUSED


def test_an_error_leaves_fullscreen_and_plots_stay_off(full, wait_for):
    surface = full.surface
    wait_for(lambda: surface.cursor().shape() == Qt.CursorShape.BlankCursor)
    surface.pointer_moved.emit()
    assert surface.cursor().shape() != Qt.CursorShape.BlankCursor
    key(full, Qt.Key.Key_P)
    assert not full.plots.isVisible()
    full.show_message("something to read")
    assert not full.isFullScreen()
    assert full.messages.isVisible()
    assert not full.plots.isVisible()


def test_a_job_does_not_show_in_fullscreen(full, wait_for):
    steps = []

    def work(progress):
        while not steps:
            progress(0.5, "working")

    full.session.jobs.run("A job", work, lambda _: None)
    wait_for(lambda: full.session.jobs.state().fraction == 0.5)
    assert not full.job_bar.isVisible()
    steps.append("enough")
    wait_for(lambda: not full.session.jobs.is_busy)


def test_a_window_that_began_in_fullscreen_has_its_title(make_window, source):
    window = make_window()
    window.hide()
    window.move(0, 0)
    window.session.show_source(source)
    window.enter_fullscreen()
    window.toggle_fullscreen()
    assert window.geometry().top() >= layout.TITLE_BAR_PX
