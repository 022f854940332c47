"""The Falcon's own driver under the contract's faults, which happen on its USB.

Each handle does something to the simulated chip, board or encoders below pyusb. All in
virtual time: what two threads do in a process is done here between two ticks.
"""

import numpy as np

from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.kinematics import Kinematics, OutOfReachError
from hapticplayer.devices.falcon.link import NO_ANSWER, StaleAnswerFilter, updated
from hapticplayer.devices.falcon.protocol import ReplyParser
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.extras.faults.usb.backend import SimulatedBus, SimulatedPort
from hapticplayer.extras.faults.usb.board import Board, Stage
from hapticplayer.extras.faults.usb.chip import Chip
from tests.doubles import BenchMechanics
from tests.faults.haptic_rig import DriverGrip

ALWAYS = 10**9
PERIOD_S = 0.001
LEAP_COUNTS = 900


class VirtualLink:
    """What `ThreadedLink` does, without threads: nothing here lets the time pass."""

    def __init__(self, ftdi, clock, chip):
        self._ftdi, self._clock, self._chip = ftdi, clock, chip
        self._parser, self._answer, self._waiting = ReplyParser(), NO_ANSWER, None
        self._answer_filter = StaleAnswerFilter()

    def post(self, frame):
        self._waiting = frame
        self._write()

    def newest(self):
        self._write()
        while self._chip.due_s() <= self._clock.now_s() and not self._is_stalled():
            data = self._ftdi.read(PERIOD_S)
            now_s = self._clock.now_s()
            if self._answer_filter.accepts(data, now_s):
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


class FalconGrip(DriverGrip):
    """A Falcon whose grip stands where a test puts it."""

    def __init__(self, clock):
        self.kinematics = Kinematics()
        self.mechanics = BenchMechanics()
        self.board = Board(self.mechanics, Stage.RUNNING)
        self.chip = Chip(self.board, clock)
        self.port = SimulatedPort(self.chip)
        self.bus = SimulatedBus([self.port])
        driver = FalconDriver(
            lambda: open_falcon(backend=self.bus),
            clock=clock,
            make_link=lambda ftdi, at: VirtualLink(ftdi, at, self.chip),
        )
        super().__init__(driver, clock)

    def are_motors_off(self):
        return self.mechanics.commands[-1][1] == (0, 0, 0)

    def motor_forces_n(self):
        """Return the magnitude of what the motors made of each frame, N."""
        jacobian = np.array(self.kinematics.jacobian(self._centred(self.position_m)))
        words = np.array([words for _, words in self.mechanics.commands])
        # J^T F = tau
        return np.linalg.norm(np.linalg.solve(jacobian.T, -words.T / 1e4), axis=0)

    def _centred(self, position_m):
        x, y, z = position_m
        return (x, y, z + self.kinematics.geometry.centre_z_m)

    def _place(self, position_m):
        """Turn the encoders there; what no leg reaches is a leap of all of them."""
        try:
            angles = self.kinematics.inverse(self._centred(position_m))
        except OutOfReachError:
            self.mechanics.counts = (LEAP_COUNTS,) * 3
        else:
            self.mechanics.counts = self.kinematics.counts(angles)

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
