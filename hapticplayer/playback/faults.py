"""What kept an output from playing, in a sentence for people, logs and records."""

from collections import Counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, joined
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode

HARMLESS = (Cause.NONE, Cause.PAUSED, Cause.SEEK, Cause.TRACK_ENDED, Cause.CLOSING)
"""Reasons of a normal playback from start to end."""
HELD_SHARE, HELD_TICKS = 0.25, 500
"""Less than that without force is not worth a word: loading, a short stall."""
UNHEARD_SHARE = 0.5
NOBODY_LISTENS = Message("nobody listens at {address}: start the rig's software")
CAUSE_TEXTS = {
    Cause.HEARTBEAT_LATE: Message("window not responding"),
    Cause.HEARTBEAT_LOST: Message("window not responding"),
    Cause.CLOCK_STALE: Message("window not responding"),
    Cause.PLAYER_GONE: Message("player ended"),
    Cause.NOT_FINITE: Message("invalid force track"),
    Cause.GRIP_BUTTON: Message("grip button"),
    Cause.UNPLUGGED: Message("unplugged"),
    Cause.REPLY_LATE: Message("device not responding"),
    Cause.REPLY_LOST: Message("device not responding"),
    Cause.MALFORMED: Message("malformed replies from the device"),
    Cause.TICK_LATE: Message("computer stalled"),
    Cause.TICK_LOST: Message("computer stalled"),
    Cause.COMMAND_STALE: Message("computer stalled"),
    Cause.NOT_HOMED: Message("not homed"),
    Cause.RUNAWAY: Message("grip released"),
    Cause.OUTSIDE: Message("grip at the edge of the workspace"),
    Cause.GUARD_LOST: Message("guard process not responding"),
    Cause.NO_TRACK: Message("no force track"),
    Cause.SOURCE_SILENT: Message("sensor silent"),
}
_DEVICE = Message("check its cable and power supply, then test the device")
_BUSY = Message("close other programs")
_HAND = Message("hold the grip, or lower the gain")
_REMEDIES = {
    Cause.GRIP_BUTTON: Message("play again"),
    Cause.NOT_FINITE: Message("make the force again"),
    Cause.NOT_HOMED: Message("set the device up first"),
    Cause.RUNAWAY: _HAND,
    Cause.SOURCE_SILENT: Message("check the sensor's cable, power and range"),
    Cause.OUTSIDE: _HAND,
    Cause.UNPLUGGED: _DEVICE,
    Cause.REPLY_LATE: _DEVICE,
    Cause.REPLY_LOST: _DEVICE,
    Cause.MALFORMED: _DEVICE,
}
_BY_A_PERSON = (Cause.STOPPED, Cause.UNPLUGGED)
"""A device that is gone has a problem of its own."""
_IS_ACTING = np.isin(np.arange(256), (Mode.ENTERING, Mode.FOLLOWING))
"""By the mode, a byte."""


def trip_text(cause: Cause) -> Message:
    """Why an output has stopped, and what to do."""
    return Message("stopped: {cause}; {remedy}", **_said(cause))


def _said(cause: Cause) -> dict[str, str]:
    return {
        "cause": CAUSE_TEXTS.get(cause, cause.name.lower()),
        "remedy": _REMEDIES.get(cause, _BUSY),
    }


class OutputFaults:
    """Counts what kept one output from playing since it was made.

    Attributes:
        trip: the last by itself that no person has re-armed, in a sentence; "" for none.
        notice: what the device has reported, "" for nothing.
    """

    def __init__(self) -> None:
        self.trip: Message | str = ""
        self.notice: Message | str = ""
        self._acted = self._sent = self._refused = 0
        self._held: Counter[int] = Counter()

    def add(self, ticks: NDArray[Any], *, is_wanted: bool, is_rig: bool) -> None:
        """Count ticks; `is_wanted` is whether the output was to play."""
        is_acting = _IS_ACTING[ticks["mode"]]
        self._acted += int(np.count_nonzero(is_acting))
        if is_rig:
            self._sent += int(np.count_nonzero(ticks["buttons"] & SENT))
            self._refused += int(np.count_nonzero(ticks["buttons"] & REFUSED))
        if not is_wanted or is_acting.all():
            return
        causes, counts = np.unique(ticks["cause"][~is_acting], return_counts=True)
        for cause, count in zip(causes.tolist(), counts.tolist(), strict=True):
            if Cause(cause) not in (*HARMLESS, *_BY_A_PERSON):
                self._held[cause] += count

    def note_mode(self, mode: Mode, cause: Cause) -> bool:
        """Note that the loop has changed its mode; return whether it has tripped."""
        if mode is not Mode.TRIPPED:
            self.trip = ""
        elif cause not in _BY_A_PERSON:
            self.trip = trip_text(cause)
            return True
        return False

    @property
    def is_unheard(self) -> bool:
        """Whether nobody has listened to most of what was sent."""
        return self._refused > UNHEARD_SHARE * max(1, self._sent)

    @property
    def sentence(self) -> Message | str:
        """The gravest of them and what the device has reported, "" for none."""
        found = [one for one in (self.trip or self._held_text(), self.notice) if one]
        return joined("; ", found) if len(found) > 1 else next(iter(found), "")

    def _held_text(self) -> Message | str:
        held = sum(self._held.values())
        if held < HELD_TICKS or held < HELD_SHARE * (held + self._acted):
            return ""
        said = _said(Cause(self._held.most_common(1)[0][0]))
        if not self._acted:
            return Message("nothing was played: {cause}; {remedy}", **said)
        return Message("at times nothing was played: {cause}; {remedy}", **said)
