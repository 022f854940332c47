"""A stop, and then every command and dialog of the window: the force stays off."""

import shutil
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QFileDialog,
    QInputDialog,
    QMessageBox,
)
from shiboken6 import isValid

from app.player.commands import COMMANDS
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import UsageError
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.playback.source import open_source

ROUNDS, SETTLED_MS, PLAYED_MS = 3, 30, 120
BUTTONS = QMessageBox.StandardButton


@pytest.fixture
def felt(monkeypatch):
    """Largest force of any device that this process opens, N, since it was cleared."""
    sizes_n: list[float] = []
    read, close = HapticsProcesses.read_ticks, HapticsProcesses.close

    def noted(link):
        ticks, lost = read(link)
        sizes_n.extend(np.abs(ticks["force_n"]).max(axis=1).tolist())
        return ticks, lost

    def read_and_closed(link):
        close(link)
        noted(link)

    monkeypatch.setattr(HapticsProcesses, "read_ticks", noted)
    monkeypatch.setattr(HapticsProcesses, "close", read_and_closed)
    return sizes_n


@pytest.fixture
def answered(monkeypatch, sequence):
    """Answer what would wait for a person, and leave the demo away."""
    chosen = SimpleNamespace(returned=("", ""))
    for name in ("getSaveFileName", "getOpenFileName"):
        monkeypatch.setattr(QFileDialog, name, lambda *_a, **_k: chosen.returned)
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_a, **_k: "")
    for name in ("getItem", "getText"):
        monkeypatch.setattr(QInputDialog, name, lambda *_a, **_k: ("", False))
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: BUTTONS.Discard)
    monkeypatch.setattr(QMessageBox, "question", lambda *_a, **_k: BUTTONS.Yes)
    monkeypatch.setattr("app.player.session.DEMO", sequence)


@pytest.fixture
def stopped(make_window, settings, sequence, tmp_path, wait_for, feel, felt, answered):
    """A window whose force was felt, and is stopped."""
    own = tmp_path / "own"
    shutil.copytree(sequence, own)
    settings.keep("folder", str(tmp_path))
    settings.keep("library", str(tmp_path))
    window = make_window("simulated")
    window.session.show_source(open_source(own))
    window.player.set_loop((0.0, 1.9))
    feel(window)
    window.commands.stop.trigger()
    wait_for(lambda: window.transport.stop.text() == "Re-arm")
    wait_for(lambda: not window.player.snapshot().leading.tick["force_n"].any())
    return window


def shown_dialogs():
    return [
        widget
        for widget in QApplication.topLevelWidgets()
        if isinstance(widget, QDialog) and widget.isVisible()
    ]


def press_everything():
    """Press each button of all dialogs once, but those that re-arm."""
    pressed = set()
    for _ in range(ROUNDS):
        for dialog in shown_dialogs():
            if isinstance(dialog, QFileDialog):
                dialog.reject()
                continue
            for button in dialog.findChildren(QAbstractButton):
                if not isValid(button) or isinstance(button.window(), QFileDialog):
                    continue
                name = (type(dialog).__name__, button.text(), button.toolTip())
                if name in pressed or button.property("role") == "rearm":
                    continue
                if button.isEnabled() and button.isVisible():
                    pressed.add(name)
                    button.click()
                    QTest.qWait(1)
        QTest.qWait(SETTLED_MS)
    for dialog in shown_dialogs():
        dialog.done(0)
    return pressed


def play_on(window, wait_for):
    """Play with a device, as a person would try it."""
    wait_for(lambda: not window.session.jobs.is_busy)
    wait_for(lambda: not shown_dialogs())
    if window.player.snapshot().leading.name == NO_DEVICE:
        window.transport.device_chosen.emit("simulated")
    wait_for(lambda: window.player.snapshot().leading.health is not Health.STARTING)
    if window.player.snapshot().leading.health is not Health.READY:
        window.transport.device_chosen.emit("simulated")
    window.player.seek(0.1)
    window.player.play()
    QTest.qWait(PLAYED_MS)


@pytest.mark.realtime
def test_no_command_or_dialog_undoes_a_stop(stopped, wait_for, felt, feel):
    window, wrong = stopped, {}
    for command in COMMANDS:
        if command.name in {"quit", "rearm"}:
            continue
        felt.clear()
        window.commands.by_name[command.name].trigger()
        QTest.qWait(SETTLED_MS)
        press_everything()
        play_on(window, wait_for)
        found = (
            window.player.snapshot().is_stopped,
            window.transport.stop.text(),
            "STOPPED" in window.health.entries[0].text(),
            max(felt, default=0.0),
        )
        if found != (True, "Re-arm", True, 0.0):
            wrong[command.name] = found
    assert not wrong
    window.session.choose_leading("simulated")
    window.commands.rearm.trigger()
    feel(window)
    assert max(felt) > 0.1


@pytest.mark.realtime
def test_no_item_of_the_study_menu_undoes_a_stop(
    stopped, wait_for, felt, make_study, monkeypatch
):
    window, study, said = stopped, make_study(), []
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    monkeypatch.setattr(
        window.study_menu, "report", lambda one, _over: said.append(one)
    )
    menu = next(
        one.menu()
        for one in window.menuBar().actions()
        if one.text().replace("&", "") == "Study"
    )
    felt.clear()
    for action in menu.actions():
        action.trigger()
        QTest.qWait(SETTLED_MS)
        press_everything()
        play_on(window, wait_for)
        assert window.player.snapshot().is_stopped
        assert window.transport.stop.text() == "Re-arm"
    assert not max(felt, default=0.0)
    assert "re-arm" in str(said[0])
    assert not window.study_menu.process.is_running


@pytest.mark.realtime
def test_the_window_is_stopped_after_a_session(
    window, wait_for, source, felt, feel, make_study, monkeypatch, tmp_path
):
    window.session.choose_leading("simulated")
    window.session.show_source(source)
    program, study = tmp_path / "session", make_study()
    program.write_text("#!/bin/sh\nexit 0\n")
    program.chmod(0o700)
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    with monkeypatch.context() as patch:
        patch.setattr("app.experimenter.study_menu.sys.executable", str(program))
        window.study_menu.run()
    felt.clear()
    wait_for(lambda: not window.study_menu.process.is_running)
    assert window.session.is_stopped
    play_on(window, wait_for)
    assert not max(felt, default=0.0)
    assert window.transport.stop.text() == "Re-arm"
    window.session.rearm()
    feel(window)


@pytest.mark.realtime
def test_a_study_does_not_begin_during_a_stop(stopped):
    with pytest.raises(UsageError, match="re-arm"):
        stopped.release_devices()
