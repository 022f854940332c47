"""Faults that a developer makes happen to a simulated device, and what came of them.

Only a simulated device takes them, and only when it was started for it: a loop without
`--faults` refuses, and one for a real device does not start with it.
"""

import enum
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.contract import MALFORMED_TRIP, Cause, Mode
from hapticplayer.simulation.falcon.remote import Controls

SHORT_STALL_S, LONG_STALL_S = 0.06, 0.3
LATE_S, LOST_S, STALE_S = 0.035, 0.080, 0.025


class Fault(enum.StrEnum):
    """What can be made to happen."""

    UNPLUG = "unplug"
    SHORT_STALL = "short-stall"
    LONG_STALL = "long-stall"
    NONSENSE = "nonsense"
    LOST_HOMING = "lost-homing"
    LET_GO = "let-go"
    BUTTON = "button"
    POSITION_NAN = "position-nan"
    FORCE_NAN = "force-nan"
    LOOP_LATE = "loop-late"
    LOOP_LOST = "loop-lost"
    STALE_COMMAND = "stale-command"


RULES_OF: dict[Fault, tuple[Cause, ...]] = {
    Fault.UNPLUG: (Cause.UNPLUGGED,),
    Fault.SHORT_STALL: (Cause.REPLY_LATE,),
    Fault.LONG_STALL: (Cause.REPLY_LATE, Cause.REPLY_LOST),
    Fault.NONSENSE: (Cause.REPLY_LATE, Cause.MALFORMED),
    Fault.LOST_HOMING: (Cause.NOT_HOMED,),
    Fault.LET_GO: (Cause.RUNAWAY, Cause.OUTSIDE),
    Fault.BUTTON: (Cause.GRIP_BUTTON,),
    Fault.POSITION_NAN: (Cause.NOT_FINITE,),
    Fault.FORCE_NAN: (Cause.NOT_FINITE,),
    Fault.LOOP_LATE: (Cause.TICK_LATE,),
    Fault.LOOP_LOST: (Cause.TICK_LOST,),
    Fault.STALE_COMMAND: (Cause.COMMAND_STALE, Cause.TICK_LATE),
}
"""The rules of the contract that answer each of them. A hand that lets go may also be
caught by spring and fade before any rule is needed."""

DEVICE_ACTS: dict[Fault, Callable[[Controls], None]] = {
    Fault.UNPLUG: Controls.unplug,
    Fault.SHORT_STALL: lambda device: device.stall(SHORT_STALL_S),
    Fault.LONG_STALL: lambda device: device.stall(LONG_STALL_S),
    Fault.NONSENSE: lambda device: device.corrupt(2 * MALFORMED_TRIP),
    Fault.LOST_HOMING: Controls.lose_homing,
    Fault.LET_GO: Controls.let_go,
    Fault.BUTTON: lambda device: device.press(1),
}
"""What happens in the device; all others happen in the loop."""


class DeviceFaults:
    """The faults that happen in a simulated device; owns one end of its line."""

    def __init__(self, descriptor: int) -> None:
        self._controls = Controls(descriptor)

    def inject(self, fault: str) -> bool:
        """Make a fault happen; False when it is one of the loop's."""
        act = DEVICE_ACTS.get(Fault(fault))
        if act is not None:
            act(self._controls)
        return act is not None

    def close(self) -> None:
        """Hang up."""
        self._controls.close()


class Outcome(NamedTuple):
    """What the contract made of a fault."""

    cause: Cause  # the rule that spoke last, and whether it tripped
    is_trip: bool  # the force stays away until a person re-arms
    reaction_s: float  # from the fault to the first command that reacts
    # from the fault to the first command without force; None so far
    zero_s: float | None


def outcome_of(ticks: NDArray[Any], fault_s: float) -> Outcome | None:
    """The measured reaction to a fault, None before it; ticks from before it on."""
    after = ticks[ticks["monotonic_s"] >= fault_s]
    reacts = np.isin(after["mode"], (Mode.RAMPING, Mode.TRIPPED))
    if not reacts.any():
        return None
    first = int(np.argmax(reacts))
    rest = after[first:]
    trips = np.flatnonzero(rest["mode"] == Mode.TRIPPED)
    row = int(trips[0]) if len(trips) else 0
    zeros = np.flatnonzero(~rest["force_n"].any(axis=1))
    times = rest["monotonic_s"] - fault_s
    return Outcome(
        Cause(int(rest["cause"][row])),
        bool(len(trips)),
        float(times[0]),
        float(times[zeros[0]]) if len(zeros) else None,
    )
