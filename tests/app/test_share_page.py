"""Sharing from the window, and another video than the force was made for."""

import threading

import pytest
from PySide6.QtWidgets import QMessageBox

from app.player import share_page
from app.player.dialogs import video_question
from app.player.share_page import SharePage
from hapticplayer.errors import HapticPlayerError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.matroska import read_attachments
from hapticplayer.media.remux import MATROSKA, Additions, remux
from hapticplayer.playback.source import open_source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.sequence.contents import MOTION_FILES
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import MANIFEST, read_packed


@pytest.fixture
def page(application, qtbot, sequence, tmp_path, wait_for):
    made = SharePage(sequence, str(tmp_path), "A ride: 100 %")
    qtbot.addWidget(made)
    made.show()
    wait_for(made.save_button.isEnabled)
    yield made
    made.close_jobs()


def names(page):
    return [page.table.item(row, 1).text() for row in range(page.table.rowCount())]


def test_the_share_page_lists_its_files_with_sizes(page, sequence):
    assert page.table.item(0, 0).text() == "Video and sound"
    assert not {*MOTION_FILES} & {*names(page)}
    small = page.table.item(page.table.rowCount() - 1, 2).text()
    page.with_motion.setChecked(True)
    assert {"motion.npz", "imu.npz"} <= {*names(page)}
    assert page.table.item(page.table.rowCount() - 1, 2).text() != small
    whole = sum(part.size_bytes for part in page.parts())
    files = [path for path in sequence.iterdir() if path.name != "sequence.json"]
    size_bytes = sum(path.stat().st_size for path in files)
    assert whole == pytest.approx(size_bytes, abs=20_000)  # the description


def test_the_share_page_says_what_is_left_out_of_names(page):
    """In a column of its own: the text of a row may be cut off."""

    def told(value):
        row = names(page).index(value)
        return [page.table.item(row, column).text() for column in (0, 2)]

    named = next(name for name in names(page) if name.startswith("20"))
    assert told(named) == ["Date", "left out"]
    page.with_places.setChecked(True)
    assert told(named) == ["Date", "included"]


@pytest.mark.parametrize("is_mp4", [False, True])
def test_the_share_page_writes_and_says_so(page, tmp_path, qtbot, is_mp4):
    page.two_files.setChecked(is_mp4)
    target = tmp_path / f"ride{page.wanted.ending}"
    with qtbot.waitSignal(page.shared) as shared:
        page.write(target)
    assert shared.args == [target]
    assert read_packed(target).sequence.motion is None
    assert page.status.text().startswith(f"Saved: {target.name}")
    assert ("ride.haptics.mkv" in page.status.text()) is is_mp4


def test_a_failure_is_said_and_another_name_helps(page, tmp_path, wait_for):
    (tmp_path / "film.mkv").write_bytes(b"somebody's film")
    page.write(tmp_path / "film.mkv")
    wait_for(lambda: "not such a file" in page.status.text())
    assert (tmp_path / "film.mkv").read_bytes() == b"somebody's film"
    page.write(tmp_path / "other.mkv")
    wait_for((tmp_path / "other.mkv").exists)


def test_cancel_leaves_nothing(page, tmp_path, wait_for, monkeypatch):
    is_cancelled = threading.Event()

    def slow(*_arguments, progress, **_options):
        is_cancelled.wait(30.0)
        progress(0.5, "copying the clip")

    monkeypatch.setattr(share_page, "in_child", slow)
    page.write(tmp_path / "ride.mkv")
    page.progress.stop.click()
    is_cancelled.set()
    wait_for(lambda: not page.progress.isVisible())
    assert page.save_button.isEnabled()
    assert not (tmp_path / "ride.mkv").exists()


def test_the_menu_shares_a_sequence_and_nothing_else(window, source, clip, monkeypatch):
    said = []
    monkeypatch.setattr(
        window.session.gateway, "report", lambda one, _over: said.append(one)
    )
    assert not window.commands.share.isEnabled()
    window.session.show_source(source)
    window.session.watch()
    assert window.commands.share.isEnabled()
    window.commands.share.trigger()
    assert window.findChild(SharePage) is not None
    window.dialogs.close()
    window.session.show_source(open_source(clip))
    said.clear()
    window.dialogs.share()
    (problem,) = said
    assert isinstance(problem, HapticPlayerError)
    assert "import the video first" in str(problem)


# --- what others have shared ------------------------------------------------------------


@pytest.fixture
def changed_file(sequence, tmp_path):
    """The force of the sequence, with a video of which one byte is another."""
    pack(sequence, tmp_path / "ride.mkv")
    content = bytearray((sequence / "clip.mp4").read_bytes())
    content[content.index(b"mdat") + 900] ^= 1
    (tmp_path / "changed.mp4").write_bytes(content)
    attached = tuple(read_attachments(tmp_path / "ride.mkv", MANIFEST))
    remux(
        tmp_path / "changed.mp4",
        tmp_path / "changed.mkv",
        MATROSKA,
        Additions(attached),
    )
    return tmp_path / "changed.mkv"


def test_a_shared_file_opens_with_its_feedbacks(
    window, sequence, tmp_path, wait_for, source
):
    pack(sequence, tmp_path / "ride.mkv")
    window.session.open_path(tmp_path / "ride.mkv")
    wait_for(lambda: window.player.snapshot().media_s > 0.1)
    now = window.player.snapshot()
    assert list(now.source.tracks) == list(source.tracks)
    assert now.source.check.wait() is Verdict.SAME
    assert window.findChild(QMessageBox) is None


@pytest.mark.parametrize("is_felt", [False, True])
def test_another_video_is_asked_about_once(window, changed_file, wait_for, is_felt):
    window.session.open_path(changed_file)
    wait_for(lambda: window.findChild(QMessageBox) is not None)
    box, check = window.findChild(QMessageBox), window.player.snapshot().source.check
    assert "This is not the video" in box.text()
    assert not check.allows_force
    role = QMessageBox.ButtonRole
    wanted = role.AcceptRole if is_felt else role.RejectRole
    (button,) = [one for one in box.buttons() if box.buttonRole(one) is wanted]
    button.click()
    assert check.allows_force is is_felt
    wait_for(lambda: window.findChild(QMessageBox) is None)
    window.session.watch()
    assert window.findChild(QMessageBox) is None


def test_escape_plays_without_force(application, qtbot, changed_file):
    source = open_source(changed_file)
    box = video_question(source, None)
    qtbot.addWidget(box)
    assert box.escapeButton() is box.defaultButton()
    assert box.buttonRole(box.escapeButton()) is QMessageBox.ButtonRole.RejectRole
    assert source.check.wait() is Verdict.ANOTHER
    assert probe(changed_file).duration_s > 0.0
