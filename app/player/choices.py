"""What can be chosen: force tracks and devices, by the engine's names."""

from collections.abc import Iterable
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.player.health import device_name
from hapticplayer.devices import NO_DEVICE, device_names, installed_devices
from hapticplayer.playback.replay import FROM_LOG
from hapticplayer.playback.source import FROM_FILE
from hapticplayer.rendering import FEEDBACKS

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
        **{one.name: translated(one.text) for one in FEEDBACKS},
        FROM_FILE: translate("Choices", "From file"),
        FROM_LOG: translate("Choices", "From a log"),
    }
    return [Choice(name, texts.get(name, name)) for name in names]


def devices(
    current: str = NO_DEVICE, falcons: Iterable[tuple[str, str]] = (("falcon", ""),)
) -> list[Choice]:
    """Return the devices that a person may choose, and the one that is chosen.

    Args:
        current: the one that is chosen.
        falcons: name and serial number of each that is plugged in.
    """
    found: list[Choice] = []
    for name in device_names():
        if name == "falcon":
            text = device_name(name)
            found += [Choice(n, f"{text} {serial}".rstrip()) for n, serial in falcons]
        elif not _is_hidden(name) or name == current:
            found.append(Choice(name, device_name(name)))
    if current not in [choice.name for choice in found]:  # one that is not plugged in
        found.insert(0, Choice(current, device_name(current)))
    return found


def _is_hidden(name: str) -> bool:
    entry = installed_devices().get(name)
    return entry is not None and entry.is_for_developers
