"""Edits that were not saved come back after a kill, once, and over nothing newer."""

import errno
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from faces import make_player

from app.bridge.recovery import Recovery, fingerprint, left_behind
from app.editor.page import EditorPage
from app.editor.playing import PlayerSetup
from hapticplayer import storage
from hapticplayer.clock import SystemClock
from hapticplayer.doctor import ROOT
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import open_sequence, store
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.effects_file import written

EFFECTS = EffectList((Effect("gain", 0.2, 0.6),))
PULSE = Effect("pulse", 0.5, 1.5, parameters={"amplitude": 2.0})
SCRIPT = Path(__file__).with_name("killed_editor.py")


@pytest.fixture
def folder(sequence, tmp_path):
    target = shutil.copytree(sequence, tmp_path / "ride")
    set_effects(target, EFFECTS)
    return target


def kill_after_an_edit(folder, wait_for) -> None:
    """Edit in a window of its own, which is killed once the edit is on the disk."""
    child = subprocess.Popen(
        [sys.executable, SCRIPT, folder],
        stdout=subprocess.PIPE,
        env={
            **os.environ,
            "PYTHONPATH": str(ROOT),
            "QT_QPA_PLATFORM": "offscreen",
        },
    )
    with child.stdout:
        assert child.stdout.readline() == b"edited\n"
        wait_for(lambda: any(storage.data_home().glob("recovery/*/kept.json")))
        child.kill()
        assert child.wait() == -signal.SIGKILL


@pytest.fixture
def left(folder):
    """Leave the pulse of a killed window in the folder's recovery."""
    made = Recovery("effects", folder)
    made.open()
    content = written(EffectList((*EFFECTS.effects, PULSE)))
    made.keep("A ride", fingerprint(written(EFFECTS)), lambda: content)
    made.close()
    return made.file


@pytest.fixture
def make_page(application, qtbot, settings, wait_for):
    made = []

    def make(folder, **options):
        setup = PlayerSetup(SystemClock(), "none", settings, make_player)
        page = EditorPage(folder, setup, **options)
        clean = page.document.stack.setClean
        qtbot.addWidget(page, before_close_func=lambda _: clean())
        made.append(page)
        page.show()
        wait_for(lambda: page.loaded is not None)
        return page

    yield make
    for page in made:
        page.document.stack.setClean()
        page.reject()


def stored(folder):
    return store.effects_of(open_sequence(folder))


def test_an_edit_is_offered_again_after_a_kill(folder, make_page, wait_for):
    kill_after_an_edit(folder, wait_for)
    assert stored(folder) == EFFECTS  # nothing was saved
    [kept] = left_behind("effects")
    assert kept.path == folder
    [file] = storage.data_home().glob("recovery/*/kept.json")
    assert file.stat().st_mode & 0o777 == storage.PRIVATE_FILE
    page = make_page(folder)
    assert page.unsaved.bar.isVisible()
    assert not page.lanes.isEnabled()  # until a person has decided
    assert page.focusWidget() is page.unsaved.bar.accept_button
    page.unsaved.bar.accept_button.click()
    assert page.document.effects.effects == (*EFFECTS.effects, PULSE)
    assert page.lanes.isEnabled()
    assert page.focusWidget() is page.lanes
    assert not page.document.stack.isClean()
    assert stored(folder) == EFFECTS
    page.undo()
    assert page.document.effects == EFFECTS


def test_a_window_offers_what_was_left_at_its_start(
    folder, left, make_window, wait_for
):
    window = make_window()
    assert "A ride" in window.recovery.text.text()
    window.recovery.accept_button.click()
    page = window.findChild(EditorPage)
    wait_for(lambda: page.loaded is not None)
    assert page.folder == folder
    assert page.document.effects.effects == (*EFFECTS.effects, PULSE)
    page.document.stack.setClean()
    page.reject()
    assert not window.recovery.isVisible()  # discarded with the page


@pytest.mark.parametrize("place", ["window", "editor"])
def test_a_refused_recovery_never_comes_back(
    folder, left, make_window, make_page, place
):
    shown = make_window() if place == "window" else make_page(folder)
    bar = shown.recovery if place == "window" else shown.unsaved.bar
    assert bar.isVisibleTo(shown)
    bar.refuse_button.click()
    assert not bar.isVisible()
    assert not left.exists()
    assert list(left_behind("effects")) == []
    if place == "editor":
        assert shown.document.effects == EFFECTS
        assert shown.lanes.isEnabled()
        shown.reject()
    page = make_page(folder)
    assert not page.unsaved.is_asking


def test_closing_without_an_answer_keeps_what_was_left(folder, left, make_page):
    page = make_page(folder)
    page.reject()
    assert not page.isVisible()
    assert make_page(folder).unsaved.is_asking


def test_effects_that_were_saved_later_stay_until_a_person_saves(
    folder, left, make_page
):
    newer = EffectList((Effect("mute", 1.0, 1.2),))
    set_effects(folder, newer)
    description = (folder / "sequence.json").read_bytes()
    page = make_page(folder)
    assert "changed since" in page.unsaved.bar.text.text()
    assert page.document.effects == newer
    page.unsaved.bar.accept_button.click()
    assert page.document.effects.effects == (*EFFECTS.effects, PULSE)
    page.undo()
    assert page.document.effects == newer
    assert stored(folder) == newer
    assert (folder / "sequence.json").read_bytes() == description


def test_saved_undone_and_discarded_edits_leave_nothing(folder, make_page, wait_for):
    page = make_page(folder)
    file = page.unsaved.file
    page.editing.add(PULSE, "Add")
    wait_for(file.exists)
    page.undo()
    assert not file.exists()
    page.redo()
    wait_for(file.exists)
    page.save()
    wait_for(page.document.stack.isClean)
    assert not file.exists()
    page.editing.add(PULSE, "Add")
    wait_for(file.exists)
    page.unsaved.end(is_discarded=True)
    assert not file.parent.exists()


def test_a_window_that_closes_over_the_editor_keeps_its_edits(folder, make_page):
    page = make_page(folder)
    page.editing.add(PULSE, "Add")
    page.close_jobs()
    [kept] = left_behind("effects")
    assert kept.content["effects"][-1]["parameters"] == {"amplitude": 2.0}


def test_a_document_that_is_edited_elsewhere_is_left_alone(folder, left, make_page):
    other = Recovery("effects", folder)
    assert other.open() is not None
    assert list(left_behind("effects")) == []
    page = make_page(folder)
    assert not page.unsaved.is_asking
    page.editing.add(EFFECTS.effects[0], "Add")
    page.unsaved.end(is_discarded=True)
    assert left.exists()
    other.close()


def test_damaged_work_is_told_of_once(folder, left, make_page):
    left.write_text(json.dumps({"kind": "effects", "place": 3}))
    page = make_page(folder)
    assert "kept.json" in page.messages.text()
    page.reject()
    assert not make_page(folder).messages.text()


def test_a_place_without_permission_is_told_of(
    folder, make_page, monkeypatch, tmp_path
):
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "file"))
    page = make_page(folder)
    assert "cannot be written" in page.messages.text()
    page.editing.add(PULSE, "Add")
    assert page.document.effect == PULSE


def test_work_is_renamed_into_place_whole_or_not_at_all(
    folder, make_page, wait_for, monkeypatch
):
    page = make_page(folder)
    file = page.unsaved.file
    page.editing.add(PULSE, "Add")
    wait_for(file.exists)
    first, number = file.read_bytes(), file.stat().st_ino
    page.editing.add(EFFECTS.effects[0], "Add")
    wait_for(lambda: file.stat().st_ino != number)
    assert json.loads(file.read_bytes())["content"]["effects"][-1]["kind"] == "gain"
    second = file.read_bytes()
    assert second != first
    write = Path.write_bytes

    def fill_the_disk(path, content):
        write(path, content[: len(content) // 2])
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", fill_the_disk)
    page.editing.add(PULSE, "Add")
    wait_for(lambda: "full" in page.messages.text())
    assert file.read_bytes() == second
    assert [one.name for one in file.parent.iterdir()] == [file.name]
