import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from scipy.signal import resample_poly

from app.experimenter.sync_dialog import SyncDialog
from app.experimenter.sync_strip import SyncStrip, columns, tick_step_s
from app.player.import_dialog import ImportDialog
from hapticplayer.capture import write_imu_csv
from hapticplayer.capture.sync.clips import simulate_pats
from hapticplayer.media import write_clip

SECONDS = 20


@pytest.fixture(scope="module")
def ride(tmp_path_factory):
    """A clip with pats, its log, a stranger's log, and the truth."""
    folder = tmp_path_factory.mktemp("pats")
    made = simulate_pats(41_001, hard=False, rate_hz=200, duration_s=SECONDS)
    other = simulate_pats(41_002, hard=False, rate_hz=200, duration_s=SECONDS)
    grey = (np.full((36, 64, 3), k % 250, np.uint8) for k in range(30 * SECONDS))
    sound = resample_poly(made.audio, 3, 1).astype(np.float32)[:, None]
    write_clip(folder / "ride.mp4", grey, frame_rate_hz=30, audio=sound)
    write_imu_csv(folder / "log.csv", made.imu)
    write_imu_csv(folder / "other.csv", other.imu)
    return folder, made


@pytest.fixture
def open_dialog(application, qtbot, ride):
    def opened(log):
        dialog = SyncDialog(ride[0] / "ride.mp4", ride[0] / log)
        qtbot.addWidget(dialog)
        dialog.show()
        return dialog

    return opened


def expected_s(made):
    log_s = (made.pats_s[1] - made.clock_map.offset_s) / made.clock_map.rate
    return made.pats_s[1] - log_s


def test_the_proposed_offset_is_shown_and_can_be_moved_by_keys(
    open_dialog, qtbot, ride, wait_for
):
    dialog = open_dialog("log.csv")
    assert not dialog.take.isEnabled()
    wait_for(dialog.take.isEnabled)
    assert "were found" in dialog.verdict.text()
    first_s = dialog.offset.value()
    assert first_s == pytest.approx(expected_s(ride[1]), abs=0.005)
    qtbot.keyClick(dialog.strip, Qt.Key.Key_Right)
    qtbot.keyClick(dialog.strip, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert dialog.offset.value() == pytest.approx(first_s - 0.009, abs=1e-6)
    with qtbot.waitSignal(dialog.chosen) as chosen:
        dialog.take.click()
    assert chosen.args == [dialog.offset.value()]


def test_doubt_is_told_and_the_offset_is_left_to_the_person(open_dialog, wait_for):
    dialog = open_dialog("other.csv")
    wait_for(dialog.take.isEnabled)
    assert "not certain" in dialog.verdict.text()


def test_a_log_that_cannot_be_read_is_told_in_the_dialog(open_dialog, wait_for):
    dialog = open_dialog("missing.csv")
    wait_for(lambda: "missing.csv" in dialog.verdict.text())
    assert not dialog.take.isEnabled()


def test_closing_while_it_looks_leaves_no_thread(open_dialog):
    dialog = open_dialog("log.csv")
    dialog.reject()
    assert not dialog._jobs.is_busy


def test_dragging_moves_the_log_by_what_the_pointer_moves(application, qtbot):
    strip = SyncStrip()
    qtbot.addWidget(strip)
    strip.resize(1000, 200)
    times = np.arange(0.0, 10.0, 0.001)
    strip.show_streams((times, times), (times, times), (1.0, 1.5, 2.0), 0.25)
    assert strip.view_s == pytest.approx((0.0, 9.999))
    moved = []
    strip.shifted.connect(moved.append)
    qtbot.mousePress(strip, Qt.MouseButton.LeftButton, pos=QPoint(500, 150))
    qtbot.mouseMove(strip, QPoint(530, 150))
    if not moved:  # a platform without a pointer sends no moves
        from PySide6.QtCore import QEvent, QPointF
        from PySide6.QtGui import QMouseEvent

        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(530, 150),
            QPointF(530, 150),
            Qt.MouseButton.NoButton,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
        strip.mouseMoveEvent(event)
    assert moved[-1] == pytest.approx(0.25 + 30 * 9.999 / 1000, abs=0.001)
    strip.show_pats()
    assert strip.view_s == pytest.approx((0.6, 2.6))


def test_no_peak_is_lost_when_many_samples_share_a_column():
    times = np.arange(100_000) / 1000.0
    values = np.zeros(100_000)
    values[54_321] = 7.0
    x, y = columns((times, values), (0.0, 100.0), 500)
    assert len(x) <= 501
    assert y.max() == 7.0
    assert x[y.argmax()] == np.floor(54.321 / 100 * 500)


@pytest.mark.parametrize(
    ("least", "step"), [(0.3, 0.5), (1.0, 1.0), (1.2, 2.0), (7, 10)]
)
def test_ticks_are_round_numbers(least, step):
    assert tick_step_s(least) == pytest.approx(step)


def test_without_an_offset_the_import_asks_for_the_pats(application, qtbot, ride):
    folder, _ = ride
    dialog = ImportDialog(str(folder))
    qtbot.addWidget(dialog)
    dialog.video.setText(str(folder / "ride.mp4"))
    assert not dialog.look.isEnabled()
    dialog.imu_log.setText(str(folder / "log.csv"))
    assert dialog.look.isEnabled()
    assert dialog.request().offset_s is None
    assert dialog.offset.text() == "by three pats"
    dialog.offset.setValue(1.25)
    assert dialog.request().offset_s == 1.25
