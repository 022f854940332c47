"""When a block sounds: by the count of the samples, checked against what is stated.

A sound server that stands still for 30 to 100 ms states times that are off by 10 to
30 ms for some ten seconds afterwards, while not one sample is late (its client fits a
line to few answers). The samples themselves tell the time without a break, except where
the output ran dry, and that shows: nothing handed over is left. So a stated time that
leaves their line is believed only once it stays where it is.
"""

NEAR_S = 0.002
"""So near, stated times move the line: clocks differ by up to some 100 ppm."""
FOLLOWS_WITHIN_S = 1.0
STEADY_S, STEADY_WITHIN_S = 2.0, 0.0015
"""Times that leave the line by the same for so long are true: another output."""
AGREED_S, LONGEST_HELD_S = 0.5, 12.0
"""Where times have not agreed with the line and each other for so long within so long,
the output is one whose times just jitter."""


class DacLine:
    """Tells when each block sounds; blocks come in the order in which they are heard.

    Args:
        rate_hz: of the samples.
    """

    def __init__(self, rate_hz: int) -> None:
        self._rate_hz = rate_hz
        self._handed = 0  # samples, before this block
        self._line_s: float | None = None  # when sample 0 sounded
        self._agreed_s = 0.0  # when stated times were last on it
        self._since_s = self._least_s = self._most_s = 0.0  # of times that agree

    @property
    def is_known(self) -> bool:
        """Whether the samples have a line; else stated times are passed on."""
        return self._line_s is not None

    def place(
        self, now_s: float, stated_s: float, count: int, *, ran_dry: bool = False
    ) -> tuple[float, float]:
        """Take the next block.

        Args:
            now_s: monotonic time of being asked for it.
            stated_s: monotonic time at which it sounds, as the output says.
            count: its samples.
            ran_dry: whether the output says that it had nothing left before it.

        Returns:
            The monotonic time at which it sounds, and how much silence the output has
            put in before it, as far as that is known, s.
        """
        elapsed_s = self._handed / self._rate_hz
        offset_s = stated_s - elapsed_s
        if self._handed:
            self._follow_run(now_s, offset_s)
        else:
            self._begin_run(now_s, offset_s)
        self._handed += count
        if self._line_s is None:
            if self._have_agreed(now_s, STEADY_S):
                self._line_s, self._agreed_s = offset_s, now_s
            return stated_s, 0.0
        expected_s = self._line_s + elapsed_s
        if ran_dry:  # it begins anew, and the first time that it states was right
            self._line_s, self._agreed_s = offset_s, now_s
            return stated_s, max(0.0, stated_s - expected_s)
        if now_s >= expected_s:
            self._line_s = None
            return stated_s, 0.0
        off_s = offset_s - self._line_s
        if abs(off_s) <= NEAR_S:
            share = count / self._rate_hz / FOLLOWS_WITHIN_S
            self._line_s += min(1.0, share) * off_s
            if self._have_agreed(now_s, AGREED_S):
                self._agreed_s = now_s
        elif self._have_agreed(now_s, STEADY_S):
            self._line_s = 0.5 * (self._least_s + self._most_s)
        if now_s > self._agreed_s + LONGEST_HELD_S:
            self._line_s = None
            return stated_s, 0.0
        return self._line_s + elapsed_s, 0.0

    def _follow_run(self, now_s: float, offset_s: float) -> None:
        """Note for how long the stated times have agreed with each other."""
        least_s, most_s = min(self._least_s, offset_s), max(self._most_s, offset_s)
        if most_s - least_s > STEADY_WITHIN_S:
            self._begin_run(now_s, offset_s)
        else:
            self._least_s, self._most_s = least_s, most_s

    def _begin_run(self, now_s: float, offset_s: float) -> None:
        self._since_s, self._least_s, self._most_s = now_s, offset_s, offset_s

    def _have_agreed(self, now_s: float, so_long_s: float) -> bool:
        return now_s - self._since_s >= so_long_s
