"""The real window with a real player; a device only where force matters."""

import os
import signal
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel

from app.bridge import languages
from app.experimenter.import_wizard import ImportWizard
from app.player.empty_page import EmptyPage
from app.player.remake import apply_appearance
from app.player.window import LEAST_VIDEO_PX
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.playback.phases import Phase


def key(window, code, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    """Press a key as the window system would."""
    QTest.keyClick(window.windowHandle(), code, modifier)


def test_work_that_fails_at_once_leaves_nothing_switched_off(
    window, tmp_path, wait_for
):
    wait_for(window.commands.open_sequence.isEnabled)
    window.session.open_path(tmp_path / "no such ride.mp4")
    for thread in threading.enumerate():
        if thread.name == "job":
            thread.join()  # before the window looks again
    assert not window.commands.open_sequence.isEnabled()
    wait_for(lambda: "no such ride" in window.messages.text())
    wait_for(window.commands.open_sequence.isEnabled)


def test_all_that_can_be_shown_fits_a_screen_of_960_by_540(window, source, qtbot):
    """A usual screen at 200 %: the line at the bottom stays on it."""
    window.commands.plots.setChecked(True)
    window.plots.prepare()
    window.messages.show_text("The device is gone")
    qtbot.wait(20)
    assert window.minimumSizeHint().height() <= 540
    window.resize(960, 540)
    qtbot.wait(20)
    page = window.empty_page
    assert page.height() >= page.minimumSizeHint().height()
    window.session.show_source(source)
    window.commands.sync_plot.setChecked(True)
    qtbot.wait(20)
    window.resize(960, 540)
    qtbot.wait(20)
    assert window.height() <= 540
    assert window.stage.height() >= LEAST_VIDEO_PX


@pytest.mark.parametrize("code", languages.NAMES)
def test_the_first_page_with_a_long_message_fits_it_too(
    make_window, settings, application, qtbot, code
):
    """Neither may the window grow beyond the screen, nor stay large afterwards."""
    settings.keep("language", code)
    apply_appearance(application, settings)
    try:
        window = make_window()
        window.resize(960, 540)
        window.messages.show_text("/material/ride.mp4: " + 12 * "damaged, " + "copy it")
        qtbot.wait(20)
        assert window.messages.height() > 1.3 * window.messages.copy.height()
        assert window.minimumSizeHint().height() <= 540
        assert window.height() == 540
    finally:
        settings.keep("language", languages.ENGLISH)
        apply_appearance(application, settings)


@pytest.mark.parametrize("width_px", [620, 900, 1500])
def test_no_line_of_the_first_page_is_cut_off(application, qtbot, width_px):
    page = EmptyPage()
    qtbot.addWidget(page)
    page.resize(width_px, 400)
    page.show()
    page.resize(width_px, page.minimumSizeHint().height())
    qtbot.wait(20)
    lines = [label for label in page.findChildren(QLabel) if label.wordWrap()]
    assert len(lines) == 2
    for label in lines:
        assert label.height() >= label.heightForWidth(label.width())


def test_a_new_window_has_no_clip_open(window):
    titles = [action.text() for action in window.menuBar().actions()]
    menus = ("File", "Edit", "Playback", "View", "Device", "Study", "Help")
    assert titles == [f"&{name}" for name in menus]
    assert window.stage.currentWidget() is window.empty_page
    assert window.player.snapshot().phase is Phase.EMPTY
    assert not window.transport.play.isEnabled()
    assert not window.commands.fullscreen.isEnabled()
    assert window.windowTitle() == "hapticplayer"
    devices = window.transport.device
    assert devices.model().item(devices.findData("falcon")).isEnabled()
    assert devices.findData("falcon-simulated") < 0  # for developers


def test_a_sequence_that_is_opened_plays(window, sequence, wait_for):
    window.session.open_path(sequence)
    wait_for(lambda: window.player.snapshot().frames_shown > 3)
    assert window.stage.currentWidget() is window.surface
    assert window.player.snapshot().phase is Phase.PLAYING
    assert window.transport.feedback.currentData() == "realistic"
    assert not window.surface.grab().toImage().isNull()


def mime_of(paths) -> QMimeData:
    content = QMimeData()
    content.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return content


def offered(content, actions=Qt.DropAction.CopyAction | Qt.DropAction.MoveAction):
    """A drag from where the files may also be moved, which is proposed."""
    keys = Qt.KeyboardModifier.ShiftModifier
    return actions, content, Qt.MouseButton.LeftButton, keys


def test_a_source_that_only_moves_files_is_refused(window, clip):
    files = mime_of([clip])
    enters = QDragEnterEvent(QPoint(9, 9), *offered(files, Qt.DropAction.MoveAction))
    QApplication.sendEvent(window, enters)
    assert not enters.isAccepted()
    assert not window.drops.frame.isVisible()


def test_a_video_that_is_dropped_plays_without_force(window, clip, wait_for):
    files = mime_of([clip])
    enters = QDragEnterEvent(QPoint(9, 9), *offered(files))
    QApplication.sendEvent(window, enters)
    assert enters.isAccepted()
    assert enters.dropAction() == Qt.DropAction.CopyAction
    assert window.drops.frame.isVisible()
    drops = QDropEvent(QPointF(9, 9), *offered(files))
    QApplication.sendEvent(window, drops)
    assert drops.dropAction() == Qt.DropAction.CopyAction
    assert not window.drops.frame.isVisible()
    wait_for(lambda: window.player.snapshot().phase is Phase.PLAYING)
    assert window.transport.feedback.currentData() == "none"


def test_frames_have_the_size_of_their_place(playing, wait_for):
    surface = playing.surface
    wait_for(lambda: surface.frame is not None)
    assert (surface.image.width(), surface.image.height()) == surface.target[2:]


def test_space_pauses_and_plays(playing, wait_for):
    key(playing, Qt.Key.Key_Space)
    wait_for(lambda: playing.player.snapshot().phase is Phase.PAUSED)
    wait_for(lambda: playing.transport.play.accessibleName() == "Play")
    key(playing, Qt.Key.Key_Space)
    wait_for(lambda: playing.player.snapshot().phase is Phase.PLAYING)
    wait_for(lambda: playing.transport.play.accessibleName() == "Pause")


def test_the_arrows_and_home_and_end_seek(playing, wait_for):
    playing.player.pause()
    key(playing, Qt.Key.Key_End)
    assert (
        playing.player.snapshot().media_s
        == playing.player.snapshot().source.clip.duration_s
    )
    key(playing, Qt.Key.Key_Left)
    assert playing.player.snapshot().media_s == 0.0  # the clip is shorter than a step
    key(playing, Qt.Key.Key_Right)
    assert (
        playing.player.snapshot().media_s
        == playing.player.snapshot().source.clip.duration_s
    )
    key(playing, Qt.Key.Key_Home)
    assert playing.player.snapshot().media_s == 0.0
    wait_for(lambda: playing.transport.slider.value() == 0)


def test_a_click_on_the_slider_jumps_there(playing, wait_for, qtbot):
    playing.player.pause()
    slider = playing.transport.slider
    middle = slider.rect().center()
    qtbot.mouseClick(slider, Qt.MouseButton.LeftButton, pos=middle)
    half_s = playing.player.snapshot().source.clip.duration_s / 2
    assert playing.player.snapshot().media_s == pytest.approx(half_s, abs=0.02)


def test_the_slider_and_the_time_follow_the_clip(playing, wait_for):
    wait_for(lambda: playing.transport.slider.value() > 300)
    assert playing.transport.time.text().startswith("00:0")
    assert playing.transport.time.text().endswith("/ 00:02.0")


def test_the_clip_ends_and_can_be_played_again(playing, wait_for):
    playing.player.seek(1.6)
    wait_for(lambda: playing.player.snapshot().phase is Phase.ENDED)
    wait_for(lambda: playing.transport.play.accessibleName() == "Play")
    playing.transport.play.click()
    wait_for(lambda: playing.player.snapshot().phase is Phase.PLAYING)
    assert (
        playing.player.snapshot().media_s
        < playing.player.snapshot().source.clip.duration_s
    )


def test_a_missing_file_is_told_and_what_was_open_stays(playing, wait_for, tmp_path):
    before = playing.player.snapshot().source
    playing.session.open_path(tmp_path / "missing.mp4")
    wait_for(lambda: "missing.mp4" in playing.messages.text())
    assert playing.player.snapshot().source is before
    assert playing.player.snapshot().phase in (Phase.PLAYING, Phase.ENDED)


def test_a_broken_file_is_told_and_the_next_good_one_clears_it(
    window, sequence, wait_for, tmp_path
):
    broken = tmp_path / "broken.mp4"
    broken.write_bytes(b"no video at all" * 100)
    window.session.open_path(broken)
    wait_for(lambda: "broken.mp4" in window.messages.text())
    assert window.stage.currentWidget() is window.empty_page
    window.session.open_path(sequence)
    wait_for(lambda: window.player.snapshot().phase is Phase.PLAYING)
    assert not window.messages.text()


def test_a_long_name_does_not_widen_the_window(playing, wait_for, tmp_path):
    wide = playing.width()
    playing.session.open_path(tmp_path / ("very-long-" * 20) / "name.mp4")
    wait_for(playing.messages.isVisible)
    assert playing.minimumSizeHint().width() < 780
    assert playing.width() == wide
    assert len(playing.windowTitle()) < 150


def test_a_fault_in_a_slot_halts_and_is_told(playing, capsys):
    playing.session.gateway.report(ValueError("a fault of ours"))
    assert playing.player.snapshot().phase is Phase.PAUSED
    assert "a fault of ours" in playing.messages.text()
    assert "ValueError" in capsys.readouterr().err


def test_the_plots_hide_and_show(playing, wait_for):
    wait_for(lambda: playing.plots.panel is not None)
    key(playing, Qt.Key.Key_P)
    assert playing.plots.isHidden()
    assert not playing.commands.plots.isChecked()
    key(playing, Qt.Key.Key_P)
    assert playing.plots.isVisible()


def test_every_control_has_a_name_and_a_tooltip(playing):
    transport = playing.transport
    for control in (
        transport.play,
        transport.stop,
        transport.slider,
        transport.feedback,
        transport.device,
        transport.fullscreen,
    ):
        assert control.accessibleName(), control
        assert control.toolTip(), control
        assert control.focusPolicy() & Qt.FocusPolicy.TabFocus, control


def test_space_on_a_focused_button_presses_it(playing, wait_for):
    playing.activateWindow()
    playing.transport.stop.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyClick(playing.transport.stop, Qt.Key.Key_Space)
    wait_for(lambda: playing.player.snapshot().phase is Phase.PAUSED)


def test_a_missing_falcon_leaves_the_window_without_a_device(window, wait_for):
    window.session.choose_leading("falcon:NOWHERE0")  # nobody has one of that number
    wait_for(lambda: "Falcon" in window.messages.text())
    assert not window.player.snapshot().leading.tick


@pytest.mark.realtime
def test_stop_trips_and_rearm_lets_the_force_back(
    make_window, long_source, wait_for, feel
):
    window = make_window("simulated")
    window.session.show_source(long_source)
    feel(window)
    window.transport.stop.click()
    wait_for(lambda: window.session.is_stopped)
    wait_for(lambda: window.transport.stop.text() == "Re-arm")
    assert window.player.snapshot().phase is Phase.PAUSED
    wait_for(lambda: not window.player.snapshot().leading.tick["force_n"].any())
    wait_for(lambda: "STOPPED" in window.health.entries[0].text())
    window.transport.stop.click()
    wait_for(lambda: not window.session.is_stopped)
    wait_for(lambda: window.transport.stop.text() == "STOP")
    feel(window)


def test_escape_stops_also_while_a_dialog_is_open(make_window, source, wait_for):
    window = make_window("simulated")
    window.session.show_source(source)
    window.dialogs.import_recording()
    dialog = window.findChild(ImportWizard)
    wait_for(lambda: window.player.snapshot().leading.tick is not None)
    key(dialog, Qt.Key.Key_Escape)
    wait_for(lambda: window.session.is_stopped)
    assert not any(w.isVisible() for w in window.findChildren(ImportWizard))


def test_changing_feedback_and_device_while_it_plays(
    make_window, long_source, wait_for, feel
):
    window = make_window("simulated")
    window.session.show_source(long_source)
    feel(window)
    window.transport.feedback_chosen.emit("none")
    assert window.player.snapshot().feedback == "none"
    first = window.player.snapshot().leading.loop_pid
    window.transport.device_chosen.emit("none")
    assert window.player.snapshot().leading.loop_pid is None
    wait_for(lambda: not is_alive(first))  # it ends beside the window
    wait_for(lambda: window.health.entries[0].text() == "none")


def is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def test_a_device_is_let_go_of_without_holding_the_window_up(
    make_window, source, wait_for, monkeypatch
):
    may_end = threading.Event()
    close = HapticsProcesses.close

    def close_slowly(link) -> None:
        if link.device == "simulated":
            assert threading.current_thread() is not threading.main_thread()
            may_end.wait(20)
        close(link)

    window = make_window("simulated")
    window.session.show_source(source)
    wait_for(lambda: window.player.snapshot().leading.health == "ready")
    first = window.player.snapshot().leading.loop_pid
    monkeypatch.setattr(HapticsProcesses, "close", close_slowly)
    window.transport.device_chosen.emit("none")
    # back already, although the old device is still being closed
    assert window.player.snapshot().leading.name == "none"
    assert is_alive(first)
    window.player.wait_released()  # nothing that only one process can have
    may_end.set()
    wait_for(lambda: not is_alive(first))


@pytest.mark.realtime
def test_a_dead_haptics_process_is_shown_and_can_be_restarted(
    make_window, source, wait_for
):
    window = make_window("simulated")
    window.session.show_source(source)
    wait_for(lambda: window.player.snapshot().leading.tick is not None)
    os.kill(window.player.snapshot().leading.loop_pid, signal.SIGKILL)
    wait_for(lambda: "choose the device again" in window.messages.text())
    wait_for(lambda: "gone" in window.health.entries[0].text())
    window.transport.device_chosen.emit("simulated")
    wait_for(lambda: window.player.snapshot().leading.tick is not None)
    assert window.player.snapshot().source is source


def test_a_second_piece_of_work_is_refused_while_one_runs(window, sequence, wait_for):
    is_enough = threading.Event()

    def work(progress) -> None:
        while not is_enough.wait(0.01):
            progress(0.0, "")

    window.session.jobs.run("slow", work, lambda _: None)
    wait_for(lambda: not window.commands.open_video.isEnabled())
    assert not window.empty_page.demo.isEnabled()
    window.session.open_path(sequence)
    assert "wait for it" in window.messages.text()
    is_enough.set()
    wait_for(window.commands.open_video.isEnabled)
    assert window.player.snapshot().source is None


def test_hidden_plots_are_not_drawn(playing, wait_for, monkeypatch):
    drawn = []
    follow = playing.plots.follow

    def count(*arguments) -> None:
        drawn.append(1)
        follow(*arguments)

    monkeypatch.setattr(playing.plots, "follow", count)
    wait_for(lambda: len(drawn) > 2)
    playing.show_plots(are_wanted=False)
    drawn.clear()
    shown = playing.player.snapshot().frames_shown
    wait_for(lambda: playing.player.snapshot().frames_shown > shown + 5)
    assert not drawn


def programs_we_started() -> set[str]:
    """Return the command lines of our children; Python's own helper stays on purpose."""
    pids = {
        pid
        for task in Path("/proc/self/task").iterdir()
        for pid in (task / "children").read_text().split()
    }
    lines = {pid: Path(f"/proc/{pid}/cmdline").read_bytes().decode() for pid in pids}
    return {f"{pid} {line}" for pid, line in lines.items() if "tracker" not in line}


@pytest.mark.realtime
def test_closing_leaves_nothing_running(make_window, long_source, feel):
    before = programs_we_started()
    window = make_window("simulated")
    window.session.show_source(long_source)
    feel(window)
    process = window.player.snapshot().leading.loop_pid
    assert len(programs_we_started() - before) >= 3  # loop, guard, simulated device
    window.close()
    assert programs_we_started() <= before
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)
    assert not [t for t in window.findChildren(QTimer) if t.isActive()]


def test_the_window_remembers_its_size(make_window, settings):
    first = make_window()
    first.resize(780, 640)  # fits the screen of the offscreen platform
    first.close()
    assert settings.text("geometry")
    assert make_window().size() == first.size()
