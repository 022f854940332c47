"""What is felt while a device shows its forces, in words."""

from PySide6.QtCore import QCoreApplication

from app.widgets.texts import local
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.rendering.demonstration import DemonstrationStep

translate = QCoreApplication.translate


def homing_text() -> str:
    """The gesture that homes a device."""
    return translate(
        "ForceWords",
        "Pull the grip all the way out, then push it in until it locks",
    )


def strength_text(record: DeviceCapabilities, force_n: float) -> str:
    """Return a force in newtons, or as a share where the device knows none."""
    if record.has_newtons:
        return local(f"{force_n:.1f}\u00a0N")
    share = translate("ForceWords", "{percent} % of its strength")
    return share.format(percent=round(100 * force_n / (record.peak_force_n or 1.0)))


def step_text(step: DemonstrationStep, record: DeviceCapabilities) -> str:
    """The force that is felt now, in words."""
    ways = {
        "right": translate("ForceWords", "To the right"),
        "left": translate("ForceWords", "To the left"),
        "up": translate("ForceWords", "Up"),
        "down": translate("ForceWords", "Down"),
        "towards you": translate("ForceWords", "Towards you"),
        "away from you": translate("ForceWords", "Away from you"),
        "vibration": translate("ForceWords", "Vibration"),
    }
    way = ways.get(step.direction, step.direction)
    return ", ".join((way, strength_text(record, step.strength_n)))
