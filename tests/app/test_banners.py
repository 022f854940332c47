"""What the window says goes when its cause does; what stops the force says so."""

import json
import os
import shutil
import signal
import threading

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog
from shiboken6 import isValid

from app.bridge.errors import Attempts
from app.bridge.settings import SOUND, keep_latency
from app.player.display import grip_of
from app.player.outputs_page import OutputsPage
from app.widgets.messages import MessageBar
from hapticplayer.errors import HapticPlayerError, InputError, UsageError
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.snapshot import OutputSnapshot, Snapshot
from hapticplayer.playback.source import open_source
from tests.needed_extras import needs


@pytest.fixture
def says(window, wait_for):
    """Wait for a banner, end its cause, and wait until it has gone."""

    def check(text, end, seen=window):
        wait_for(lambda: text in seen.messages.text())
        QTest.qWait(300)  # it stays while its cause does
        assert text in seen.messages.text()
        end()
        wait_for(lambda: seen.messages.text() == "")

    return check


def test_a_message_stays_without_an_end_and_goes_with_one(qtbot):
    bar, ends = MessageBar(), [False]
    qtbot.addWidget(bar)
    bar.show_text("first")
    QTest.qWait(300)
    assert bar.text() == "first"
    bar.show_text("second", lambda: ends[0])
    QTest.qWait(300)
    assert bar.text() == "second"
    ends[0] = True
    qtbot.waitUntil(lambda: bar.text() == "")
    bar.show_text("third")  # the end of another is not its own
    QTest.qWait(300)
    assert bar.text() == "third"


def test_another_attempt_ends_the_complaint_about_the_one_before():
    attempts = Attempts()
    first = attempts.begin()
    assert not first()
    second = attempts.begin()
    assert (first(), second()) == (True, False)


@needs("wheels")
def test_a_device_that_cannot_be_opened_is_over_once_removed(window, says):
    window.commands.outputs.trigger()
    page = window.findChild(OutputsPage)
    window.player.set_outputs(["wheel:event99"])
    says("event99", lambda: page.remove("wheel:event99"))


@pytest.mark.realtime
def test_a_dead_device_is_over_once_it_is_opened_again(make_window, says, wait_for):
    window = make_window("simulated")
    for again in (
        lambda: window.session.choose_outputs(["simulated"]),
        lambda: window.player.set_outputs(["simulated"]),
    ):
        wait_for(lambda: window.player.snapshot().leading.health is Health.READY)
        os.kill(window.player.snapshot().leading.loop_pid, signal.SIGKILL)
        says("choose the device again", again, window)


def test_a_refused_re_arm_is_over_once_the_force_is_back(window, says, monkeypatch):
    window.session.stop()
    problem = UsageError("move the grip to the centre first, then re-arm again")
    with monkeypatch.context() as patch:
        patch.setattr(window.player, "rearm", lambda: (_ for _ in ()).throw(problem))
        window.session.rearm()
    says("move the grip", window.session.rearm)


def test_a_refused_session_is_over_once_the_force_is_back(
    window, says, make_study, monkeypatch
):
    study = make_study()
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.session.stop()
    window.study_menu.run()
    says("re-arm it first", window.session.rearm)


def test_a_session_that_has_failed_is_over_with_the_next(window, says, make_study):
    window.study_menu.process.ended.emit("the session has ended with status 3")
    assert window.session.is_stopped
    says("status 3", window.study_menu.attempts.begin)


def test_a_far_reach_is_over_with_another_force(window, sequence, tmp_path, says):
    strong = shutil.copytree(sequence, tmp_path / "strong")
    path = strong / "sequence.json"
    description = json.loads(path.read_text())
    excursion = description["feedbacks"]["realistic"]["excursion"]
    excursion["hands"]["relaxed"].update(reach=0.96, reach_at_s=1.25)
    path.write_text(json.dumps(description))
    window.session.show_source(open_source(strong))
    says("96 % of the workspace", lambda: window.session.choose_feedback("none"))
    window.session.choose_feedback("realistic")
    assert "96 % of the workspace" in window.messages.text()


def test_a_busy_window_is_over_with_its_work(window, sequence, says):
    is_enough = threading.Event()

    def work(progress) -> None:
        while not is_enough.wait(0.01):
            progress(0.0, "")

    window.session.jobs.run("slow", work, lambda _: None)
    window.session.open_path(sequence)
    says("wait for it", is_enough.set)


def test_a_missing_file_is_over_with_the_next_attempt(window, tmp_path, says, clip):
    window.session.open_path(tmp_path / "missing.mp4")
    says("missing.mp4", lambda: window.session.open_path(clip))


@pytest.mark.parametrize("command", ["rendering", "share", "edit_effects"])
def test_a_need_for_a_sequence_is_over_with_one(
    window, clip, source, says, wait_for, command
):
    window.session.show_source(open_source(clip))
    wait_for(window.commands.by_name[command].isEnabled)
    window.commands.by_name[command].trigger()
    says("import the video first", lambda: window.session.show_source(source))


def test_a_need_for_a_device_is_over_with_one(window, says):
    window.commands.get_to_know.trigger()
    says("Choose a device", lambda: window.player.set_outputs(["simulated"]))


def test_a_file_of_settings_that_fails_is_over_with_the_next(window, tmp_path, says):
    (tmp_path / "file").touch()
    window.dialogs.export(str(tmp_path / "file" / "a.json"))
    says("cannot be written", lambda: window.dialogs.export(str(tmp_path / "a.json")))
    window.dialogs.take(str(tmp_path / "b.json"))
    says("settings", lambda: window.dialogs.take(str(tmp_path / "a.json")))


@pytest.mark.parametrize("way", ["another", "measured"])
def test_a_late_sound_is_over_with_another_output(window, says, monkeypatch, way):
    from dataclasses import replace

    now = window.player.snapshot()
    playing = [replace(now, sound_output="AirPods", reported_latency_s=0.3)]
    monkeypatch.setattr(window.player, "snapshot", lambda: playing[0])
    window.extras.latency_monitor.look(window.clock.now_s() + 2.0)
    ends = {
        "another": lambda: playing.__setitem__(0, now),
        "measured": lambda: keep_latency(window.settings, SOUND, "AirPods", 200.0),
    }
    says("AirPods reports a latency", ends[way])


def test_a_clash_of_outputs_is_over_with_other_outputs(window, says):
    window.session.choose_outputs(["simulated", "simulated"])
    says("appears twice", lambda: window.player.set_outputs(["simulated"]))


def test_a_page_that_fails_to_open_a_device_is_over_with_it(window, says):
    problem = InputError("no device here", remedy="connect it")
    window.session.report_outputs(problem)
    says("no device here", lambda: window.player.set_outputs(["simulated"]))


def test_a_fault_of_this_program_stays_until_it_is_closed(window, capsys):
    window.session.gateway.report(ValueError("a fault of ours"))
    QTest.qWait(300)
    assert "a fault of ours" in window.messages.text()
    assert "Help > Report a problem" in window.messages.text()
    window.messages.close_button.click()
    assert window.messages.text() == ""
    assert "ValueError" in capsys.readouterr().err


def test_a_refusal_without_an_end_stays(window):
    window.session.report(HapticPlayerError("said once"))
    QTest.qWait(300)
    assert window.messages.text() == "said once"


# --- Escape closes what is open and stops the force, and says so ---------------


@pytest.mark.parametrize("opened", ["shortcuts", "library", "menu", "list"])
def test_escape_that_closes_something_says_that_the_force_is_off(
    window, wait_for, opened
):
    window.activateWindow()
    wait_for(window.isActiveWindow)
    if opened == "menu":
        window.commands.menus["playback"].popup(window.pos())
    elif opened == "list":
        window.transport.device.showPopup()
    else:
        window.commands.by_name[opened].trigger()
    popup = QApplication.activePopupWidget()
    dialogs = [one for one in window.findChildren(QDialog) if one.isVisible()]
    found = popup or dialogs[0]
    found.activateWindow()
    wait_for(lambda: QGuiApplication.focusWindow() is found.window().windowHandle())
    QTest.keyClick(found.window().windowHandle(), Qt.Key.Key_Escape)
    wait_for(lambda: not (isValid(found) and found.isVisible()))
    assert window.session.is_stopped
    assert window.extras.toast.text() == "Force stopped. Ctrl+R re-arms it."
    wait_for(lambda: window.transport.stop.text() == "Re-arm")


# --- a device without a grip ----------------------------------------------------


@needs("shakers", "toys", "wheels")
@pytest.mark.parametrize("name", ["shaker", "rumble", "buttplug", "tcode:/dev/null"])
def test_a_device_without_a_grip_shows_none(window, wait_for, name):
    shown = grip_of(Snapshot(outputs=(OutputSnapshot(name, Health.READY),)), None)
    assert shown.state == "This device has no grip"
    assert shown.position_m is None
