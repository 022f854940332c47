import json

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest

from app.bridge.settings import Settings
from app.editor.commands import EDITOR_COMMANDS
from app.player.command import KEYS, owner_of
from app.player.commands import COMMANDS
from app.player.keys_dialog import KeysDialog
from hapticplayer.playback.phases import Phase


def key(window, code) -> None:
    QTest.keyClick(window.windowHandle(), code)


def test_every_key_has_one_command_in_window_and_in_editor():
    every = (*COMMANDS, *EDITOR_COMMANDS)
    for command in every:
        for first in map(QKeySequence, command.keys):
            assert owner_of(first, command, every, {}) is None


def test_the_keys_of_mpv_are_there():
    keys = {key: command.name for command in COMMANDS for key in command.keys}
    wanted = {
        "Space": "play", "Left": "back", "Right": "forward", ".": "step_forward",
        ",": "step_back", "[": "slower", "]": "faster", "Backspace": "normal_speed",
        "9": "quieter", "0": "louder", "M": "mute", "L": "loop", "F": "fullscreen",
        "I": "statistics", "?": "shortcuts", "Q": "quit", "Esc": "stop",
    }  # fmt: skip
    assert {key: keys[key] for key in wanted} == wanted


def test_every_command_does_something(window):
    unbound = [
        name
        for name, action in window.commands.by_name.items()
        if not action.receivers("2triggered(bool)")
        and not action.receivers("2toggled(bool)")
    ]
    assert unbound == []


@pytest.fixture
def dialog(window, qtbot, settings) -> KeysDialog:
    made = KeysDialog((*COMMANDS, *EDITOR_COMMANDS), settings, window)
    made.changed.connect(window.commands.apply_keys)
    qtbot.addWidget(made)
    made.show()
    return made


def test_another_key_works_at_once_and_after_a_restart(
    dialog, window, tmp_path, wait_for
):
    dialog.choose("mute")
    dialog.key.setKeySequence(QKeySequence("X"))
    dialog.assign.click()
    dialog.hide()
    window.activateWindow()
    wait_for(window.isActiveWindow)
    key(window, Qt.Key.Key_X)
    assert window.extras.controls.is_muted
    key(window, Qt.Key.Key_M)  # no longer
    assert window.extras.controls.is_muted
    again = Settings(tmp_path / "window.json")
    mute = next(command for command in COMMANDS if command.name == "mute")
    assert mute.keys_in(again.table(KEYS)) == [QKeySequence("X")]


def test_a_key_that_is_taken_is_refused_with_its_owner(dialog, settings):
    dialog.choose("mute")
    dialog.key.setKeySequence(QKeySequence("F"))
    dialog.assign.click()
    assert "Fullscreen" in dialog.note.text()
    assert settings.table(KEYS) == {}


@pytest.mark.parametrize(
    ("name", "key", "is_free"),
    [
        ("effect_toggle", "G", True),  # the window shows the grip by it
        ("effect_toggle", "Space", False),  # plays in the editor, too
        ("play", "E", False),
        ("effect_delete", "E", False),
    ],
)
def test_window_and_editor_share_keys_that_never_meet(
    dialog, settings, name, key, is_free
):
    dialog.choose(name)
    dialog.key.setKeySequence(QKeySequence(key))
    dialog.assign.click()
    assert (settings.table(KEYS) == {name: [key]}) is is_free
    assert bool(dialog.note.text()) is not is_free


def test_the_stop_key_stays(dialog, settings):
    dialog.choose("stop")
    assert not dialog.assign.isEnabled()
    assert "always" in dialog.note.text()
    stop = next(command for command in COMMANDS if command.name == "stop")
    assert stop.keys_in({"stop": ["X"]}) == [QKeySequence("Esc")]


def test_reset_gives_the_first_keys_back(dialog, window, settings):
    settings.keep(KEYS, {"mute": ["X"], "loop": ["M"]})
    dialog.refresh()
    dialog.choose("mute")
    dialog.reset.click()
    assert "Loop" in dialog.note.text()  # which has that key now
    dialog.reset_all.click()
    assert settings.table(KEYS) == {}
    assert window.commands.mute.shortcut() == QKeySequence("M")


@pytest.mark.parametrize("kept", [{"play": 3}, {"play": [1]}, {"play": {}}, {"x": []}])
def test_damaged_keys_are_like_none(kept):
    play = next(command for command in COMMANDS if command.name == "play")
    assert play.keys_in(kept) == [QKeySequence("Space")]


# --- settings ----------------------------------------------------------------


def test_settings_say_their_version(tmp_path):
    settings = Settings(tmp_path / "a.json")
    settings.keep("volume", 40)
    settings.save()
    assert json.loads((tmp_path / "a.json").read_text()) == {"volume": 40, "version": 1}


def test_a_newer_file_is_left_as_it_is(tmp_path):
    path = tmp_path / "a.json"
    path.write_text('{"version": 9, "volume": 40}')
    settings = Settings(path)
    assert settings.number("volume", 100) == 100
    settings.keep("volume", 7)
    settings.save()
    assert json.loads(path.read_text()) == {"version": 9, "volume": 40}


def test_an_export_tells_nothing_of_what_was_watched(tmp_path):
    settings = Settings(tmp_path / "a.json")
    for name in ("recent", "positions", "folder", "geometry", "volume"):
        settings.keep(name, 40)
    settings.export(tmp_path / "out.json")
    assert json.loads((tmp_path / "out.json").read_text()) == {
        "volume": 40,
        "version": 1,
    }
    other = Settings(tmp_path / "b.json")
    other.keep("recent", ["/here"])
    other.take(tmp_path / "out.json")
    assert (other.number("volume", 0), other.texts("recent")) == (40, ["/here"])


@pytest.mark.parametrize(
    ("content", "message"),
    [("{}", "no settings"), ("nothing", "no settings"), ('{"version": 2}', "newer")],
)
def test_a_file_that_is_none_is_refused_and_changes_nothing(tmp_path, content, message):
    path = tmp_path / "in.json"
    path.write_text(content)
    settings = Settings(tmp_path / "a.json")
    settings.keep("volume", 40)
    with pytest.raises(Exception, match=message):
        settings.take(path)
    assert settings.number("volume", 0) == 40


def test_settings_from_a_file_work_at_once(window, tmp_path):
    (tmp_path / "in.json").write_text(
        '{"version": 1, "volume": 30, "keys": {"play": ["X"]}}'
    )
    window.dialogs.take(str(tmp_path / "in.json"))
    assert window.transport.volume.value() == 30
    assert window.commands.play.shortcut() == QKeySequence("X")


def test_export_and_import_that_fail_are_told(window, tmp_path):
    (tmp_path / "file").touch()
    window.dialogs.export(str(tmp_path / "file" / "out.json"))
    assert "cannot be written" in window.messages.text()
    window.dialogs.take(str(tmp_path / "missing.json"))
    assert "no settings" in window.messages.text()
    assert window.player.snapshot().phase is Phase.EMPTY
