"""What the engine reports, in words and with a judgement: snapshot to readings."""

import enum
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.widgets.texts import local, titled
from hapticplayer.devices import NO_DEVICE, find_device, installed_devices
from hapticplayer.devices.options import with_gain
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.linux import Scheduling
from hapticplayer.model import LoopStats, SyncStats
from hapticplayer.playback.faults import CAUSE_TEXTS
from hapticplayer.playback.meters import EARLY_MS, LATE_MS
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.snapshot import Measurements, Snapshot

translate = QCoreApplication.translate

# The slice request reaches p99 of 60 to 75 us, normal scheduling 0.7 to 2 ms
# (reference/playback.md, part A).
LATENESS_GOOD_US, LATENESS_BAD_US = 300.0, 1500.0
MISSED_GOOD, MISSED_BAD = 0.001, 0.01
SYNC_GOOD_MS = 5.0  # what the project promises; beyond the alarm's limits it is bad
DROPPED_GOOD, DROPPED_BAD = 0.005, 0.02


class Level(enum.IntEnum):
    """How something is doing."""

    NEUTRAL = 0
    GOOD = 1
    WATCH = 2
    BAD = 3


class Reading(NamedTuple):
    """One entry of the health line."""

    level: Level
    text: str


class Frames(NamedTuple):
    """Frames of a clip so far."""

    shown: int = 0
    dropped: int = 0


NONE_YET = Frames()


def readings(
    snapshot: Snapshot, measured: Measurements, before: Frames = NONE_YET
) -> tuple[Reading, ...]:
    """The entries in the order of the line; `before` are the frames of 10 s ago."""
    return (
        device(snapshot),
        scheduling(snapshot),
        lateness(snapshot, measured.loop),
        sync(measured.force_minus_video),
        sync(measured.force_minus_audio if is_heard(snapshot) else None),
        frames(snapshot, before),
        clock(snapshot),
    )


def device(snapshot: Snapshot) -> Reading:
    """Return the device, its health and what it does."""
    if snapshot.leading.name == NO_DEVICE:
        return Reading(Level.NEUTRAL, translate("Health", "none"))
    name = device_name(snapshot.leading.name)
    ends: dict[str, str] = {
        Health.FAILED: translate("Health", "failed"),
        Health.GONE: translate("Health", "gone"),
    }
    if snapshot.leading.health in ends:
        return Reading(Level.BAD, _with(name, ends[snapshot.leading.health]))
    if snapshot.is_stopped:
        return Reading(Level.BAD, f"{name}, {stop_reason(snapshot.leading.cause)}")
    is_starting = snapshot.leading.health is Health.STARTING
    waits = translate("Health", "starting") if is_starting else snapshot.leading.note
    if waits:
        return Reading(Level.WATCH, _with(name, translated(waits)))
    if snapshot.leading.cause is Cause.NOT_HOMED:
        return Reading(Level.WATCH, _not_homed(name, snapshot.leading.name))
    mode, held = mode_text(snapshot.leading.mode), _held_by(snapshot)
    level = Level.WATCH if held else Level.GOOD
    return Reading(level, _with(name, titled(mode, held) if held else mode))


def _held_by(snapshot: Snapshot) -> str:
    """Why a clip plays without its force, "" where nothing is wrong with that."""
    is_at_rest = snapshot.leading.mode in (Mode.IDLE, Mode.RAMPING)
    cause = snapshot.leading.cause
    if snapshot.phase is not Phase.PLAYING or not is_at_rest or cause is Cause.NO_TRACK:
        return ""
    return cause_text(cause)


def _not_homed(name: str, device: str) -> str:
    if not find_device(device).capabilities.axes:  # it has no grip
        return _with(name, translate("Health", "starting"))
    text = translate("Health", "pull the grip out, then push it in")
    return titled(name, text)


def _with(name: str, state: str) -> str:
    return f"{name}, {state}"  # lupdate skips such strings


def device_name(name: str) -> str:
    """Return a device's name for people."""
    kind, _, serial = with_gain(name).partition(":")
    if kind == NO_DEVICE:
        return translate("Health", "None")
    entry = installed_devices().get(kind)
    return f"{translated(entry.label) if entry else kind} {serial}".rstrip()


def mode_text(mode: Mode) -> str:
    """The loop's mode in words."""
    return {
        Mode.IDLE: translate("Health", "at rest"),
        Mode.ENTERING: translate("Health", "fading in"),
        Mode.FOLLOWING: translate("Health", "active"),
        Mode.RAMPING: translate("Health", "fading out"),
        Mode.TRIPPED: translate("Health", "STOPPED"),
    }[mode]


def stop_reason(cause: Cause) -> str:
    """Return why the force was stopped."""
    stopped, reason = translate("Health", "STOPPED"), cause_text(cause)
    return titled(stopped, reason) if reason else stopped


def cause_text(cause: Cause) -> str:
    """The event; nothing where a person did it, or it went by itself."""
    return translated(CAUSE_TEXTS.get(cause, ""))


def scheduling(snapshot: Snapshot) -> Reading:
    """Return the class that the loop runs in."""
    if not snapshot.leading.scheduling or is_dead(snapshot):
        return Reading(Level.NEUTRAL, "\u2013")
    level, text = {
        Scheduling.FIFO: (Level.GOOD, translate("Health", "FIFO")),
        Scheduling.SLICE: (Level.GOOD, translate("Health", "slice")),
        Scheduling.NORMAL: (Level.WATCH, translate("Health", "normal")),
    }[Scheduling(snapshot.leading.scheduling)]
    return Reading(level, text)


def lateness(snapshot: Snapshot, loop: LoopStats | None) -> Reading:
    """Return how punctual the 1 kHz loop has been in the last 10 s."""
    if loop is None or is_dead(snapshot):
        return Reading(Level.NEUTRAL, "\u2013")
    p99_us = loop.lateness_p99_us
    missed = loop.missed / max(1, loop.ticks)
    level = max(
        _judge(p99_us, LATENESS_GOOD_US, LATENESS_BAD_US),
        _judge(missed, MISSED_GOOD, MISSED_BAD),
    )
    if missed > MISSED_BAD:  # the loop allows 3 N at most then
        text = translate("Health", "no, {us:.0f} \u00b5s, {missed} missed")
    else:
        text = translate("Health", "yes, {us:.0f} \u00b5s, {missed} missed")
    return Reading(level, text.format(us=p99_us, missed=loop.missed))


def sync(stats: SyncStats | None) -> Reading:
    """Return by how much the force is later than what it belongs to."""
    if stats is None:
        return Reading(Level.NEUTRAL, "\u2013")
    if not EARLY_MS <= stats.p50_ms <= LATE_MS:
        late = translate("Health", "late {p50:+.1f}, {p95:+.1f} ms")
        early = translate("Health", "early {p50:+.1f}, {p95:+.1f} ms")
        level, text = Level.BAD, late if stats.p50_ms > 0.0 else early
    else:
        level = Level.GOOD if abs(stats.p50_ms) <= SYNC_GOOD_MS else Level.WATCH
        text = translate("Health", "{p50:+.1f}, {p95:+.1f} ms")
    p50_ms, p95_ms = (round(ms, 1) + 0.0 for ms in (stats.p50_ms, stats.p95_ms))
    # there is no -0.0
    return Reading(level, local(text.format(p50=p50_ms, p95=p95_ms)))


def frames(snapshot: Snapshot, before: Frames = NONE_YET) -> Reading:
    """How many frames were shown and came too late; judged by those since `before`."""
    shown, dropped = snapshot.frames_shown, snapshot.frames_dropped
    lately = dropped - before.dropped
    share = lately / max(1, shown - before.shown + lately)
    level = _judge(share, DROPPED_GOOD, DROPPED_BAD) if shown else Level.NEUTRAL
    text = translate("Health", "{shown} shown, {dropped} dropped")
    if snapshot.frames_damaged:
        level = max(level, Level.WATCH)
        text = translate("Health", "{damaged} damaged, {dropped} dropped")
    text = text.format(shown=shown, dropped=dropped, damaged=snapshot.frames_damaged)
    return Reading(level, text)


def clock(snapshot: Snapshot) -> Reading:
    """The leader of the clock."""
    if is_heard(snapshot):
        return Reading(Level.GOOD, translate("Health", "audio"))
    if snapshot.audio and snapshot.phase is Phase.PLAYING:
        return Reading(Level.WATCH, translate("Health", "no sound"))
    return Reading(Level.NEUTRAL, translate("Health", "monotonic"))


def is_heard(snapshot: Snapshot) -> bool:
    """Whether the sound leads the clock at present."""
    return snapshot.clock == "audio"


def is_dead(snapshot: Snapshot) -> bool:
    """Whether the loop is gone, and its last figures with it."""
    return snapshot.leading.health in (Health.FAILED, Health.GONE)


def level_word(level: Level) -> str:
    """Return a judgement in a word, for those who do not see its colour."""
    return {
        Level.NEUTRAL: translate("Health", "no data"),
        Level.GOOD: translate("Health", "good"),
        Level.WATCH: translate("Health", "watch"),
        Level.BAD: translate("Health", "bad"),
    }[level]


def _judge(value: float, good: float, bad: float) -> Level:
    if value <= good:
        return Level.GOOD
    return Level.WATCH if value <= bad else Level.BAD
