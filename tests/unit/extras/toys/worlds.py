"""A toy through a fake Intiface, and a board that takes TCode."""

import contextlib
import socket

from hapticplayer.clock import SystemClock
from hapticplayer.devices import installed_devices
from hapticplayer.extras.toys import buttplug, tcode
from tests.unit.devices.conformance.world import Stuckable, World
from tests.unit.extras.toys.fake_intiface import FakeIntiface


class Toy(World):
    """A toy through a fake Intiface, in real time."""

    has_place = has_buttons = False

    def __init__(self):
        self.clock = SystemClock()
        self.server = FakeIntiface()
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.lines = ours, theirs
        self.device = installed_devices()["buttplug"].make(ours.fileno())
        self.device.open_port = lambda: buttplug.ButtplugPort(
            self.server.where, ours.fileno(), self.clock, overdue_s=0.01
        )

    def wait(self):
        self.clock.sleep_until(self.clock.now_s() + 0.001)

    def be_slow(self):
        self.server.gap_ms = 100

    def refuse(self):
        self.server.errors = 10**6

    def fall_silent(self):
        self.server.answers = False

    def talk_nonsense(self):
        self.server.babble(100)

    def unplug(self):
        self.server.hang_up()

    def are_off(self):
        return not any(self.server.strength.values())

    def guard(self):
        return buttplug.silence(self.lines[1].fileno())

    def kill(self):
        """Nothing: the connection stays, as that of a loop that stands still."""

    def close(self):
        super().close()
        self.server.close()
        for line in self.lines:
            line.close()


class Board(World):
    """A board that takes TCode by UDP, in virtual time."""

    has_place = has_buttons = False

    def __init__(self):
        super().__init__()
        self.end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.end.bind(("127.0.0.1", 0))
        self.end.setblocking(False)
        self.where = f"127.0.0.1:{self.end.getsockname()[1]}"
        self.strength, self.sender, self.babbles = 0, None, False
        self.device = installed_devices()["tcode"].make(-1)
        self.options = tcode.tcode_options(self.where)
        self.device.open_port = lambda: tcode.open_board(self.options)
        self.device.make_writer = lambda port: Stuckable(port, self)

    def wait(self):
        super().wait()
        with contextlib.suppress(OSError):
            while True:
                data, self.sender = self.end.recvfrom(200)
                for line in data.decode().splitlines():
                    is_stop = line == "DSTOP"
                    self.strength = 0 if is_stop else int(line[2:6])
        if self.babbles and self.sender:
            self.end.sendto(b"\xff\xfe", self.sender)

    def be_slow(self):
        self.takes_s = 0.1

    def refuse(self):
        self.end.close()  # the network says that nobody listens

    def fall_silent(self):
        self.is_stuck = True

    def talk_nonsense(self):
        self.tick((1.0, 0.0, 0.0), 30)
        self.babbles = True

    def unplug(self):
        self.end.close()

    def are_off(self):
        return self.strength == 0

    def guard(self):
        return tcode.silence(-1, self.options)

    def kill(self):
        """Nothing: the board keeps its last target."""

    def close(self):
        super().close()
        self.end.close()


WORLDS = {"buttplug": Toy, "tcode": Board}
