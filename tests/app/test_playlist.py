"""Files that play one after the other, and what `hapticplayer FILE` opens."""

import shutil

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from app.player import application
from app.player.playlist import Playlist, Repeat, beside
from app.player.playlist_page import PlaylistPage
from app.player.window import PlayerWindow
from hapticplayer import cli
from hapticplayer.playback.phases import Phase
from hapticplayer.study.creation import create_study


@pytest.fixture
def rides(clip, sequence, tmp_path):
    """Two clips, a sequence, and what cannot be played."""
    folder = tmp_path / "rides"
    folder.mkdir()
    for name in ("ride 10.mp4", "ride 9.mp4"):
        shutil.copy(clip, folder / name)
    shutil.copytree(sequence, folder / "ride 11")
    (folder / "ride 9.csv").write_text("time_s\n")
    (folder / "ride 9.haptics.mkv").write_bytes(b"")
    (folder / "empty").mkdir()
    return folder


def test_neighbours_are_sorted_as_people_count(rides):
    names = [path.name for path in beside(rides / "ride 9.mp4")]
    assert names == ["ride 9.mp4", "ride 10.mp4", "ride 11"]


def opened_by(playlist, *steps):
    for step in steps:
        playlist.go(step)


@pytest.fixture
def playlist(rides):
    opened = []

    def open_path(path):
        opened.append(path.name)
        made.note_opened(path)

    made = Playlist(open_path)
    made.opened = opened
    made.note_opened(rides / "ride 9.mp4")
    return made


def test_the_folder_is_left_at_neither_end(playlist):
    opened_by(playlist, 1, 1, 1, -1, -1, -1)
    assert playlist.opened == ["ride 10.mp4", "ride 11", "ride 10.mp4", "ride 9.mp4"]


def test_a_folder_does_not_play_on_by_itself_but_a_list_does(playlist, rides):
    assert playlist.follow_end()
    assert playlist.opened == []
    playlist.take([rides / "ride 11", rides / "ride 9.mp4"])
    assert playlist.follow_end()
    assert playlist.opened == ["ride 11", "ride 9.mp4"]
    assert playlist.follow_end()  # nothing is left
    assert len(playlist.opened) == 2


def test_repeating_all_begins_again_and_repeating_one_stays(playlist, rides):
    playlist.take([rides / "ride 11", rides / "ride 9.mp4"])
    assert playlist.turn_repeat() is Repeat.ONE
    assert not playlist.follow_end()
    assert playlist.turn_repeat() is Repeat.ALL
    assert playlist.follow_end()
    assert playlist.follow_end()
    assert playlist.opened == ["ride 11", "ride 9.mp4", "ride 11"]
    assert playlist.turn_repeat() is Repeat.OFF


def test_one_clip_alone_repeats_by_all_too(playlist, rides):
    playlist.take([rides / "ride 11"])
    playlist.repeat = Repeat.ALL
    assert not playlist.follow_end()


def test_keys_go_to_the_next_file_and_say_where_none_is(window, rides, wait_for):
    player = window.player
    window.open_path(rides / "ride 10.mp4")
    wait_for(lambda: player.snapshot().source is not None)
    window.commands.next_file.trigger()
    wait_for(lambda: player.snapshot().source.path.name == "ride 11")
    window.commands.next_file.trigger()
    assert window.extras.toast.text() == "No next file"
    window.commands.previous_file.trigger()
    wait_for(lambda: player.snapshot().source.path.name == "ride 10.mp4")


@pytest.mark.realtime
def test_a_clip_that_is_repeated_plays_again(window, source, wait_for):
    window.commands.repeat.trigger()
    assert window.extras.toast.text() == "Repeat this clip"
    window.session.show_source(source)
    window.player.seek(1.8)
    window.player.play()
    ended = []
    window.session.ended.connect(lambda: ended.append(True))
    wait_for(lambda: bool(ended))
    wait_for(lambda: window.player.snapshot().phase is Phase.PLAYING)
    assert window.player.snapshot().media_s < 1.5


def test_dropped_clips_become_the_list_that_a_page_shows(window, rides, wait_for):
    window.dropping.take([rides / "ride 9.mp4", rides / "ride 11"])
    wait_for(lambda: window.player.snapshot().source is not None)
    window.commands.playlist.trigger()
    page = window.findChild(PlaylistPage)
    shown = [page.list.item(row) for row in range(page.list.count())]
    assert [item.text() for item in shown] == ["ride 9.mp4", "ride 11"]
    assert [item.font().bold() for item in shown] == [True, False]
    page.list.setCurrentRow(1)
    page.up.click()
    assert [path.name for path in window.playlist.paths] == ["ride 11", "ride 9.mp4"]
    page.add([rides / "ride 10.mp4", rides / "empty"])
    page.list.setCurrentRow(0)
    page.remove_button.click()
    assert [p.name for p in window.playlist.paths] == ["ride 9.mp4", "ride 10.mp4"]
    page.list.selectAll()
    page.remove_button.click()
    assert "The list is empty" in page.hint.text()
    assert not page.up.isEnabled()
    page.close()


@pytest.fixture
def in_window(qapp):
    """Run the command and look at its window once something is so; it is closed then."""
    seen = []
    timer = QTimer()

    def run(words, is_so, look):
        def poll():
            for window in QApplication.topLevelWidgets():
                if isinstance(window, PlayerWindow) and is_so(window):
                    timer.stop()
                    seen.append(look(window))
                    window.close()

        timer.timeout.connect(poll)
        timer.start(20)
        assert cli.main([str(word) for word in words], application.run) == 0
        return seen[0]

    yield run
    timer.stop()


def test_files_without_a_command_are_played_in_turn(in_window, rides):
    words = ["--mute", rides / "ride 9.mp4", rides / "ride 11"]
    names = in_window(
        words,
        lambda w: w.player.snapshot().phase is Phase.PLAYING,
        lambda w: [path.name for path in w.playlist.paths],
    )
    assert names == ["ride 9.mp4", "ride 11"]


def test_a_study_is_opened_in_its_editor(in_window, tmp_path):
    folder = create_study(tmp_path / "study", "qoe2012").folder
    title = in_window(
        [folder],
        lambda _window: QApplication.activeModalWidget() is not None,
        lambda _window: QApplication.activeModalWidget().windowTitle(),
    )
    assert "study" in title.lower()


@pytest.mark.parametrize("word", ["no-such.mp4", "no/such"])
def test_a_file_that_is_missing_is_named(word, capsys):
    assert cli.main([word, "--headless"]) == 1
    assert f"{word}: there is no such file" in capsys.readouterr().err


def test_a_word_that_is_no_file_stays_an_unknown_command(capsys):
    assert cli.main(["plaay"]) == 2
    assert "invalid choice: 'plaay'" in capsys.readouterr().err


def test_several_clips_need_a_window(clip, capsys):
    assert cli.main([str(clip), str(clip), "--headless"]) == 2
    assert "without a window one clip is played" in capsys.readouterr().err
