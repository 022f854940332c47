"""The safety contract with the Inverse3's driver; faults happen in its service."""

import math

import pytest
from haptic_cases import CASES
from haptic_rig import Rig, SlowClock
from inverse_rig import InverseGrip, Placed

from hapticplayer.haptics.contract import Cause, Mode, Reaction
from hapticplayer.haptics.limiter import ZERO

PHASES = 5
STRIDE = 37
SLACK = 2  # an answer is taken with the tick after its command
RAMP_TICKS = 20
# JSON has no such number: what is not finite is nonsense, and counted as that.
NOT_IN_JSON = ("position-not-finite",)


@pytest.fixture(params=["3.5.0", "3.1.2"])
def rig(request):
    clock = SlowClock()
    made = Rig(device=InverseGrip(clock, request.param), clock=clock)
    yield made
    made.close()


def ticks_to(rig, mode, most):
    for count in range(1, most + 1):
        rig.tick()
        if rig.mode is mode:
            return count
    raise AssertionError(f"still {rig.mode.name} ({rig.cause.name}) after {most}")


def applied_n(rig):
    return rig.device.service.simulation.applied_n


@pytest.mark.parametrize("name", [name for name in CASES if name not in NOT_IN_JSON])
@pytest.mark.parametrize("phase", range(PHASES))
def test_the_force_is_gone_in_the_stated_time_and_two_periods(name, phase, rig):
    case = CASES[name]
    rig.following(phase * STRIDE % 700)
    assert math.hypot(*applied_n(rig)) > 1.5
    is_reachable = name not in ("reply-late", "reply-lost")
    case.inject(rig)
    expected = Mode.TRIPPED if case.reaction is Reaction.TRIP else Mode.RAMPING
    if case.gap_s > 0.001 or case.passes_s:
        rig.tick(1, case.gap_s)
        assert rig.mode is expected
    else:
        ticks_to(rig, expected, case.notice + SLACK)
    assert rig.cause is case.cause
    if name == "unplugged":
        return  # nothing can be sent any more
    applied = []
    for _ in range(RAMP_TICKS + SLACK):
        rig.tick()
        applied.append(applied_n(rig))
    assert ZERO in rig.device.sent[-RAMP_TICKS - SLACK :]
    if is_reachable:
        assert ZERO in applied


def test_a_repeated_state_under_a_new_force_is_doubted(rig):
    """A service that hangs inside answers, always with the same position."""
    rig.following()
    service = rig.device.service
    service.frozen = service.answer("{}", rig.clock.now_s())
    count = ticks_to(rig, Mode.RAMPING, 400)
    assert rig.cause is Cause.REPLY_LATE
    assert count > 100
    service.frozen = None
    rig.tick(600)
    assert rig.mode is Mode.FOLLOWING


def test_each_command_waits_for_its_answer_but_zero_does_not(rig):
    rig.following()
    link = rig.device.link
    link.answers = False
    count = len(link.sent)
    rig.tick(15)
    assert len(link.sent) - count <= 1  # the newest force of many is sent later
    rig.tick(200)
    assert 1 <= len(link.sent) - count <= 4
    assert '"x":0.0,"y":-0.0,"z":0.0' in link.sent[-1]
    link.answers = True
    rig.tick(5)
    assert applied_n(rig) == ZERO


def test_the_axes_are_turned_between_the_frames(rig):
    service = rig.device.service
    service.simulation = Placed((0.01, 0.02, 0.03), service.simulation)
    rig.device.exchange((1.0, 2.0, 3.0), 1.0)
    reading = rig.device.exchange((1.0, 2.0, 3.0), 1.001)
    assert reading.position_m == pytest.approx((0.01, 0.02, 0.03), abs=1e-6)
    assert applied_n(rig) == (1.0, 2.0, 3.0)
    sent = rig.device.link.sent[-1]
    assert '{"x":1.0,"y":-3.0,"z":2.0}' in sent
