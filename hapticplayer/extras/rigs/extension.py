"""Motion rigs: software that moves a seat, spoken to by UDP as a game does."""

from typing import TYPE_CHECKING

from hapticplayer.devices import DeviceEntry
from hapticplayer.errors import Message
from hapticplayer.model.device import DeviceCapabilities, Signal

if TYPE_CHECKING:
    from hapticplayer.cli import Command

_HERE = "hapticplayer.extras.rigs"
RIG = DeviceCapabilities(
    axes=6,  # surge, sway, heave, roll, pitch, yaw
    peak_force_n=0.0,
    continuous_force_n=0.0,
    workspace_radius_m=0.0,
    rate_hz=200.0,  # unless a person chooses another one, 50 to 500
    latency_s=0.0,  # not known: the software of the rig decides
    signal=Signal.MOTION,
)


def devices() -> tuple[DeviceEntry, ...]:
    """A rig, which takes motion."""
    return (
        DeviceEntry(
            "rig",
            Message("Motion rig"),
            "software of a motion rig, spoken to as a game does by UDP",
            RIG,
            f"{_HERE}.sender:make",
            options=f"{_HERE}.settings:rig_settings",
            loop=f"{_HERE}.loop:RigLoop",
            guide=f"{_HERE}.guide:RIG",
        ),
    )


def device_actions() -> "tuple[Command, ...]":
    """The action `device rig-monitor`."""
    from hapticplayer.cli import Command

    summary = "listen as a motion rig would, and report what it would do"
    return (Command("rig-monitor", summary, f"{_HERE}.command"),)
