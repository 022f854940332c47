"""Ranges of the numbers that people choose, in options and in answers about a log."""

import sys
from typing import NamedTuple

from hapticplayer.errors import Message, UsageError


class Range(NamedTuple):
    """Least and largest value of a number.

    Attributes:
        least: still allowed.
        largest: still allowed.
        unit: for people.
        is_whole: only whole numbers are allowed.
    """

    least: float
    largest: float
    unit: str = ""
    is_whole: bool = False

    def find(self, text: str) -> float | None:
        """Return the number in a text, an int where it must be whole; else None."""
        try:
            value = int(text) if self.is_whole else float(text)
        except ValueError:
            return None
        return value if self.least <= value <= self.largest else None

    def parse(self, name: str, text: str) -> float:
        value = self.find(text)
        if value is not None:
            return value
        within = Message(
            "{name} must be between {least} and {largest}{unit}, not {text}"
        )
        whole = Message(
            "{name} must be a whole number between {least} and {largest}{unit}, "
            "not {text}"
        )
        raise UsageError(
            whole.template if self.is_whole else within.template,
            name=name,
            least=f"{self.least:.16g}",
            largest=f"{self.largest:.16g}",
            unit=f" {self.unit}" if self.unit else "",
            text=text[:40],
        )


def finite_number(value: object) -> float | None:
    """A value that is a finite number, else None; true and false are none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if abs(value) <= sys.float_info.max else None


MEDIA_TIME_S = Range(0.0, 1e7, "s")
"""Longer than any clip."""

OFFSET_S = Range(-1e10, 1e10, "s")
"""Clocks count from 1970 at the earliest; float64 still tells 2 us apart there."""

DRIFT_PPM = Range(-2000.0, 2000.0, "ppm")
"""Ten times what quartzes differ by, and a film of 29.97 shown at 30."""

SLOWED = Range(1e-4, 1e4)
"""From a frame a minute to the fastest camera, shown at 30."""

SPEED = Range(0.5, 4.0)
"""Beyond it, speech is not understood and frames are dropped."""

SKEW_S = Range(-2.0, 2.0, "s")
"""Cameras are off by a few frames."""

RATE_DELAY_S = Range(-10.0, 10.0, "s")
"""Between the clocks of two sensors in one recorder."""

GAIN_N_PER_MPS2 = Range(1e-4, 100.0, "N per m/s^2")
"""From nothing that is felt to the limit of any device at 0.1 m/s^2."""

FORCE_DELAY_S = Range(-5.0, 5.0, "s")
"""Of a force against its clip, in studies; early and late."""

FORCE_GAIN = Range(0.0, 10.0)
"""Of a force against the one that was rendered, in studies."""

LEVER_ARM_M = Range(-10.0, 10.0, "m")
"""Within a vehicle; beyond it the noise of the angular rate outweighs the motion."""

TIME_CONSTANT_S = Range(0.1, 1000.0, "s")
"""Beyond it the smoother has no solution for short recordings."""

LOWPASS_HZ = Range(0.01, 10_000.0, "Hz")
"""Slower motion is an offset; half the sample rate is checked with the recording."""

AVERAGE_HZ = Range(0.1, 10_000.0, "Hz")

SAMPLE_RATE_HZ = Range(1.0, 100_000.0, "Hz")

UNIT_FACTOR = Range(1e-9, 1e9)
"""From counts of a sensor to SI, or from ns to s."""

TIMEOUT_S = Range(0.1, 3600.0, "s")

SIMULATED_PARTICIPANTS = Range(1, 200, is_whole=True)
"""More than any study of this kind had."""

SEED = Range(0, 2**53, is_whole=True)
"""Whole numbers that JSON keeps exactly."""

PORT = Range(0, 65535, is_whole=True)

SUGGEST_GAIN = Range(0.05, 20.0)
"""Factor on motion that is estimated from a picture, which does not show its scale."""
