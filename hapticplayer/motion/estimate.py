"""What an orientation estimator returns, and what it may be asked for."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Estimate:
    """The orientation at the times of a log.

    Attributes:
        quaternion_wxyz: (N, 4) unit, sensor to earth; for averaged samples in the
            middle of their windows.
        vertical: (N, 3) the earth's up direction in the sensor frame; for averaged
            samples its mean over the window, which is shorter than 1 while it turns.
        sigma_rad: (N,) RMS of the angle between estimated and true vertical, or None
            where the method does not know.
        at_rest: (N,) still samples that were found to be so, or None where the
            method does not look.
        found: returns what was chosen and found on the way, for provenance: plain
            numbers, lists and texts. Most callers do not ask.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats | None = None
    at_rest: NDArray[np.bool_] | None = None
    found: Callable[[], Mapping[str, Any]] = dict
