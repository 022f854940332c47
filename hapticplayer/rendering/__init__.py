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
from hapticplayer.rendering.force import adapted, render_force

__all__ = [
    "FEEDBACKS",
    "FeedbackCondition",
    "adapted",
    "circle",
    "coverage_notice",
    "demonstration",
    "no_feedback",
    "random_feedback",
    "refuse_late",
    "render_force",
]
