"""From motion to force: axis alignment, gain, feedback conditions.

A pure room: no I/O, no threads, no clocks.
"""

from hapticplayer.rendering.coverage import coverage_notice, refuse_late
from hapticplayer.rendering.demonstration import circle, demonstration
from hapticplayer.rendering.feedback import (
    FEEDBACKS,
    FeedbackCondition,
    no_feedback,
    random_feedback,
)
from hapticplayer.rendering.force import adapted, fit_gain, render_force
from hapticplayer.rendering.lever_arm import LEVER_ARMS_M, at_point

__all__ = [
    "FEEDBACKS",
    "LEVER_ARMS_M",
    "FeedbackCondition",
    "adapted",
    "at_point",
    "circle",
    "coverage_notice",
    "demonstration",
    "fit_gain",
    "no_feedback",
    "random_feedback",
    "refuse_late",
    "render_force",
]
