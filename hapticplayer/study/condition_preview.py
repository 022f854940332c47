"""The force of a condition, beside the realistic one, before anybody feels it."""

from collections.abc import Mapping
from pathlib import Path

from hapticplayer.errors import Progress
from hapticplayer.playback.conditions import feedback_track
from hapticplayer.playback.source import open_source
from hapticplayer.rendering import ParameterKind, condition_named
from hapticplayer.sequence.comparison import Curves, curves_of
from hapticplayer.study.definition import StudyFeedback
from hapticplayer.study.session_setup import others_of


def condition_curves(
    folders: Mapping[str, Path],
    key: str,
    feedback: StudyFeedback,
    *,
    progress: Progress,
) -> tuple[Curves, Curves]:
    """The curves of a sequence as it is rendered, and under a condition.

    Args:
        folders: of the study's sequences, by key.
        key: of the sequence.
        feedback: the condition.
        progress: called now and then; raises to cancel.
    """
    condition = condition_named(feedback.condition)
    parameters = condition.parameters if condition else ()
    is_of_others = any(one.kind is ParameterKind.CLIP for one in parameters)
    wanted = folders if is_of_others else {key: folders[key]}
    opened = {name: open_source(folder) for name, folder in wanted.items()}
    progress(0.5, "")
    source = opened[key]
    track = feedback_track(
        source, feedback.condition, feedback.parameters, others_of(opened, key)
    )
    duration_s = source.clip.duration_s
    before = curves_of(source.tracks[source.feedback], duration_s)
    return before, curves_of(track, duration_s)
