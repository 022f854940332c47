"""The Falcon's own driver under the contract's faults, which happen on its USB.

`FalconGrip` has the handles of `haptic_rig.Grip`, but each of them does something to
the simulated chip, board or encoders below pyusb. All in virtual time: what two threads
do in a process is done here between two ticks.
"""

import math

from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.kinematics import Kinematics, OutOfReachError
from hapticplayer.devices.falcon.link import NO_ANSWER, Freshness, updated
from hapticplayer.devices.falcon.protocol import ReplyParser
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.simulation.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.simulation.usb.board import Board, Stage
from hapticplayer.simulation.usb.chip import Chip
from tests.doubles import BenchMechanics

ALWAYS = 10**9
PERIOD_S = 0.001
LEAP_COUNTS = 900


class VirtualLink:
    """What `ThreadedLink` does, without threads: nothing here lets the time pass."""

    def __init__(self, ftdi, clock, chip):
        self._ftdi, self._clock, self._chip = ftdi, clock, chip
        self._parser, self._answer, self._waiting = ReplyParser(), NO_ANSWER, None
        self._freshness = Freshness()

    def post(self, frame):
        self._waiting = frame
        self._write()

    def newest(self):
        self._write()
        while self._chip.due_s() <= self._clock.now_s() and not self._is_stalled():
            data = self._ftdi.read(PERIOD_S)
            now_s = self._clock.now_s()
            if self._freshness.accepts(data, now_s):
                self._answer = updated(self._answer, self._parser, data, now_s)
        return self._answer

    def stop(self):
        pass

    def _is_stalled(self):
        is_stalled = self._clock.now_s() < self._chip.stalled_until_s
        return is_stalled and self._chip.is_plugged

    def _write(self):
        if self._waiting is not None and not self._is_stalled():
            self._ftdi.write(self._waiting, PERIOD_S)
            self._waiting = None


class FalconGrip:
    """A Falcon whose grip stands where a test puts it."""

    def __init__(self, clock):
        self.clock = clock
        self.kinematics = Kinematics()
        self.mechanics = BenchMechanics()
        self.board = Board(self.mechanics, Stage.RUNNING)
        self.chip = Chip(self.board, clock)
        self.port = SimulatedPort(self.chip)
        self.bus = SimulatedBus([self.port])
        self.driver = FalconDriver(
            lambda: open_falcon(backend=self.bus),
            clock=clock,
            make_link=lambda ftdi, at: VirtualLink(ftdi, at, self.chip),
        )
        self.name, self.capabilities = "falcon", self.driver.capabilities
        self.velocity_mps = (0.0, 0.0, 0.0)
        self.sent = []
        self.position_m = (0.0, 0.0, 0.0)
        self.driver.open()

    def exchange(self, force_n, now_s):
        if self.velocity_mps != (0.0, 0.0, 0.0):
            pairs = zip(self.position_m, self.velocity_mps, strict=True)
            self.position_m = tuple(p + PERIOD_S * v for p, v in pairs)
        reading = self.driver.exchange(force_n, now_s)
        self.sent.append(force_n)
        return reading

    @property
    def position_m(self):
        return self._position_m

    @position_m.setter
    def position_m(self, position_m):
        """Turn the encoders there; what no leg reaches is a leap of all of them."""
        self._position_m = position_m
        x, y, z = position_m
        place = (x, y, z + self.kinematics.geometry.centre_z_m)
        try:
            self.mechanics.counts = self.kinematics.counts(
                self.kinematics.inverse(place)
            )
        except OutOfReachError:
            self.mechanics.counts = (LEAP_COUNTS, LEAP_COUNTS, LEAP_COUNTS)

    def _set_plugged(self, is_plugged):
        assert not is_plugged
        self.chip.unplug()

    def _set_answers(self, answers):
        self.board.faults.silent = 0 if answers else ALWAYS

    def _set_malformed(self, count):
        self.board.faults.corrupt = count

    def _set_homed(self, is_homed):
        self.mechanics.homed = 7 if is_homed else 0

    def _set_buttons(self, buttons):
        self.mechanics.buttons = buttons

    is_plugged = property(fset=_set_plugged)
    answers = property(fset=_set_answers)
    malformed = property(fset=_set_malformed)
    is_homed = property(fset=_set_homed)
    buttons = property(fset=_set_buttons)

    def motor_forces_n(self, since_s=-math.inf):
        """Return (time, magnitude) of what the motors made of each frame, N."""
        jacobian = self.driver_jacobian()
        found = []
        for at_s, words in self.mechanics.commands:
            if at_s >= since_s:
                torque = [-word / 10_000.0 for word in words]
                found.append((at_s, _solved(jacobian, torque)))
        return found

    def driver_jacobian(self):
        x, y, z = self.position_m
        geometry = self.kinematics.geometry
        return self.kinematics.jacobian((x, y, z + geometry.centre_z_m))


def _solved(jacobian, torque):
    """Return |F| with J^T F = tau."""
    import numpy as np

    return float(np.linalg.norm(np.linalg.solve(np.array(jacobian).T, torque)))
