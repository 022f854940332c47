"""From motion to force: axis alignment, gain, feedback conditions.

A pure room: no I/O, no threads, no clocks.
"""

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
    "demonstration",
    "no_feedback",
    "random_feedback",
    "render_force",
]
