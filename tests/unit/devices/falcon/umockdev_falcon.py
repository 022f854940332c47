# ruff: noqa: E402 - the path of the imports has to be set before them
"""A Falcon below the machine's own libusb: run with umockdev-wrapper, prints JSON.

umockdev keeps sysfs, udev and the device's node; here are the answers to the ioctls of
usbfs (Linux, include/uapi/linux/usbdevice_fs.h, layout of 64-bit machines), given by
the same simulated chip that the other tests use. Functional only: the node of a mock is
always ready, so libusb spins.
"""

import errno
import json
import os
import struct
import sys
import threading

sys.path.append("/usr/lib/python3/dist-packages")  # where Debian keeps it

import gi

gi.require_version("UMockdev", "1.0")
from gi.repository import GLib, UMockdev

from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon import usbfs
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.devices.falcon.transport import (
    ENDPOINT_OUT,
    list_falcons,
    open_falcon,
)
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.board import Board, synthetic_image
from hapticplayer.extras.faults.usb.chip import Chip, UsbFault
from tests.doubles import BenchMechanics

CONTROL, BULK = 0xC0185500, 0xC0185502
SUBMIT, DISCARD, REAP, REAP_NOW = 0x8038550A, 0x550B, 0x4008550C, 0x4008550D
CLAIM, RELEASE, GET_DRIVER, IOCTL = 0x8004550F, 0x80045510, 0x41045508, 0xC0105512
CAPABILITIES, DISCONNECT = 0x8004551A, 0x5516
URB_BYTES, DRIVER_BYTES = 56, 260
CONTROL_TRANSFER, IN = 2, 0x80
STRINGS = {1: "Novint", 2: "FALCON HAPTIC", 3: "12PZ657E"}
DEVICE = bytes.fromhex("12010002000000080304" + "48cb0006" + "01020301")
CONFIGURATION = bytes.fromhex("09022000010100a02d0904000002ffffff0207058102400000")
CONFIGURATION += bytes.fromhex("07050202400000")


class Node:
    """The device's node: what usbfs would answer."""

    def __init__(self, chip):
        self.chip = chip
        self.driver = b"ftdi_sio"
        self.claimed_over = ""
        self.pending, self.done, self.kept = [], [], []

    def handle(self, _handler, client):
        """Answer one ioctl."""
        try:
            result, problem = self.answer(client.get_request(), client), 0
        except UsbFault as fault:
            result, problem = -1, fault.errno
        client.complete(result, problem)
        return True

    def answer(self, request, client):  # noqa: C901, PLR0912 - one case for each ioctl
        if not self.chip.is_plugged:
            raise UsbFault(errno.ENODEV, "gone")
        argument = client.get_arg()
        self.kept.append(argument)  # the library does not hold what it lends
        if request == CAPABILITIES:
            argument.resolve(0, 4).update(0, struct.pack("<I", 0))
        elif request == GET_DRIVER:
            if not self.driver:
                raise UsbFault(errno.ENODATA, "no driver")
            name = self.driver.ljust(DRIVER_BYTES - 4, b"\0")
            argument.resolve(0, DRIVER_BYTES).update(4, name)
        elif request == IOCTL:
            wrapped = bytes(argument.resolve(0, 16).retrieve())
            assert struct.unpack_from("<ii", wrapped)[1] == DISCONNECT
            self.driver = b""
        elif request == CLAIM:
            if self.driver:
                raise UsbFault(errno.EBUSY, "taken")
        elif request == SUBMIT:
            self.submit(argument.resolve(0, URB_BYTES))
        elif request in (REAP, REAP_NOW):
            self.reap(argument.resolve(0, 8))
        elif request == DISCARD:
            self.discard()
        elif request == BULK:
            return self.bulk(argument.resolve(0, 24))
        elif request != RELEASE:
            raise UsbFault(errno.ENOTTY, hex(request))
        return 0

    def submit(self, urb):
        kind, endpoint, length = struct.unpack_from("<BB22xi", bytes(urb.retrieve()))
        data = urb.resolve(16, length)
        if kind == CONTROL_TRANSFER:
            self.finish(urb, data, self.control(bytes(data.retrieve())))
        elif endpoint & IN:
            self.pending.append((urb, data))
        else:
            taken = self.chip.write(bytes(data.retrieve()), 0.0)
            self.finish(urb, None, taken)

    def control(self, setup):
        kind, request, value, index, length = struct.unpack_from("<BBHHH", setup)
        if kind & IN:
            assert request == 6
            which = value & 0xFF
            text = STRINGS[which].encode("utf-16-le") if which else b"\x09\x04"
            return (bytes((len(text) + 2, 3)) + text)[:length]
        self.chip.control(request, value, index)
        return b""

    def finish(self, urb, data, answer, status=0):
        count = answer
        if isinstance(answer, bytes):
            count = len(answer)
            if data is not None and answer:
                is_control = urb.retrieve()[0] == CONTROL_TRANSFER
                data.update(8 if is_control else 0, answer)
        urb.update(4, struct.pack("<i", status))
        urb.update(28, struct.pack("<i", count))
        self.done.append(urb)

    def reap(self, place):
        if not self.done and self.pending:
            packet = self.chip.read(0.0)
            if packet is not None:
                urb, data = self.pending.pop(0)
                self.finish(urb, data, packet)
        if not self.done:
            raise UsbFault(errno.EAGAIN, "nothing yet")
        place.set_ptr(0, self.done.pop(0))

    def discard(self):
        if self.pending:
            urb, data = self.pending.pop(0)
            self.finish(urb, data, b"", -errno.ENOENT)

    def bulk(self, request):
        endpoint, length = struct.unpack_from("<II", bytes(request.retrieve()))
        assert endpoint == ENDPOINT_OUT
        return self.chip.write(bytes(request.resolve(16, length).retrieve()), 0.0)


def plug_in(node):
    """Return a machine with the Falcon in it."""
    testbed = UMockdev.Testbed.new()
    hexadecimal = (DEVICE + CONFIGURATION).hex().upper()
    testbed.add_from_string(
        "P: /devices/pci0000:00/0000:00:14.0/usb1/1-1\n"
        "N: bus/usb/001/005\n"
        "E: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
        "E: BUSNUM=001\nE: DEVNUM=005\nE: DEVNAME=/dev/bus/usb/001/005\n"
        "A: busnum=1\\n\nA: devnum=5\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\n"
        "A: idVendor=0403\\n\nA: idProduct=cb48\\n\nA: bNumConfigurations=1\\n\n"
        f"H: descriptors={hexadecimal}\n"
    )
    handler = UMockdev.IoctlBase()
    handler.connect("handle-ioctl", node.handle)
    testbed.attach_ioctl("/dev/bus/usb/001/005", handler)
    return testbed, handler


def scenario():
    """Do all that a Falcon goes through; return what happened."""
    clock = SystemClock()
    mechanics = BenchMechanics()
    board = Board(mechanics)
    node = Node(Chip(board, clock))
    kept = plug_in(node)
    loop = GLib.MainLoop()
    threading.Thread(target=loop.run, daemon=True).start()
    found = {"serials": [falcon.serial for falcon in list_falcons()]}
    driver = FalconDriver(open_falcon, clock=clock, image=synthetic_image)
    driver.open()
    found["kernel_driver_detached"] = node.driver == b""
    found["image_is_whole"] = board.image == synthetic_image().data
    for _ in range(200):
        reading = driver.exchange((0.0, 1.0, 0.0), clock.now_s())
        clock.sleep_until(clock.now_s() + 0.002)
    found["homed"] = reading.is_homed
    found["pushed"] = mechanics.commands[-1][1] != (0, 0, 0)
    usbfs.NODE = kept[0].get_root_dir() + usbfs.NODE
    file = usbfs.open_descriptor(1, 5)
    zero = encode_command((0, 0, 0))
    found["guard_wrote"] = usbfs.bulk_write(file, ENDPOINT_OUT, zero, 0.005)
    found["zero_arrived"] = any(
        words == (0, 0, 0) for _, words in mechanics.commands[-3:]
    )
    node.chip.unplug()
    try:
        for _ in range(100):
            driver.exchange((0.0, 0.0, 0.0), clock.now_s())
            clock.sleep_until(clock.now_s() + 0.005)
    except DeviceError as problem:
        found["unplugged"] = str(problem)
    driver.close()
    del kept
    return found


if __name__ == "__main__":
    sys.stdout.write(json.dumps(scenario()) + "\n")
    sys.stdout.flush()
    os._exit(0)  # not after GLib's thread
