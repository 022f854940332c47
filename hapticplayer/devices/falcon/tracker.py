"""From encoder counts to poses, with a guard against encoders that leap."""

from hapticplayer.devices.falcon.kinematics import (
    Counts,
    Kinematics,
    OutOfReachError,
    Pose,
)
from hapticplayer.devices.falcon.protocol import Reply

MOST_COUNTS_PER_MS = 200
"""A joint at 127 rad/s, the grip at 9 m/s: no hand does that, a glitch does."""
LEAPS_TO_FAULT = 5
_PERIOD_S = 0.001


class Tracker:
    """Where the grip is, as far as the replies can be trusted.

    Attributes:
        pose: of the last trusted reply of homed encoders; None before.
        is_homed: whether the last reply's encoders were all homed.
        replied_s: time of the last trusted reply; 0 before.
        buttons: of that reply.
        rejected: replies in a row, up to now, that were not trusted.
    """

    def __init__(self, kinematics: Kinematics) -> None:
        self._kinematics = kinematics
        self._counts: Counts | None = None
        self._last_s = 0.0
        self.pose: Pose | None = None
        self.is_homed = False
        self.replied_s = 0.0
        self.buttons = 0
        self.rejected = 0

    @property
    def has_lost_its_place(self) -> bool:
        """Whether the encoders went on from elsewhere: it was no glitch."""
        return self.rejected >= LEAPS_TO_FAULT

    def take(self, reply: Reply, at_s: float) -> None:
        """Use a reply that has not been used before."""
        gap_s, self._last_s = at_s - self._last_s, at_s
        self.is_homed = reply.is_homed
        if not reply.is_homed:  # the counts mean nothing, and will jump to their zero
            self._counts, self.pose = None, None
        elif self._leaps(reply.counts, gap_s) or not self._moved_to(reply.counts):
            self.rejected += 1
            return
        self.rejected = 0
        self.replied_s, self.buttons = at_s, reply.buttons

    def _leaps(self, counts: Counts, gap_s: float) -> bool:
        if self._counts is None:
            return False
        most = MOST_COUNTS_PER_MS * max(1.0, gap_s / _PERIOD_S)
        pairs = zip(counts, self._counts, strict=True)
        return any(abs(now - before) > most for now, before in pairs)

    def _moved_to(self, counts: Counts) -> bool:
        if counts == self._counts:
            return True
        near_m = self.pose.position_m if self.pose is not None else None
        try:
            self.pose = self._kinematics.pose(self._kinematics.angles(counts), near_m)
        except OutOfReachError:
            return False
        self._counts = counts
        return True
