"""The checks before the first trial, which are stored with the session."""

import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.errors import Message, message_of
from hapticplayer.haptics.contract import Cause
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.study.definition import Checks

DEVICE, HOMED, SCHEDULING, SOUND, VOLUME, SCREEN, DISK = (
    "device",
    "homed",
    "scheduling",
    "sound",
    "volume",
    "screen",
    "disk",
)

_FIRST = Message("choose a device first")
SIMULATED = "simulated"  # without force feedback, for trying a study out


@dataclass(frozen=True, slots=True)
class SessionCheck:
    """The result of one check.

    Attributes:
        name: of the check.
        is_good: whether it meets the definition.
        found: the state in a few words.
        remedy: what to do where it does not; "" where that is plain.
    """

    name: str
    is_good: bool
    found: Message
    remedy: str = ""


def run_checks(
    player: Player,
    checks: Checks,
    folder: Path,
    screen: Mapping[str, Any],
    *,
    is_sound_heard: bool,
    volume_percent: int,
) -> tuple[SessionCheck, ...]:
    """Check everything that a session needs.

    Args:
        player: with its device.
        checks: required by the definition.
        folder: of the study.
        screen: of the participant: width_px, height_px, refresh_hz, screens.
        is_sound_heard: whether a person has confirmed audible sound.
        volume_percent: of the player.
    """
    now = player.snapshot()
    return (
        _device(now, checks),
        _homed(now, checks),
        _scheduling(now, checks),
        SessionCheck(
            SOUND,
            is_sound_heard or not checks.sound,
            Message("heard") if is_sound_heard else Message("not confirmed"),
            Message("play a clip, and tick the box if you hear it"),
        ),
        SessionCheck(
            VOLUME,
            volume_percent > 0 or not checks.sound,
            Message("{percent} %", percent=volume_percent),
            Message("turn the volume up"),
        ),
        SessionCheck(
            SCREEN,
            bool(screen.get("refresh_hz", 0) >= 30),
            Message(
                "{width_px} x {height_px}, {refresh_hz:.0f} Hz, screens: {screens}",
                **screen,
            ),
            Message("choose a refresh rate of 30 Hz or more"),
        ),
        _disk(checks, folder),
    )


def checks_as_json(checks: tuple[SessionCheck, ...]) -> list[dict[str, Any]]:
    return [{"check": c.name, "ok": c.is_good, "found": str(c.found)} for c in checks]


def volume_in_checks(checks: object) -> int | None:
    """Return the volume (per cent) in stored checks, or None."""
    rows = checks if isinstance(checks, list) else []
    texts = [
        str(row.get("found", ""))
        for row in rows
        if isinstance(row, dict) and row.get("check") == VOLUME
    ]
    number = texts[-1].removesuffix(" %") if texts else ""
    is_number = number.isdecimal() and len(number) <= len("100")
    return min(int(number), 100) if is_number else None


def _device(now: Snapshot, checks: Checks) -> SessionCheck:
    if now.leading.name == NO_DEVICE:
        remedy = Message("the study requires a device: choose it above")
        return SessionCheck(DEVICE, not checks.device, Message("none"), remedy)
    is_real = SIMULATED not in now.leading.name or not checks.device
    is_good = is_real and now.leading.health is Health.READY
    remedy = Message(
        "nobody feels a simulated device: choose a real one, or allow sessions without "
        "one (first page of the study editor)"
    )
    if is_real:
        remedy = Message("wait until it is ready, or choose it again")
    found = Message(
        "{device}, {state}",
        device=find_device(now.leading.name).label,
        state=Message(now.leading.health),
    )
    return SessionCheck(DEVICE, is_good, found, remedy)


def _homed(now: Snapshot, checks: Checks) -> SessionCheck:
    if now.leading.name == NO_DEVICE:
        return SessionCheck(HOMED, not checks.device, Message("no device"), _FIRST)
    if now.leading.tick is None:
        found, remedy = Message("no data from the device yet"), Message("wait for it")
        return SessionCheck(HOMED, False, found, remedy)
    is_homed = now.leading.cause is not Cause.NOT_HOMED
    return SessionCheck(
        HOMED,
        is_homed,
        Message("yes") if is_homed else Message("not yet"),
        Message("pull the grip all the way out, then push it in until it locks"),
    )


def _scheduling(now: Snapshot, checks: Checks) -> SessionCheck:
    if now.leading.name == NO_DEVICE:
        found = Message("no device")
        return SessionCheck(SCHEDULING, not checks.device, found, _FIRST)
    is_good = now.leading.scheduling in checks.scheduling
    remedy = Message("other programs may delay the force: close them")
    return SessionCheck(
        SCHEDULING,
        is_good,
        Message(now.leading.scheduling or "\u2013"),
        remedy if now.leading.scheduling else "",
    )


def _disk(checks: Checks, folder: Path) -> SessionCheck:
    try:
        free_gb = shutil.disk_usage(folder).free / 1e9
    except OSError as problem:
        return SessionCheck(DISK, False, message_of(problem))
    return SessionCheck(
        DISK,
        1e3 * free_gb >= checks.disk_free_mb,
        Message("{free_gb:.1f} GB free", free_gb=free_gb),
        Message("free {need_mb} MB there", need_mb=checks.disk_free_mb),
    )
