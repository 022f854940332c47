"""Steps of a camera over the ground, made up, and what they suggest."""

import numpy as np

from hapticplayer.extras.frames.estimate import Suggestion, suggestion
from hapticplayer.extras.frames.ground import GroundMotion

FRAME_S = 1.0 / 30.0
DURATION_S = 20.0
SPEED = 2.0  # heights per second


def steps(
    turn_radps=lambda t: 0.0 * t,
    sinking=lambda t: 0.0 * t,
    apart: float = 0.0,
    unseen_s: tuple[float, float] = (0.0, 0.0),
    every_s: float = FRAME_S,
) -> list[GroundMotion]:
    """Return frames of a ride; `apart` is what its halves of points differ by."""
    rng = np.random.default_rng(3)
    made = []
    for begin_s in np.arange(0.0, DURATION_S, every_s):
        middle_s = begin_s + 0.5 * every_s
        is_seen = not unseen_s[0] <= middle_s < unseen_s[1]
        one, other = sinking(middle_s) + apart * rng.standard_normal(2)
        made.append(
            GroundMotion(
                begin_s,
                begin_s + every_s,
                float(turn_radps(middle_s)) * every_s,
                np.array([0.5 * (one + other), one, other]) * every_s,
                is_turn_known=is_seen,
                is_sunk_known=is_seen,
            )
        )
    return made


def suggested(made: list[GroundMotion], speed: float = SPEED, **more) -> Suggestion:
    speeds = (np.array([0.0, DURATION_S]), np.array([speed, speed]))
    return suggestion(made, speeds, DURATION_S, **more)


def turning(time_s) -> np.ndarray:
    """A bend to the left from 7 to 13 s."""
    return 0.4 * ((time_s > 7.0) & (time_s < 13.0))


def stepping(time_s) -> np.ndarray:
    return 0.1 * np.sin(2.0 * np.pi * 2.0 * time_s)
