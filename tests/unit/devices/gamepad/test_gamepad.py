"""Pads: bytes as the kernel has them, motors that follow the force, and always stop."""

import math
import subprocess
import sys
import threading

import pytest
from fake_pad import FakePad

from hapticplayer.devices.capabilities import GAMEPAD
from hapticplayer.devices.gamepad import ports
from hapticplayer.devices.gamepad.driver import REFRESH_S
from hapticplayer.devices.gamepad.reports import (
    DUALSENSE,
    DUALSHOCK4,
    buttons_of,
    layout_of,
    motors_report,
)
from hapticplayer.devices.gamepad.rumble import Rumble
from hapticplayer.devices.paced import NewestWriter, PacedDriver, silencer
from hapticplayer.errors import DeviceError
from tests.doubles import DirectWriter

ZERO = (0.0, 0.0, 0.0)


def test_the_reports_are_the_kernels():
    """Offsets of hid-playstation.c: DualSense motors right 3, left 4; DS4 right 4, left 5."""
    sense = motors_report(DUALSENSE, strong=0xAB, weak=0xCD)
    assert sense == b"\x02\x03\x00\xcd\xab" + bytes(43)
    shock = motors_report(DUALSHOCK4, strong=0xAB, weak=0xCD)
    assert shock == b"\x05\x01\x00\x00\xcd\xab" + bytes(26)
    assert (len(sense), len(shock)) == (48, 32)
    with pytest.raises(ValueError, match="range"):
        motors_report(DUALSENSE, 256, 0)


def test_pads_are_known_by_their_numbers():
    assert layout_of(0x0CE6) is layout_of(0x0DF2) is DUALSENSE
    assert layout_of(0x05C4) is layout_of(0x09CC) is DUALSHOCK4
    assert layout_of(0x0268) is None


@pytest.mark.parametrize("layout", [DUALSENSE, DUALSHOCK4], ids=lambda it: it.title)
def test_each_button_is_a_bit_and_a_resting_pad_has_none(layout):
    seen = set()
    presses = [(0x08 | 1 << n, 0, 0) for n in range(4, 8)]
    presses += [(0x08, 1 << n, 0) for n in range(8)]
    presses += [(0x08, 0, 1 << n) for n in range(2)] + [(0x02, 0, 0)]
    for press in presses:
        report = bytearray(64)
        report[0] = 1
        report[layout.buttons_at : layout.buttons_at + 3] = bytes(press)
        mask = buttons_of(layout, bytes(report))
        assert mask.bit_count() == 1
        seen.add(mask)
    assert len(seen) == len(presses)
    rest = bytearray(64)
    rest[0], rest[layout.buttons_at], rest[layout.buttons_at + 2] = 1, 0x08, 0xF8
    assert buttons_of(layout, bytes(rest)) == 0
    assert buttons_of(layout, b"\x31" + bytes(77)) is None
    assert buttons_of(layout, b"") is None


def steady(rumble, force_n, seconds, begin_s=0.0):
    for k in range(round(1000 * seconds)):
        levels = rumble.levels(force_n(k / 1000.0), begin_s + k / 1000.0)
    return levels


def test_a_steady_force_is_felt_in_the_large_motor():
    assert steady(Rumble(), lambda _: (0.0, 2.25, 0.0), 1.0) == (128, 0)
    assert steady(Rumble(), lambda _: (3.0, 3.0, 3.0), 1.0) == (255, 0)  # above full
    assert Rumble().levels((0.0, 4.5, 0.0), 0.0)[1] > 200  # a jolt


@pytest.mark.parametrize(("hertz", "least", "most"), [(1, 0, 20), (40, 45, 85)])
def test_what_changes_faster_than_10_hz_turns_the_small_motor(hertz, least, most):
    """Of 2.25 N +- 1 N (57 levels): a one-pole high-pass at 10 Hz lets 0.1 and 0.97 by."""
    levels = []
    rumble = Rumble()
    for k in range(2000):
        t = k / 1000.0
        size = 2.25 + math.sin(2 * math.pi * hertz * t)
        levels.append(rumble.levels((size, 0.0, 0.0), t)[1])
    assert least <= max(levels[1000:]) <= most


def test_nothing_that_is_no_number_turns_anything():
    rumble = Rumble()
    for bad in (math.nan, math.inf):
        assert rumble.levels((bad, 0.0, 0.0), 1.0) == (0, 0)
    assert steady(rumble, lambda _: (0.0, 2.25, 0.0), 1.0, 2.0) == (128, 0)


def test_at_most_100_reports_a_second_and_none_without_news():
    pad = FakePad()
    device = PacedDriver("gamepad", GAMEPAD, lambda: pad, REFRESH_S, DirectWriter)
    device.open()
    for k in range(1000):
        t = k / 1000.0
        device.exchange((2.0 + math.sin(50 * t), 0.0, 0.0), 5.0 + t)
    assert 80 < len(pad.written) <= 100
    for k in range(3000):
        device.exchange((2.0, 0.0, 0.0), 6.0 + k / 1000.0)
    pad.written.clear()
    for k in range(2000):  # a steady force is sent again from time to time
        device.exchange((2.0, 0.0, 0.0), 9.0 + k / 1000.0)
    assert 3 <= len(pad.written) <= 4
    for k in range(1000):
        device.exchange(ZERO, 11.0 + k / 1000.0)
    assert pad.motors == (0, 0)
    pad.written.clear()
    for k in range(1000):
        device.exchange(ZERO, 12.0 + k / 1000.0)
    assert pad.written == []
    device.close()
    assert pad.motors == (0, 0)
    assert not pad.is_open


def test_the_thread_sends_the_newest_and_tells_of_a_lost_pad():
    pad, written = FakePad(), threading.Event()
    write = pad.write

    def slow_write(report):
        write(report)
        written.set()

    pad.write = slow_write
    outlet = NewestWriter(pad)
    outlet.post(motors_report(DUALSENSE, 7, 0))
    assert written.wait(30)
    pad.is_plugged = False
    written.clear()

    def go_on():
        for _ in range(10_000):  # the thread meets it a little later
            outlet.post(motors_report(DUALSENSE, 8, 0))
            written.wait(0.001)

    with pytest.raises(DeviceError, match="unplugged"):
        go_on()
    outlet.stop()
    assert pad.motors == (7, 0)


def test_the_guard_switches_off_beside_the_loop_and_after_it():
    pad = FakePad()
    write_zero = silencer(lambda: pad)
    pad.write(motors_report(DUALSENSE, 200, 100))
    assert write_zero()
    assert pad.motors == (0, 0)
    pad.is_plugged = False
    assert not write_zero()


def test_a_program_that_ends_without_closing_leaves_no_motor_on(tmp_path):
    code = """
import sys
sys.path.insert(0, sys.argv[1])
from fake_pad import FakePad
from hapticplayer.devices.capabilities import GAMEPAD
from hapticplayer.devices.paced import PacedDriver
pad = FakePad()
close = pad.close
pad.close = lambda: (print("motors", *pad.motors), close())
device = PacedDriver('gamepad', GAMEPAD, lambda: pad, 0.5)
device.open()
for k in range(50):
    device.exchange((4.0, 0.0, 0.0), 1.0 + k / 1000.0)
print("on", any(any(report[3:5]) for report in pad.written) or "posted")
raise RuntimeError("something else is broken")
"""
    folder = str(pytest.importorskip("fake_pad").__file__).rsplit("/", 1)[0]
    done = subprocess.run(
        [sys.executable, "-c", code, folder],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert "RuntimeError" in done.stderr
    assert done.stdout.splitlines()[-1] == "motors 0 0"


class FakeHidapi:
    """hidapi with one pad on USB, one on Bluetooth, and a stranger."""

    def __init__(self, problem=None):
        self.opened, self.problem = [], problem

    def enumerate(self, vendor, product):
        assert (vendor, product) == (0x054C, 0)
        common = {"serial_number": "", "bus_type": 1}
        return [
            {**common, "path": b"/dev/hidraw7", "product_id": 0x0268},
            {**common, "path": b"/dev/hidraw8", "product_id": 0x0CE6, "bus_type": 2},
            {**common, "path": b"/dev/hidraw9", "product_id": 0x09CC},
        ]

    def device(self):
        return self

    def open_path(self, path):
        if self.problem:
            raise OSError("open failed")
        self.opened.append(path)

    def set_nonblocking(self, flag):
        assert flag == 1

    def write(self, report):
        return -1

    def read(self, _count):
        raise OSError("read error")

    def close(self):
        self.opened.clear()


def test_only_pads_on_usb_are_opened_and_trouble_says_what_to_do(monkeypatch):
    api = FakeHidapi()
    for name in ("hidraw", "hid"):
        monkeypatch.setitem(sys.modules, name, api)
    port = ports.open_pad()
    assert api.opened == [b"/dev/hidraw9"]
    assert port.layout is DUALSHOCK4
    with pytest.raises(DeviceError, match="unplugged"):
        port.write(b"")
    with pytest.raises(DeviceError, match="unplugged"):
        port.read()
    port.close()
    api.problem = True
    with pytest.raises(DeviceError, match="udev rule"):
        ports.open_pad()
    monkeypatch.setattr(api, "enumerate", lambda *_: [])
    with pytest.raises(DeviceError, match="no game pad"):
        ports.open_pad()
