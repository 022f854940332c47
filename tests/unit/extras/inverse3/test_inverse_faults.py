"""The safety contract with the Inverse3's driver, and faults only its service has."""

import json
from functools import partial

import pytest

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import ZERO
from tests.faults.driver_faults import Side, cases_of, check_force_is_gone_in_time
from tests.faults.haptic_rig import Rig, SlowClock
from tests.unit.extras.inverse3.inverse_rig import InverseGrip, Placed

# An answer is taken with the tick after its command. JSON has no "not a number".
NEWER = Side(
    InverseGrip,
    phases=3,
    slack=2,
    cannot=("position-not-finite",),
    also={},
    deaf=("unplugged", "reply-late", "reply-lost"),
)
OLDER = NEWER._replace(  # it says `values` for `vector`
    make=partial(InverseGrip, version="3.1.2"), phases=1
)


@pytest.fixture(params=["3.5.0", "3.1.2"])
def rig(request):
    clock = SlowClock()
    made = Rig(device=InverseGrip(clock, request.param), clock=clock)
    yield made
    made.close()


def test_a_repeated_state_under_a_new_force_is_doubted(rig):
    """A service that hangs inside answers, always with the same position."""
    rig.following()
    service = rig.device.service
    service.frozen = service.answer("{}", rig.clock.now_s())
    count = rig.ticks_to(Mode.RAMPING, 400)
    assert rig.cause is Cause.REPLY_LATE
    assert count > 100
    service.frozen = None
    rig.tick(600)
    assert rig.mode is Mode.FOLLOWING


def test_a_doubt_lasts_until_the_position_changes(rig):
    """The force that was there when the service hung proves nothing."""
    rig.following()
    service = rig.device.service
    service.frozen = service.answer("{}", rig.clock.now_s())
    rig.ticks_to(Mode.RAMPING, 400)
    rig.ticks_to(Mode.TRIPPED, 4000)


def test_an_error_that_the_device_reports_ends_the_force(rig):
    rig.following()
    service = rig.device.service
    message = json.loads(service.answer("{}", rig.clock.now_s()))
    message["inverse3"][0]["status"]["error"] = 7
    service.frozen = json.dumps(message)
    rig.ticks_to(Mode.TRIPPED, 50)


@pytest.mark.parametrize("error", [{"error": "usb lost"}, {"errors": ["usb lost"]}])
def test_an_error_in_place_of_a_state_is_said(rig, error):
    rig.following()
    rig.device.service.frozen = json.dumps(error)
    rig.ticks_to(Mode.TRIPPED, 400)
    assert "reports the error usb lost; look" in rig.loop.reading.notice


def test_the_answer_of_another_device_is_none(rig):
    rig.following()
    service = rig.device.service
    message = json.loads(service.answer("{}", rig.clock.now_s()))
    message["inverse3"][0]["device_id"] = "9999"
    service.frozen = json.dumps(message)
    rig.ticks_to(Mode.TRIPPED, 400)
    assert rig.cause is Cause.MALFORMED


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
    assert rig.device.applied_n == ZERO


def test_the_axes_are_turned_between_the_frames(rig):
    service = rig.device.service
    service.simulation = Placed((0.01, 0.02, 0.03), service.simulation)
    rig.device.exchange((1.0, 2.0, 3.0), 1.0)
    reading = rig.device.exchange((1.0, 2.0, 3.0), 1.001)
    assert reading.position_m == pytest.approx((0.01, 0.02, 0.03), abs=1e-6)
    assert rig.device.applied_n == (1.0, 2.0, 3.0)
    sent = rig.device.link.sent[-1]
    assert '{"x":1.0,"y":-3.0,"z":2.0}' in sent


@pytest.mark.parametrize(
    ("side", "name", "phase"),
    [(side, *case) for side in (NEWER, OLDER) for case in cases_of(side)],
)
def test_the_force_is_gone_in_the_stated_time_and_its_slack(side, name, phase):
    check_force_is_gone_in_time(side, name, phase)
