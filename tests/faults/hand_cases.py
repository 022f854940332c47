"""The real `step` against the physics of device and hand, in virtual time.

One trial is one loop: force track, step, wire (delay, lost packets), Falcon, hand.
"""

import math
from collections import deque
from dataclasses import dataclass, field

import numpy as np

from hapticplayer.devices.dynamics import RELAXED, Mechanism
from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.contract import Cause, Mode, Situation, State, Supervision
from hapticplayer.haptics.hand import observe
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.haptics.step import step
from hapticplayer.haptics.track import LoadedTrack
from hapticplayer.model import PlaybackClock
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.simulation import Simulation
from tests.rigs import loaded

START_S = 100.0
SMOOTH = Mechanism(coulomb_nm=0.0)  # the worst: without dry friction nothing stops


@dataclass
class Trial:
    """One loop; `run` goes on from where it is.

    Attributes:
        track: of force; from its beginning on.
        hand: on the grip; None for a free grip.
        delay_s: from a command to its force, whole milliseconds.
        lost: share of the packets that do not arrive, each way.
        aim: where the person wants the grip: a function of the time, s, or None.
        energy_j: of the observer at the port: what spring and damper have taken in.
            The force of `centring` is followed along the wire, so it is the work
            that the device really did.
    """

    track: object
    hand: object = RELAXED
    delay_s: float = 0.0
    lost: float = 0.0
    seed: int = 1
    mechanism: Mechanism = field(default_factory=Mechanism)
    centring: Centring = field(default_factory=Centring)
    limits: Limits = field(default_factory=Limits)
    aim: object = None

    def __post_init__(self):
        self.simulation = Simulation(
            self.hand,
            mechanism=self.mechanism,
            electronics=Electronics(delay_s=self.delay_s),
        )
        if not isinstance(self.track, LoadedTrack):
            self.track = loaded(self.track)
        self._rng = np.random.default_rng(self.seed)
        self._clock = PlaybackClock(1, START_S, 0.0, 1.0, math.inf)
        self._reading = None
        self._on_the_way = deque()
        self._acting_n = ZERO
        self.state = State()
        self.ticks = 0
        self.energy_j = self.least_energy_j = 0.0
        self.speed_mps = 0.0
        self.radii_m = []
        self.sent_n = []
        self.trips = []

    @property
    def reach(self):
        """Furthest place so far, share of the workspace."""
        return max(self.radii_m) / self.limits.workspace_m

    def run(self, duration_s):
        """Tick for so long; return this trial."""
        for _ in range(round(duration_s / PERIOD_S)):
            self._tick()
        return self

    def _tick(self):
        now_s = START_S + self.ticks * PERIOD_S
        simulation, before_m = self.simulation, self.simulation.position_m
        simulation.advance(now_s)
        self._observe_energy(before_m, simulation.position_m)
        was, reading = self.state.mode, self._reading
        self.state = state = step(
            Situation(
                now_s,
                self._clock,
                self.track,
                self.state,
                observe(self.state.hand, reading, self.limits),
                Supervision(math.inf),
                self.limits,
                self.centring,
            )
        )
        if state.mode is Mode.TRIPPED and was is not Mode.TRIPPED:
            self.trips.append(Cause(state.cause).name)
        if self.aim is not None:
            simulation.aim(self.aim(now_s - START_S))
        arrives, returns = self._rng.random(2) >= self.lost
        if arrives:
            simulation.command(state.force_n, now_s)
            due = self.ticks + round(self.delay_s / PERIOD_S)
            self._on_the_way.append((due, self._pull()))
        while self._on_the_way and self._on_the_way[0][0] <= self.ticks:
            _, self._acting_n = self._on_the_way.popleft()
        if returns or reading is None:
            self._reading = simulation.reading(now_s)
        self.radii_m.append(math.hypot(*simulation.position_m))
        self.speed_mps = max(self.speed_mps, math.hypot(*simulation.velocity_mps))
        self.sent_n.append(state.force_n)
        self.ticks += 1

    def _pull(self):
        """Return the part of the command that spring and damper have."""
        state = self.state
        if state.mode is Mode.FOLLOWING:
            return state.centring_n
        if state.mode is not Mode.ENTERING:
            return ZERO
        share = min(1.0, (state.ticks_in_mode + 1) / self.limits.entry_ticks)
        return tuple(share * value for value in state.centring_n)

    def _observe_energy(self, from_m, to_m):
        taken = zip(self._acting_n, from_m, to_m, strict=True)
        self.energy_j -= sum(f * (b - a) for f, a, b in taken)
        self.least_energy_j = min(self.least_energy_j, self.energy_j)


def swing_m(trial, last_s):
    """Return how far the radius still moves in the last seconds."""
    tail = trial.radii_m[-round(last_s / PERIOD_S) :]
    return max(tail) - min(tail)
