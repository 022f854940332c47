"""The choices of the window: force tracks and devices, by the engine's names."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QObject

from app.bridge.jobs import BackgroundLookup
from app.bridge.languages import translated
from app.player.health import device_name
from app.widgets.texts import local
from hapticplayer.devices import (
    NO_DEVICE,
    device_names,
    installed_devices,
    takes_motion,
)
from hapticplayer.devices.falcon.transport import list_falcons
from hapticplayer.model import PresetName
from hapticplayer.playback.replay import FROM_LOG
from hapticplayer.playback.source import FROM_FILE
from hapticplayer.rendering import (
    FEEDBACKS,
    ChosenFeedback,
    Parameter,
    ParameterKind,
    chosen_feedback,
    condition_named,
)

translate = QCoreApplication.translate


class Choice(NamedTuple):
    """An entry of a list; `refusal` is why it cannot be chosen, "" where it can."""

    name: str
    text: str
    refusal: str = ""


def feedback_words(chosen: ChosenFeedback) -> str:
    """Return a condition with its parameters for people."""
    condition = condition_named(chosen.name)
    if condition is None:
        return chosen.name
    given = ", ".join(
        f"{translated(one.text)} {_value_text(one, chosen.parameters[one.name])}"
        for one in condition.parameters
        if one.name in chosen.parameters
    )
    return translated(condition.text) + (f" ({given})" if given else "")


def _value_text(parameter: Parameter, value: float | str) -> str:
    """A value as people read it, with its unit."""
    if not isinstance(value, str):
        unit = parameter.range.unit if parameter.range else ""
        return local(f"{value:g}\u00a0{unit}").rstrip()
    is_clip = parameter.kind is ParameterKind.CLIP
    return Path(value).name if is_clip else preset_name(value)


def preset_name(name: str) -> str:
    """The title of a preset; an unknown one by its own name."""
    names = {
        PresetName.FAITHFUL.value: translate("RenderingFields", "Faithful"),
        PresetName.BALANCED.value: translate("RenderingFields", "Balanced"),
        PresetName.EQUAL.value: translate("RenderingFields", "Equal"),
    }
    return names.get(name, name)


def feedbacks(names: Iterable[str]) -> list[Choice]:
    """Return the force tracks of a source as choices."""
    texts = {
        **{one.name: translated(one.text) for one in FEEDBACKS},
        FROM_FILE: translate("Choices", "From file"),
        FROM_LOG: translate("Choices", "From a log"),
    }
    return [Choice(name, texts.get(name) or _title(name)) for name in names]


def _title(name: str) -> str:
    """The title of a source's track; one that was made has parameters."""
    return feedback_words(chosen_feedback(name)) if ":" in name else name


def devices(
    current: str = NO_DEVICE, falcons: Iterable[tuple[str, str]] = (("falcon", ""),)
) -> list[Choice]:
    """Return the devices that a person may choose, and the one that is chosen.

    `falcons` are name and serial number of each that is plugged in.
    """
    found: list[Choice] = []
    for name in device_names():
        if name == "falcon":
            text = device_name(name)
            found += [Choice(n, f"{text} {serial}".rstrip()) for n, serial in falcons]
        elif not (_is_hidden(name) or takes_motion(name)) or name == current:
            found.append(Choice(name, device_name(name)))
    if current not in [choice.name for choice in found]:  # one that is not plugged in
        found.insert(0, Choice(current, device_name(current)))
    return found


def _is_hidden(name: str) -> bool:
    entry = installed_devices().get(name)
    return entry is not None and entry.is_for_developers


class PluggedFalcons(BackgroundLookup):
    """Finds the serial numbers, "" for those that may not be read."""

    def __init__(
        self,
        find: Callable[[], list[str]] | None = None,
        parent: QObject | None = None,
    ) -> None:
        find = find or _serials
        super().__init__(lambda _progress: find(), parent)

    def falcons(self) -> list[tuple[str, str]]:
        """Return (the engine's name, the serial number) of each Falcon to choose.

        The only one, or none, is `falcon`; its number may be "".
        """
        numbers = sorted(filter(None, self.found))
        if len(numbers) > 1:
            return [(f"falcon:{number}", number) for number in numbers]
        return [("falcon", "".join(numbers))]


def _serials() -> list[str]:
    return [found.serial for found in list_falcons()]
