"""The stop as a latch: set by anything that stops the force, ended only by a person.

One latch belongs to a window, a session of a study or a command. Everything there that
opens a device shares it and begins stopped while it is set: players, device tests,
demonstrations. So a stop survives each change of devices, pages and dialogs.
"""

import math
from collections.abc import Callable

from hapticplayer.errors import Message, UsageError

STOPPED = Message("the force is stopped; re-arm it first")


class StopLatch:
    """Whether the force is stopped until a person re-arms it.

    Attributes:
        is_set: whether it is.
        rearmed_s: monotonic time at which it was re-armed last.
        conditions: of a re-arm, each raises UsageError where it is not met.
    """

    def __init__(self) -> None:
        self.is_set, self.rearmed_s = False, -math.inf
        self.conditions: list[Callable[[], None]] = []

    def stop(self) -> None:
        """Keep every force off from now on."""
        self.is_set = True

    def rearm(self, now_s: float) -> None:
        """Allow force again; only what a person does may call this.

        Raises:
            UsageError: when a condition is not met; it stays set.
        """
        for check in self.conditions:
            check()
        self.is_set, self.rearmed_s = False, now_s

    def refuse(self) -> None:
        """Refuse what is there to make force; raises UsageError while it is set."""
        if self.is_set:
            raise UsageError(STOPPED)
