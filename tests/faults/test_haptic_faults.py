"""Each single fault at many moments: when the loop reacts, how, and how it comes back.

Time is virtual; reactions are counted in periods of 1 ms and must be exact.
"""

import math
import re
from pathlib import Path

import pytest
from haptic_cases import CASES
from haptic_rig import Rig

from hapticplayer.haptics.contract import RULES, Cause, Mode, Reaction
from hapticplayer.haptics.limiter import ZERO, Limits
from hapticplayer.haptics.messages import MessageKind

PHASES = 8
LIMITS = Limits()
RAMP_TICKS = 20
TRIPS = [n for n, c in CASES.items() if c.mend and c.reaction is Reaction.TRIP]
RAMPS = [n for n, c in CASES.items() if c.mend and c.reaction is Reaction.RAMP]
WORSE = (Cause.HEARTBEAT_LOST, Cause.REPLY_LOST)
# Coprime to the periods of the track, so that the phases are spread.
STRIDE = 37
SAFETY = Path(__file__).parents[2] / "docs" / "safety.md"


def slews(forces):
    return [math.dist(a, b) for a, b in zip(forces[1:], forces, strict=False)]


@pytest.fixture
def rig(request):
    made = Rig(is_live=CASES[request.node.callspec.params["name"]].is_live)
    yield made
    made.close()


@pytest.fixture
def live_rig():
    made = Rig(is_live=True)
    yield made
    made.close()


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("phase", range(PHASES))
def test_the_force_is_gone_in_exactly_the_stated_time(name, phase, rig):
    check_force_is_gone(CASES[name], rig, phase * STRIDE % 700)


@pytest.mark.parametrize("name", [n for n in CASES if n != "end-of-track"])
def test_a_live_force_is_gone_in_the_same_time(name, live_rig):
    check_force_is_gone(CASES[name], live_rig, phase=300)


def check_force_is_gone(case, rig, phase):
    rig.following(phase)
    before = rig.device.sent[-1]
    case.inject(rig)
    quiet = rig.tick(case.notice - 1, case.gap_s) if case.notice > 1 else []
    after = [before, *quiet]
    gap_s = case.gap_s if not quiet else 0.001
    reacting = rig.tick(1, gap_s)
    assert rig.cause is case.cause
    if case.cause not in WORSE:  # a milder rule comes before these
        assert all(force != ZERO for force in after)
    if case.reaction is Reaction.TRIP:
        assert rig.mode is Mode.TRIPPED
        reacting += rig.tick(RAMP_TICKS)
        # unplugged, nothing can be sent any more, and nothing is
        assert all(force == ZERO for force in reacting)
        return
    assert rig.mode is Mode.RAMPING
    stop_n = LIMITS.stop_slew_n * max(1.0, gap_s / 0.001, case.passes_s / 0.001)
    assert math.hypot(*reacting[0]) < math.hypot(*after[-1])
    assert math.dist(reacting[0], after[-1]) <= stop_n + 1e-9
    reacting += rig.tick(RAMP_TICKS)
    assert ZERO in reacting[: RAMP_TICKS + 1]
    assert max(slews(reacting)) <= LIMITS.stop_slew_n + 1e-9


@pytest.mark.parametrize("name", TRIPS)
def test_a_trip_stays_until_a_person_lets_the_force_come_back(name, rig):
    case = CASES[name]
    rig.following()
    case.inject(rig)
    rig.tick(case.notice, case.gap_s if case.notice == 1 else 0.001)
    case.mend(rig)
    rig.device.velocity_mps = ZERO
    assert rig.tick(600) == [ZERO] * 600
    assert rig.mode is Mode.TRIPPED
    if math.hypot(*rig.device.position_m) > 0.02:
        rig.player.send(MessageKind.REARM)
        assert rig.tick(50) == [ZERO] * 50, "armed far from the middle"
        rig.device.position_m = ZERO
        rig.tick(60)
    rig.player.send(MessageKind.REARM)
    back = rig.tick(150)
    assert math.hypot(*back[-1]) > 0.5
    assert max(slews(back)) <= LIMITS.entry_slew_n + 1e-9


@pytest.mark.parametrize("name", RAMPS)
def test_after_a_ramp_the_force_fades_in_by_itself(name, rig):
    case = CASES[name]
    rig.following()
    case.inject(rig)
    rig.tick(case.notice + RAMP_TICKS, case.gap_s if case.notice == 1 else 0.001)
    case.mend(rig)
    back = rig.tick(400)
    start = back.index(ZERO) if ZERO in back else 0
    assert max(slews(back[start : start + 200])) <= LIMITS.entry_slew_n + 1e-9
    assert math.hypot(*back[-1]) > 1.5
    assert rig.mode is Mode.FOLLOWING


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.cause.name)
def test_every_rule_has_a_case(rule):
    assert any(
        case.cause is rule.cause and case.reaction is rule.reaction
        for case in CASES.values()
    )


def test_every_row_of_the_hazard_list_has_a_test_that_exists():
    rows = re.findall(r"^\| .*\| `([^`]+)` \|$", SAFETY.read_text(), re.MULTILINE)
    assert len(rows) >= len(CASES)
    root = SAFETY.parents[1]
    for row in rows:
        path, _, rest = row.partition("::")
        test, _, case = rest.partition("[")
        assert (root / path).is_file(), row
        assert not test or f"def {test}" in (root / path).read_text(), row
        assert not case or case.rstrip("]") in CASES, row


def test_every_case_and_cause_is_in_the_hazard_list():
    text = SAFETY.read_text()
    for name in CASES:
        assert f"[{name}]`" in text, f"no row for {name}"
    for cause in Cause:
        assert cause is Cause.NONE or f"`{cause.name}`" in text, cause
