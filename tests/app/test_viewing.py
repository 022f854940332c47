"""Zoom, shape, tracks and subtitles of the clip; wheel, right click, frames as files."""

import subprocess

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtWidgets import QApplication, QMenu

from app.player import fullscreen, viewing
from app.player.video_surface import Box, zoomed
from hapticplayer.playback.source import open_source


@pytest.fixture(scope="module")
def spoken_clip(tmp_path_factory):
    """10 s of grey with two sounds and a caption from 0 to 9 s."""
    folder = tmp_path_factory.mktemp("spoken")
    (folder / "a.srt").write_text("1\n00:00:00,000 --> 00:00:09,000\nMind the gap\n")
    path = folder / "spoken.mkv"
    subprocess.run(
        [
            *(
                "ffmpeg",
                "-v",
                "error",
                "-f",
                "lavfi",
                "-i",
                "color=gray:s=320x180:d=10",
            ),
            *(
                "-f",
                "lavfi",
                "-i",
                "sine=440:d=10",
                "-f",
                "lavfi",
                "-i",
                "sine=880:d=10",
            ),
            *(
                "-i",
                folder / "a.srt",
                "-map",
                "0",
                "-map",
                "1",
                "-map",
                "2",
                "-map",
                "3",
            ),
            *("-c:v", "libx264", "-preset", "ultrafast", "-c:a", "aac", "-c:s", "srt"),
            *(
                "-metadata:s:a:1",
                "language=deu",
                "-metadata:s:s:0",
                "language=eng",
                path,
            ),
        ],
        check=True,
    )
    return path


@pytest.fixture
def spoken(window, spoken_clip):
    window.session.show_source(open_source(spoken_clip))
    return window


def turn(surface, notches, keys=Qt.KeyboardModifier.NoModifier):
    at = QPointF(surface.rect().center())
    event = QWheelEvent(
        at,
        surface.mapToGlobal(at),
        QPoint(),
        QPoint(0, round(120 * notches)),
        Qt.MouseButton.NoButton,
        keys,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(surface, event)


def entries(menu):
    menu.aboutToShow.emit()
    return [action.text() for action in menu.actions()]


def test_the_wheel_turns_the_volume_and_with_shift_it_seeks(playing):
    playing.controls.set_volume(50)
    turn(playing.surface, 2)
    assert playing.controls.volume_percent == 60
    for _ in range(4):  # a touch pad
        turn(playing.surface, -0.25)
    assert playing.controls.volume_percent == 55
    before_s = playing.player.snapshot().media_s
    turn(playing.surface, -1, Qt.KeyboardModifier.ShiftModifier)
    assert playing.player.snapshot().media_s < before_s
    assert playing.controls.volume_percent == 55


@pytest.mark.parametrize("zoom", [0.5, 1.0, 2.0])
def test_zoom_keeps_the_middle(zoom):
    box = zoomed(Box(0, 10, 320, 180), zoom)
    assert box.width == round(320 * zoom)
    assert box.x + box.width / 2 == pytest.approx(160, abs=1)
    assert box.y + box.height / 2 == pytest.approx(100, abs=1)


def test_zoom_and_shape_change_what_is_painted(spoken):
    surface = spoken.surface
    whole = surface.target
    spoken.commands.video_larger.trigger()
    assert surface.target.width == pytest.approx(1.1 * whole.width, abs=2)
    assert spoken.extras.toast.text() == "Zoom 110\u00a0%"
    assert surface.grab().toImage().pixelColor(surface.rect().center()).red() > 100
    for _ in range(99):
        spoken.commands.video_larger.trigger()
    assert surface.zoom == viewing.MOST_ZOOM
    spoken.commands.video_fit.trigger()
    assert surface.target == whole
    spoken.viewing.choose_aspect("4:3")
    shown = surface.target
    assert shown.width / shown.height == pytest.approx(4 / 3, abs=0.02)
    spoken.viewing.choose_aspect("")
    assert surface.target == whole


def test_another_clip_is_not_zoomed(spoken, source):
    spoken.commands.video_larger.trigger()
    spoken.session.show_source(source)
    assert spoken.surface.zoom == 1.0


def test_tracks_are_offered_by_language(spoken):
    sound, texts = spoken.viewing.sound_menu.menu, spoken.viewing.subtitle_menu.menu
    assert entries(sound) == ["Track 1", "Track 2, Deutsch"]
    off, english = entries(texts)
    assert off == "Off"
    assert "English" in english


def test_a_clip_without_tracks_says_so(window, source):
    window.session.show_source(source)
    assert entries(window.viewing.sound_menu.menu) == ["No sound in this clip"]
    assert entries(window.viewing.subtitle_menu.menu) == ["No subtitles in this clip"]


def test_another_track_is_heard_from_the_same_place(spoken):
    player = spoken.player
    player.seek(4.0)
    player.play()
    spoken.viewing.choose_sound(1)
    now = player.snapshot()
    assert now.source.clip.audio_track == 1
    assert now.media_s >= 4.0
    assert now.is_playing
    spoken.viewing.choose_sound(7)
    assert player.snapshot().source.clip.audio_track == 1


def test_subtitles_lie_over_the_video_while_they_are_due(spoken, wait_for):
    caption = spoken.viewing.caption
    spoken.viewing.choose_subtitles("0")
    wait_for(caption.isVisible)
    assert caption.text() == "Mind the gap"
    assert spoken.surface.video_rect.contains(caption.geometry())
    spoken.player.seek(9.5)
    wait_for(lambda: not caption.isVisible())
    spoken.player.seek(1.0)
    wait_for(caption.isVisible)
    spoken.viewing.choose_sound(1)  # stays with another sound
    wait_for(caption.isVisible)
    spoken.viewing.choose_subtitles("-")
    assert not caption.isVisible()


def test_subtitles_of_one_clip_do_not_stay_for_the_next(spoken, source, wait_for):
    spoken.viewing.choose_subtitles("0")
    wait_for(spoken.viewing.caption.isVisible)
    spoken.session.show_source(source)
    assert not spoken.viewing.caption.isVisible()
    spoken.viewing.refresh()
    assert not spoken.viewing.caption.isVisible()


def test_a_frame_is_saved_in_the_size_of_the_clip(spoken, settings, tmp_path, wait_for):
    settings.keep(viewing.FRAMES, str(tmp_path / "frames"))
    wait_for(lambda: spoken.surface.frame is not None)
    for count in (1, 2):  # the second one does not replace the first
        spoken.commands.save_frame.trigger()
        wait_for(lambda n=count: len(list(tmp_path.glob("frames/*.png"))) == n)
        wait_for(lambda: "Saved" in spoken.extras.toast.text())
    for path in tmp_path.glob("frames/*.png"):
        image = QImage(str(path))
        assert (image.width(), image.height()) == (320, 180)
        assert np.isclose(image.pixelColor(160, 90).red(), 128, atol=4)


def test_a_frame_that_cannot_be_saved_is_a_message(
    spoken, settings, tmp_path, wait_for
):
    (tmp_path / "file").write_text("")
    settings.keep(viewing.FRAMES, str(tmp_path / "file"))
    wait_for(lambda: spoken.surface.frame is not None)
    spoken.commands.save_frame.trigger()
    wait_for(lambda: "cannot be written" in spoken.messages.text())


def test_a_right_click_offers_what_belongs_to_the_video(playing):
    playing.surface.menu_wanted.emit(playing.mapToGlobal(QPoint(50, 50)))
    menus = [m for m in playing.findChildren(QMenu) if m.isVisible()]
    assert len(menus) == 1
    said = [action.text().replace("&", "") for action in menus[0].actions()]
    assert {"Play or pause", "Next file", "Subtitles", "Stop the force"} <= set(said)
    menus[0].close()


@pytest.fixture
def full(playing, monkeypatch, wait_for):
    monkeypatch.setattr(fullscreen, "CURSOR_STAYS_MS", 100)
    playing.enter_fullscreen()
    wait_for(lambda: playing.surface.size() == playing.screen().geometry().size())
    return playing


def test_controls_come_with_the_pointer_in_fullscreen(full, wait_for):
    transport, surface = full.transport, full.surface
    assert not transport.isVisible()
    surface.pointer_moved.emit()
    assert transport.isVisible()
    assert surface.rect().bottom() == transport.geometry().bottom()
    assert transport.width() == surface.width()
    wait_for(lambda: not transport.isVisible())
    surface.pointer_moved.emit()
    transport.stop.click()
    assert full.session.is_stopped
    full.fullscreen.leave()
    assert transport.parent() is not surface
    assert transport.isVisible()
    assert transport.geometry().top() >= surface.mapTo(full, QPoint()).y()
