"""The folders of a study's sequences, and what may not be in them."""

from pathlib import Path

from hapticplayer.errors import InputError, Message, StudyError
from hapticplayer.model import Feedback, rendered_feedback
from hapticplayer.sequence.store import DESCRIPTION, read_description
from hapticplayer.study.definition import Definition, read_file, refuse
from hapticplayer.study.definition_reader import DEFINITION
from hapticplayer.study.session_folder import sha256
from hapticplayer.study.study_folder import Study


def sequence_folder(study: Study, key: str) -> Path:
    """Return the folder of a sequence.

    Raises:
        StudyError: when the definition has none or it does not exist.
    """
    entry = next(s for s in study.definition.sequences if s.key == key)
    folder = study.folder / entry.folder
    if not entry.folder or not (folder / DESCRIPTION).is_file():
        raise StudyError(
            "the sequence {key!r} has no folder with a sequence",
            where=str(study.folder / DEFINITION),
            remedy="choose its folder (`hapticplayer study new --sequence KEY=FOLDER`)",
            key=key,
        )
    return folder


def clip_checksums(study: Study) -> dict[str, str]:
    """Return the SHA-256 of each sequence's description."""
    return {
        s.key: sha256(read_file(sequence_folder(study, s.key) / DESCRIPTION))
        for s in study.definition.sequences
    }


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
