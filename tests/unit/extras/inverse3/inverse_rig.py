"""The Inverse3's own driver under the contract's faults, which happen in its service.

The service answers on a virtual clock: what comes over a WebSocket in a process comes
here with the next tick.
"""

from collections import deque

from hapticplayer.errors import DeviceError
from hapticplayer.extras.inverse3.driver import Inverse3Driver
from hapticplayer.extras.inverse3.simulated.service import Service, simulation_of
from hapticplayer.haptics.limiter import ZERO
from tests.faults.haptic_rig import DriverGrip


class VirtualLink:
    """A connection without threads; the answers come when they are asked for."""

    def __init__(self, service, clock):
        self.service, self.clock = service, clock
        self.is_open, self.answers = True, True
        self.sent = []
        self._waiting = deque([service.inventory(clock.now_s())])
        self._unanswered = deque()

    def fileno(self):
        return -1

    def send(self, text):
        self._check()
        self.sent.append(text)
        self._unanswered.append(text)

    def receive(self, _timeout_s=0.0):
        self._check()
        while self._unanswered and self.answers:
            text = self._unanswered.popleft()
            self._waiting.append(self.service.answer(text, self.clock.now_s()))
        return self._waiting.popleft() if self._waiting else ""

    def close(self):
        for text in self._unanswered:  # what was sent arrives all the same
            self.service.answer(text, self.clock.now_s())
        self._unanswered.clear()
        self.is_open = False

    def take(self, text):
        """Take a message of the guard; its answer comes to the loop."""
        if self.is_open:
            self._waiting.append(self.service.answer(text, self.clock.now_s()))
        return self.is_open

    def _check(self):
        if not self.is_open:
            raise DeviceError("the service has closed the connection; start it again")


class InverseGrip(DriverGrip):
    """An Inverse3 whose grip stands where a test puts it."""

    def __init__(self, clock, version="3.5.0"):
        self.service, self.link = Service(simulation_of(None), version), None
        super().__init__(Inverse3Driver(self._connected, clock=clock), clock)

    @property
    def applied_n(self):
        return self.service.simulation.applied_n

    def are_motors_off(self):
        return self.applied_n == ZERO

    def _connected(self):
        self.link = VirtualLink(self.service, self.clock)
        return self.link

    def _place(self, position_m):
        self.service.simulation = Placed(position_m, self.service.simulation)

    def _set_plugged(self, is_plugged):
        assert not is_plugged
        self.link.is_open = False

    def _set_answers(self, answers):
        self.link.answers = answers

    def _set_malformed(self, count):
        self.service.corrupt = count

    def _set_homed(self, is_homed):
        self.service.simulation.is_homed = is_homed

    def _set_buttons(self, buttons):
        self.service.simulation.buttons = buttons


class Placed:
    """A grip that a test holds; what trembles a little, as every hand does."""

    velocity_mps = ZERO

    def __init__(self, position_m, before):
        self._position_m = position_m
        self.is_homed, self.buttons = before.is_homed, before.buttons
        self.refused, self.applied_n = 0, ZERO
        self._count = 0

    @property
    def position_m(self):
        self._count += 1
        x, y, z = self._position_m
        return (x + 1e-9 * (self._count % 7), y, z)

    def advance(self, now_s):
        pass

    def command(self, force_n, _now_s):
        self.applied_n = force_n
