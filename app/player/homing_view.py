"""What the picture of homing shows: from the engine's progress to shares of the whole."""

from typing import NamedTuple

from hapticplayer.devices.falcon.homing import WAY_COUNTS, Advice
from hapticplayer.devices.falcon.setting_up import Progress, Step

RADIUS_M = 0.040
"""Of the sphere in which the grip is shown once its place is known."""


class HomingView(NamedTuple):
    """One state of the picture.

    Attributes:
        homed: encoders (top, right, lower left) that have found their zero.
        legs: how far out each of them is, 0 to 1; None where nothing is known.
        out: the same for the grip.
        aside: place of the grip right and up, -1 to 1.
        arrow: 1 pull, -1 push, 0 nothing to do.
        is_ready: whether all is done.
    """

    homed: tuple[bool, bool, bool] = (False, False, False)
    legs: tuple[float, float, float] | None = None
    out: float | None = None
    aside: tuple[float, float] = (0.0, 0.0)
    arrow: int = 0
    is_ready: bool = False


class Ways:
    """Turns differences of counts into shares of the way from the inner end.

    Before homing nobody knows where on its way the grip began: in the middle, until
    it goes further to one side than that leaves room for.
    """

    def __init__(self) -> None:
        self._low = [-WAY_COUNTS / 2.0] * 4

    def share(self, which: int, counts: float) -> float:
        """Return the share of the way for leg 0 to 2, or for the mean of them, 3."""
        low = min(self._low[which], counts)
        self._low[which] = low = max(low, counts - WAY_COUNTS)
        return (counts - low) / WAY_COUNTS


def view_of(progress: Progress | None, ways: Ways) -> HomingView:
    """Return what to show.

    Args:
        progress: None while there is no Falcon.
        ways: of this homing; it learns.
    """
    if progress is None:
        return HomingView()
    if progress.step is Step.READY:
        x, y, z = (max(-1.0, min(1.0, way / RADIUS_M)) for way in progress.position_m)
        out = (z + 1.0) / 2.0
        return HomingView((True,) * 3, (out,) * 3, out, (x, y), 0, is_ready=True)
    guidance = progress.guidance
    if guidance is None:
        return HomingView()
    i, j, k = (ways.share(leg, counts) for leg, counts in enumerate(guidance.legs))
    arrow = {Advice.PULL: 1, Advice.PUSH: -1, Advice.DONE: 0}[guidance.advice]
    return HomingView(
        guidance.homed,
        (i, j, k),
        ways.share(3, guidance.out),
        (0.0, 0.0),
        arrow,
        is_ready=guidance.advice is Advice.DONE,
    )
