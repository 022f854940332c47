"""The folders of a study's sequences."""

from pathlib import Path

from hapticplayer.errors import StudyError
from hapticplayer.study.definition import read_file
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
    if not entry.folder or not (folder / "sequence.json").is_file():
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
        s.key: sha256(read_file(sequence_folder(study, s.key) / "sequence.json"))
        for s in study.definition.sequences
    }
