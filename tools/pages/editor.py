"""Pictures of the editor of effects: empty, at work, offering, several, asking, damaged."""

from pathlib import Path

from PySide6.QtCore import QPoint
from PySide6.QtGui import QPainter, QPixmap

from app.editor.edits import with_curve
from app.editor.page import EditorPage
from app.editor.playing import PlayerSetup
from app.player.video_surface import SurfaceSink
from hapticplayer.clock import Clock, SystemClock
from hapticplayer.playback.player import Player
from hapticplayer.rendering.effects import Effect
from tools.pages.stage import Pictures, Stage

IN_THE_TURN_S = 5.2


def pictures(stage: Stage) -> Pictures:
    """Yield the page in every state."""
    page = _page(stage, stage.source.path)
    with stage.shown(page):
        yield "editor-reading", page.grab()
        _wait(stage, page)
        yield "editor-empty", stage.picture(page)
        _edit(page)
        page.document.select(1)
        page.play_bar.loop.click()
        page.lanes.point_at(IN_THE_TURN_S)
        stage.wait_until(lambda: page.comparison.after is not None)
        yield "editor-working", stage.picture(page, 300)
        yield "editor-offer", _with_menu(stage, page)
        page.editing.select_all()
        page.left.setCurrentWidget(page.markers)
        yield "editor-several", stage.picture(page)
        page.view.show_span(6.2, 8.2)
        page.document.select(3)
        page.panel.fields["amplitude"].box.setValue(20.0)
        yield "editor-zoomed", stage.picture(page, 1500)
        yield "editor-asks", stage.asked(page.reject)
        page.document.stack.setClean()
    long_named = stage.material.library / "sequence-2"
    for name, folder in (("long", long_named), ("damaged", stage.folder / "nowhere")):
        page = _page(stage, folder)
        with stage.shown(page):
            stage.wait_until(lambda p=page: not p.jobs.is_busy)
            yield f"editor-{name}", stage.picture(page)


def _page(stage: Stage, folder: Path) -> EditorPage:
    return EditorPage(
        folder, PlayerSetup(SystemClock(), "none", stage.settings, _player)
    )


def _player(clock: Clock, sink: SurfaceSink, device: str) -> Player:
    return Player(clock, sink, outputs=[device], audio=None)


def _wait(stage: Stage, page: EditorPage) -> None:
    stage.wait_until(lambda: page.live is not None and not page.live.is_busy)


def _edit(page: EditorPage) -> None:
    """Take what events suggest, and add some."""
    for event in page.lanes.events[:4]:
        page.editing.add(event.effect, "")
    page.document.select(1)
    gain = page.document.effect
    page.editing.put(with_curve(gain, "0 1; 1.2 1.8; 2.4 1"), "")
    page.editing.add(Effect("low-pass", 6.5, 7.8, fade_in_s=0.2, fade_out_s=0.2), "")
    page.editing.add(Effect("engine", 1.0, 3.6, fade_in_s=0.5, fade_out_s=0.5), "")
    page.editing.toggle()
    for at_s in (2.5, IN_THE_TURN_S):
        page.editing.mark(at_s)


def _with_menu(stage: Stage, page: EditorPage) -> QPixmap:
    """Return the page with the menu over it, which is a window of its own."""
    at = page.lanes.event_box(2).bottomLeft().toPoint()
    page.lanes.offer(2, page.lanes.mapToGlobal(at))
    whole = stage.picture(page)
    menu = page.lanes.menu
    with QPainter(whole) as painter:
        place = page.lanes.mapTo(page, QPoint(at))
        left = min(place.x(), page.width() - menu.width())
        painter.drawPixmap(left, place.y() - menu.height(), menu.grab())
    menu.close()
    return whole
