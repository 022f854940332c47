"""What a desktop player has beside playing, in the real window."""

import json
import threading
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QFontInfo
from PySide6.QtTest import QTest

from app.player import menus as history
from app.player.menus import History
from app.player.seek_preview import HEIGHT_PX, heat_image, heat_of
from hapticplayer.model import ForceTrack
from hapticplayer.playback.phases import Phase
from tests.conftest import clip_of


def key(window, code) -> None:
    QTest.keyClick(window.windowHandle(), code)


def test_brackets_change_the_speed_and_backspace_resets_it(playing):
    key(playing, Qt.Key.Key_BracketRight)
    assert playing.player.snapshot().speed == pytest.approx(1.1)
    assert playing.transport.speed.isVisible()
    assert "1.10" in playing.extras.toast.text()
    key(playing, Qt.Key.Key_BracketLeft)
    assert playing.player.snapshot().speed == 1.0
    for _ in range(20):
        key(playing, Qt.Key.Key_BracketLeft)
    assert playing.player.snapshot().speed == 0.5
    key(playing, Qt.Key.Key_Backspace)
    assert playing.player.snapshot().speed == 1.0
    assert not playing.transport.speed.isVisible()


def test_a_start_without_sound_is_not_remembered(playing, settings):
    controls, ring = playing.extras.controls, clip_of(playing.player).sound.ring
    controls.begin_muted()
    assert ring.gain == 0.0
    assert playing.transport.mute.accessibleName() == "Sound on"
    assert settings.flag("muted", default=True) is False
    key(playing, Qt.Key.Key_M)
    assert ring.gain == pytest.approx(1.0)


def test_volume_and_mute_are_heard_shown_and_remembered(playing, settings):
    ring = clip_of(playing.player).sound.ring
    key(playing, Qt.Key.Key_9)
    assert playing.transport.volume.value() == 95
    assert ring.gain == pytest.approx(0.95**3)
    key(playing, Qt.Key.Key_M)
    assert ring.gain == 0.0
    assert playing.transport.mute.accessibleName() == "Sound on"
    key(playing, Qt.Key.Key_M)
    assert ring.gain == pytest.approx(0.95**3)
    playing.transport.volume.setValue(50)
    assert ring.gain == pytest.approx(0.125)
    assert settings.number("volume", 0) == 50


def test_the_loop_key_marks_a_then_b_then_forgets(playing):
    playing.player.pause()
    playing.player.seek(0.4)
    key(playing, Qt.Key.Key_L)
    assert playing.transport.slider.marks_s == pytest.approx((0.4,))
    playing.player.seek(1.2)
    key(playing, Qt.Key.Key_L)
    assert playing.player.snapshot().loop_s == pytest.approx((0.4, 1.2))
    assert playing.transport.slider.marks_s == pytest.approx((0.4, 1.2))
    key(playing, Qt.Key.Key_L)
    assert playing.player.snapshot().loop_s is None
    assert playing.transport.slider.marks_s == ()


def test_the_dot_shows_the_next_picture(playing, wait_for):
    playing.player.pause()
    playing.player.seek(1.0)
    wait_for(lambda: abs(clip_of(playing.player).video.frame_s - 1.0) < 0.02)
    wait_for(lambda: not clip_of(playing.player).video.is_previewing)
    wait_for(lambda: clip_of(playing.player).video.feeder.peek() is not None)
    key(playing, Qt.Key.Key_Period)
    assert clip_of(playing.player).video.frame_s == pytest.approx(1.04, abs=1e-6)
    assert playing.player.snapshot().phase is Phase.PAUSED


def test_every_line_of_the_statistics_is_on_a_low_picture_too(playing):
    playing.commands.statistics.setChecked(True)
    statistics, surface = playing.extras.statistics, playing.surface
    for height_px in (1000, 260):
        surface.setFixedHeight(height_px)
        statistics.refresh(playing.player)
        assert statistics.geometry().bottom() <= height_px
    assert QFontInfo(statistics.font()).pixelSize() >= 7


def test_the_statistics_show_and_hide(playing, wait_for):
    key(playing, Qt.Key.Key_I)
    statistics = playing.extras.statistics
    assert statistics.isVisible()
    assert "160 x 90" in statistics.text()
    before = statistics.text()
    wait_for(lambda: statistics.text() != before)  # the position at least
    key(playing, Qt.Key.Key_I)
    assert not statistics.isVisible()


def test_the_force_under_the_seek_bar_follows_the_feedback(playing):
    slider = playing.transport.slider
    assert slider.heat is not None
    playing.session.choose_feedback("none")
    assert slider.heat is None
    playing.session.choose_feedback("realistic")
    assert slider.heat is not None


def test_the_strip_holds_every_peak():
    rng = np.random.default_rng(3)
    time_s = np.arange(0.0, 60.0, 1 / 200)
    force_n = rng.standard_normal((len(time_s), 3)).astype(np.float32)
    force_n[7001] = (0.0, 9.0, 0.0)
    heat = heat_of(ForceTrack(time_s, force_n), 60.0, 600)
    amounts = np.linalg.norm(force_n, axis=1)[:12000].reshape(600, 20)
    assert (heat >= amounts.max(axis=1) - 1e-6).all()
    assert np.argmax(heat) == 7001 // 20
    image = heat_image(heat)
    assert (image.width(), image.height()) == (600, 1)
    brightest = image.pixelColor(350, 0).lightness()
    assert brightest == max(image.pixelColor(k, 0).lightness() for k in range(600))


def test_a_picture_is_shown_under_the_pointer(playing, wait_for, qtbot):
    slider, thumbs = playing.transport.slider, playing.extras.thumbnails
    assert not thumbs.is_busy  # nobody has pointed at it yet
    QTest.mouseMove(slider, QPoint(slider.width() // 2, 10))
    wait_for(thumbs.tip.isVisible)
    assert thumbs.tip.time.text().startswith("00:0")
    wait_for(lambda: not thumbs.is_busy)
    assert thumbs.tip.image.isVisible()  # though the pointer rests
    slider.hovered.emit(1.6)
    late = thumbs.tip.image.pixmap().toImage()
    slider.hovered.emit(0.0)
    early = thumbs.tip.image.pixmap().toImage()
    assert late.height() == HEIGHT_PX
    middle = QPoint(80, 45)
    assert late.pixelColor(middle).lightness() > early.pixelColor(middle).lightness()
    slider.hovered.emit(-1.0)
    assert not thumbs.tip.isVisible()


def test_opened_clips_are_listed_and_resume_where_they_were_left(
    make_window, sequence, settings, wait_for, monkeypatch
):
    monkeypatch.setattr(history, "FROM_START_S", 0.5)
    monkeypatch.setattr(history, "FROM_END_S", 0.1)
    first = make_window()
    first.session.open_path(sequence)
    wait_for(lambda: first.player.snapshot().phase is Phase.PLAYING)
    first.player.pause()
    first.player.seek(1.0)
    first.close()
    second = make_window()
    menu = second.extras.menus.recent
    menu.fill()
    assert menu.menu.actions()[0].text() == sequence.name
    menu.menu.actions()[0].trigger()
    wait_for(lambda: second.player.snapshot().phase is Phase.PLAYING)
    assert second.player.snapshot().media_s >= 1.0
    assert "Home" in second.extras.toast.text()


def test_the_ends_of_a_clip_are_not_remembered(settings):
    kept = History(settings)
    assert not history.is_worth_keeping(2.0, 60.0)
    assert history.is_worth_keeping(20.0, 60.0)
    assert not history.is_worth_keeping(58.0, 60.0)
    settings.keep("positions", {"/a": "x", "/b": float("nan"), "/c": 20})
    left = {name: kept.position_s(Path(f"/{name}"), 60.0) for name in "abc"}
    assert left == {"a": 0.0, "b": 0.0, "c": 20.0}


def test_forget_all_forgets_all(settings, tmp_path):
    kept = History(settings)
    kept.note_opened(tmp_path / "a")
    kept.note_opened(tmp_path / "b")
    kept.note_opened(tmp_path / "a")
    assert [path.name for path in kept.recent()] == ["a", "b"]
    kept.forget()
    assert kept.recent() == []


def test_the_chosen_output_is_asked_for_and_remembered(window, settings, monkeypatch):
    asked = []
    monkeypatch.setattr(window.player, "set_sound_output", asked.append)
    window.extras.controls.choose_output("Headphones")
    assert asked[0].keywords == {"device": "Headphones"}
    assert settings.text("sound_output") == "Headphones"
    menu = window.extras.menus.outputs
    menu.fill()
    checked = [a.text() for a in menu.menu.actions() if a.isChecked()]
    assert checked == ["Headphones"]


def test_outputs_are_looked_for_beside_the_window(window, monkeypatch, wait_for):
    names, looked_in = ["Headphones", "Speakers"], []

    def found(_work, *, progress) -> list[str]:
        looked_in.append(threading.current_thread())
        return names

    monkeypatch.setattr("app.player.controls.in_child", found)
    window.commands.menus["playback"].aboutToShow.emit()
    menu = window.extras.menus.outputs.menu
    wait_for(lambda: [action.data() for action in menu.actions()] == ["", *names])
    assert threading.main_thread() not in looked_in


def test_the_chosen_screen_is_remembered(window, settings):
    menu = window.extras.menus.screens
    menu.fill()
    name = window.screen().name()
    next(a for a in menu.menu.actions() if a.data() == name).trigger()
    assert window.fullscreen.screen_name == name
    assert settings.text("fullscreen_screen") == name


def test_a_log_of_the_open_clip_is_felt_again(playing, source, tmp_path, wait_for):
    header = {
        "kind": "header",
        "clip": source.clip.path.name,
        "duration_s": source.clip.duration_s,
    }
    rows = [
        {"kind": "force", "media_s": k / 100, "force_n": [0.0, 1.5, 0.0]}
        for k in range(200)
    ]
    path = tmp_path / "log.jsonl"
    path.write_text("\n".join(json.dumps(row) for row in [header, *rows]))
    playing.session.open_log(path)
    wait_for(lambda: playing.player.snapshot().feedback == "log")
    assert playing.transport.feedback.currentText() == "From a log"
    track = playing.player.snapshot().source.tracks["log"]
    assert track.at(np.array([1.0]))[0] == pytest.approx([0.0, 1.5, 0.0])
    playing.session.open_log(tmp_path / "missing")
    wait_for(lambda: "no such file" in playing.messages.text())
