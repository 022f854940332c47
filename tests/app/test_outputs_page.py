"""More devices in the window: added, muted, tested, removed, and stopped by Escape."""

import contextlib

import face_checks
import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.bridge.languages import translated
from app.bridge.settings import (
    OUTPUTS,
    KeptOutput,
    Settings,
    default_path,
    outputs_of,
)
from app.player import application as program
from app.player.device_form import output_text
from app.player.outputs_page import OutputsPage, state_text
from app.player.window import PlayerWindow
from hapticplayer import cli
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import RigTrack
from hapticplayer.playback import device_test
from hapticplayer.playback.latency import LatencySource
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.snapshot import OutputSnapshot
from hapticplayer.rendering.rig import RigStep
from tests.needed_extras import needs


@pytest.fixture
def receiver():
    from hapticplayer.extras.rigs.receiver import PacketReceiver

    with contextlib.closing(PacketReceiver(SystemClock(), [0])) as made:
        yield made


@pytest.fixture
def page(window):
    window.commands.outputs.trigger()
    return window.findChild(OutputsPage)


def playing_on(window):
    return {one.name: one for one in window.player.snapshot().outputs}


def add_rig(page, receiver):
    (port,) = receiver.rigs
    page.kind.setCurrentIndex(page.kind.findData("rig:outsim"))
    page.address.setText(f"127.0.0.1:{port}")
    page.add()
    return f"rig:outsim,127.0.0.1:{port}"


def test_a_rig_is_added_with_a_small_gain_and_removed(window, page, receiver, wait_for):
    name = add_rig(page, receiver)
    wait_for(lambda: playing_on(window)[name].health is Health.READY)
    assert playing_on(window)[name].gain == 0.25
    page.look()
    assert page.rows[name].state.text() == "at rest"
    page.add()
    assert page.problem.text() == "This device is already in use"
    page.remove(name)
    assert playing_on(window) == {}
    assert page.rows == {}
    assert "press Add" in page.list_end.text()


@needs("rigs", "shakers")
def test_an_unreachable_or_forbidden_address_is_named(window, page):
    page.kind.setCurrentIndex(page.kind.findData("rig:beamng"))
    page.address.setText("here")
    page.add()
    assert "use outsim, codemasters, beamng, HOST:PORT" in page.problem.text()
    assert playing_on(window) == {}


def test_muting_is_seen_by_the_player(window, page, receiver):
    name = add_rig(page, receiver)
    QTest.mouseClick(page.rows[name].mute, Qt.MouseButton.LeftButton)
    assert playing_on(window)[name].is_muted == page.rows[name].mute.isChecked()
    page.mute(name, is_muted=True)
    assert playing_on(window)[name].is_muted
    page.mute(name, is_muted=False)
    assert not playing_on(window)[name].is_muted


@pytest.fixture
def short_test(monkeypatch):
    """A rig is tested for 1.5 s, upwards."""
    motion = np.zeros((150, 15))
    motion[60:90, 2] = 2.0
    track = RigTrack(np.arange(0.0, 1.5, 0.01), motion)
    steps = (RigStep(0.5, 1.0, "heave"),)
    monkeypatch.setattr(device_test, "rig_demonstration", lambda: (track, steps))


def begin_test(page, name, wait_for):
    """Agree to the test of an output, and wait until it moves."""
    page.rows[name].test.click()
    assert not page.panel.is_running
    assert "Esc or STOP ends it" in page.panel.question.text.text()
    page.panel.question.yes.click()
    wait_for(lambda: page.panel.test is not None and page.panel.test.done_s > 0.0)


def test_a_test_moves_the_rig_and_leaves_it_in_neutral(
    window, page, receiver, wait_for, short_test
):
    name = add_rig(page, receiver)
    wait_for(lambda: playing_on(window)[name].health is Health.READY)
    page.look()
    begin_test(page, name, wait_for)
    page.look()
    assert page.panel.isVisible()
    assert page.focusWidget() is page.stop_button
    assert page.rows[name].state.text() == "in test, or being set up"
    assert not page.rows[name].test.isEnabled()
    heights = []

    def is_over():
        heights.append(page.panel.picture.shown.pose.up_m)
        return not page.panel.is_running

    wait_for(is_over)
    assert max(heights) > 0.01  # the picture has moved
    assert page.problem.text() == "Test finished."
    assert not page.panel.isVisible()
    list(receiver.listen(0.0))
    (report,) = receiver.report().values()
    assert report["peak_mps2"] > 0.1
    assert report["is_neutral"]
    wait_for(lambda: playing_on(window)[name].health is Health.READY)
    assert list(playing_on(window)) == [name]


def test_a_person_may_decline(window, page, receiver, wait_for):
    name = add_rig(page, receiver)
    wait_for(lambda: playing_on(window)[name].health is Health.READY)
    page.look()
    page.rows[name].test.click()
    page.panel.question.no.click()
    assert not page.panel.is_running
    assert playing_on(window)[name].health is Health.READY


def test_escape_stops_a_test_and_everything_else(window, page, wait_for):
    name = "simulated"
    window.player.set_outputs([name])
    wait_for(lambda: playing_on(window)[name].health is Health.READY)
    page.look()
    begin_test(page, name, wait_for)
    player = page.panel.test.player
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert player.health is Health.GONE
    wait_for(lambda: playing_on(window)[name].mode is Mode.TRIPPED)
    assert window.session.is_stopped
    window.session.rearm()
    wait_for(lambda: playing_on(window)[name].mode is Mode.IDLE)


@needs("rigs")
def test_names_and_states_are_words():
    assert output_text("rig:beamng,gain=0.5") == "Motion rig: BeamNG, gain=0.5"
    assert output_text("simulated") == "Simulated"
    assumed = LatencySource.ASSUMED
    values = ("", "realistic", False, 1.0, 0.0, assumed, Mode.FOLLOWING, Cause.NONE, 1)
    playing = OutputSnapshot("rig", Health.READY, "", *values)
    assert state_text(playing) == "active"
    lost = OutputSnapshot("rig", Health.FAILED, "the network is down", *values)
    assert state_text(lost) == "the network is down"
    assert state_text(OutputSnapshot("rig", Health.STARTING, "", *values)) == "starting"


def choose(page, kind, text=""):
    page.kind.setCurrentIndex(page.kind.findData(kind))
    page.address.setText(text)


@needs("shakers", "toys")
def test_any_kind_takes_the_settings_that_it_has(window, page):
    choose(page, "simulated")
    assert not page.address.isEnabled()
    choose(page, "shaker", "pulse,channels=3+9")
    page.add()
    assert "shaker option 'channels=3+9': channel must be" in page.problem.text()
    choose(page, "tcode", "127.0.0.1:1")
    page.add()
    assert list(playing_on(window)) == ["tcode:127.0.0.1:1"]
    latency = page.rows["tcode:127.0.0.1:1"].latency
    assert latency.text() == "\u2248\u200930\u00a0ms"
    assert "typical value" in latency.toolTip()
    choose(page, "falcon", "1\u200b2")
    page.add()
    assert page.problem.text() == "Settings may contain letters, digits and punctuation"


@needs("wheels")
def test_the_problem_of_an_output_is_read_whole(dressed, make_window, wait_for):
    dressed(language="de")
    window = make_window()
    window.commands.outputs.trigger()
    page, names = window.findChild(OutputsPage), ["wheel:event99,full=3", "rumble"]
    window.player.set_outputs([*names, "rig:outsim,rate=500,invert=sway+yaw+roll"])
    wait_for(lambda: all(playing_on(window)[name].problem for name in names))
    page.look()
    assert page.rows[names[0]].state.text() == translated(
        playing_on(window)[names[0]].problem
    )
    wait_for(
        lambda: not list(face_checks.cut_off(page))
    )  # once its rows have their places


@pytest.mark.realtime
@pytest.mark.parametrize("way", ["escape", "stop"])
def test_escape_and_stop_bring_device_and_output_to_rest(
    make_window, source, receiver, wait_for, way
):
    window = make_window("simulated")
    window.commands.outputs.trigger()
    page, player = window.findChild(OutputsPage), window.player
    name = add_rig(page, receiver)
    window.session.show_source(source)
    player.set_loop((0.0, 1.5))
    player.play()

    def modes():
        return {player.snapshot().leading.mode, playing_on(window)[name].mode}

    def are_felt():
        if Mode.TRIPPED in modes():  # by a busy machine
            player.rearm()
            player.play()
        return modes() == {Mode.FOLLOWING}

    wait_for(are_felt)
    if way == "escape":
        page.activateWindow()
        wait_for(page.isActiveWindow)
        QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    else:
        window.transport.stop_clicked.emit()
    wait_for(lambda: modes() == {Mode.TRIPPED})
    assert player.snapshot().phase is Phase.PAUSED


def enter(box, text):
    """Type a number into a box and press Enter."""
    box.setFocus()
    box.lineEdit().selectAll()
    QTest.keyClicks(box.lineEdit(), text)
    QTest.keyClick(box.lineEdit(), Qt.Key.Key_Return)


def test_gain_and_latency_are_changed_in_the_list(window, page, settings):
    """The same for every output, at once, and after the next start."""
    names = ["simulated", "falcon"]
    for name in names:
        choose(page, name)
        page.add()
        enter(page.rows[name].gain, "0.35")
        enter(page.rows[name].latency, "45")
        assert playing_on(window)[name].gain == 0.35
        assert playing_on(window)[name].latency_s == pytest.approx(0.045)
        assert playing_on(window)[name].latency_source is LatencySource.ENTERED
        page.kind.setFocus()
        page.look()
        assert page.rows[name].gain.value() == 0.35
        assert page.rows[name].latency.text() == "45\u00a0ms"
    assert outputs_of(settings) == dict.fromkeys(names, KeptOutput(gain=0.35))
    page.move_up("falcon")  # what is chosen stays with its output
    assert {one.gain for one in playing_on(window).values()} == {0.35}


@needs("rigs")
def test_a_latency_among_the_settings_is_not_changed_beside_them(window, page):
    window.player.set_outputs(["rig:outsim,latency_ms=40"])
    page.look()
    box = page.rows["rig:outsim,latency_ms=40"].latency
    assert not box.isEnabled()
    assert (box.value(), "in its settings" in box.toolTip()) == (40.0, True)


def test_the_wheel_over_a_gain_scrolls_the_page(window, page):
    choose(page, "simulated")
    page.add()
    box = page.rows["simulated"].gain
    middle = box.rect().center()
    turn = QWheelEvent(
        middle,
        box.mapToGlobal(middle),
        QPoint(0, 120),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    for has_focus in (False, True):
        box.setFocus() if has_focus else page.kind.setFocus()
        QApplication.sendEvent(box, turn)
        assert playing_on(window)["simulated"].gain == 1.0


def test_another_that_opens_the_device_has_its_gain(window, page, monkeypatch):
    choose(page, "simulated")
    page.add()
    page.set_gain("simulated", 0.5)
    assert window.release_devices() == ["simulated:gain=0.5"]
    window.take_back_devices()
    made = []
    monkeypatch.setattr(
        "app.player.device_dialogs.Player", lambda *_a, **k: made.append(k["outputs"])
    )
    window.dialogs.own_player(window.clock, None, "simulated")
    assert made == [["simulated:gain=0.5"]]


# --- what is remembered --------------------------------------------------------


def test_chosen_and_muted_outputs_are_kept(window, page, receiver, settings, tmp_path):
    name = add_rig(page, receiver)
    assert outputs_of(settings) == {name: KeptOutput(gain=0.25)}
    page.look()
    page.rows[name].mute.click()
    kept = outputs_of(Settings(tmp_path / "window.json"))
    assert kept == {name: KeptOutput(is_muted=True, gain=0.25)}
    page.remove(name)
    assert Settings(tmp_path / "window.json").table(OUTPUTS) == {}


@needs("toys")
def test_the_first_output_leads_and_the_order_is_kept(window, page, settings):
    names = ["simulated", "tcode:127.0.0.1:1"]
    choose(page, "simulated")
    page.add()
    choose(page, "tcode", "127.0.0.1:1")
    page.add()
    assert window.player.snapshot().leading.name == "simulated"
    page.move_up(names[1])
    assert window.player.snapshot().leading.name == names[1]
    assert list(outputs_of(settings)) == names[::-1]
    window.transport.device_chosen.emit("simulated")  # in the place of what leads
    assert list(playing_on(window)) == ["simulated"]
    assert outputs_of(settings) == {"simulated": KeptOutput(gain=1.0)}


@needs("rigs", "wheels")
def test_only_what_this_version_knows_is_taken_from_settings(settings):
    muted = {"muted": True, "gain": 0.5}
    kept = {"rig:outsim": muted, "teleporter": {}, "rig:x": {}, "wheel": 1}
    wrong = {"muted": "yes", "gain": 9}
    settings.keep(OUTPUTS, {**kept, "falcon:\0": {}, "rumble": wrong})
    assert outputs_of(settings) == {
        "rig:outsim": KeptOutput(is_muted=True, gain=0.5),
        "wheel": KeptOutput(),
        "rumble": KeptOutput(),
    }


def test_addresses_neither_leave_nor_come_with_settings(settings, tmp_path):
    settings.keep(OUTPUTS, {"rig:outsim,192.0.2.1:4123": {}})
    settings.save()
    settings.export(tmp_path / "out.json")
    assert "192.0.2.1" not in (tmp_path / "out.json").read_text()
    other = Settings(tmp_path / "other.json")
    (tmp_path / "in.json").write_text(
        '{"version": 1, "volume": 7, "outputs": {"rig:outsim,192.0.2.1:4123": {}}}'
    )
    other.take(tmp_path / "in.json")
    assert other.number("volume", 0) == 7
    assert outputs_of(other) == {"simulated": KeptOutput()}  # as at first


def test_the_window_begins_with_what_was_chosen(application, monkeypatch):
    kept = Settings(default_path())
    kept.keep(OUTPUTS, {"simulated": {"muted": True, "gain": 0.5}})
    kept.save()
    seen = []

    def look() -> None:
        for window in QApplication.topLevelWidgets():
            if isinstance(window, PlayerWindow) and not window.is_over:
                seen.extend(window.player.snapshot().outputs)
                window.close()

    timer = QTimer()
    timer.timeout.connect(look)
    timer.start(50)
    assert cli.main([], program.run) == 0
    timer.stop()
    assert [(one.device, one.is_muted) for one in seen] == [
        ("simulated:gain=0.5", True)
    ]


@needs("rigs")
def test_kept_outputs_that_clash_are_said_and_the_window_opens(window, settings):
    alike = {"rig:outsim": {}, "rig:outsim,gain=0.5": {}}
    settings.keep(OUTPUTS, alike)
    settings.save()
    program.restore_outputs(window, outputs_of(settings))
    assert "two outputs send outsim to 127.0.0.1:4123" in window.messages.text()
    assert playing_on(window) == {}
