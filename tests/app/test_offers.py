"""What the window offers for a clip without force, and what Esc closes."""

import dataclasses

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.experimenter.import_queue import QueuePage
from app.experimenter.import_wizard import ImportWizard
from app.player.guide import GuideWindow
from hapticplayer.playback.source import open_source


def choose(window, source):
    window.session.show_source(source)
    window.session.chosen.emit(source)


def test_a_clip_with_motion_offers_to_be_imported(window, clip, wait_for):
    plain = open_source(clip)
    holds = dataclasses.replace(plain.clip, has_telemetry=True)
    choose(window, dataclasses.replace(plain, clip=holds))
    assert "clip.mp4 contains motion data" in window.offer.text.text()
    window.offer.accept_button.click()
    wait_for(lambda: window.findChild(ImportWizard) is not None)
    wizard = window.findChild(ImportWizard)
    assert wizard.files.video.text() == str(clip)
    assert not window.offer.isVisible()
    wizard.reject()


def test_a_plain_clip_offers_a_log_or_an_estimate(window, clip):
    choose(window, open_source(clip))
    assert window.offer.isVisible()
    assert "Suggest motion" in window.offer.accept_button.text()


def test_a_sequence_offers_no_import(window, clip, source):
    choose(window, open_source(clip))
    choose(window, source)
    assert not window.offer.isVisible()


def test_escape_closes_a_page_beside_the_window_too(window, qtbot):
    window.commands.guide.trigger()
    page = window.findChild(GuideWindow)
    page.activateWindow()
    qtbot.waitUntil(page.isActiveWindow)
    QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    assert window.session.is_stopped
    assert not any(one.isVisible() for one in window.findChildren(GuideWindow))


def test_a_log_that_is_dropped_asks_for_its_clip(window, case):
    log = case("si-csv-answers/phone.csv")
    window.dropping.take([log])
    wizard = window.findChild(ImportWizard)
    assert wizard.files.log.text() == str(log)
    assert "phone.csv is a motion log. Choose or drop the video" in (
        wizard.files.facts.text()
    )
    assert not wizard.next.isEnabled()
    wizard.reject()


def test_a_video_may_follow_its_log(window, clip, case, wait_for):
    log = case("si-csv-answers/phone.csv")
    wizard = window.dialogs.import_recording([log])
    wizard.files.take([clip])
    assert wizard.files.chosen() == (clip, (log,))
    wait_for(wizard.next.isEnabled)
    wizard.files.take([clip])  # another recording
    assert wizard.files.chosen() == (clip, None)
    wizard.reject()


def test_a_log_that_is_dropped_on_a_plain_clip_belongs_to_it(
    window, clip, case, wait_for
):
    log = case("si-csv-answers/phone.csv")
    window.open_path(clip)
    wait_for(window.offer.isVisible)
    window.dropping.take([log])
    wizard = window.findChild(ImportWizard)
    assert wizard.files.chosen() == (clip, (log,))
    wizard.reject()


def test_the_frames_suggest_motion_where_that_was_chosen(window, clip, wait_for):
    window.open_path(clip)
    wait_for(window.offer.isVisible)
    window.offer.accept_button.click()
    wizard = window.findChild(ImportWizard)
    box = wizard.files.suggestion
    wait_for(box.isVisible)
    assert box.choice.isChecked() == box.choice.isEnabled()
    wizard.reject()


def test_clips_dropped_together_play_and_can_be_imported(
    window, clip, wait_for, tmp_path
):
    clips = [tmp_path / name for name in ("a.mp4", "b.mp4")]
    for one in clips:
        one.write_bytes(clip.read_bytes())
    window.dropping.take(clips)
    wait_for(window.offer.isVisible)
    assert window.playlist.paths == clips
    assert "Clips: 2" in window.offer.text.text()
    window.offer.accept_button.click()
    queue = window.findChild(QueuePage)
    assert [row.item.video for row in queue.rows] == clips
    queue.reject()


def test_a_file_that_is_neither_is_opened_and_refused(window, tmp_path, wait_for):
    other = tmp_path / "notes.txt"
    other.write_text("hello\n")
    window.dropping.take([other])
    wait_for(lambda: "notes.txt" in window.messages.text())
    assert window.findChild(ImportWizard) is None
