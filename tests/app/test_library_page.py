"""The library page over a folder of sequences, and what it changes in them."""

import json
import shutil

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox

from app.experimenter import library_details
from app.experimenter.library_details import read_filter, write_filters
from app.experimenter.library_page import LibraryPage
from app.player.question import Question
from hapticplayer.playback.phases import Phase
from hapticplayer.sequence import open_sequence, verify_sequence
from hapticplayer.sequence.editing import rename_sequence
from hapticplayer.sequence.force_formats import force_formats, read_force
from tests.needed_extras import needs


@pytest.fixture
def library(sequence, tmp_path, monkeypatch):
    """Two sequences, one damaged folder, and one that is none."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    (tmp_path / "data").mkdir()
    home = tmp_path / "library"
    for name, title in (("a", "Bicycle in the park"), ("b", "Horse at a gallop")):
        shutil.copytree(sequence, home / name)
        rename_sequence(home / name, title)
    (home / "c").mkdir()
    (home / "c" / "sequence.json").write_text("{}")
    (home / "holidays").mkdir()
    return home


@pytest.fixture
def page(application, qtbot, library):
    made = LibraryPage(library)
    qtbot.addWidget(made)
    made.show()
    yield made
    made.close_jobs()


def titles(page) -> list[str]:
    shown = (page.list.item(row) for row in range(page.list.count()))
    return [item.text().split("\n")[0] for item in shown if not item.isHidden()]


def test_the_library_shows_titles_durations_and_frames(page, wait_for):
    assert titles(page) == ["Bicycle in the park", "c", "Horse at a gallop"]
    assert "00:02.0" in page.list.item(0).text()
    empty = page.list.item(0).icon().cacheKey()
    wait_for(lambda: page.list.item(0).icon().cacheKey() != empty)
    image = page.list.item(0).icon().pixmap(72).toImage()
    grey = image.pixelColor(image.width() // 2, image.height() // 2).red()
    assert grey == pytest.approx(20 + 215 / 3, abs=12)  # a third into the fade


def test_search_takes_all_words(page):
    page.search.setText("gallop HORSE")
    assert titles(page) == ["Horse at a gallop"]
    page.search.setText("horse park")
    assert titles(page) == []
    assert not page.buttons["open"].isEnabled()


def test_enter_opens_and_a_damaged_one_is_not_opened(page, qtbot):
    page.list.setCurrentRow(1)
    assert not page.buttons["open"].isEnabled()
    page.list.setCurrentRow(0)
    with qtbot.waitSignal(page.open_wanted) as wanted:
        qtbot.keyClick(page.list, Qt.Key.Key_Return)
    assert wanted.args[0].name == "a"


def test_why_a_damaged_one_does_not_open_is_not_greyed(page):
    page.list.setCurrentRow(1)
    assert "cannot be played" in page.details.report.toPlainText()
    assert page.details.report.isEnabled()
    assert not page.details.tracks.isEnabled()
    assert not page.details.rendering.isEnabled()


def test_deleting_asks_and_can_be_undone(page, library, monkeypatch):
    page.list.setCurrentRow(0)
    asked = []

    def no(box):
        asked.append(box.text())
        return int(QMessageBox.StandardButton.Cancel)

    monkeypatch.setattr(QMessageBox, "exec", no)
    page.buttons["delete"].click()
    assert "Bicycle" in asked[0]
    assert (library / "a").exists()
    page.delete(page.chosen())
    assert not (library / "a").exists()
    assert titles(page) == ["c", "Horse at a gallop"]
    page.undo.click()
    assert titles(page)[0] == "Bicycle in the park"
    verify_sequence(library / "a")


def test_verifying_tells_of_a_changed_byte(page, library, wait_for):
    page.list.setCurrentRow(0)
    page.buttons["check"].click()
    wait_for(lambda: "intact" in page.status.text())
    clip = library / "a" / "clip.mp4"
    content = bytearray(clip.read_bytes())
    content[-5] ^= 1
    clip.write_bytes(content)
    page.buttons["check"].click()
    wait_for(lambda: "has changed" in page.status.text())


def test_a_track_is_added_renamed_and_removed(
    page, library, wait_for, tmp_path, monkeypatch
):
    csv = tmp_path / "my track.csv"
    csv.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n0.5,0,1.5,0\n1.5,0,0,0\n")
    page.list.setCurrentRow(0)
    page.details.add_force(csv)
    wait_for(lambda: page.details.tracks.rowCount() == 3)
    row = [page.details.tracks.item(2, column).text() for column in range(4)]
    assert row[:2] == ["my track", "1.50 N"]
    assert row[3].endswith(" %")
    track = open_sequence(library / "a").tracks["my track"]
    np.testing.assert_allclose(track.at(np.array([0.2, 0.7, 1.7]))[:, 1], (0, 1.5, 0))
    page.details.tracks.selectRow(2)
    monkeypatch.setattr(library_details, "ask_text", lambda *_: " Gentle ")
    page.details.rename.click()
    assert page.details.tracks.item(2, 0).text() == "Gentle"
    page.details.tracks.selectRow(2)
    page.details.remove.click()
    assert page.details.tracks.rowCount() == 2
    verify_sequence(library / "a")
    assert len(list((library / "a").glob("force_*"))) == 2


def test_a_sequence_is_opened_from_the_window(window, library, settings, wait_for):
    settings.keep("library", str(library))
    window.commands.library.trigger()
    page = window.findChild(LibraryPage)
    page.list.setCurrentRow(2)
    page.buttons["open"].click()
    wait_for(lambda: window.player.snapshot().phase is Phase.PLAYING)
    assert window.player.snapshot().source.path == library / "b"


def test_an_unplayable_sequence_is_not_called_doubtful(page):
    page.list.setCurrentRow(1)  # the damaged folder
    shown = page.details.report.toPlainText()
    assert "cannot be played" in shown
    assert "Doubtful" not in shown
    assert str(page.library) not in page.list.item(1).text()


def test_an_empty_list_says_why_and_nothing_about_quality(page, library):
    page.search.setText("zebra")
    assert page.nothing.text() == "No matches"
    assert page.details.report.toPlainText() == ""
    page.search.clear()
    assert page.nothing.text() == ""
    for folder in library.iterdir():
        shutil.rmtree(folder)
    page.refresh()
    assert "Import a recording" in page.nothing.text()


def perception(modality):
    """Half of its largest force for a second, upwards."""
    frames = [
        {"relative_position": at_ms, "amplitude_modulation": 0.5} for at_ms in (0, 1000)
    ]
    effect = {"effect_type": "Basis", "position": 0, "keyframes": frames}
    band = {"band_type": "Curve", "curve_type": "Linear", "effects": [effect]}
    channel = {"bands": [band], "direction": {"Y": 1}}
    device = {"id": 0, "maximum_amplitude": 4.0}
    found = {"perception_modality": modality, "channels": [channel]}
    return {**found, "reference_devices": [device]}


def asked_about(page, tmp_path, wait_for, *modalities):
    """The question about a file of the published encoder that is added."""
    path = tmp_path / "of the encoder.hjif"
    perceptions = [perception(one) for one in modalities]
    path.write_text(json.dumps({"perceptions": perceptions}))
    page.list.setCurrentRow(0)
    page.details.add_force(path)
    wait_for(lambda: page.details.findChildren(Question) != [])
    (question,) = page.details.findChildren(Question)
    assert path.name in question.text.text()
    assert page.details.tracks.rowCount() == 2
    return question


@needs("formats")
@pytest.mark.parametrize(("answer", "peak"), [(0, "2.00 N"), (1, "0.50 N")])
def test_the_window_asks_what_other_haptics_are(page, wait_for, tmp_path, answer, peak):
    question = asked_about(page, tmp_path, wait_for, "Other")
    assert len(question.answers) == 2
    question.answers[answer].click()
    wait_for(lambda: page.details.tracks.rowCount() == 3)
    assert page.details.tracks.item(2, 1).text() == peak
    assert "Other was taken as" in page.details.notes.text()


@needs("formats")
def test_other_haptics_can_be_left_out_of_a_track(page, wait_for, tmp_path):
    question = asked_about(page, tmp_path, wait_for, "Force", "Other")
    assert len(question.answers) == 3
    question.answers[2].click()
    wait_for(lambda: page.details.tracks.rowCount() == 3)
    assert page.details.tracks.item(2, 1).text() == "2.00 N"
    assert "not read: perception Other (1)" in page.details.notes.text()


@needs("formats")
def test_a_track_that_is_not_decided_about_is_not_added(page, wait_for, tmp_path):
    question = asked_about(page, tmp_path, wait_for, "Other")
    question.no.click()
    wait_for(lambda: page.details.findChildren(Question) == [])
    assert page.details.tracks.rowCount() == 2
    assert not page.jobs.is_busy


@needs("formats")
def test_a_track_is_exported_and_its_cost_is_told(page, library, wait_for, tmp_path):
    page.list.setCurrentRow(0)
    page.details.tracks.selectRow(0)
    assert page.details.export.isEnabled()
    (form,) = (one for one in write_filters().values() if one.name == "hjif")
    page.details.export_force(tmp_path / "for others", form)
    wait_for(lambda: "kbit/s" in page.details.notes.text())
    assert page.details.notes.text().startswith("Saved: ")
    assert "\nIt keeps the force in newtons" in page.details.notes.text()
    assert "largest 0" in page.details.notes.text()
    assert "left out: nothing" in page.details.notes.text()
    back = read_force(tmp_path / "for others.hjif").track
    track = open_sequence(library / "a").tracks["realistic"]
    at_s = np.arange(0.0, 0.9, 0.001)
    assert np.abs(track.at(at_s) - back.at(at_s)).max() <= 0.0101


def test_every_format_is_offered_in_the_dialogs():
    for name, form in force_formats().items():
        assert (f"*{form.suffix}" in read_filter()) == (form.read is not None), name
        assert (form in write_filters().values()) == (form.write is not None), name
    begins = [line.partition(" \u2013 ")[0] for line in write_filters()]
    assert {"CSV", "HJIF", "Funscript", "MPEG-V"} <= set(begins)
