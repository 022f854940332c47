"""Pictures of the player's window in every state, its menus, and what it tells."""

from PySide6.QtCore import QPoint
from PySide6.QtGui import QPixmap
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from app.extras.faults.panel import FaultPanel
from app.player.commands import COMMANDS
from app.player.dialogs import about_dialog
from app.player.keys_dialog import KeysDialog
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.plots.playhead_plot import PlayheadPlot
from app.widgets.layout import resize_within_screen
from hapticplayer.clock import SystemClock
from hapticplayer.errors import Progress
from hapticplayer.extras.faults.injected import Fault
from hapticplayer.haptics.contract import Mode
from hapticplayer.playback.player import Player
from tools.pages.stage import Pictures, Stage

WIDTH_PX, HEIGHT_PX = 1280, 800
AT_S, PLAYED_MS = 4.0, 2500  # of the demo: the plots have something to show
LATEST_S = 9.0  # then it continues from there
STEADY, MOST_LOOKS = 10, 200  # until the whole window is up to date; on a slow machine


def pictures(stage: Stage) -> Pictures:
    """Yield every state of the player's window."""
    surface = VideoSurface()
    player = Player(
        SystemClock(), SurfaceSink(surface), outputs=["simulated"], audio=None
    )
    window = PlayerWindow(player, surface, SystemClock(), stage.settings)
    resize_within_screen(window, WIDTH_PX, HEIGHT_PX)
    try:
        yield from _empty(stage, window)
        yield from _with_clip(stage, window)
        yield from _menus(stage, window)
        yield from _faults(stage, window)
        yield from _dialogs(stage, window)
    finally:
        window.close()
        window.deleteLater()  # before Python does so, item by item of its plots
        stage.wait()


def _empty(stage: Stage, window: PlayerWindow) -> Pictures:
    yield "player-empty", stage.picture(window, 400)
    is_over: list[bool] = []

    def work(progress: Progress) -> None:
        while not is_over:
            progress(0.4, "drawing the ride")

    window.session.jobs.run(
        window.session.tr("Preparing the demo"), work, lambda _none: None
    )
    window.session.changed.emit()
    yield "player-busy", stage.picture(window, 600)
    is_over.append(True)
    stage.wait_until(lambda: not window.session.jobs.is_busy)
    window.session.open_path(stage.folder / "no such ride.mp4")
    stage.wait_until(lambda: bool(window.messages.text()))
    yield "player-empty-error", stage.picture(window, 400)
    window.session.open_path(stage.material.damaged)
    stage.wait_until(lambda: "damaged" in window.messages.text())
    yield "player-damaged", stage.picture(window)
    window.messages.hide()


def _with_clip(stage: Stage, window: PlayerWindow) -> Pictures:
    player, commands = window.player, window.commands
    window.session.show_source(stage.source)
    yield "player-beginning", stage.picture(window, 600)
    player.seek(AT_S)
    player.play()
    stage.wait(PLAYED_MS)
    commands.sync_plot.setChecked(True)
    commands.statistics.setChecked(True)
    stage.wait(500)
    yield "player-inside", _with_force(stage, window)
    commands.statistics.setChecked(False)
    commands.sync_plot.setChecked(False)
    stage.wait(300)
    yield "player-playing", _with_force(stage, window)
    window.player.pause()
    yield from _pointed_at(stage, window)
    window.stop()
    yield "player-stopped", stage.picture(window, 300)
    window.session.rearm()
    window.extras.controls.change_speed(1)
    window.extras.controls.loop()
    yield "player-toast", stage.picture(window)
    commands.plots.setChecked(False)
    yield "player-without-plots", stage.picture(window)
    commands.plots.setChecked(True)
    window.toggle_fullscreen()
    yield "player-fullscreen", stage.picture(window, 300)
    window.fullscreen.leave()
    stage.wait()


def _with_force(stage: Stage, window: PlayerWindow) -> QPixmap:
    """Return the window while a force is felt; a busy machine takes it away at times."""
    player, felt = window.player, [False]

    def is_steady() -> bool:
        if player.snapshot().media_s > LATEST_S:
            player.seek(AT_S)
        latest = player.snapshot().leading.tick
        felt.append(latest is not None and int(latest["mode"]) == Mode.FOLLOWING)
        return all(felt[-STEADY:]) or len(felt) > MOST_LOOKS

    stage.wait_until(is_steady)
    return window.grab()


def _pointed_at(stage: Stage, window: PlayerWindow) -> Pictures:
    """Point at the seek bar, then into a plot."""
    slider, thumbnails = window.transport.slider, window.extras.thumbnails
    slider.hovered.emit(AT_S)
    stage.wait_until(lambda: not thumbnails.is_busy)
    slider.hovered.emit(AT_S)
    yield "player-thumbnail", stage.picture(window)
    slider.hovered.emit(-1.0)
    plot = window.findChild(PlayheadPlot)
    at = QPoint(plot.viewport().width() * 2 // 3, plot.viewport().height() // 2)
    QTest.mouseMove(plot.viewport(), at)
    yield "player-read-out", stage.picture(window)
    QTest.mouseMove(window.surface, QPoint(9, 9))


def _menus(stage: Stage, window: PlayerWindow) -> Pictures:
    names = ("file", "edit", "playback", "view", "device", "study", "help")
    for name, action in zip(names, window.menuBar().actions(), strict=True):
        menu = action.menu()
        yield f"menu-{name}", _popped(stage, menu)
        inner = [a.menu() for a in menu.actions() if a.menu() is not None]
        for number, one in enumerate(inner, 1):
            yield f"menu-{name}-{number}", _popped(stage, one)


def _popped(stage: Stage, menu: QMenu) -> QPixmap:
    menu.popup(menu.mapToGlobal(menu.pos()))
    stage.wait()
    seen = menu.grab()
    menu.close()
    return seen


def _faults(stage: Stage, window: PlayerWindow) -> Pictures:
    window.player.seek(AT_S)
    window.commands.faults.trigger()
    panel = window.findChild(FaultPanel)
    stage.wait(400)
    yield "faults", panel.grab()
    window.player.play()
    for fault in (Fault.SHORT_STALL, Fault.UNPLUG):
        stage.wait(900)
        panel.inject(fault.value)
    stage.wait(700)
    yield "faults-shown", panel.grab()
    yield "player-unplugged", window.grab()
    panel.close()
    stage.wait()
    window.session.choose_leading("simulated")
    window.messages.hide()


def _dialogs(stage: Stage, window: PlayerWindow) -> Pictures:
    for name, make in (
        ("keyboard", lambda: KeysDialog(COMMANDS, stage.settings, window)),
        ("about", lambda: about_dialog(window)),
    ):
        with stage.shown(make()) as dialog:
            yield name, dialog.grab()
