"""The command with a window, as `hapticplayer play` calls it."""

import json
import os
import signal

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from app.player import application
from app.player.window import PlayerWindow
from hapticplayer import cli
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.phases import Phase
from hapticplayer.shipped import DEMO


def run(*arguments) -> int:
    return cli.main([str(argument) for argument in arguments], application.run)


def open_windows() -> list[PlayerWindow]:
    return [w for w in QApplication.topLevelWidgets() if isinstance(w, PlayerWindow)]


@pytest.fixture
def when_playing(application):
    """Call something in the window once its clip plays."""
    timer = QTimer()

    def arrange(action) -> None:
        def look() -> None:
            for window in open_windows():
                if window.player.snapshot().phase is Phase.PLAYING:
                    timer.stop()
                    action(window)

        timer.timeout.connect(look)
        timer.start(10)

    yield arrange
    timer.stop()


def test_a_clip_plays_to_its_end_and_writes_the_log(qapp, sequence, tmp_path):
    log = tmp_path / "log.jsonl"
    status = run(
        "play",
        sequence,
        "--close-at-end",
        "--log",
        log,
        "--start",
        1,
        "--duration",
        0.5,
    )
    assert status == 0
    lines = [json.loads(line) for line in log.read_text().splitlines()]
    kinds = {line["kind"] for line in lines}
    assert kinds >= {"header", "frame", "force", "event", "summary"}
    shown = [line["media_s"] for line in lines if line["kind"] == "frame"]
    assert min(shown) > 0.9
    assert max(shown) < 1.6
    last = [line for line in lines if line["kind"] == "force"][-1]
    assert last["force_n"] == [0.0, 0.0, 0.0]
    assert lines[-1]["kind"] == "summary"


class FailingLog(PlaybackLog):
    """Has lines that cannot be written."""

    def line(self, kind, **_fields) -> None:
        super().line(kind, value=float("nan"))


def test_a_log_that_fails_is_told_when_the_window_closes(
    qapp, clip, tmp_path, capsys, monkeypatch
):
    monkeypatch.setattr("hapticplayer.cli.play.PlaybackLog", FailingLog)
    words = ("--close-at-end", "--duration", 0.2, "--log", tmp_path / "log.jsonl")
    assert run("play", clip, "--device", "none", *words) == 1
    assert "the log is incomplete" in capsys.readouterr().err


def test_a_clip_with_other_bytes_in_its_name_plays_in_the_window(qapp, clip, tmp_path):
    path = tmp_path / os.fsdecode(b"ride \xff.mp4")
    path.write_bytes(clip.read_bytes())
    words = ("--close-at-end", "--duration", 0.2)
    assert run("play", path, "--device", "none", *words) == 0


def test_a_missing_source_is_one_sentence_and_no_window(qapp, tmp_path, capsys):
    assert run("play", tmp_path / "missing.mp4") == 1
    errors = capsys.readouterr().err
    assert errors.startswith("hapticplayer: ")
    assert errors.count("\n") == 1
    assert not [w for w in open_windows() if w.isVisible()]


def test_a_device_that_is_not_there_is_said_in_one_sentence(qapp, clip, capsys):
    # nobody has a Falcon of that number
    assert run("play", clip, "--device", "falcon:NOWHERE0") == 1
    assert "Falcon" in capsys.readouterr().err


def test_a_feedback_that_does_not_exist_is_wrong_usage(qapp, clip, capsys):
    assert run("play", clip, "--feedback", "sweet", "--device", "none") == 2
    assert "sweet" in capsys.readouterr().err


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signals_close_in_good_order(when_playing, sequence, tmp_path, number):
    log = tmp_path / "log.jsonl"
    when_playing(lambda _window: os.kill(os.getpid(), number))
    before = signal.getsignal(number)
    assert run("play", sequence, "--device", "none", "--log", log) == 0
    assert json.loads(log.read_text().splitlines()[-1])["kind"] == "summary"
    assert signal.getsignal(number) is before


def test_fullscreen_and_no_plots_from_the_command_line(when_playing, sequence):
    seen = []

    def look(window) -> None:
        seen.append((window.isFullScreen(), window.transport.isVisible()))
        window.fullscreen.leave()
        seen.append((window.transport.isVisible(), window.plots.isVisible()))
        window.close()

    when_playing(look)
    assert run("play", sequence, "--device", "none", "--fullscreen", "--no-plots") == 0
    assert seen == [(True, False), (True, False)]


def test_without_a_source_the_demo_is_played(when_playing):
    opened = []

    def look(window):
        opened.append(window.player.snapshot().source.path)
        window.close()

    when_playing(look)
    assert run() == 0
    assert opened == [DEMO]


def test_a_damaged_clip_that_closes_at_the_end_is_a_failure(
    qapp, clip, tmp_path, capsys
):
    # the index stands in front, so a clip cut off in the middle opens
    cut = tmp_path / "cut.mp4"
    whole = clip.read_bytes()
    cut.write_bytes(whole[: int(0.8 * len(whole))])
    status = run("play", cut, "--device", "none", "--close-at-end")
    assert status in (0, 1)
    if status:
        assert "cut.mp4" in capsys.readouterr().err


def test_the_speed_of_the_command_line(when_playing, sequence, capsys):
    seen = []

    def look(window) -> None:
        seen.append((window.player.snapshot().speed, window.transport.speed.text()))
        window.close()

    when_playing(look)
    assert run("play", sequence, "--device", "none", "--speed", "0.5") == 0
    assert seen == [(0.5, "0.50\u00d7")]
    assert run("play", sequence, "--device", "none", "--speed", "nan") == 2
    assert "--speed must be between 0.5 and 4, not nan" in capsys.readouterr().err


def test_twice_the_speed_shows_the_clip_in_half_the_time(qapp, sequence, tmp_path):
    log = tmp_path / "log.jsonl"
    options = ("--speed", 2, "--log", log, "--device", "none", "--headless")
    assert run("play", sequence, *options) == 0
    rows = [json.loads(line) for line in log.read_text().splitlines()]
    frames = [r for r in rows if r["kind"] == "frame"]
    first, last = frames[0], frames[-1]
    wall_s = last["monotonic_s"] - first["monotonic_s"]
    assert (last["media_s"] - first["media_s"]) / wall_s == pytest.approx(2, rel=0.15)
