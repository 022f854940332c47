"""Random scripts of manoeuvres: driving, riding and walking.

Each writes until the duration is full, from a seeded generator. Levels are shares of
g, as drivers and the literature on comfort give them.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from hapticplayer.extras.rides.script import MARGIN_S, Drive
from hapticplayer.model import STANDARD_GRAVITY_MPS2

Band = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Style:
    """How hard a person drives: bands of level and speed.

    `edge_s` is how quickly a manoeuvre comes to its level.
    """

    level_g: Band
    speed_mps: Band
    edge_s: float


CALM = Style((0.10, 0.15), (8.0, 15.0), 0.8)
BRISK = Style((0.25, 0.35), (8.0, 21.0), 0.5)
HARD = Style((0.50, 0.70), (9.0, 26.0), 0.35)


class _Driver:
    """Draws what happens next."""

    def __init__(
        self, rng: np.random.Generator, drive: Drive, duration_s: float
    ) -> None:
        self.rng = rng
        self.drive = drive
        self._end_s = duration_s + MARGIN_S

    def between(self, band: Band) -> float:
        return float(self.rng.uniform(*band))

    def level(self, band_g: Band) -> float:
        return STANDARD_GRAVITY_MPS2 * self.between(band_g)

    def side(self) -> float:
        return float(self.rng.choice((-1.0, 1.0)))

    def goes_on(self) -> bool:
        return self.drive.clock_s < self._end_s

    def reach(self, speed: Band, level_g: Band) -> None:
        """Change to a speed of a band unless the speed is in it already."""
        if not speed[0] <= self.drive.speed_mps <= speed[1]:
            self.drive.change_speed(self.between(speed), self.level(level_g))

    def stop(self, level_g: Band, standing_s: Band) -> None:
        if self.drive.speed_mps > 0.0:
            self.drive.change_speed(0.0, self.level(level_g))
        engine_off = bool(self.rng.random() < 0.6)
        self.drive.stand(self.between(standing_s), engine_off=engine_off)

    def bend(self, level_g: Band, angle_deg: Band) -> None:
        """Turn by about an angle, as fast as the lateral level makes it."""
        lateral = self.level(level_g)
        angle = np.radians(self.between(angle_deg))
        length_s = angle * self.drive.speed_mps / lateral
        self.drive.bend(self.side() * lateral, float(np.clip(length_s, 1.5, 20.0)))

    def roundabout(self, level_g: Band) -> None:
        """Right, around to the left for 5 to 15 s, right and out."""
        self.reach((6.0, 9.0), level_g)
        lateral = self.level(level_g)
        self.drive.bend(-0.8 * lateral, 2.0)
        self.drive.bend(lateral, self.between((5.0, 15.0)))
        self.drive.bend(-0.8 * lateral, 2.0)


def town(rng: np.random.Generator, duration_s: float, style: Style) -> Drive:
    """Stops, bends, roundabouts, slopes and straights at one style's level."""
    drive = Drive(edge_s=style.edge_s)
    driver = _Driver(rng, drive, duration_s)
    driver.stop(style.level_g, (3.0, 5.0))
    choices: tuple[Callable[[], None], ...] = (
        lambda: driver.bend(style.level_g, (40.0, 110.0)),
        lambda: driver.roundabout(style.level_g),
        lambda: drive.change_speed(
            driver.between(style.speed_mps), driver.level(style.level_g)
        ),
        lambda: driver.stop(style.level_g, (3.0, 9.0)),
        lambda: drive.slope(driver.between((-0.07, 0.07)), 4.0),
    )
    while driver.goes_on():
        # each kind once, in random order: a minute shows all of them
        for kind in rng.permutation(len(choices)):
            driver.reach(style.speed_mps, style.level_g)
            choices[kind]()
            drive.cruise(driver.between((1.5, 5.0)))
    return drive


def roundabouts(rng: np.random.Generator, duration_s: float) -> Drive:
    """One roundabout after the other."""
    drive = Drive(speed_mps=11.0, edge_s=0.6)
    driver = _Driver(rng, drive, duration_s)
    while driver.goes_on():
        drive.cruise(driver.between((2.0, 5.0)))
        driver.roundabout((0.2, 0.4))
        driver.reach((10.0, 15.0), (0.15, 0.25))
    return drive


def motorway(rng: np.random.Generator, duration_s: float) -> Drive:
    """Long gentle bends, changes of lane and of speed; never a stop."""
    drive = Drive(speed_mps=29.0, edge_s=1.0)
    driver = _Driver(rng, drive, duration_s)
    while driver.goes_on():
        kind = rng.integers(4)
        if kind <= 1:
            lateral = driver.side() * driver.level((0.04, 0.12))
            drive.bend(lateral, driver.between((10.0, 40.0)))
        elif kind == 2:
            side = driver.side() * driver.level((0.05, 0.10))
            drive.bend(side, 2.2)
            drive.bend(-side, 2.2)
        else:
            drive.change_speed(driver.between((25.0, 34.0)), driver.level((0.03, 0.08)))
        drive.slope(driver.between((-0.03, 0.03)), 6.0)
        drive.cruise(driver.between((2.0, 10.0)))
    return drive


def stop_and_go(rng: np.random.Generator, duration_s: float) -> Drive:
    """A queue: a few seconds of rolling, then a standstill."""
    drive = Drive(edge_s=0.5)
    driver = _Driver(rng, drive, duration_s)
    while driver.goes_on():
        driver.stop((0.1, 0.3), (2.0, 12.0))
        drive.change_speed(driver.between((2.5, 9.0)), driver.level((0.1, 0.2)))
        drive.cruise(driver.between((1.0, 5.0)))
    return drive


def on_ramp(rng: np.random.Generator, duration_s: float) -> Drive:
    """A ramp's bend, about ten seconds of acceleration, a motorway, and off again."""
    drive = Drive(edge_s=0.6)
    driver = _Driver(rng, drive, duration_s)
    driver.stop((0.2, 0.3), (3.0, 5.0))
    while driver.goes_on():
        driver.reach((10.5, 12.5), (0.2, 0.3))
        drive.bend(-driver.level((0.2, 0.28)), driver.between((6.0, 11.0)))
        to_mps = driver.between((31.0, 35.0))
        drive.change_speed(to_mps, (to_mps - drive.speed_mps) / driver.between((9, 11)))
        drive.bend(driver.side() * driver.level((0.04, 0.1)), 12.0)
        drive.cruise(driver.between((3.0, 8.0)))
        drive.change_speed(driver.between((11.0, 12.0)), driver.level((0.2, 0.3)))
    return drive


def hills(rng: np.random.Generator, duration_s: float) -> Drive:
    """Slopes of 4 to 12 % up and down, with bends."""
    drive = Drive(speed_mps=14.0, edge_s=0.6)
    driver = _Driver(rng, drive, duration_s)
    uphill = driver.side()
    while driver.goes_on():
        drive.slope(uphill * driver.between((0.04, 0.12)), driver.between((5.0, 9.0)))
        uphill = -uphill
        driver.reach((10.0, 18.0), (0.15, 0.3))
        driver.bend((0.15, 0.3), (40.0, 120.0))
        drive.cruise(driver.between((2.0, 6.0)))
        drive.change_speed(driver.between((9.0, 19.0)), driver.level((0.12, 0.25)))
    return drive


def bicycle(rng: np.random.Generator, duration_s: float) -> Drive:
    """The demo's ride, for longer: away, bends, slopes, hard stops."""
    drive = Drive(edge_s=0.6)
    driver = _Driver(rng, drive, duration_s)
    driver.stop((0.2, 0.3), (2.0, 4.0))
    while driver.goes_on():
        driver.reach((4.0, 7.5), (0.08, 0.18))
        drive.slope(driver.between((-0.04, 0.04)), 4.0)
        for _ in range(int(rng.integers(1, 4))):
            drive.cruise(driver.between((2.0, 6.0)))
            driver.bend((0.15, 0.35), (30.0, 100.0))
        drive.cruise(driver.between((1.0, 4.0)))
        if rng.random() < 0.5:
            driver.stop((0.2, 0.45), (2.0, 6.0))
    return drive


def downhill(rng: np.random.Generator, duration_s: float) -> Drive:
    """A mountain-bike trail: steep, bend after bend, braking before each."""
    drive = Drive(speed_mps=5.0, edge_s=0.4)
    driver = _Driver(rng, drive, duration_s)
    while driver.goes_on():
        drive.slope(-driver.between((0.10, 0.32)), driver.between((1.5, 4.0)))
        drive.change_speed(driver.between((7.0, 11.0)), driver.level((0.08, 0.2)))
        drive.cruise(driver.between((0.5, 3.0)))
        drive.change_speed(driver.between((4.0, 6.5)), driver.level((0.2, 0.5)))
        driver.bend((0.3, 0.6), (40.0, 140.0))
    return drive


def stroll(rng: np.random.Generator, duration_s: float, speed_mps: float) -> Drive:
    """On foot: turns at corners, now and then a halt."""
    drive = Drive(edge_s=0.6)
    driver = _Driver(rng, drive, duration_s)
    driver.stop((0.1, 0.2), (2.0, 4.0))
    while driver.goes_on():
        driver.reach((0.9 * speed_mps, 1.1 * speed_mps), (0.1, 0.2))
        for _ in range(int(rng.integers(2, 5))):
            drive.cruise(driver.between((3.0, 9.0)))
            angle = driver.side() * np.radians(driver.between((30.0, 110.0)))
            drive.turn(float(angle), driver.between((0.5, 1.2)))
        drive.cruise(driver.between((2.0, 6.0)))
        driver.stop((0.1, 0.2), (2.0, 5.0))
    return drive
