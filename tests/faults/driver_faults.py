"""The safety contract with a real driver; faults happen at its other side."""

from collections.abc import Callable
from typing import NamedTuple

from hapticplayer.haptics.contract import Cause, Mode, Reaction
from tests.faults.haptic_cases import CASES
from tests.faults.haptic_rig import Rig, SlowClock

STRIDE = 37  # of the phases of the track
RAMP_TICKS = 20


class Side(NamedTuple):
    """What the other side of a driver can do.

    Attributes:
        make: what makes the driver, with its handles.
        phases: so many moments of the track.
        slack: periods after which an answer is taken.
        cannot: faults that do not exist there.
        also: further causes that are right.
        deaf: faults in which nothing arrives.
    """

    make: Callable
    phases: int
    slack: int
    cannot: tuple[str, ...]
    also: dict[str, Cause]
    deaf: tuple[str, ...]


def cases_of(side) -> list[tuple[str, int]]:
    """Each fault of the contract at each phase of the track."""
    names = [name for name in CASES if name not in side.cannot]
    return [(name, phase) for name in names for phase in range(side.phases)]


def check_force_is_gone_in_time(side, name, phase):
    case, clock = CASES[name], SlowClock()
    rig = Rig(device=side.make(clock), clock=clock, is_live=case.is_live)
    rig.following(phase * STRIDE % 700)
    assert not rig.device.are_motors_off()
    case.inject(rig)
    expected = Mode.TRIPPED if case.reaction is Reaction.TRIP else Mode.RAMPING
    if case.gap_s > 0.001 or case.passes_s:
        rig.tick(1, case.gap_s)
        assert rig.mode is expected
    else:
        rig.ticks_to(expected, case.notice + side.slack)
    assert rig.cause in (case.cause, side.also.get(name))
    is_off = []
    for _ in range(RAMP_TICKS + side.slack):
        rig.tick()
        is_off.append(rig.device.are_motors_off())
    if name not in side.deaf:
        is_trip = case.reaction is Reaction.TRIP
        assert all(is_off[side.slack :]) if is_trip else any(is_off)
    rig.close()
