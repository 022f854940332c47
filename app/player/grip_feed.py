"""What the view of the grip shows, from what the haptic link knows."""

from PySide6.QtCore import QCoreApplication

from app.player.health import device_name, mode_text, stop_reason
from app.plots.grip_scene import (
    TRAIL_S,
    Activity,
    Grip,
    force_of,
    position_of,
    trail_of,
)
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import Feedback
from hapticplayer.playback.snapshot import Snapshot, TicksSince

translate = QCoreApplication.translate

SIMULATED = "simulated"
_ACTIVITIES = {
    Mode.IDLE: Activity.OFF,
    Mode.FOLLOWING: Activity.ACTIVE,
    Mode.TRIPPED: Activity.STOPPED,
}


def grip_of(now: Snapshot, ticks_since: TicksSince) -> Grip:
    """Return what there is to see of a device that tells where its grip is.

    Args:
        now: of the player.
        ticks_since: `Player.ticks_since`.
    """
    title = _title(now.device)
    if now.device == NO_DEVICE:
        text = translate(
            "GripView", "No device: choose {name} to see what would be felt"
        )
        return Grip(title, text.format(name=device_name(SIMULATED)))
    if now.device_health is Health.FAILED:
        text = translate("GripView", "The device has failed")
        return Grip(title, text, Activity.STOPPED)
    if now.device_health is Health.GONE:
        text = translate("GripView", "The haptics process has ended")
        return Grip(title, text, Activity.STOPPED)
    if now.tick is None:
        return Grip(title, translate("GripView", "Starting"), Activity.CHANGING)
    return _moving(title, now, ticks_since)


def _moving(title: str, now: Snapshot, ticks_since: TicksSince) -> Grip:
    capabilities = find_device(now.device).capabilities
    latest, mode, feedback = now.tick, now.mode, now.feedback
    position_m = position_of(latest)
    ticks = ticks_since(float(latest["monotonic_s"]) - TRAIL_S)
    return Grip(
        title,
        _state(mode, now.cause, feedback)
        if position_m
        else translate("GripView", "The position is not known"),
        _activity(mode, feedback),
        position_m,
        force_of(latest, "force_n"),
        force_of(latest, "planned_n"),
        force_of(latest, "centring_n"),
        trail_of(ticks),
        capabilities.workspace_radius_m,
        capabilities.continuous_force_n,
    )


def _title(device: str) -> str:
    if device in (SIMULATED, NO_DEVICE):
        return translate("GripView", "Simulated grip")
    return translate("GripView", "Grip")


def _is_off(mode: Mode, feedback: str) -> bool:
    return mode is Mode.IDLE or (
        mode is not Mode.TRIPPED and feedback == Feedback.NONE.value
    )


def _activity(mode: Mode, feedback: str) -> Activity:
    if _is_off(mode, feedback):
        return Activity.OFF
    return _ACTIVITIES.get(mode, Activity.CHANGING)


def _state(mode: Mode, cause: Cause, feedback: str) -> str:
    if mode is Mode.TRIPPED:
        return stop_reason(cause)
    if _is_off(mode, feedback):
        return translate("GripView", "Force is off")
    return translate("GripView", "Force is {what}").format(what=mode_text(mode))
