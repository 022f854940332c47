"""What docs/devices.md asks of a device, of every device that is shipped."""

import math
import subprocess
import sys

import pytest

from hapticplayer.devices import installed_devices
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.contract import MALFORMED_TRIP, REPLY_RAMP_S
from hapticplayer.haptics.limiter import limits_of
from tests.unit.devices.conformance.world import ZERO
from tests.unit.devices.conformance.worlds import WORLDS, Example, capabilities_of

PUSH = (1.0, 1.5, 0.5)


@pytest.fixture(params=WORLDS)
def name(request):
    return request.param


@pytest.fixture
def closed(name):
    made = WORLDS[name]()
    yield made
    made.close()


@pytest.fixture
def world(closed):
    """A device that is open and has answered."""
    closed.device.open()
    closed.until(lambda reading: reading.is_homed)
    return closed


def test_every_shipped_device_is_tested_here_and_offered_by_name():
    forces = {name for name, one in installed_devices().items() if not one.takes_motion}
    assert forces == set(WORLDS) - {"example"}


def test_the_record_makes_sense_and_is_the_one_that_is_offered(name, closed):
    record = closed.device.capabilities
    assert record == capabilities_of(name, closed)
    assert 0 <= record.axes <= 3
    assert 0.0 < record.continuous_force_n <= record.peak_force_n < 50.0
    assert 0.0 < record.workspace_radius_m < 1.0
    assert 10.0 <= record.rate_hz <= 10_000.0
    assert 0.0 <= record.latency_s <= 0.1
    limits = limits_of(record)
    assert limits.force_cap_n <= record.peak_force_n
    assert limits.workspace_m == record.workspace_radius_m


def test_a_closed_device_refuses_and_closing_again_is_nothing(closed, name):
    if name != "simulated":  # that one is connected by its line
        with pytest.raises(DeviceError, match="choose"):
            closed.device.exchange(ZERO, closed.clock.now_s())
    closed.device.close()
    closed.device.close()


def test_before_the_first_answer_it_is_centred_and_not_homed(closed):
    closed.device.open()
    now_s = closed.clock.now_s()
    reading = closed.device.exchange(ZERO, now_s)
    assert math.hypot(*reading.position_m) < 0.001
    assert reading.replied_s <= closed.clock.now_s()
    if not reading.is_homed:
        assert reading.position_m == ZERO
    assert reading.malformed == 0


def test_answers_are_fresh_and_their_times_never_run_backwards(world):
    before_s = -math.inf
    fresh = 0
    for _ in range(100):
        reading = world.tick(ZERO)
        assert before_s <= reading.replied_s <= world.clock.now_s()
        assert all(map(math.isfinite, reading.position_m))
        fresh += reading.replied_s > before_s
        before_s = reading.replied_s
    assert fresh > 20


def test_force_reaches_the_motors_and_so_does_zero(world):
    assert world.are_off()
    world.until_motors(are_off=False, force_n=PUSH)
    world.until_motors(are_off=True, force_n=ZERO)


def test_closing_under_force_leaves_zero(world):
    world.until_motors(are_off=False, force_n=PUSH)
    world.device.close()
    world.until_motors(are_off=True)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_no_force_that_is_not_finite_gets_through(bad, world):
    world.until_motors(are_off=False, force_n=PUSH)
    for _ in range(50):
        try:
            world.tick((bad, 0.0, 0.0))
        except DeviceError:
            break
    # whoever refuses such a command may keep the last good one; zero still helps
    try:
        world.until_motors(are_off=True, force_n=ZERO)
    except DeviceError:
        world.device.close()
        world.until_motors(are_off=True)


def test_buttons_are_seen(world):
    assert world.tick().buttons == 0
    if not world.has_buttons:
        return
    world.press(4)
    assert world.until(lambda reading: reading.buttons != 0).is_homed


def test_buttons_are_a_mask_of_sixteen_bits():
    """The loop's block has no room for more."""
    example = WORLDS["example"]()
    example.device.open()
    example.press(3 + (1 << 70))
    assert example.until(lambda reading: reading.is_homed).buttons == 3
    example.press(-1)
    assert example.until(lambda reading: reading.buttons != 3).buttons == 0xFFFF
    example.close()


def test_a_silent_device_is_an_old_answer_and_not_an_error(world):
    world.fall_silent()
    world.tick(PUSH, 200)
    last_s = world.tick(PUSH).replied_s
    reading = world.tick(PUSH, 100)
    assert reading.replied_s == last_s
    assert world.clock.now_s() - reading.replied_s > 0.1


def test_nonsense_is_counted_and_dropped(world):
    place = world.tick(ZERO).position_m
    if not world.has_answers:
        return
    world.talk_nonsense()
    reading = world.until(lambda reading: reading.malformed >= 20)
    assert math.dist(reading.position_m, place) < 0.001


def test_a_slow_device_plays_at_its_own_rate(closed):
    """A grip that answers within 20 ms, and what takes 0.1 s for each command."""
    if not closed.can_be_slow:
        return
    closed.be_slow()
    closed.device.open()
    closed.until(lambda reading: reading.is_homed)
    closed.until_motors(are_off=False, force_n=PUSH)
    ages_s = []
    for k in range(1000):
        reading = closed.tick((1.0 + 0.5 * math.sin(k / 9), 1.5, 0.5))
        ages_s.append(closed.clock.now_s() - reading.replied_s)
    # of those that answer in real time a busy machine may delay a few
    assert sorted(ages_s)[-20] < REPLY_RAMP_S
    assert reading.malformed == 0
    assert not reading.notice
    closed.until_motors(are_off=True, force_n=ZERO)


def test_errors_that_a_device_answers_are_heard(world):
    """By its loop as malformed answers or a notice, or as its end with a reason."""
    world.tick(PUSH, 5)
    world.refuse()
    said = ""
    for k in range(3000):
        try:
            reading = world.tick((1.0 + math.sin(k), 1.5, 0.5))
        except DeviceError as problem:
            said = str(problem)
            break
        if reading.malformed >= MALFORMED_TRIP:
            return
        said = said or reading.notice
    assert ";" in said


def test_an_unplugged_device_says_what_to_do(world):
    world.tick(PUSH, 5)
    world.unplug()
    with pytest.raises(DeviceError) as raised:
        world.tick(PUSH, 3000)
    assert ";" in str(raised.value)
    assert "\n" not in str(raised.value)
    with pytest.raises(DeviceError):
        world.tick(ZERO, 10)
    world.device.close()


def test_the_guard_takes_the_force_away_after_the_loop_has_died(world):
    write_zero = world.guard()
    world.until_motors(are_off=False, force_n=PUSH)
    world.kill()
    assert write_zero() is world.needs_guard
    for _ in range(4):
        world.wait()
        if not write_zero():
            break  # there is nothing left
    world.until_motors(are_off=True)


def test_the_guard_knows_when_there_is_nothing_left(world):
    write_zero = world.guard()
    assert write_zero() is world.needs_guard
    world.unplug()
    world.kill()
    for _ in range(2000):
        if not write_zero():
            return
        world.wait()
    raise AssertionError("it never learned")


def test_the_example_is_about_sixty_lines_and_stands_alone(tmp_path):
    example = Example()
    lines = [line for line in example.code.splitlines() if line.strip()]
    assert len(lines) <= 80
    file = tmp_path / "seat.py"
    file.write_text(example.code, encoding="utf-8")
    code = (
        "import sys, seat; heavy = {'PySide6', 'av', 'scipy'} & set(sys.modules);"
        "sys.exit(str(heavy) if heavy else 0)"
    )
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True, timeout=60)
    example.close()


def test_the_example_of_the_documentation_has_sixty_lines():
    example = WORLDS["example"]()
    try:
        lines = [line for line in example.code.splitlines() if line.strip()]
        assert 40 < len(lines) <= 60
    finally:
        example.close()
