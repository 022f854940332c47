"""What can be chosen: force tracks and devices, by the engine's names."""

from collections.abc import Iterable
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.player.health import device_name
from hapticplayer.cli import DEVICE_NAMES
from hapticplayer.devices import DEVICES
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


def devices(current: str = NO_DEVICE) -> list[Choice]:
    """Return the devices that a person may choose, and the one that is chosen."""
    names = [name for name in DEVICE_NAMES if not _is_hidden(name) or name == current]
    if current not in names:  # one of several, by its number
        names.insert(0, current)
    return [Choice(name, device_name(name)) for name in names]


def _is_hidden(name: str) -> bool:
    return name in DEVICES and DEVICES[name].is_for_developers
