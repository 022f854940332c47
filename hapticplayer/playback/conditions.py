"""Feedback conditions of what can be played, made when they are chosen."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from hapticplayer.errors import UsageError
from hapticplayer.model import Feedback, ForceTrack
from hapticplayer.playback.source import Source, open_source
from hapticplayer.rendering import ConditionInputs, chosen_feedback, condition_named
from hapticplayer.rendering.condition import Value

Other = Callable[[str], ForceTrack]
"""Returns the realistic track of another clip by its name, "" for one that suits."""


def with_feedback(source: Source, text: str | None) -> tuple[Source, str]:
    """Return the source with a feedback, and its name there.

    Args:
        source: to be played.
        text: name of a track, or of a condition with its parameters, such as
            `delayed:delay_s=0.3`; None for the source's own.
    """
    if text is None or text in source.tracks:
        return source, text or source.feedback
    chosen = chosen_feedback(text)
    track = feedback_track(source, chosen.name, chosen.parameters)
    return replace(source, tracks={**source.tracks, text: track}), text


def feedback_track(
    source: Source,
    name: str,
    parameters: Mapping[str, Value],
    other: Other | None = None,
) -> ForceTrack:
    """Return the track of a condition; a track of the source of that name comes first.

    Args:
        source: a sequence.
        name: of the condition or track.
        parameters: that are given, checked before.
        other: realistic tracks of other clips; None for those of folders.

    Raises:
        UsageError: when there is no such feedback.
        InputError: when it cannot be made.
    """
    if not parameters and name in source.tracks:
        return source.tracks[name]
    condition = condition_named(name)
    if condition is None or not (parameters or condition.is_derived):
        raise _unknown(source, name)
    realistic = source.tracks.get(Feedback.REALISTIC)
    if realistic is None and Feedback.ESTIMATED in source.tracks:
        raise UsageError(
            "the motion of {title} was estimated from the picture, so there is no "
            "realistic feedback to make {name!r} of",
            title=source.title,
            name=name,
        )
    if realistic is None:
        raise UsageError(
            "{title} has no realistic feedback to make {name!r} of; import it first",
            title=source.title,
            name=name,
        )
    of = ConditionInputs(
        realistic,
        rendered=lambda preset, effects: _rendered(source, preset, effects=effects),
        other=other or _of_folder,
        stored=lambda track: _stored(source, track),
    )
    return condition.track(of, parameters)


def _rendered(source: Source, preset: str, *, effects: bool) -> ForceTrack:
    from hapticplayer.sequence.editing import rendered_again  # a tenth of a second

    if not source.path.is_dir():
        raise UsageError(
            "another rendering needs the folder of the sequence; unpack it"
        )
    return rendered_again(source.path, preset, has_effects=effects)


def _of_folder(folder: str) -> ForceTrack:
    if not folder:
        raise UsageError(
            "the force of another clip needs its sequence: choose its folder"
        )
    source = open_source(Path(folder))
    if Feedback.REALISTIC not in source.tracks:
        raise _unknown(source, Feedback.REALISTIC)
    return source.tracks[Feedback.REALISTIC]


def _stored(source: Source, track: str) -> ForceTrack:
    if track not in source.tracks:
        raise _unknown(source, track)
    return source.tracks[track]


def _unknown(source: Source, name: str) -> UsageError:
    return UsageError(
        "{title} has no feedback {name!r}; choose one of {known}",
        title=source.title,
        name=name,
        known=", ".join(source.tracks),
    )
