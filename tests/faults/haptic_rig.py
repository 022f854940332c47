"""The real loop on a virtual clock, with a device and a player that can fail at will."""

import math
from functools import cache

from hapticplayer.clock import ManualClock
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, limits_of
from hapticplayer.haptics.live import LiveForce
from hapticplayer.model import ForceTrack, PlaybackClock
from hapticplayer.model.device import DeviceReading
from tests.rigs import LoopRig

TRACK_S = 100.0


class Grip:
    """A device whose grip stands where a test puts it; it keeps what it was sent."""

    name, capabilities = "grip", FALCON

    def __init__(self):
        self.position_m = ZERO
        self.velocity_mps = ZERO
        self.buttons = 0
        self.is_homed = True
        self.is_plugged = True
        self.answers = True
        self.malformed = 0  # further answers that will make no sense
        self.bad_in_a_row = 0
        self.sent = []
        self.last = DeviceReading(ZERO, 0, is_homed=False, replied_s=-math.inf)

    def open(self):
        pass

    def close(self):
        pass

    def exchange(self, force_n, now_s):
        if not self.is_plugged:
            raise DeviceError("the device is gone")
        self.sent.append(force_n)
        self.position_m = next_position(self)
        if not self.answers:
            return self.last
        if self.malformed:
            self.malformed -= 1
            self.bad_in_a_row += 1
            return self.last._replace(malformed=self.bad_in_a_row)
        self.bad_in_a_row = 0
        self.last = DeviceReading(
            self.position_m, self.buttons, self.is_homed, replied_s=now_s
        )
        return self.last


def next_position(grip):
    pairs = zip(grip.position_m, grip.velocity_mps, strict=True)
    return tuple(p + PERIOD_S * v for p, v in pairs)


def handle(method):
    """Return an attribute that only a test sets."""
    return property(fset=lambda grip, value: getattr(grip, method)(value))


class DriverGrip:
    """A device's own driver with the handles of `Grip`.

    Each of them is a method of the subclass, which does it to the driver's other side.
    """

    is_plugged, answers = handle("_set_plugged"), handle("_set_answers")
    malformed, is_homed = handle("_set_malformed"), handle("_set_homed")
    buttons = handle("_set_buttons")

    def __init__(self, driver, clock):
        self.driver, self.clock = driver, clock
        self.name, self.capabilities = driver.name, driver.capabilities
        self.velocity_mps, self.position_m, self.sent = ZERO, ZERO, []
        driver.open()

    def exchange(self, force_n, now_s):
        if self.velocity_mps != ZERO:
            self.position_m = next_position(self)
        reading = self.driver.exchange(force_n, now_s)
        self.sent.append(force_n)
        return reading

    @property
    def position_m(self):
        return self._position_m

    @position_m.setter
    def position_m(self, position_m):
        self._position_m = position_m
        self._place(position_m)


class SlowClock(ManualClock):
    """Time that may pass between deciding and sending."""

    delay_s = 0.0

    def now_s(self):
        now_s = super().now_s()
        if self.delay_s:
            now_s += self.delay_s
            self.advance(self.delay_s)
            self.delay_s = 0.0
        return now_s


class Rig(LoopRig):
    """Player, loop and device in one thread; `tick` is one period."""

    def __init__(self, force=None, device=None, clock=None, *, is_live=False):
        super().__init__(clock or SlowClock(), device or Grip(), limits_of(FALCON))
        self.beats, self.refreshes, self.guards = True, True, True
        self.epoch, self.rate, self.track_id = 1, 1.0, 1
        self.delay_sending_s = 0.0
        self.media0_s, self.media_from_s = 0.0, self.clock.now_s()
        self.live, self.measures = LiveForce() if is_live else None, True
        if self.live:
            force = self.live.scaled("", (1.0, 1.0, 1.0))
        self.give_track(force or swaying())

    def tick(self, count=1, gap_s=PERIOD_S):
        """Do so many periods, the first after a gap; return the forces sent."""
        before = len(self.device.sent)
        for number in range(count):
            self.clock.advance(gap_s if number == 0 else PERIOD_S)
            now_s = self.clock.now_s()
            if self.live and self.measures:
                self.live.write(now_s, swaying_force(now_s))
            if self.beats:
                self.block.beat(now_s)
            if self.guards:
                self.block.beat_guard(now_s)
            if self.refreshes:
                self.block.write_clock(self.playback(now_s), self.track_id)
            missed = round(gap_s / PERIOD_S) - 1 if number == 0 else 0
            self.clock.delay_s, self.delay_sending_s = self.delay_sending_s, 0.0
            self.loop.tick(now_s, 0.0, missed)
        return self.device.sent[before:]

    def ticks_to(self, mode, most):
        """Tick until the loop is in a mode; return how many periods that took."""
        for count in range(1, most + 1):
            self.tick()
            if self.mode is mode:
                return count
        raise AssertionError(f"still {self.mode.name} ({self.cause.name})")

    def playback(self, now_s):
        at_s = (0.0, 0.0) if self.live else (self.media_from_s, self.media0_s)
        return PlaybackClock(self.epoch, *at_s, self.rate, now_s + 0.150)

    def seek(self, media_s):
        self.epoch += 1
        self.media0_s, self.media_from_s = media_s, self.clock.now_s()

    @property
    def mode(self):
        return self.loop.state.mode

    @property
    def cause(self):
        return self.loop.state.cause

    def following(self, phase=0):
        """Play until the force is fully there, and so many ticks more."""
        self.tick(260 + phase)
        assert self.mode is Mode.FOLLOWING
        assert math.hypot(*self.device.sent[-1]) > 1.5
        return self


@cache
def swaying():
    """A force of 2 to 4 N that turns and grows and shrinks without end."""
    times = [0.005 * k for k in range(round(TRACK_S / 0.005) + 1)]
    return ForceTrack(times, [swaying_force(t) for t in times])


def swaying_force(t):
    size = 3.0 + math.sin(9.0 * t)
    return (size * math.cos(2.0 * t), size * math.sin(2.0 * t), 0.0)
