"""Plays the trials of a session and measures their playback."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.errors import StudyError
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.faults import HARMLESS
from hapticplayer.playback.meters import described
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Measurements, Snapshot
from hapticplayer.playback.source import Source
from hapticplayer.rendering import shifted_and_scaled
from hapticplayer.study.definition import Checks, Condition, PlaybackLimits
from hapticplayer.study.stage import PlaybackResult

_LOST = (Health.FAILED, Health.GONE)
_ACTING = (Mode.ENTERING, Mode.FOLLOWING)


class PlayerStage:
    """Plays trials with a `Player`.

    Args:
        player: polled by the front end.
        sources: of the study's sequences, by key.
        demonstration: of the device.
        rules: limits of a valid playback, and required checks.
        clock: of the machine.
        record: name of the file with all ticks, stored with the trial.

    Attributes:
        opening: called with each source before it is loaded.
    """

    def __init__(
        self,
        player: Player,
        sources: Mapping[str, Source],
        demonstration: Source,
        rules: tuple[PlaybackLimits, Checks],
        clock: Clock,
        record: str = "",
    ) -> None:
        self.player = player
        self._sources, self._demonstration = sources, demonstration
        self.clip_s = {key: one.clip.duration_s for key, one in sources.items()}
        self._limits, self._checks = rules
        self._clock, self._record = clock, record
        self.opening: Callable[[Source], None] = lambda _source: None
        self._monitor = _PlaybackMonitor(player, clock.now_s())
        outputs = player.snapshot().outputs
        self._ready = [one.name for one in outputs if one.health is Health.READY]

    def check(self) -> None:
        """Refuse a trial without a device that was there; another stays as it is."""
        for one in self.player.snapshot().outputs:
            is_lost = one.health in _LOST and one.name in self._ready
            if is_lost and self._checks.device:
                raise StudyError(
                    "no trial begins: {device} was lost ({reason})",
                    remedy="connect it, close this session and resume it",
                    device=one.name,
                    reason=one.problem or one.fault or one.health.value,
                )

    def prepare(self, condition: Condition) -> None:
        """Load the clip and the force of a condition."""
        source = self._sources[condition.sequence]
        track = source.tracks[condition.feedback]
        shifted = shifted_and_scaled(track, condition.delay_s, condition.gain)
        self._open(replace(source, tracks={condition.feedback: shifted}))

    def prepare_demonstration(self) -> None:
        """Load the demonstration of the device."""
        self._open(self._demonstration)

    def _open(self, source: Source) -> None:
        self.opening(source)
        self.player.open(source, next(iter(source.tracks)))

    def begin(self) -> None:
        """Play from the beginning."""
        if self.player.snapshot().media_s > 0.0:
            self.player.seek(0.0)
        self.player.restart_meters()
        self._monitor = _PlaybackMonitor(self.player, self._clock.now_s())
        self.player.play()

    def is_over(self) -> bool:
        """Whether the clip has ended; also checks for faults."""
        self._monitor.update()
        return self.player.snapshot().phase in (Phase.ENDED, Phase.EMPTY)

    @property
    def first_frame_s(self) -> float | None:
        """When media time 0 was on the screen, monotonic; None before that."""
        return _stamp(self.player.first_frame_s)

    def media_s(self, monotonic_s: float) -> float | None:
        """Where the clip is at a time; None while it does not run."""
        clock = self.player.media_clock
        return clock.media_s(monotonic_s) if clock.is_running(monotonic_s) else None

    @property
    def is_stopped(self) -> bool:
        """Whether the force is stopped until a person re-arms it."""
        return self.player.latch.is_set

    def halt(self) -> None:
        """Stop force and playback at once, until `rearm`."""
        self._monitor.update()
        self.player.stop_force()

    def interrupt(self) -> None:
        """Pause; the force fades out, and may come back with the next clip."""
        self._monitor.update()
        self.player.pause()

    def rearm(self) -> None:
        """Allow force again: a person asks for it; as `Player.rearm`."""
        self.player.rearm()

    def played(self, *reasons: str) -> PlaybackResult:
        """Return the result since `begin`."""
        self._monitor.update()
        found = [*reasons, *self._monitor.reasons(self._limits, self._checks)]
        figures = self._monitor.figures(self._clock.now_s())
        if self._record:
            figures["record"] = self._record
        distinct = tuple(dict.fromkeys(found))
        return PlaybackResult(not distinct, distinct, figures)


def _stamp(monotonic_s: float | None) -> float | None:
    """A time as records keep it."""
    return None if monotonic_s is None else round(monotonic_s, 6)


class _PlaybackMonitor:
    """Measures one playback.

    Args:
        player: that plays.
        now_s: monotonic time of its start.
    """

    def __init__(self, player: Player, now_s: float) -> None:
        self._player = player
        self._begun_s = self._seen_s = now_s
        self._before = player.snapshot()
        self._measured_before = player.measurements()
        self._was_acting = False
        self._faults: list[dict[str, Any]] = []
        self._ticks = self._missed = 0
        self._squares_n2 = np.zeros(3)
        self._led_by_sound = False

    def update(self) -> None:
        """Read the ticks since the last update."""
        self._led_by_sound |= self._player.snapshot().clock == "audio"
        ticks = self._player.ticks_since(self._seen_s)
        if not len(ticks):
            return
        self._seen_s = float(ticks["monotonic_s"][-1])
        self._ticks += len(ticks)
        self._missed += int(ticks["missed"].sum())
        self._squares_n2 += np.square(ticks["force_n"], dtype=np.float64).sum(axis=0)
        self._note_faults(ticks)

    def _note_faults(self, ticks: NDArray[Any]) -> None:
        """Note each stop of the force other than by the player."""
        is_acting = np.isin(ticks["mode"], _ACTING)
        before = np.concatenate([[self._was_acting], is_acting[:-1]])
        for row in np.flatnonzero(before & ~is_acting):
            cause = Cause(int(ticks["cause"][row]))
            if cause not in HARMLESS:
                at_s = round(float(ticks["monotonic_s"][row]), 6)
                self._faults.append({"cause": cause.name.lower(), "mono_s": at_s})
        self._was_acting = bool(is_acting[-1])

    def figures(self, now_s: float) -> dict[str, Any]:
        """Return the figures of the playback."""
        after, measured = self._player.snapshot(), self._player.measurements()
        before = self._measured_before
        silence_s = measured.audio_underrun_s - before.audio_underrun_s
        rms_n = np.sqrt(self._squares_n2 / max(1, self._ticks))
        return {
            "begun_mono_s": round(self._begun_s, 6),
            "ended_mono_s": round(now_s, 6),
            "first_frame_mono_s": _stamp(self._player.first_frame_s),
            "media_s": round(after.media_s, 3),
            "duration_s": round(after.duration_s, 3),
            "frames_shown": after.frames_shown - self._before.frames_shown,
            "frames_dropped": after.frames_dropped - self._before.frames_dropped,
            "silence_s": round(silence_s, 4),
            "clock": "audio" if self._led_by_sound else "monotonic",
            "force_minus_video_ms": described(measured.force_minus_video_total),
            "force_minus_sound_ms": described(measured.force_minus_audio_total),
            "ticks": self._ticks,
            "missed": self._missed,
            "lost": measured.ticks_lost - before.ticks_lost,
            "force_rms_n": [round(float(value), 4) for value in rms_n],
            "faults": self._faults,
            "outputs": self._player.output_names,
            "output_faults": {
                one.name: str(what)
                for one in after.outputs
                if (what := one.problem or one.fault or one.note)
            },
            "scheduling": after.leading.scheduling,
        }

    def reasons(self, limits: PlaybackLimits, checks: Checks) -> list[str]:
        """Return why this playback was not valid."""
        found = [f"fault:{fault['cause']}" for fault in self._faults]
        after, measured = self._player.snapshot(), self._player.measurements()
        shown = after.frames_shown - self._before.frames_shown
        dropped = after.frames_dropped - self._before.frames_dropped
        if after.problem:
            found.append("clip_damaged")
        if not shown or dropped > limits.dropped_share * (shown + dropped):
            found.append("frames_dropped")
        if checks.sound:
            found += self._sound_reasons(limits, after, measured)
        if after.outputs:
            found += self._force_reasons(limits, after)
        elif checks.device:
            found.append("no_device")
        totals = {
            "video": measured.force_minus_video_total,
            "sound": measured.force_minus_audio_total,
        }
        for name, total in totals.items():
            if total is not None and abs(total.p50_ms) > limits.sync_ms:
                found.append(f"sync:{name}")
        return found

    def _sound_reasons(
        self, limits: PlaybackLimits, after: Snapshot, measured: Measurements
    ) -> list[str]:
        if after.source is None or not after.source.clip.has_audio:
            return []
        if not self._led_by_sound:
            return ["no_sound"]
        before_s = self._measured_before.audio_underrun_s
        missing_s = measured.audio_underrun_s - before_s
        return ["sound_missing"] if missing_s > limits.silence_s else []

    def _force_reasons(self, limits: PlaybackLimits, after: Snapshot) -> list[str]:
        found = []
        if any(one.health in _LOST for one in after.outputs):
            found.append("device_lost")
        found += [
            f"output_fault:{one.name}"
            for one in after.outputs
            if one.fault or one.is_unheard
        ]
        if self._missed > limits.missed_share * max(1, self._ticks):
            found.append("periods_missed")
        if not self._ticks:
            found.append("no_ticks")
        if after.leading.record_problem:
            found.append("record_incomplete")
        return found
