"""The editor of effects over a sequence: what it shows, plays and stops."""

import numpy as np
import pytest
from faces import make_player
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.editor.page import EditorPage
from app.experimenter.library_page import LibraryPage
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.contract import Mode
from hapticplayer.playback.source import open_source
from hapticplayer.rendering.effects import Effect, EffectList
from tests.conftest import clip_of

EFFECTS = EffectList(
    (Effect("gain", 0.2, 1.0), Effect("mute", 0.5, 0.8), Effect("sine", 1.2, 1.9))
)


def frame_level(page) -> float:
    image = page.playing.surface.image
    return image.pixelColor(image.width() // 2, image.height() // 2).red()


def test_the_editor_shows_force_effects_and_frame_at_the_cursor(
    make_page, folder, wait_for
):
    page = make_page(folder)
    assert page.lanes.effects == EFFECTS
    assert "A ride whose title" in page.windowTitle()
    first, second, third = (page.lanes.effect_box(k) for k in range(3))
    assert first.top() < second.top()  # they overlap in time
    assert first.top() == third.top()
    assert first.right() == pytest.approx(page.lanes.width() / 2.0, abs=1.0)
    page.lanes.point_at(1.8)
    # from 20 to 235 in two seconds
    wait_for(lambda: page.playing.surface.frame is not None and frame_level(page) > 195)
    assert page.lanes.cursor_s == 1.8


def test_keys_move_the_cursor_by_frames_and_zoom(make_page, folder):
    page = make_page(folder)
    lanes = page.lanes
    lanes.point_at(1.0)
    for _ in range(3):
        QTest.keyClick(lanes, Qt.Key.Key_Period)
    assert lanes.cursor_s == pytest.approx(1.12)  # 25 frames a second
    QTest.keyClick(lanes, Qt.Key.Key_Plus)
    assert page.view.span_s == pytest.approx(2.0 / 1.25)
    assert page.view_bar.isEnabled()
    page.view_bar.setValue(page.view_bar.maximum())
    assert page.view.end_s == pytest.approx(2.0, abs=0.002)
    page.play_bar.whole.click()
    assert page.view.span_s == pytest.approx(2.0)
    assert not page.view_bar.isEnabled()
    QTest.keyClick(lanes, Qt.Key.Key_End)
    assert lanes.cursor_s == pytest.approx(2.0)


def test_the_wheel_zooms_around_the_pointer(make_page, folder, qtbot):
    page = make_page(folder)
    before = page.lanes.grab().toImage()
    page.view.zoom(0.1, 0.5)
    after = page.lanes.grab().toImage()
    assert before != after
    assert page.view.x_of(0.5, 100.0) == pytest.approx(25.0)


def test_without_effects_sound_and_events_the_lanes_say_so(make_page, sequence):
    page = make_page(sequence)
    assert len(page.lanes.effects) == 0
    assert not page.messages.text()
    assert page.lanes.isEnabled()


def test_a_damaged_sequence_is_told_of(make_page, folder):
    (folder / "sequence.json").write_text("{}")
    page = make_page(folder)
    assert "is not the description of a sequence" in page.messages.text()
    assert not page.lanes.isEnabled()
    assert not page.play_bar.play_button.isEnabled()


def test_without_the_device_it_shows_everything(make_page, folder):
    def refuse(clock, sink, device):
        if device != "none":
            raise DeviceError("there is no device here")
        return make_player(clock, sink, device)

    page = make_page(folder, "simulated", refuse)
    assert "no device here" in page.messages.text()
    assert page.play_bar.play_button.isEnabled()


def test_space_plays_and_escape_stops_before_it_closes(make_page, folder, wait_for):
    page = make_page(folder)
    QTest.keyClick(page.lanes, Qt.Key.Key_Space)
    wait_for(lambda: page.lanes.cursor_s > 0.1)
    QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    assert page.isVisible()
    assert not page.playing.session.player.snapshot().is_playing
    QTest.qWait(20)
    QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    assert not page.isVisible()


@pytest.mark.realtime
def test_a_playing_force_is_felt_and_escape_ends_it(felt, wait_for):
    page, player = felt

    def after_stop():
        ticks = player.ticks_since(-np.inf)
        return ticks["force_n"][ticks["mode"] == Mode.TRIPPED]

    QTest.keyClick(page.windowHandle(), Qt.Key.Key_Escape)
    assert player.snapshot().leading.mode is Mode.TRIPPED  # before its first tick
    wait_for(lambda: len(after_stop()) > 0)
    assert not after_stop().any()
    assert page.isVisible()
    wait_for(lambda: page.play_bar.stop_button.text() == "Re-arm")
    page.play_bar.stop_button.click()
    wait_for(lambda: player.snapshot().leading.mode is not Mode.TRIPPED)


def test_menu_and_library_open_it(window, source, folder, wait_for):
    window.dialogs.edit_effects(window.clock)  # nothing is open
    assert window.findChild(EditorPage) is None
    assert "Only the effects of a sequence" in window.messages.text()
    window.session.show_source(source)
    wait_for(window.commands.edit_effects.isEnabled)
    window.commands.edit_effects.trigger()
    page = window.findChild(EditorPage)
    assert page.folder == source.path
    wait_for(lambda: page.loaded is not None)
    page.reject()
    wait_for(lambda: window.findChild(EditorPage) is None)
    window.settings.keep("library", str(folder.parent))
    window.dialogs.library(window.clock)
    library = window.findChild(LibraryPage)
    library.buttons["edit"].click()
    page = window.findChild(EditorPage)
    assert page.folder == folder
    wait_for(lambda: page.loaded is not None)
    page.reject()


@pytest.mark.parametrize(
    ("kept", "gain"),
    [({}, 1.0), ({"volume": 50}, 0.125), ({"volume": 50, "muted": True}, 0.0)],
)
def test_the_editor_is_as_loud_as_the_window(make_page, folder, settings, kept, gain):
    for name, value in kept.items():
        settings.keep(name, value)
    player = make_page(folder).playing.session.player
    assert clip_of(player).sound.ring.gain == pytest.approx(gain)


def test_the_window_plays_what_was_saved(window, folder, wait_for):
    window.session.show_source(open_source(folder))
    window.player.seek(1.0)
    before = window.player.snapshot().source.tracks["realistic"]
    window.dialogs.edit_effects(window.clock)
    page = window.findChild(EditorPage)
    wait_for(lambda: page.loaded is not None)
    page.editing.add_kind("mute", 0.0)
    page.save()
    wait_for(page.document.stack.isClean)
    now = window.player.snapshot()
    after = now.source.tracks["realistic"]
    at_s = np.array([0.37])  # of a shake of 2 Hz
    assert np.abs(after.at(at_s)).max() < 0.2 * np.abs(before.at(at_s)).max()
    assert now.media_s == pytest.approx(1.0, abs=0.05)
    page.reject()
