from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog

from app.player.import_dialog import ImportDialog
from hapticplayer.capture import write_imu_csv
from hapticplayer.playback.snapshot import Phase


@pytest.fixture
def dialog(application, qtbot, tmp_path) -> ImportDialog:
    made = ImportDialog(str(tmp_path))
    qtbot.addWidget(made)
    return made


def test_nothing_can_be_imported_at_first(dialog):
    assert not dialog.ok.isEnabled()
    assert dialog.problem.text() == ""


def test_a_video_suggests_the_folder_beside_it(dialog, clip):
    dialog.video.setText(str(clip))
    assert dialog.target.text() == str(clip.with_name("clip-sequence"))
    assert dialog.ok.isEnabled()
    request = dialog.request()
    assert request.video == clip
    assert request.imu_log is None
    assert request.offset_s is None


def test_a_folder_that_was_typed_is_not_replaced(dialog, clip):
    dialog.target.setText("/somewhere/else")
    dialog.video.setText(str(clip))
    assert dialog.target.text() == "/somewhere/else"


def test_what_exists_is_not_overwritten(dialog, clip, tmp_path):
    dialog.video.setText(str(clip))
    dialog.target.setText(str(tmp_path))
    assert not dialog.ok.isEnabled()
    assert "exists already" in dialog.problem.text()


def test_the_offset_belongs_to_a_log(dialog, clip, tmp_path):
    dialog.video.setText(str(clip))
    assert not dialog.offset.isEnabled()
    dialog.imu_log.setText(str(tmp_path / "missing.csv"))
    assert dialog.offset.isEnabled()
    assert "log does not exist" in dialog.problem.text()


def test_an_import_makes_a_sequence_and_plays_it(
    window, clip, still_log, tmp_path, wait_for
):
    log = tmp_path / "log.csv"
    write_imu_csv(log, still_log)
    window.dialogs.import_recording()
    dialog = window.findChild(ImportDialog)
    dialog.video.setText(str(clip))
    dialog.imu_log.setText(str(log))
    dialog.offset.setValue(-1.5)
    dialog.target.setText(str(tmp_path / "new"))
    dialog.ok.click()
    wait_for(lambda: window.player.phase is Phase.PLAYING)
    assert window.player.source.path == tmp_path / "new"
    assert window.player.source.motion.time_s[0] == pytest.approx(-1.5, abs=0.01)


def test_a_chosen_video_is_opened_and_its_folder_remembered(
    window, clip, settings, wait_for
):
    window.dialogs.open_video()
    dialog = window.findChild(QFileDialog)
    dialog.fileSelected.emit(str(clip))
    dialog.reject()
    wait_for(lambda: window.player.phase is Phase.PLAYING)
    assert settings.text("folder") == str(Path(clip).parent)


@pytest.mark.parametrize("name", ["shortcuts", "about"])
def test_help_opens_and_closes(window, name, qtbot):
    getattr(window.dialogs, name)()
    (dialog,) = [w for w in window.children() if hasattr(w, "accept")]
    assert dialog.isVisible()
    with qtbot.waitSignal(dialog.destroyed):
        dialog.accept()


@pytest.mark.parametrize("typed", ["/", "..", ".", "~", " "])
def test_a_path_on_its_way_to_a_name_is_no_error(dialog, typed):
    dialog.video.setText(typed)
    assert not dialog.ok.isEnabled()
