"""What can be chosen: force tracks and devices, by the engine's names."""

from collections.abc import Iterable
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.player.health import device_name
from hapticplayer.cli import DEVICE_NAMES
from hapticplayer.devices import DEVICES, find_device
from hapticplayer.errors import DeviceError
from hapticplayer.model import Feedback
from hapticplayer.playback.haptic_link import NO_DEVICE
from hapticplayer.playback.replay import FROM_LOG
from hapticplayer.playback.source import FROM_FILE

translate = QCoreApplication.translate


class Choice(NamedTuple):
    """An entry of a list.

    Attributes:
        name: the engine's.
        text: for people.
        refusal: why it cannot be chosen, "" where it can.
    """

    name: str
    text: str
    refusal: str = ""


def feedbacks(names: Iterable[str]) -> list[Choice]:
    """Return the force tracks of a source as choices."""
    texts = {
        Feedback.REALISTIC.value: translate("Choices", "Realistic"),
        Feedback.NONE.value: translate("Choices", "None"),
        Feedback.RANDOM.value: translate("Choices", "Random"),
        FROM_FILE: translate("Choices", "From file"),
        FROM_LOG: translate("Choices", "From a log"),
    }
    return [Choice(name, texts.get(name, name)) for name in names]


def devices() -> list[Choice]:
    """Return all devices, also those that this version cannot drive yet."""
    return [Choice(name, device_name(name), _refusal(name)) for name in DEVICE_NAMES]


def _refusal(name: str) -> str:
    if name == NO_DEVICE or name in DEVICES:
        return ""
    try:
        find_device(name)
    except DeviceError as problem:
        return str(problem)
    return ""
