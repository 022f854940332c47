"""The latency of a device on its set-up page: its source, kept at once, compensated."""

import pytest

from app.bridge.settings import DEVICE, Settings, keep_latency, latencies_of
from app.player.latency_field import LatencyField
from app.player.setup_page import SetupPage
from tests.needed_extras import needs


@pytest.fixture
def field(application, settings, qtbot):
    made = LatencyField(settings, application)
    for widget in (made.number, made.source, made.caption):
        qtbot.addWidget(widget)
    made.changes = []
    made.changed.connect(lambda: made.changes.append(made.number.value()))
    return made


def shown(field):
    return field.number.value(), field.source.text()


def enter(field, value_ms):
    field.number.setValue(value_ms)
    field.number.editingFinished.emit()


@needs("wheels")
def test_an_entered_latency_is_kept_and_announced_at_once(field, tmp_path):
    field.follow("rumble")
    assert shown(field) == (15.0, "typical value, not measured")
    field.number.editingFinished.emit()  # nothing was entered
    assert field.changes == []
    enter(field, 25.0)
    assert shown(field) == (25.0, "entered")
    assert field.changes == [25.0]
    again = latencies_of(Settings(tmp_path / "window.json"), "")
    assert again.of_device("rumble").latency_s == pytest.approx(0.025)
    enter(field, 0.0)
    assert shown(field) == (0.0, "entered")


@needs("wheels")
def test_an_entered_value_takes_the_place_of_a_measured_one(field, settings):
    keep_latency(settings, DEVICE, "rumble", 40.0)
    field.follow("rumble")
    assert shown(field) == (40.0, "measured")
    enter(field, 30.0)
    assert shown(field) == (30.0, "entered")
    keep_latency(settings, DEVICE, "rumble", 50.0)  # measured again, by tapping
    field.follow("rumble")
    assert shown(field) == (50.0, "measured")


def test_a_test_measures_what_nobody_has_entered(field):
    field.follow("simulated")
    field.take(0.0023)
    assert shown(field) == (2.3, "measured")
    enter(field, 5.0)
    field.take(0.001)
    assert shown(field) == (5.0, "entered")


@needs("rigs")
def test_a_latency_of_the_settings_is_not_changed_here(field):
    field.follow("rig:outsim,latency_ms=40")
    assert shown(field) == (40.0, "entered in its settings")
    assert not field.number.isEnabled()
    field.follow("shaker")
    assert shown(field) == (80.0, "kept by the device's clock")
    assert field.number.isEnabled()


@needs("wheels")
def test_a_latency_entered_on_the_page_is_compensated(make_window, wait_for):
    window = make_window("none")
    window.player.set_outputs(["rumble"])
    (output,) = window.player.snapshot().outputs
    assert (output.latency_s, output.latency_source.value) == (0.015, "assumed")
    window.commands.set_up_device.trigger()
    page = window.findChild(SetupPage)
    page.device.setCurrentIndex(page.device.findData("rumble"))
    page.device.activated.emit(page.device.currentIndex())
    enter(page.latency, 45.0)
    (output,) = window.player.snapshot().outputs
    assert output.latency_s == pytest.approx(0.045)
    assert output.latency_source.value == "entered"
    page.reject()
    wait_for(lambda: not page.isVisible())
