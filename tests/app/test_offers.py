"""What the window offers for a clip without force, and what Esc closes."""

import dataclasses

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

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
    assert "suggest motion" in window.offer.accept_button.text()


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
