"""Choosing any kind of device: a list, and a line for its address or settings."""

from collections.abc import Iterable

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QComboBox, QLabel, QLineEdit, QWidget

from app.bridge.languages import translated
from app.player import choices
from app.player.choices import Choice
from app.player.health import device_name
from app.widgets.layout import captioned
from app.widgets.texts import titled
from hapticplayer.devices import (
    NO_DEVICE,
    DeviceEntry,
    find_device,
    installed_devices,
    takes_motion,
)
from hapticplayer.devices.guides import guide_of
from hapticplayer.errors import DeviceError


def entry_of(name: str) -> DeviceEntry:
    """Return the registry's entry of a kind, whatever follows it; not for "none"."""
    return installed_devices()[name.partition(":")[0]]


def output_text(name: str) -> str:
    """Return a device's name for people, with what was chosen of it."""
    kind, _, chosen = name.partition(":")
    if not takes_motion(kind):
        return device_name(name).replace(",", ", ")
    variant, *settings = chosen.split(",")
    title, _ = guide_of(entry_of(kind)).variants.get(variant, (variant, ""))
    return titled(translated(entry_of(kind).label), ", ".join([title, *settings]))


def takes_settings(name: str) -> bool:
    """Whether a person enters what follows a kind and a colon.

    Falcons are found by themselves, each with its number.
    """
    entry = entry_of(name)
    return bool(entry.options) and not entry.direct


def variants() -> list[Choice]:
    """Return the kinds of those outputs that have several, such as a rig's formats."""
    return [
        Choice(f"{entry.name}:{variant}", output_text(f"{entry.name}:{variant}"))
        for entry in installed_devices().values()
        for variant in guide_of(entry).variants
    ]


def kinds(
    current: str = NO_DEVICE, falcons: Iterable[tuple[str, str]] = (("falcon", ""),)
) -> list[Choice]:
    """Return everything that can be chosen, by what precedes its settings."""
    kind = parted(current)[0]
    held = NO_DEVICE if takes_motion(kind) else kind
    found = choices.devices(held, falcons)
    return [*(one for one in found if one.name != NO_DEVICE), *variants()]


def parted(name: str) -> tuple[str, str]:
    """Return the name of a choice, and what was entered beside it."""
    kind, _, chosen = name.partition(":")
    if kind == NO_DEVICE or not takes_settings(kind):
        return name, ""
    known = guide_of(entry_of(kind)).variants
    if not known:
        return kind, chosen
    variant, _, rest = chosen.partition(",")
    return f"{kind}:{variant or next(iter(known))}", rest


def put_together(choice: str, text: str) -> str:
    """Return the device's name of a choice and what was entered beside it."""
    if not text:
        return choice
    return f"{choice},{text}" if ":" in choice else f"{choice}:{text}"


def example_of(choice: str) -> str:
    """The hint for the field beside a choice, "" for no field."""
    kind, _, variant = choice.partition(":")
    guide = guide_of(entry_of(kind))
    return guide.variants.get(variant, ("", guide.example))[1]


def problem_of(name: str) -> DeviceError | None:
    """The fault of a name that was put together, None for none."""
    try:
        find_device(name)
    except DeviceError as problem:
        return problem
    return None


class DeviceForm(QObject):
    """The list and the line; `changed` when a person has chosen or entered something."""

    changed = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.kind, self.settings = QComboBox(), QLineEdit()
        self.kind.setAccessibleName(self.tr("Device"))
        self.caption: QLabel
        self.caption, _ = captioned(self.tr("Address or settings"), self.settings)
        self.kind.activated.connect(self._on_kind)
        self.settings.editingFinished.connect(self._on_entered)
        self._entered = ""

    @property
    def name(self) -> str:
        """The engine's name of what is chosen."""
        return put_together(str(self.kind.currentData()), self._entered)

    def fill(
        self, current: str, falcons: Iterable[tuple[str, str]] = (("falcon", ""),)
    ) -> None:
        """List everything that can be chosen, and choose one."""
        choice, self._entered = parted(current)
        self.kind.clear()
        for one in kinds(current, falcons):
            self.kind.addItem(one.text, one.name)
        self.kind.setCurrentIndex(max(0, self.kind.findData(choice)))
        self.settings.setText(self._entered)
        self._show()

    def _on_kind(self, _row: int) -> None:
        self._entered = ""
        self.settings.clear()
        self._show()
        self.changed.emit()

    def _on_entered(self) -> None:
        text = self.settings.text().strip()
        if text != self._entered:
            self._entered = text
            self.changed.emit()

    def _show(self) -> None:
        choice = str(self.kind.currentData())
        for widget in (self.caption, self.settings):
            widget.setVisible(takes_settings(choice))
        self.settings.setPlaceholderText(example_of(choice))
