"""The rendering dialog: what is chosen, what it would change, and what is written."""

import shutil
import threading
from dataclasses import replace

import hearing
import numpy as np
import pytest

from app.bridge.jobs import in_child
from app.experimenter import rendering_page
from app.experimenter.library_page import LibraryPage
from app.experimenter.rendering_fields import EACH, FIT, ONE, OTHER, Chosen
from app.experimenter.rendering_page import RenderingPage
from app.player.dialogs import Dialogs
from hapticplayer.errors import HapticPlayerError
from hapticplayer.model import Mapping
from hapticplayer.rendering import LEVER_ARMS_M
from hapticplayer.sequence import open_sequence, verify_sequence
from hapticplayer.sequence.editing import set_mapping

ROTATION = "0.6,0.8,0,0,0,1,0.8,-0.6,0"
MAPPINGS = {
    "default": Mapping(),
    "axes": Mapping(gain_n_per_mps2=(0.123456789, 0.2, 0.3)),
    "all": Mapping(
        np.array([[0.6, 0.8, 0.0], [0.0, 0.0, 1.0], [0.8, -0.6, 0.0]]),
        1 / 3,
        4.0,
        1.5,
        (0.1, 1 / 7, -0.3),
    ),
}


@pytest.fixture
def ride(sequence, tmp_path):
    """A sequence of one's own."""
    return shutil.copytree(sequence, tmp_path / "ride")


@pytest.fixture
def make_page(application, qtbot, tmp_path, wait_for):
    made = []

    def make(folder):
        page = RenderingPage(folder, "A ride", tmp_path / "library")
        made.append(page)
        qtbot.addWidget(page)
        page.show()
        wait_for(lambda: not page.jobs.is_busy)
        return page

    yield make
    for page in made:
        page.close_jobs()


@pytest.fixture
def page(make_page, ride):
    return make_page(ride)


def choose(combo, value):
    combo.setCurrentIndex(combo.findData(value))


def shown(page, key):
    return [label.text() for label in page.figures[key]]


@pytest.mark.parametrize("name", MAPPINGS)
def test_the_rendering_page_shows_a_mapping_and_changes_nothing(make_page, ride, name):
    set_mapping(ride, MAPPINGS[name], preset="equal")
    page = make_page(ride)
    chosen, mapping = page.fields.chosen(), open_sequence(ride).mapping
    assert (chosen.preset, chosen.fits_gain) == ("equal", False)
    assert np.array_equal(chosen.mapping.axes, mapping.axes)
    for field in ("gain_n_per_mps2", "force_limit_n", "soft_knee_n", "lever_arm_m"):
        assert getattr(chosen.mapping, field) == getattr(mapping, field), field
    assert page.before is page.after
    assert page.focusWidget() is page.fields.preset
    for key in page.figures:
        first, second = shown(page, key)
        assert first == second != "\u2013"


def test_every_preset_has_its_sentence(page):
    texts = set()
    for row in range(page.fields.preset.count()):
        page.fields.preset.setCurrentIndex(row)
        texts.add(page.fields.preset_text.text())
    assert len(texts) == 3
    assert any("every participant" in text for text in texts)


def test_a_choice_is_predicted_beside_what_is_there(page, ride, wait_for, monkeypatch):
    before, may_go_on = open_sequence(ride), threading.Event()
    before_px = page.picture.geometry()

    def held(*arguments, **options):
        may_go_on.wait(60.0)
        return in_child(*arguments, **options)

    monkeypatch.setattr(rendering_page, "in_child", held)
    page.fields.gain.setValue(0.2)
    assert shown(page, "peak")[1] == "\u2013"
    wait_for(page.progress.isVisible)
    assert page.picture.geometry() == before_px  # nothing jumps
    may_go_on.set()
    wait_for(lambda: page.after is not None)
    peak_n = before.tracks["realistic"].peak_n()
    assert shown(page, "peak") == [f"{peak_n:.2f} N", f"{peak_n / 2:.2f} N"]
    said = hearing.value(page.picture)
    assert f"{peak_n:.2f} N" in said
    assert f"{peak_n / 2:.2f} N" in said
    assert page.picture.before is page.before.curves
    assert page.picture.after is page.after.curves
    assert open_sequence(ride).mapping.gain_n_per_mps2 == 0.4


def test_a_fitted_gain_is_offered_and_never_the_default(page, wait_for):
    assert page.fields.gain_kind.currentData() == ONE
    offer = page.before.fitted_gain_n_per_mps2
    assert f"{offer:.3g} N per m/s\u00b2" in page.fields.gain_text.text()
    choose(page.fields.gain_kind, FIT)
    assert page.fields.chosen().fits_gain
    wait_for(lambda: page.after is not None)
    assert page.after.mapping.gain_n_per_mps2 == pytest.approx(offer)


def test_gains_of_the_axes_begin_with_the_one_of_all(page):
    page.fields.gain.setValue(0.3)
    choose(page.fields.gain_kind, EACH)
    assert page.fields.gains.isVisible()
    assert not page.fields.gain.isVisible()
    assert page.fields.gains.numbers() == (0.3, 0.3, 0.3)
    page.fields.gains.boxes[1].setValue(0.6)
    assert page.fields.chosen().mapping.gain_n_per_mps2 == (0.3, 0.6, 0.3)


@pytest.mark.parametrize("point", LEVER_ARMS_M)
def test_the_felt_point_is_an_example_or_anywhere(page, point):
    choose(page.fields.lever_arm, point)
    assert page.fields.chosen().mapping.lever_arm_m == LEVER_ARMS_M[point]
    choose(page.fields.lever_arm, OTHER)
    assert page.fields.point.numbers() == LEVER_ARMS_M[point]
    page.fields.point.boxes[2].setValue(1.0)
    assert page.fields.chosen().mapping.lever_arm_m == (*LEVER_ARMS_M[point][:2], 1.0)


def test_axes_are_typed_and_wrong_ones_explained(page, wait_for):
    choose(page.fields.device, "behind")
    choose(page.fields.device, OTHER)
    assert page.fields.axes.text() == "-x,z,y"
    page.fields.axes.setText("x,y")
    wait_for(lambda: "not three axes" in page.status.text())
    page.replace.click()
    assert "not three axes" in page.status.text()
    page.fields.axes.setText(ROTATION)
    wait_for(lambda: page.after is not None)
    assert page.status.text() == ""
    np.testing.assert_allclose(page.after.mapping.axes[0], (0.6, 0.8, 0.0), atol=1e-9)


def test_in_place_it_is_what_was_previewed(page, ride, qtbot, wait_for):
    choose(page.fields.preset, "faithful")
    page.fields.gain.setValue(1.2)
    page.fields.knee.setChecked(True)
    wait_for(lambda: page.after is not None)
    figures = page.after.figures
    with qtbot.waitSignal(page.changed) as changed:
        page.replace.click()
    assert changed.args == [ride]
    wait_for(lambda: not page.jobs.is_busy)
    assert "rendered again" in page.status.text()
    assert page.before.figures == figures
    after = open_sequence(ride)
    assert after.mapping.gain_n_per_mps2 == 1.2
    assert after.mapping.soft_knee_n == 2.0
    assert after.tracks["realistic"].provenance["preset"] == "faithful"
    verify_sequence(ride)


def test_a_new_sequence_leaves_the_old_one(page, ride, qtbot, monkeypatch, tmp_path):
    before = {path.name: path.read_bytes() for path in ride.iterdir()}
    asked = []

    def ask(_parent, _title, _label, text):
        asked.append(text)
        return f"{text} / 2"

    monkeypatch.setattr(rendering_page, "ask_text", ask)
    choose(page.fields.preset, "equal")
    with qtbot.waitSignal(page.made) as made:
        page.copy.click()
    assert asked == ["A ride (Equal)"]
    (folder,) = made.args
    assert folder.parent == tmp_path / "library"
    sequence = open_sequence(folder)
    assert sequence.title == "A ride (Equal) / 2"
    assert sequence.tracks["realistic"].provenance["preset"] == "equal"
    verify_sequence(folder)
    assert {path.name: path.read_bytes() for path in ride.iterdir()} == before
    assert str(folder) in page.status.text()


def test_cancel_and_failure_leave_all_as_it_was(page, ride, wait_for, monkeypatch):
    before = {path.name: path.read_bytes() for path in ride.iterdir()}
    is_cancelled = threading.Event()

    def slow(*_arguments, progress, **_options):
        is_cancelled.wait(30.0)
        progress(0.5, "predicting excursions")

    monkeypatch.setattr(rendering_page, "in_child", slow)
    page.replace.click()
    wait_for(page.progress.stop.isVisible)
    assert not page.area.isEnabled()
    page.progress.stop.click()
    is_cancelled.set()
    wait_for(lambda: not page.jobs.is_busy)
    assert page.replace.isEnabled()

    def full(*_arguments, **_options):
        raise HapticPlayerError("the disk is full")

    monkeypatch.setattr(rendering_page, "in_child", full)
    page.replace.click()
    wait_for(lambda: "disk is full" in page.status.text())
    assert page.replace.isEnabled()
    assert {path.name: path.read_bytes() for path in ride.iterdir()} == before


def test_a_damaged_sequence_is_told_of(make_page, tmp_path):
    page = make_page(tmp_path / "nowhere")
    assert "sequence.json" in page.status.text()
    assert not page.area.isEnabled()
    assert not page.copy.isEnabled()
    assert not page.replace.isEnabled()


def test_closing_stops_the_work(page, monkeypatch, wait_for):
    stopped = threading.Event()

    def endless(*_arguments, progress, **_options):
        try:
            while True:
                progress(0.1, "")
        finally:
            stopped.set()

    monkeypatch.setattr(rendering_page, "in_child", endless)
    page.fields.gain.setValue(0.1)
    wait_for(lambda: page.jobs.is_busy)
    page.reject()
    assert not page.isVisible()
    wait_for(stopped.is_set)
    wait_for(lambda: not page.jobs.is_busy)


def test_the_library_renders_and_lists_again(
    application, qtbot, ride, tmp_path, wait_for
):
    library = LibraryPage(tmp_path)
    qtbot.addWidget(library)
    library.show()
    library.list.setCurrentRow(0)
    assert library.details.rendered.text() == "Balanced; gain 0.4 N per m/s\u00b2"
    library.details.rendering.click()
    page = library.findChild(RenderingPage)
    wait_for(lambda: page.before is not None)
    gains = replace(page.before.mapping, gain_n_per_mps2=(0.1, 0.2, 0.3))
    page.fields.show_chosen(Chosen(gains, False, "faithful"))
    page.replace.click()
    wait_for(lambda: "Faithful" in library.details.rendered.text())
    assert "each axis" in library.details.rendered.text()
    library.close_jobs()


def test_the_menu_renders_what_is_open_and_plays_it(window, ride, wait_for):
    window.session.open_path(ride)
    wait_for(lambda: window.player.snapshot().source is not None)
    wait_for(window.commands.rendering.isEnabled)
    window.commands.rendering.trigger()
    page = window.findChild(RenderingPage)
    wait_for(lambda: page.before is not None)
    before = window.player.snapshot().source
    page.fields.gain.setValue(0.2)
    page.replace.click()
    wait_for(lambda: window.player.snapshot().source is not before)
    source = window.player.snapshot().source
    half = before.tracks["realistic"].peak_n() / 2
    assert source.tracks["realistic"].peak_n() == pytest.approx(half)
    window.dialogs.close()


def test_a_video_without_force_cannot_be_rendered(window, clip, monkeypatch, wait_for):
    said = []
    monkeypatch.setattr(
        window.session.gateway, "report", lambda one, _over: said.append(one)
    )
    window.session.open_path(clip)
    wait_for(lambda: window.player.snapshot().source is not None)
    said.clear()
    Dialogs.rendering(window.dialogs)
    (problem,) = said
    assert "import the video first" in str(problem)
