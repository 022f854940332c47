"""The safety contract with real drivers; faults happen at the other side of each."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import pytest
from falcon_rig import FalconGrip
from haptic_cases import CASES
from haptic_rig import Rig, SlowClock
from inverse_rig import InverseGrip

from hapticplayer.haptics.contract import Cause, Mode, Reaction

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


SIDES = {
    # The answer comes with the chip's latency timer. No encoder says "not a number", and
    # none leaps through the air to the edge; a place that is lost for good is a fault of
    # the driver, earlier than 20 bad answers.
    "falcon": Side(
        FalconGrip,
        phases=3,
        slack=3,
        cannot=("position-not-finite", "pushed-out"),
        also={"encoder-leaps": Cause.UNPLUGGED},
        deaf=("unplugged",),
    ),
    # An answer is taken with the tick after its command. JSON has no "not a number".
    "inverse3": Side(
        InverseGrip,
        phases=3,
        slack=2,
        cannot=("position-not-finite",),
        also={},
        deaf=("unplugged", "reply-late", "reply-lost"),
    ),
}

old = partial(InverseGrip, version="3.1.2")  # which says `values` for `vector`
SIDES["inverse3 3.1.2"] = SIDES["inverse3"]._replace(make=old, phases=1)


@pytest.mark.parametrize(
    ("device", "name", "phase"),
    [
        (device, name, phase)
        for device, side in SIDES.items()
        for name in CASES
        if name not in side.cannot
        for phase in range(side.phases)
    ],
)
def test_the_force_is_gone_in_the_stated_time_and_its_slack(device, name, phase):
    side, case, clock = SIDES[device], CASES[name], SlowClock()
    rig = Rig(device=side.make(clock), clock=clock)
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
