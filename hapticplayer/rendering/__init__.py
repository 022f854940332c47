"""From motion to force: axis alignment, gain, feedback conditions.

A pure room: no I/O, no threads, no clocks.
"""

from hapticplayer.rendering.condition import (
    ChosenFeedback,
    ConditionInputs,
    FeedbackCondition,
    Parameter,
    ParameterKind,
)
from hapticplayer.rendering.derived import (
    coverage_notice,
    refuse_late,
    shifted_and_scaled,
)
from hapticplayer.rendering.feedback import (
    FEEDBACKS,
    chosen_feedback,
    condition_named,
    no_feedback,
    random_feedback,
)
from hapticplayer.rendering.force import (
    adapted,
    fit_gain,
    render_force,
)
from hapticplayer.rendering.lever_arm import LEVER_ARMS_M, at_point

__all__ = [
    "FEEDBACKS",
    "LEVER_ARMS_M",
    "ChosenFeedback",
    "ConditionInputs",
    "FeedbackCondition",
    "Parameter",
    "ParameterKind",
    "adapted",
    "at_point",
    "chosen_feedback",
    "condition_named",
    "coverage_notice",
    "fit_gain",
    "no_feedback",
    "random_feedback",
    "refuse_late",
    "render_force",
    "shifted_and_scaled",
]
