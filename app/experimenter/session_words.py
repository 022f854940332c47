"""What the operator reads about a session, in the window's language.

The records keep the engine's own words, the same in every language.
"""

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.player.health import cause_text, device_name
from app.widgets.numbers import local
from hapticplayer.haptics.contract import Cause
from hapticplayer.study.preflight import DEVICE, DISK, SCHEDULING, SCREEN, SessionCheck

translate = QCoreApplication.translate

_SAME = {  # for a moment or for good: in the same words
    "heartbeat_late": "heartbeat_lost",
    "reply_late": "reply_lost",
    "tick_late": "tick_lost",
    "clock_stale": "heartbeat_lost",
    "command_stale": "tick_lost",
}
_FREE, _SCREENS = " MB free", ", screens: "


def _only_in_trials() -> dict[str, str]:
    """Return what takes the force away for a moment, which the window need not say."""
    return {
        "no_track": translate("SessionWords", "there was no force track"),
        "guard_lost": translate("SessionWords", "the guard was silent"),
        "stopped": translate("SessionWords", "someone stopped it"),
        "not_homed": translate("SessionWords", "the grip had lost its zero"),
    }


def reason_text(reason: str) -> str:
    """Return why a trial was not sound; what is not known keeps the record's word."""
    kind, _, more = reason.partition(":")
    if kind == "fault":
        known = {cause.name.lower(): cause_text(cause) for cause in Cause}
        known |= _only_in_trials()
        text = translate("SessionWords", "the contract stopped it ({0})")
        return text.format(known.get(_SAME.get(more, more)) or more)
    if kind == "sync":
        return {
            "picture": translate("SessionWords", "force and picture were apart"),
            "sound": translate("SessionWords", "force and sound were apart"),
        }.get(more, reason)
    return {
        "paused": translate("SessionWords", "paused"),
        "repeated": translate("SessionWords", "to be repeated"),
        "skipped": translate("SessionWords", "left out"),
        "stopped": translate("SessionWords", "the session was ended"),
        "operator": translate("SessionWords", "stopped by the operator"),
        "escape": translate("SessionWords", "the participant pressed Esc"),
        "space": translate("SessionWords", "the participant pressed the space bar"),
        "focus_lost": translate("SessionWords", "another program came in front"),
        "window_closed": translate("SessionWords", "the window was to be closed"),
        "clip_damaged": translate("SessionWords", "the clip is damaged"),
        "pictures_dropped": translate("SessionWords", "pictures were dropped"),
        "no_sound": translate("SessionWords", "there was no sound"),
        "sound_missing": translate("SessionWords", "sound was missing"),
        "no_device": translate("SessionWords", "there was no device"),
        "device_lost": translate("SessionWords", "the device was lost"),
        "periods_missed": translate("SessionWords", "the loop missed periods"),
        "no_ticks": translate("SessionWords", "the device said nothing"),
        "record_incomplete": translate("SessionWords", "the record has gaps"),
    }.get(reason, reason)


def found_text(check: SessionCheck) -> str:
    """Return what a check has found."""
    found = check.found
    if check.name == DEVICE and ", " in found:
        name, _, state = found.rpartition(", ")
        return f"{device_name(name)}, {_words().get(state, state)}"
    if check.name == SCREEN and _SCREENS in found:
        size, _, count = found.partition(_SCREENS)
        text = translate("SessionWords", "{size}; screens in all: {n}")
        return text.format(size=size.replace(" x ", " \u00d7 "), n=count)
    if check.name == DISK and found.endswith(_FREE):
        text = translate("SessionWords", "{n} GB free")
        return text.format(n=local(f"{float(found.removesuffix(_FREE)) / 1e3:.1f}"))
    if check.name == SCHEDULING and not found:
        return "\u2013"
    return _words().get(found) or translated(found)


def _words() -> dict[str, str]:
    return {
        "heard": translate("StartPanel", "heard"),
        "not confirmed": translate("StartPanel", "not confirmed"),
        "none": translate("StartPanel", "none"),
        "no device": translate("StartPanel", "no device"),
        "the device has said nothing yet": translate(
            "StartPanel", "the device has said nothing yet"
        ),
        "yes": translate("StartPanel", "yes"),
        "not yet": translate("StartPanel", "not yet"),
        "starting": translate("Health", "starting"),
        "ready": translate("SessionWords", "ready"),
        "failed": translate("Health", "failed"),
        "gone": translate("Health", "gone"),
        "fifo": translate("Health", "FIFO"),
        "slice": translate("Health", "slice"),
        "normal": translate("Health", "normal"),
    }
