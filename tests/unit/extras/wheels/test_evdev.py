"""Force feedback of Linux: the kernel's structs, one axis, and an end on its own."""

import ctypes
import math
import os

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.clock import ManualClock
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import checks_of
from hapticplayer.devices.paced import PacedDriver
from hapticplayer.errors import DeviceError
from hapticplayer.extras.wheels import effects, guide, ports
from hapticplayer.extras.wheels.extension import RUMBLE, WHEEL
from hapticplayer.extras.wheels.options import wheel_options
from hapticplayer.rendering.demonstration import demonstration
from tests.doubles import DirectWriter
from tests.unit.extras.wheels.fake_input import (
    Constant,
    Effect,
    FakeInput,
    InputEvent,
    Rumble,
)

ZERO = (0.0, 0.0, 0.0)


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def kernel(clock, monkeypatch):
    return FakeInput(clock, monkeypatch)


def opener(kind, translate):
    return lambda: ports.open_first(kind, "", translate)


@pytest.fixture
def wheel(kernel):
    open_port = opener(
        effects.FF_CONSTANT, lambda: effects.ConstantForceTranslator(0, 4.5)
    )
    made = PacedDriver("wheel", WHEEL, open_port, effects.REFRESH_S, DirectWriter)
    yield made
    made.close()


def drive(device, clock, force_n, ticks):
    for _ in range(ticks):
        reading = device.exchange(force_n, clock.now_s())
        clock.advance(0.001)
    return reading


def test_the_structs_are_those_of_the_c_header():
    """Offsets of <linux/input.h>: union at 16, 48 bytes; an event has 24."""
    assert (ctypes.sizeof(Effect), Effect.u.offset, Effect.length.offset) == (
        48,
        16,
        10,
    )
    assert ctypes.sizeof(InputEvent) == effects.EVENT_SIZE == 24
    constant = Effect.from_buffer_copy(effects.constant_effect(-1234))
    assert (constant.type, constant.id, constant.u.constant.level) == (0x52, -1, -1234)
    assert constant.length == effects.LENGTH_MS
    assert (Constant.envelope.offset, Rumble.weak.offset) == (2, 2)
    rumble = Effect.from_buffer_copy(effects.rumble_effect(0xABCD, 0x1234))
    assert (rumble.type, rumble.u.rumble.strong) == (0x50, 0xABCD)
    assert rumble.u.rumble.weak == 0x1234
    event = InputEvent.from_buffer_copy(effects.event_bytes(0x15, 0x60, -5))
    assert (event.type, event.code, event.value) == (0x15, 0x60, -5)


@given(
    st.floats(allow_nan=True, allow_infinity=True),
    st.sampled_from([0.5, 4.5, -4.5, 20.0]),
    st.integers(0, 2),
)
def test_a_level_is_the_share_of_the_axis_and_bounded(force_n, full_n, axis):
    vector = [7.0, -7.0, 7.0]
    vector[axis] = force_n
    command = effects.ConstantForceTranslator(axis, full_n).command(tuple(vector), 0.0)
    level = Effect.from_buffer_copy(command).u.constant.level
    if not math.isfinite(force_n):
        assert level == 0
    elif abs(force_n) < abs(full_n):
        assert level == pytest.approx(32767 * force_n / full_n, abs=0.5)
    elif abs(force_n) < 1e8:
        assert level == math.copysign(32767, force_n * full_n)


def test_a_force_is_felt_follows_and_ends(wheel, kernel, clock):
    wheel.open()
    drive(wheel, clock, (2.25, 4.0, 4.0), 1000)
    assert kernel.felt == (16384, 0)
    assert len(kernel.effects) == 1
    drive(wheel, clock, (-4.5, 0.0, 0.0), 5)
    assert kernel.felt == (-32767, 0)
    drive(wheel, clock, ZERO, 5)
    assert kernel.felt == (0, 0)
    wheel.close()
    assert kernel.effects == {}


def test_a_loop_that_stands_still_is_felt_for_a_quarter_second(wheel, kernel, clock):
    wheel.open()
    drive(wheel, clock, (4.5, 0.0, 0.0), 100)
    clock.advance(0.2 * effects.REFRESH_S)
    assert kernel.felt == (32767, 0)
    clock.advance(effects.LENGTH_MS / 1000.0)
    assert kernel.felt == (0, 0)


def test_the_guard_takes_the_gain_and_the_loop_brings_it_back(wheel, kernel, clock):
    wheel.open()
    write_zero = find_device("wheel").silence(-1)
    drive(wheel, clock, (4.5, 0.0, 0.0), 50)
    assert write_zero()
    assert kernel.felt == (0, 0)
    drive(wheel, clock, (4.0, 0.0, 0.0), 10)
    assert kernel.felt[0] > 0
    kernel.is_plugged = False
    assert not write_zero()


def test_a_device_that_takes_nothing_grows_old(wheel, kernel, clock):
    class Stuck(DirectWriter):
        is_waiting = False

        def post(self, _command):
            self.is_waiting = True

    wheel.make_writer = Stuck
    wheel.open()
    first = drive(wheel, clock, ZERO, 10)
    assert clock.now_s() - first.replied_s < 0.002
    last = drive(wheel, clock, (1.0, 0.0, 0.0), 300)
    assert clock.now_s() - last.replied_s > 0.09


def test_buttons_come_and_go_and_lost_events_release_them(wheel, kernel, clock):
    wheel.open()
    kernel.press(0x121)
    kernel.press(0x130)
    assert drive(wheel, clock, ZERO, 1).buttons == 0b11
    kernel.press(0x121, 0)
    assert drive(wheel, clock, ZERO, 1).buttons == 0b01
    kernel.waiting.append(effects.event_bytes(effects.EV_SYN, effects.SYN_DROPPED, 0))
    assert drive(wheel, clock, ZERO, 1).buttons == 0
    kernel.press(30)  # a key of a keyboard
    assert drive(wheel, clock, ZERO, 1).buttons == 0


@pytest.mark.parametrize(
    ("text", "axis", "full_n", "node"),
    [
        ("event5", 0, 4.5, "event5"),
        ("axis=y", 1, 4.5, ""),
        ("event12,axis=z,full=2.5,sign=-", 2, -2.5, "event12"),
        ("full=9,sign=+", 0, 9.0, ""),
    ],
)
def test_options_choose_node_axis_scale_and_sign(text, axis, full_n, node):
    found = wheel_options(text)
    assert (found.axis, found.sign * found.full_n, found.address) == (
        axis,
        full_n,
        node,
    )
    record = find_device(f"wheel:{text}").capabilities
    assert (record.axes, record.first_axis, record.has_newtons) == (1, axis, False)


@pytest.mark.parametrize(
    ("text", "allowed"),
    [
        ("axis=w", "use x, y, z"),
        ("full=nan", "between 0.5 and 20"),
        ("full=0", "between 0.5 and 20"),
        ("a,b", "such as event5"),
        ("event1,event2", "say it once"),
        ("sign=2", "use \\+, -"),
        ("x=1", "use axis, full, sign"),
    ],
)
def test_option_that_is_not_allowed_says_what_is(text, allowed):
    with pytest.raises(DeviceError, match=rf"wheel option .*{allowed}"):
        find_device(f"wheel:{text}")


def test_the_demonstration_of_an_axis_has_its_two_directions():
    _track, steps = demonstration(find_device("wheel:axis=y").capabilities)
    assert {step.direction for step in steps} == {"up", "down"}


def test_devices_are_found_by_the_mask_of_what_they_can(tmp_path):
    for node, mask, title in [
        ("event10", "107030000 0\n", "Pad"),
        ("event2", "300040000 0\n", "Wheel"),
        ("event3", "0\n", "Mouse"),
        ("event4", "what\n", "Broken"),
    ]:
        folder = tmp_path / node / "device"
        (folder / "capabilities").mkdir(parents=True)
        (folder / "capabilities" / "ff").write_text(mask)
        (folder / "name").write_text(title + "\n")
    wheels = ports.list_devices(effects.FF_CONSTANT, tmp_path)
    assert [one.title for one in wheels] == ["Wheel"]
    pads = ports.list_devices(effects.FF_RUMBLE, tmp_path)
    assert [one.node for one in pads] == ["event10"]
    assert ports.list_devices(effects.FF_RUMBLE, tmp_path / "none") == []


def test_who_may_not_open_it_is_told_what_to_do(wheel, kernel):
    kernel.is_allowed = False
    with pytest.raises(DeviceError, match="group input"):
        wheel.open()
    with pytest.raises(DeviceError, match=r"event9: .* event3 \(Wheel\)"):
        ports.open_first(effects.FF_CONSTANT, "event9", effects.RumbleTranslator)


def test_a_pad_rumbles_as_strongly_as_the_force(kernel, clock):
    open_port = opener(effects.FF_RUMBLE, effects.RumbleTranslator)
    pad = PacedDriver("rumble", RUMBLE, open_port, effects.REFRESH_S, DirectWriter)
    pad.open()
    drive(pad, clock, (0.0, 2.25, 0.0), 1000)
    strong, weak = kernel.felt
    pad.close()
    assert strong == pytest.approx(0x8080, abs=0x101)
    assert weak < 0x300


def _states(name):
    return {str(check.what): check.is_met for check in checks_of(find_device(name))}


def test_a_wheel_needs_its_driver_and_the_group(monkeypatch):
    found = []
    monkeypatch.setattr(guide, "list_devices", lambda _effect: found)
    assert _states("wheel") == {"Wheel or joystick with a motor": False}
    found.append(ports.InputDevice("event7", "G29"))
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert _states("wheel:event7,axis=y") == {
        "G29": True,
        "Permission for /dev/input/event7": False,
    }
    assert _states("rumble:event8") == {"Game pad that Linux can rumble": False}
    (_, permission) = checks_of(find_device("wheel"))
    assert "group input" in permission.remedy
