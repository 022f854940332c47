"""Where the media is: led by what is being heard, else by the monotonic clock.

The position never jumps except by a seek. Reports of the sound output bend the
rate until the difference is gone; how far is clamped, so that the correction is not
seen, heard or felt.
"""

import enum
from typing import NamedTuple

from hapticplayer.model import PlaybackClock

HORIZON_S = 0.150  # design section 5: how long a published clock may be trusted
MAX_BEND = 0.02  # of the rate; 2 % is invisible, and 50 ms are gone in 2.5 s
SETTLING_S = 0.5
# Reports jitter by 0.1 to 0.2 ms; correct from half a millisecond down to a tenth.
CORRECT_FROM_S, CORRECT_TO_S = 0.0005, 0.0001
SMOOTHING = 0.1
REPORT_TIMEOUT_S = 0.200
RESYNC_S = 0.250  # farther off, bending takes too long: start a new epoch instead


class AudioReport(NamedTuple):
    """What was heard: `media_s` at `monotonic_s`, in an epoch."""

    epoch: int
    monotonic_s: float
    media_s: float


class ClockSource(enum.StrEnum):
    """What leads the clock."""

    AUDIO = "audio"
    MONOTONIC = "monotonic"


class MediaClock:
    """The one owner of the media position."""

    def __init__(self) -> None:
        self.epoch = 0
        self.source = ClockSource.MONOTONIC
        self.speed = 1.0  # of the media in the person's time; set before `seek`
        self._monotonic0_s = 0.0
        self._media0_s = 0.0
        self._is_running = False
        self._bend = 0.0
        self._error_s = 0.0
        self._is_correcting = False
        self._last_report_s = float("-inf")

    @property
    def is_running(self) -> bool:
        """Whether the position moves, or will at a set time."""
        return self._is_running

    @property
    def error_s(self) -> float:
        """Smoothed difference of the last reports to the clock; positive: behind."""
        return self._error_s

    def seek(self, media_s: float) -> None:
        """Stand still at a position; a new epoch begins."""
        self.epoch += 1
        self._media0_s = media_s
        self._stand()

    def renew(self) -> None:
        """Begin a new epoch where we are: the force fades out and in, no more."""
        self.epoch += 1

    def start(self, at_s: float, source: ClockSource = ClockSource.MONOTONIC) -> None:
        """Run from the present position at a monotonic time, past or to come."""
        self._monotonic0_s = at_s
        self._is_running = True
        self.source = source
        self._last_report_s = at_s

    def start_with(self, report: AudioReport) -> None:
        """Run along with the first sound of this epoch."""
        self._media0_s = report.media_s
        self.start(report.monotonic_s, ClockSource.AUDIO)

    def pause(self, now_s: float) -> None:
        """Stand still where the media is now; a new epoch begins."""
        position_s = self.media_s(now_s)
        self.epoch += 1
        self._media0_s = position_s
        self._stand()

    def media_s(self, now_s: float) -> float:
        """Return the position, s."""
        elapsed_s = now_s - self._monotonic0_s
        if not self._is_running or elapsed_s <= 0.0:
            return self._media0_s
        return self._media0_s + self.speed * (1.0 + self._bend) * elapsed_s

    def snapshot(self, now_s: float) -> PlaybackClock:
        """The clock that holds until the horizon."""
        rate = self.speed * (1.0 + self._bend) if self._is_running else 0.0
        return PlaybackClock(
            self.epoch, self._monotonic0_s, self._media0_s, rate, now_s + HORIZON_S
        )

    def report(self, report: AudioReport, now_s: float) -> bool:
        """Bend the clock towards what is heard.

        Returns:
            False when the difference is too large to be bent away: the caller
            should seek to the report instead.
        """
        if report.epoch != self.epoch or not self._is_running:
            return True
        was_lost = self.source is ClockSource.MONOTONIC
        self.source = ClockSource.AUDIO
        self._last_report_s = max(self._last_report_s, report.monotonic_s)
        error_s = report.media_s - self.media_s(report.monotonic_s)
        if abs(error_s) > RESYNC_S:
            return False
        smoothing = 1.0 if was_lost else SMOOTHING
        self._error_s += smoothing * (error_s - self._error_s)
        self._correct(now_s)
        return True

    def check(self, now_s: float) -> None:
        """Go on with the monotonic clock when nothing is heard any more."""
        silence_s = now_s - self._last_report_s
        if self.source is ClockSource.AUDIO and silence_s > REPORT_TIMEOUT_S:
            self.source = ClockSource.MONOTONIC
            self._error_s, self._is_correcting = 0.0, False
            self._set_bend(0.0, now_s)

    def _correct(self, now_s: float) -> None:
        threshold = CORRECT_TO_S if self._is_correcting else CORRECT_FROM_S
        self._is_correcting = abs(self._error_s) > threshold
        wanted = self._error_s / SETTLING_S if self._is_correcting else 0.0
        self._set_bend(max(-MAX_BEND, min(MAX_BEND, wanted)), now_s)

    def _set_bend(self, bend: float, now_s: float) -> None:
        if bend != self._bend and now_s >= self._monotonic0_s:
            self._media0_s = self.media_s(now_s)
            self._monotonic0_s = now_s
            self._bend = bend

    def _stand(self) -> None:
        self._is_running = False
        self._bend = self._error_s = 0.0
        self._is_correcting = False
        self.source = ClockSource.MONOTONIC
