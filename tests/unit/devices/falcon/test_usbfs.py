"""One open file in two processes: found, handed over, written to."""

import ctypes
import errno
import os
import socket
from pathlib import Path

import pytest

from hapticplayer.devices.descriptor_passing import hand_over, take_over
from hapticplayer.devices.falcon import usbfs
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.devices.falcon.silence import Silencer
from hapticplayer.devices.falcon.transport import ENDPOINT_OUT

ZERO_FRAME = encode_command((0, 0, 0))


@pytest.fixture
def lines():
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    yield ours.fileno(), theirs.fileno()
    ours.close()
    theirs.close()


@pytest.fixture
def kernel(monkeypatch):
    """What the kernel was asked for; it answers as `kernel.problem` says."""

    class Kernel:
        asked = ()
        problem = 0

        def ioctl(self, descriptor, request, bulk, _changes):
            data = ctypes.string_at(bulk.data, bulk.length)
            self.asked = (descriptor, request, bulk.endpoint, data, bulk.timeout_ms)
            if self.problem:
                raise OSError(self.problem, os.strerror(self.problem))
            return bulk.length

    made = Kernel()
    monkeypatch.setattr(usbfs.fcntl, "ioctl", made.ioctl)
    return made


@pytest.mark.skipif(ctypes.sizeof(ctypes.c_void_p) != 8, reason="of 64-bit machines")
def test_the_request_is_the_number_that_linux_gives_it():
    assert usbfs.BULK == 0xC0185502  # USBDEVFS_BULK, as strace prints it


def test_a_device_is_found_among_the_open_files(tmp_path, monkeypatch):
    monkeypatch.setattr(usbfs, "NODE", str(tmp_path / "{:03}-{:03}"))
    (tmp_path / "001-007").touch()
    assert usbfs.open_descriptor(1, 7) is None
    with (tmp_path / "001-007").open("r+b") as file:
        assert usbfs.open_descriptor(1, 7) == file.fileno()
        assert usbfs.open_descriptor(1, 8) is None


def test_the_newest_file_arrives_and_older_ones_are_closed(lines, tmp_path):
    assert take_over(lines[1]) is None
    for name in ("first", "second"):
        with (tmp_path / name).open("w+b") as file:
            hand_over(lines[0], file.fileno())
    before = len(list(Path("/proc/self/fd").iterdir()))
    newest, _note = take_over(lines[1])
    assert Path(f"/proc/self/fd/{newest}").readlink() == tmp_path / "second"
    assert len(list(Path("/proc/self/fd").iterdir())) == before + 1
    os.close(newest)
    assert take_over(lines[1]) is None


def test_without_anybody_to_take_it_nothing_happens(lines, tmp_path):
    with (tmp_path / "file").open("w+b") as file:
        for _ in range(10_000):  # more than a queue holds
            hand_over(lines[0], file.fileno())


def test_the_guard_writes_through_the_loops_own_file(lines, tmp_path, running, kernel):
    silencer = Silencer(running.bus, lines[1])
    running.port.is_claimed = True  # by the loop, which stands still
    assert silencer()
    assert kernel.asked == ()
    with (tmp_path / "file").open("w+b") as file:
        hand_over(lines[0], file.fileno())
        assert silencer()
        assert kernel.asked[0] != file.fileno()  # a descriptor of its own
    assert kernel.asked[1:] == (usbfs.BULK, ENDPOINT_OUT, ZERO_FRAME, 5)
    kernel.problem = errno.ETIMEDOUT
    assert silencer()  # it may listen the next time
    kernel.problem = errno.ENODEV
    assert not silencer()


def test_a_line_that_has_closed_leaves_the_search_on_the_bus(running, tmp_path):
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    ours.close()
    with theirs:
        silencer = Silencer(running.bus, theirs.fileno())
        assert silencer()
        silencer.close()
    assert not running.port.is_claimed
