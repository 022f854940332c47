"""What the window offers at the end of the demo, and of nothing else."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.experimenter.import_wizard import ImportWizard
from app.player import demo_end
from app.player.demo_end import DemoEnd
from app.player.playlist import Repeat
from app.player.setup_page import SetupPage
from hapticplayer.haptics.contract import Mode
from hapticplayer.playback.phases import Phase


@pytest.fixture
def at_end(make_window, sequence, source, monkeypatch, wait_for):
    """Make a window that has played a clip, the demo if `is_demo`, to its end."""

    def make(*outputs, is_demo=True, repeat=Repeat.OFF):
        monkeypatch.setattr(demo_end, "DEMO", sequence if is_demo else None)
        window = make_window(*outputs)
        window.playlist.repeat = repeat
        window.session.show_source(source)
        ended = []
        window.session.ended.connect(lambda: ended.append(True))
        window.player.play()
        wait_for(lambda: bool(ended))
        return window, window.findChild(DemoEnd)

    return make


def test_the_end_of_the_demo_plays_it_again_by_key(at_end, wait_for, qtbot):
    window, end = at_end("simulated")
    assert end.isVisible()
    assert end.parent().rect().contains(end.geometry())
    wait_for(lambda: window.player.snapshot().leading.mode is Mode.IDLE)
    assert not window.player.snapshot().leading.tick["force_n"].any()
    window.activateWindow()
    end.offer()
    wait_for(end.again.hasFocus)
    QTest.keyClick(end.again, Qt.Key.Key_Return)
    wait_for(lambda: window.player.snapshot().is_playing)
    assert not end.isVisible()


def test_a_stop_outlasts_playing_the_demo_again(at_end, wait_for):
    window, end = at_end("simulated")
    window.commands.stop.trigger()
    end.again.click()
    wait_for(lambda: window.player.snapshot().media_s > 0.0)
    assert window.session.is_stopped
    assert window.player.snapshot().leading.mode is Mode.TRIPPED


def test_import_and_device_open_out_of_fullscreen(at_end, wait_for):
    window, end = at_end()
    window.enter_fullscreen()
    end.bring_in.click()
    assert window.findChild(ImportWizard).isVisible()
    assert not window.fullscreen.is_on
    end.device.click()
    wait_for(lambda: window.findChild(SetupPage) is not None)


@pytest.mark.parametrize("more", [{"is_demo": False}, {"repeat": Repeat.ONE}])
def test_other_clips_and_a_repeated_demo_ask_nothing(at_end, more):
    _, end = at_end(**more)
    assert not end.isVisible()


def test_going_back_into_the_demo_takes_the_offer_away(at_end, wait_for):
    window, end = at_end()
    window.player.seek(0.5)
    wait_for(lambda: not end.isVisible())
    assert window.player.snapshot().phase is not Phase.ENDED
