"""Keeps motion that nothing measured out of studies that do not name it."""

from pathlib import Path

from hapticplayer.errors import InputError, Message
from hapticplayer.model import Feedback, rendered_feedback
from hapticplayer.sequence.store import DESCRIPTION, read_description
from hapticplayer.study.definition import Definition, refuse


def refuse_estimates(definition: Definition, path: str, folder: Path) -> None:
    """Refuse sequences whose motion was estimated from the picture.

    Unless a feedback of the definition is `estimated`.

    Args:
        definition: its sequences that are not there yet are passed over.
        path: of the definition, for the message.
        folder: of the study, which the folders of sequences are relative to.
    """
    if any(one.condition == Feedback.ESTIMATED for one in definition.chosen_feedbacks):
        return
    for number, sequence in enumerate(definition.sequences):
        description = folder / sequence.folder / DESCRIPTION
        if sequence.folder and _is_estimated(description):
            what = Message(
                "the motion of {key!r} was estimated from the picture, nothing measured it",
                key=sequence.key,
            )
            remedy = Message("take another sequence, or add 'estimated' to feedbacks")
            refuse(path, f"sequences[{number}].folder", what, remedy)


def _is_estimated(description: Path) -> bool:
    if not description.is_file():
        return False
    try:
        feedbacks = read_description(description.parent).feedbacks
    except InputError:
        return False  # what is wrong with it is said when it is opened
    return rendered_feedback(feedbacks) is Feedback.ESTIMATED
