"""Unpublished figures of the Falcon, measured by an owner at low force.

All forces stay below 1.5 N, are left at a button, above 0.5 m/s and outside 30 mm, and
end in zero frames whatever happens. Each function takes an open, homed driver, except
`round_trips`.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.protocol import ReplyParser, encode_command
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceReading, Vector

PUSH_N = 1.0
MOST_N = 1.5
RAMP_N_PER_S = 0.5
MOVED_M = 0.001
SILENCES_S = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)
TRIES = 20
"""Of a silence: a busy computer stalls for 15 ms every few seconds."""
_SETTLE_S, _LOOK_S, _RISE_S = 1.0, 0.1, 0.3
_PERIOD_S = 0.001
_TOO_FAST_MPS, _TOO_FAR_M = 0.5, 0.030
_SPEED_OVER = 10  # periods; one step of an encoder in one is 0.05 m/s
_FIRST_ANSWERS = 100
_ZERO: Vector = (0.0, 0.0, 0.0)
_ZERO_WORDS = (0, 0, 0)
_AXES: dict[str, Vector] = {
    "right": (1.0, 0.0, 0.0),
    "left": (-1.0, 0.0, 0.0),
    "up": (0.0, 1.0, 0.0),
    "down": (0.0, -1.0, 0.0),
    "towards": (0.0, 0.0, 1.0),
    "away": (0.0, 0.0, -1.0),
}


def round_trips(
    ftdi: Ftdi, clock: Clock, count: int = 500, *, event_character: bool
) -> dict[str, float]:
    """Return how long zero frames take to be answered, ms, and the rate, Hz.

    `event_character`: the chip answers after '>' at once.
    """
    ftdi.set_event_character(b">" if event_character else b"")
    frame, parser, took_s = encode_command(_ZERO_WORDS), ReplyParser(), []
    lost, begin_s = 0, clock.now_s()
    try:
        for _ in range(count):
            sent_s = clock.now_s()
            ftdi.write(frame, 0.02)
            while clock.now_s() < sent_s + 0.05:
                if parser.feed(ftdi.read(0.02)):
                    took_s.append(clock.now_s() - sent_s)
                    break
            else:
                lost += 1
    finally:
        ftdi.set_event_character(b"")
    if not took_s:
        raise DeviceError("the Falcon answered none of the frames; home it, try again")
    p50, p99 = np.percentile(took_s, (50, 99))
    return {
        "p50_ms": 1e3 * float(p50),
        "p99_ms": 1e3 * float(p99),
        "rate_hz": len(took_s) / (clock.now_s() - begin_s),
        "lost": lost,
    }


class Bench:
    """Exchanges every millisecond, with a hand that has to be able to stop it."""

    def __init__(self, driver: FalconDriver, clock: Clock) -> None:
        self._driver, self._clock = driver, clock
        self._recent: list[Vector] = []
        for _ in range(_FIRST_ANSWERS):  # the very first exchange has none yet
            if driver.exchange(_ZERO, clock.now_s()).is_homed:
                break
            clock.sleep_until(clock.now_s() + _PERIOD_S)

    def run(
        self, force_of: Callable[[float], Vector], duration_s: float
    ) -> Iterator[tuple[float, DeviceReading]]:
        """Yield (seconds since the beginning, reading); the force is zero afterwards."""
        begin_s = deadline_s = self._clock.now_s()
        try:
            while (now_s := self._clock.now_s()) < begin_s + duration_s:
                force = force_of(now_s - begin_s)
                reading = self._driver.exchange(force, now_s)
                self._check(reading)
                yield now_s - begin_s, reading
                deadline_s = max(deadline_s + _PERIOD_S, self._clock.now_s())
                self._clock.sleep_until(deadline_s)
        finally:
            self._driver.exchange(_ZERO, self._clock.now_s())

    def still(self, duration_s: float, force_n: Vector = _ZERO) -> Vector:
        """Hold a force, risen within 0.3 s; return the mean place at its end, m."""
        kept = []

        def risen(at_s: float) -> Vector:
            share = min(1.0, at_s / _RISE_S)
            return (share * force_n[0], share * force_n[1], share * force_n[2])

        for at_s, reading in self.run(risen, duration_s):
            if at_s > duration_s - _LOOK_S:
                kept.append(reading.position_m)
        x, y, z = np.mean(kept, axis=0).tolist()
        return (x, y, z)

    def _check(self, reading: DeviceReading) -> None:
        _refuse_button(reading)
        if not reading.is_homed:
            raise DeviceError(
                "the Falcon is not homed; home it (`hapticplayer device home`)"
            )
        recent = self._recent
        recent.append(reading.position_m)
        if len(recent) > _SPEED_OVER:
            before = recent.pop(0)
            way_m = math.dist(before, reading.position_m)
            if way_m > _TOO_FAST_MPS * _SPEED_OVER * _PERIOD_S:
                raise DeviceError("stopped, for the grip was faster than 0.5 m/s")
        if math.hypot(*reading.position_m) > _TOO_FAR_M:
            raise DeviceError(
                "stopped, for the grip is more than 30 mm from the middle"
            )


def force_after_silence(
    driver: FalconDriver, clock: Clock, was_disturbed: Callable[[], bool] = bool
) -> dict[str, Any]:
    """Find out how long the motors push after the last frame; a hand holds the grip.

    1 N to the right pushes the hand aside. Then nothing is sent for a while; at the
    first frame after it the hand is still aside, or back. That includes the time in
    which a hand swings back, about 0.1 s. A silence is measured again if
    `was_disturbed`: another process may have sent a frame since the last call.

    Returns:
        "pushes_at_least_s" and "lets_go_within_s" (inf: not in 2 s), and the share of
        the way that was left after each silence.
    """
    left: dict[str, float] = {}
    at_least_s, within_s = 0.0, math.inf
    for silence_s in SILENCES_S:
        for _ in range(TRIES):
            share = _share_left(driver, clock, silence_s, was_disturbed)
            if not was_disturbed():
                break
        else:
            raise DeviceError(
                "the computer stalled repeatedly; close other programs, measure again"
            )
        left[f"{silence_s:g}"] = share
        if share > 0.5:
            at_least_s = silence_s
        elif math.isinf(within_s):
            within_s = silence_s
    return {
        "pushes_at_least_s": at_least_s,
        "lets_go_within_s": within_s,
        "share_of_way_left": left,
    }


def _share_left(
    driver: FalconDriver,
    clock: Clock,
    silence_s: float,
    was_disturbed: Callable[[], bool],
) -> float:
    """Return the share of the hand's way aside that is left after one silence."""
    bench = Bench(driver, clock)
    rest = bench.still(_SETTLE_S)
    was_disturbed()  # until here the guard could only say what was said anyway
    aside = _held(bench, driver, clock)
    clock.sleep_until(clock.now_s() + silence_s)
    after = _first_answer(driver, clock)
    way_m = aside[0] - rest[0]
    if way_m < MOVED_M:
        raise DeviceError("the grip did not give way to 1 N; hold it more loosely")
    return (after[0] - rest[0]) / way_m


def _held(bench: Bench, driver: FalconDriver, clock: Clock) -> Vector:
    """Return the place under the force, which is still on afterwards."""
    place = bench.still(_SETTLE_S, (PUSH_N, 0.0, 0.0))
    # `still` ends in zero: put the force back before the hand has moved
    driver.exchange((PUSH_N, 0.0, 0.0), clock.now_s())
    return place


def _first_answer(driver: FalconDriver, clock: Clock) -> Vector:
    """Return the first position that is reported after a silence."""
    last_s = driver.exchange(_ZERO, clock.now_s()).replied_s
    for _ in range(100):
        clock.sleep_until(clock.now_s() + _PERIOD_S)
        reading = driver.exchange(_ZERO, clock.now_s())
        _refuse_button(reading)
        if reading.replied_s > last_s:
            return reading.position_m
    raise DeviceError("the Falcon did not answer after the silence; try again")


def friction(driver: FalconDriver, clock: Clock) -> dict[str, float]:
    """Return the force in N at which the free grip begins to move, by direction.

    It rises by 0.5 N a second; nan where 1.5 N did not move it by 1 mm.
    """
    return {name: _breakaway(driver, clock, way) for name, way in _AXES.items()}


def _breakaway(driver: FalconDriver, clock: Clock, way: Vector) -> float:
    bench = Bench(driver, clock)
    rest = bench.still(_SETTLE_S)

    def rising(at_s: float) -> Vector:
        size = RAMP_N_PER_S * at_s
        return (size * way[0], size * way[1], size * way[2])

    for at_s, reading in bench.run(rising, MOST_N / RAMP_N_PER_S):
        if math.dist(reading.position_m, rest) > MOVED_M:
            return RAMP_N_PER_S * at_s
    return math.nan


def _refuse_button(reading: DeviceReading) -> None:
    if reading.buttons:
        raise DeviceError("stopped by a button on the grip")


def stops(driver: FalconDriver, clock: Clock, duration_s: float) -> dict[str, Any]:
    """Return how far a person moves the grip without force: counts, and m in frame D.

    A button ends it here, too: no force follows.
    """
    counts, places = [], []
    end_s = clock.now_s() + duration_s
    while clock.now_s() < end_s:
        reading = driver.exchange(_ZERO, clock.now_s())
        _refuse_button(reading)
        if reading.is_homed and driver.reply is not None:
            counts.append(driver.reply.counts)
            places.append(reading.position_m)
        clock.sleep_until(clock.now_s() + 0.005)
    if not counts:
        raise DeviceError(
            "the Falcon is not homed; home it (`hapticplayer device home`)"
        )
    return {
        "counts_min": np.min(counts, axis=0).tolist(),
        "counts_max": np.max(counts, axis=0).tolist(),
        "position_min_m": np.min(places, axis=0).tolist(),
        "position_max_m": np.max(places, axis=0).tolist(),
    }
