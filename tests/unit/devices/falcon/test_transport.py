"""Finding and claiming a Falcon through the real pyusb, and what goes wrong there."""

import errno
import subprocess
import sys

import pytest
import usb.core

from hapticplayer.devices.falcon.transport import (
    FalconGoneError,
    list_falcons,
    open_falcon,
)
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.extras.faults.usb.board import Board, Stage
from hapticplayer.extras.faults.usb.chip import Chip
from tests.doubles import BenchMechanics


def another_port(bench, serial):
    chip = Chip(Board(BenchMechanics(), Stage.DARK), bench.clock)
    return SimulatedPort(chip, serial)


def test_pyusb_is_loaded_only_when_a_device_is_looked_for():
    code = (
        "import sys, hapticplayer.devices.falcon.driver; "
        "sys.exit(any(name.split('.')[0] == 'usb' for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_falcons_are_listed_with_their_serials(bench):
    bench.bus.ports.append(another_port(bench, "FTPNM0FB"))
    found = list_falcons(bench.bus)
    assert [(f.serial, f.bus, f.address) for f in found] == [
        ("SIM00001", 1, 2),
        ("FTPNM0FB", 1, 3),
    ]


def test_a_falcon_is_opened_by_its_serial(bench):
    second = another_port(bench, "FTPNM0FB")
    bench.bus.ports.append(second)
    device = open_falcon("FTPNM0FB", bench.bus)
    assert (bench.port.is_claimed, second.is_claimed) == (False, True)
    device.close()
    device.close()
    assert not second.is_claimed


def test_several_falcons_need_a_choice(bench):
    bench.bus.ports.append(another_port(bench, "FTPNM0FB"))
    with pytest.raises(DeviceError, match="FTPNM0FB, SIM00001; choose one"):
        open_falcon(backend=bench.bus)
    with pytest.raises(DeviceError, match="no Falcon '12PZ657E' is plugged in"):
        open_falcon("12PZ657E", bench.bus)


def test_no_falcon_says_what_to_connect():
    with pytest.raises(DeviceError, match="connect its USB cable and its power"):
        open_falcon(backend=SimulatedBus([]))


def test_a_driver_of_the_system_is_detached(bench):
    bench.port.has_kernel_driver = True
    device = bench.open()
    assert not bench.port.has_kernel_driver
    assert bench.port.is_claimed
    device.close()


@pytest.mark.parametrize(
    ("code", "remedy"),
    [
        (errno.EACCES, r"udev rule .*packaging/udev/.*\.rules"),
        (errno.EPERM, "udev rule"),
        (errno.EBUSY, "another program"),
        (errno.ENOSYS, "WinUSB"),
        (errno.ENODEV, "unplugged"),
        (errno.EIO, "cable is loose"),
        (errno.ETIMEDOUT, "unplug its power"),
        (errno.EPIPE, "could not be opened"),
    ],
)
def test_every_refusal_says_what_to_do(bench, code, remedy):
    bench.port.refuses_with = code
    with pytest.raises(DeviceError, match=remedy):
        open_falcon(backend=bench.bus)


def test_an_interface_in_use_is_said(bench):
    bench.port.is_claimed = True
    with pytest.raises(DeviceError, match="in use by another program"):
        bench.open()


def test_a_missing_libusb_is_named(monkeypatch):
    def nothing(**_options):
        raise usb.core.NoBackendError("No backend available")

    monkeypatch.setattr(usb.core, "find", nothing)
    with pytest.raises(DeviceError, match=r"package libusb-1\.0-0"):
        list_falcons()


def test_unplugging_is_said_by_every_call(bench):
    device = bench.open()
    bench.chip.unplug()
    for call in (
        lambda: device.read(0.001),
        lambda: device.write(b"x", 0.001),
        lambda: device.control(0, 0),
    ):
        with pytest.raises(FalconGoneError, match="unplugged"):
            call()
    device.close()


def test_a_stall_is_no_error_and_ends_in_time(running):
    device = running.open()
    began_s = running.clock.now_s()
    running.chip.stalled_until_s = began_s + 1.0
    assert device.read(0.02) == b""
    assert device.write(b"x", 0.02) == 0
    assert running.clock.now_s() - began_s == pytest.approx(0.04, abs=1e-3)
    device.close()


def test_an_idle_chip_answers_with_its_status_each_latency(running):
    device = running.open()
    device.control(9, 16)
    device.read(0.1)
    began_s = running.clock.now_s()
    assert device.read(0.1) == b"\x01\x60"
    assert running.clock.now_s() - began_s == pytest.approx(0.016)
    device.close()


def test_timeouts_are_never_for_ever(running, monkeypatch):
    """To libusb, 0 ms means that."""
    device, asked_ms, read = running.open(), [], running.bus.bulk_read

    def watched(*arguments):
        asked_ms.append(arguments[-1])
        return read(*arguments)

    monkeypatch.setattr(running.bus, "bulk_read", watched)
    device.read(0.0)
    device.read(0.0201)
    assert asked_ms == [1, 21]
    device.close()
