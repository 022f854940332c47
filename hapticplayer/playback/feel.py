"""What a sensor measures now is felt now, on the outputs of a player.

The samples come from a thread that reads the source: one of its own, or that of a
recorder. Gravity is removed causally, the mapping makes a force of what is left, and the
haptic loops read the newest one with the whole contract (docs/safety.md).
"""

import enum
import threading
from collections import deque
from dataclasses import dataclass
from typing import Any

import numpy as np

from hapticplayer.capture.live.source import ClockRestarted, OpenedSource, Samples
from hapticplayer.capture.mounting import AS_RECORDED
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError, Message, UsageError, message_of
from hapticplayer.haptics.live import LIVE_VALID_S, LiveForce
from hapticplayer.model import Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import Vector
from hapticplayer.motion.causal import REST_S, CausalFilter
from hapticplayer.playback.player import Player
from hapticplayer.rendering.force import mapped

SLOW_HZ = 25.0
"""A source that is read less often is felt in jerks, or as silent."""
_READ_S, _JOIN_S, _RATE_OVER_S, _GONE_S = 0.02, 2.0, 1.0, 1.5
_BEGINS_S, _HEARD_S = 3.0, 0.5  # a source may take so long to begin; between reads
_HELD_S = 0.1  # for which an angular rate also counts for samples without


class FeelPhase(enum.StrEnum):
    """What a person does next."""

    WAITING = "waiting"
    """The sensor is to be laid down."""
    FELT = "felt"
    SILENT = "silent"
    """It has sent nothing that can be used for 100 ms."""
    LOST = "lost"
    """It will send nothing any more."""


@dataclass(frozen=True, slots=True)
class FeelState:
    """What a front end shows of it.

    Attributes:
        phase: see there.
        text: what to do, for people.
        rested_share: of the rest that is asked for, 0 to 1.
        rate_hz: of the samples in the last second.
        acceleration_mps2: the newest, without gravity, in the wearer's axes.
        force_n: the newest that the mapping made of it, in the device's axes.
        skipped: samples that could not be used.
    """

    phase: FeelPhase
    text: Message | str
    rested_share: float
    rate_hz: float
    acceleration_mps2: Vector
    force_n: Vector
    skipped: int


_ZERO = (0.0, 0.0, 0.0)


class Feel:
    """Makes force of one source. Its commands are those of the thread that polls the player.

    Args:
        player: on whose outputs it is felt.
        source: an open one; who opened it closes it.
        mapping: from motion to force.
        clock: the machine's.
        mounting: the wearer's right, front and up in the sensor's axes.

    Raises:
        UsageError: for a mapping with a lever arm, which needs what comes after.
    """

    def __init__(
        self,
        player: Player,
        source: OpenedSource,
        mapping: Mapping,
        clock: Clock,
        mounting: str = AS_RECORDED,
    ) -> None:
        if mapping.moves_point:
            raise UsageError(
                "a lever arm needs a whole recording; feel the sensor where it is"
            )
        self._player, self._source, self._mapping = player, source, mapping
        self._clock, self._mounting = clock, mounting or AS_RECORDED
        self._filter, self._force = CausalFilter(), LiveForce()
        self._thread: threading.Thread | None = None
        self._stopping = threading.Event()
        self._newest: tuple[float, Vector, Vector] = (-np.inf, _ZERO, _ZERO)
        self._reads: deque[tuple[float, int]] = deque()  # of the last second with any
        self._rate, self._rate_s = np.full(3, np.nan), -np.inf
        self._samples, self._felt_s, self._is_known = 0, 0.0, False
        self._began_s, self._problem = clock.now_s(), Message("")

    # --- commands ---------------------------------------------------------------

    def start(self, *, is_read: bool = False) -> None:
        """Feel it from now on.

        Args:
            is_read: whether a recorder reads the source; else a thread begins to.
        """
        self._began_s = self._clock.now_s()
        self._source.listener = self.feed
        self._player.feel(self._force)
        if not is_read:
            self._thread = threading.Thread(
                target=self._read, name="live-source", daemon=True
            )
            self._thread.start()

    def stop(self) -> None:
        """Ramp the force, and let the player have its clip again."""
        self._stopping.set()
        self._source.listener = None
        self._player.feel(None)
        if self._thread is not None:
            self._thread.join(_JOIN_S)

    def stop_force(self) -> None:
        """Set the force to zero at once, until a person re-arms."""
        self._player.stop_force()

    def set_mapping(self, mapping: Mapping) -> None:
        """Map the next samples otherwise; changes go no faster than the limiter lets them."""
        self._mapping = mapping

    # --- the thread that reads ----------------------------------------------------

    def _read(self) -> None:
        try:
            while not self._stopping.is_set():
                try:
                    self._source.read(_READ_S)
                except ClockRestarted:  # it sends on; who wears it rests once more
                    self._source.forget_clock()
        except HapticPlayerError as problem:
            self._problem = message_of(problem)

    def feed(self, samples: Samples) -> None:
        """Make force of what was read now."""
        now_s = self._clock.now_s()
        count = len(samples.stamp_s)
        if self._problem or not count:
            return
        self._count(now_s, count)
        samples = samples.in_frame_a(self._source.declares.axes)
        samples = samples.in_frame_a(self._mounting)
        try:
            removed = [self._add(*row) for row in zip(*samples[1:], strict=True)]
        except HapticPlayerError as problem:
            self._problem = message_of(problem)
            return
        usable = [one for one in removed if one is not None]
        if usable:
            acceleration = usable[-1]  # the others are over
            force, _ = mapped(acceleration[None], self._mapping)
            x, y, z = force[0].tolist()
            self._force.write(now_s, (x, y, z))
            ax, ay, az = acceleration.tolist()
            gap_s = now_s - self._newest[0]
            self._felt_s += gap_s if gap_s <= LIVE_VALID_S else 0.0
            self._newest = now_s, (ax, ay, az), (x, y, z)
        self._refuse_without_gyro(now_s)

    def _add(self, stamp_s: float, accel: Floats, rate: Floats) -> Floats | None:
        if np.isfinite(rate).all():
            self._rate, self._rate_s = rate, stamp_s
        elif abs(stamp_s - self._rate_s) <= _HELD_S:
            rate = self._rate  # of a sensor with a stamp of its own
        return self._filter.add(stamp_s, accel, rate)

    def _refuse_without_gyro(self, now_s: float) -> None:
        if self._rate_s == -np.inf and now_s - self._began_s > _BEGINS_S:
            self._problem = Message(
                "the source sends no angular rate, without which gravity cannot be told "
                "from motion; choose one with a gyroscope"
            )

    def _count(self, now_s: float, count: int) -> None:
        self._samples += count
        self._reads.append((now_s, count))
        while self._reads[0][0] < now_s - _RATE_OVER_S:
            self._reads.popleft()
            self._is_known = True

    def summary(self) -> dict[str, Any]:
        """What was measured and felt, for the end of a run."""
        return {
            "source": self._source.text,
            "samples": self._samples,
            "skipped": self._filter.skipped,
            "felt_s": round(self._felt_s, 3),
        }

    # --- what a front end shows ----------------------------------------------------

    def snapshot(self) -> FeelState:
        """What it does now."""
        now_s, reads = self._clock.now_s(), tuple(self._reads)
        newest_s, acceleration, force = self._newest
        heard_s = reads[-1][0] if reads else -np.inf
        phase = self._phase(now_s, newest_s, heard_s)
        is_felt = phase is FeelPhase.FELT
        is_jerky = self._is_known and len(reads) < SLOW_HZ * _RATE_OVER_S
        is_gone = now_s - heard_s > _GONE_S
        since_s = now_s - _RATE_OVER_S
        rate_hz = sum(count for at_s, count in reads if at_s > since_s) / _RATE_OVER_S
        return FeelState(
            phase,
            self._text(phase, is_jerky=is_jerky and not is_gone),
            1.0 if self._filter.is_ready else self._filter.rest_s / REST_S,
            rate_hz,
            acceleration if is_felt else _ZERO,
            force if is_felt else _ZERO,
            self._filter.skipped,
        )

    def _phase(self, now_s: float, newest_s: float, heard_s: float) -> FeelPhase:
        if self._problem:
            return FeelPhase.LOST
        if now_s - newest_s <= LIVE_VALID_S:
            return FeelPhase.FELT
        is_new = now_s - self._began_s < _BEGINS_S
        is_heard = is_new or now_s - heard_s <= _HEARD_S
        is_waiting = not self._filter.is_ready or newest_s == -np.inf
        return FeelPhase.WAITING if is_heard and is_waiting else FeelPhase.SILENT

    def _text(self, phase: FeelPhase, *, is_jerky: bool) -> Message | str:
        if phase is FeelPhase.LOST:
            return self._problem
        if phase is FeelPhase.WAITING:
            return Message(
                "lay the sensor down and let it rest for {rest_s:.1f} s", rest_s=REST_S
            )
        if is_jerky:
            return Message(
                "the sensor is heard less than {slow_hz:.0f} times a second and felt in "
                "jerks: set it to 100, or choose one that sends each sample at once",
                slow_hz=SLOW_HZ,
            )
        if phase is FeelPhase.SILENT:
            return Message(
                "nothing comes from the sensor: check its cable, power, range"
            )
        return Message("move the sensor: the grip follows")
