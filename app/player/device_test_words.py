"""What is said before, during and after the test of a device."""

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.player.device_form import entry_of, output_text
from app.player.force_words import homing_text, step_text, strength_text
from app.player.health import stop_reason
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of, hold_text
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.model.device import DeviceCapabilities, Signal
from hapticplayer.playback.device_test import DevicePart, DeviceTest, Step, parts_of
from hapticplayer.rendering.demonstration import DemonstrationStep

translate = QCoreApplication.translate


def question_text(name: str) -> str:
    """The announcement of a test, and the preparation; raises DeviceError."""
    record, parts = find_device(name).capabilities, parts_of(name)
    hold = translated(hold_text(guide_of(entry_of(name)), record))
    how_to_stop = translate("DeviceTestWords", "Esc or STOP ends it immediately.")
    what = _what(record, parts).format(
        seconds=round(sum(part.end_s for part in parts)),
        strength=strength_text(record, _largest_n(parts[0])),
        channels=", ".join(part.label for part in parts),
    )
    return f"{output_text(name)}\n\n{what}\n\n{hold} {how_to_stop}"


def _what(record: DeviceCapabilities, parts: tuple[DevicePart, ...]) -> str:
    if record.signal is Signal.MOTION:
        return translate(
            "DeviceTestWords",
            "It will move gently for {seconds} s, along and about one axis after the "
            "other.",
        )
    if len(parts) > 1:
        return translate(
            "DeviceTestWords",
            "It will vibrate on the channels {channels}, one after the other, for "
            "{seconds} s, with up to {strength}.",
        )
    if record.axes == 0:
        return translate(
            "DeviceTestWords",
            "It will vibrate for {seconds} s, with up to {strength}.",
        )
    if record.axes == 1:
        return translate(
            "DeviceTestWords",
            "It will turn or pull to one side and to the other for {seconds} s, with "
            "up to {strength}.",
        )
    return translate(
        "DeviceTestWords",
        "It will push gently in each direction for {seconds} s, with up to {strength}.",
    )


def _largest_n(part: DevicePart) -> float:
    steps = [one for one in part.steps if isinstance(one, DemonstrationStep)]
    return max((one.strength_n for one in steps), default=0.0)


def state_text(test: DeviceTest, record: DeviceCapabilities) -> str:
    """The step that runs now, in words."""
    step = test.step
    if step is None:
        if test.cause is Cause.NOT_HOMED and record.has_newtons:
            return homing_text()
        if test.done_s > test.part.steps[0].begin_s:
            return translate("DeviceTestWords", "Pause")
        return translate("DeviceTestWords", "Starting")
    text = _step_text(step, record)
    if test.part.label:
        channel = translate("DeviceTestWords", "Channel {label}: {what}")
        return channel.format(label=test.part.label, what=text)
    return text


def _step_text(step: Step, record: DeviceCapabilities) -> str:
    if not isinstance(step, DemonstrationStep):
        return _axis_text(step.axis)
    return step_text(step, record)


def _axis_text(axis: str) -> str:
    texts = {
        "surge": translate("DeviceTestWords", "Surge: forwards and back"),
        "sway": translate("DeviceTestWords", "Sway: to the right and back"),
        "heave": translate("DeviceTestWords", "Heave: up and back"),
        "roll": translate("DeviceTestWords", "Roll: leaning to the right and back"),
        "pitch": translate("DeviceTestWords", "Pitch: nose up and back"),
        "yaw": translate("DeviceTestWords", "Yaw: turning to the left and back"),
    }
    return texts.get(axis, axis)


def verdict_text(test: DeviceTest, finished: str = "") -> str:
    """Return how a test has ended; `finished` is said of one that was whole."""
    if test.problem:
        return translated(test.problem)
    if test.was_stopped:
        return translate("DeviceTestWords", "Stopped.")
    if test.mode is Mode.TRIPPED:
        return stop_reason(test.cause)
    return finished or translate("DeviceTestWords", "Test finished.")
