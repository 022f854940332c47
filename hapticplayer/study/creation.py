"""New studies from templates, and changes of their definition."""

import json
import re
import secrets
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from hapticplayer import storage
from hapticplayer.errors import Message, StudyError, entry_named
from hapticplayer.rendering import chosen_feedback
from hapticplayer.storage import json_text
from hapticplayer.study.definition import StudyFeedback, read_file
from hapticplayer.study.definition_reader import DEFINITION, parse_definition
from hapticplayer.study.estimates import refuse_estimates
from hapticplayer.study.plan import LETTERS
from hapticplayer.study.session_folder import sha256
from hapticplayer.study.study_folder import Study, open_study

TEMPLATES = Path(__file__).resolve().parents[2] / "resources" / "studies"
_ID_LETTERS = 10
_KEY_OF = re.compile(r"(?:([a-z0-9_-]+)=)?(.*)", re.DOTALL)


def template_names() -> list[str]:
    return sorted(path.stem for path in TEMPLATES.glob("*.json"))


def chosen_text(text: str) -> StudyFeedback:
    """Return the feedback in a text such as `late=delayed:delay_s=0.3`."""
    key, name = _KEY_OF.fullmatch(text).groups()  # type: ignore[union-attr]
    chosen = chosen_feedback(name)
    return StudyFeedback(chosen.name, dict(chosen.parameters), key)


def create_study(
    folder: Path,
    template: str = "qoe2012",
    folders: Mapping[str, Path] | None = None,
    feedbacks: Sequence[str] = (),
) -> Study:
    """Make a study's folder, which must not exist yet; see `new_definition`."""
    text = new_definition(template, folders, feedbacks)
    refuse_estimates(parse_definition(text, template), template, folder)
    with storage.folder_written_aside(folder, storage.PRIVATE_FOLDER) as aside:
        storage.write_private(aside / DEFINITION, text)
    return open_study(folder)


def new_definition(
    template: str = "qoe2012",
    folders: Mapping[str, Path] | None = None,
    feedbacks: Sequence[str] = (),
) -> bytes:
    """The definition of a new study, from a template.

    Args:
        template: one of `template_names()`.
        folders: of the sequences, by key; others stay empty.
        feedbacks: in place of the template's, see `chosen_text`.
    """
    content = _template(template)
    letters = LETTERS.lower()
    content["id"] = "".join(secrets.choice(letters) for _ in range(_ID_LETTERS))
    known = {entry["key"]: entry for entry in content["sequences"]}
    for key, path in (folders or {}).items():
        sequence = entry_named(known, key, Message("sequence"))
        sequence["folder"] = str(path.resolve())
    if feedbacks:
        content["feedbacks"] = [_described(chosen_text(text)) for text in feedbacks]
    return definition_text(content)


def _described(feedback: StudyFeedback) -> str | dict[str, Any]:
    """Return a feedback as the definition holds it, without what is not needed."""
    if not feedback.parameters and feedback.key in (None, feedback.condition):
        return feedback.condition
    described: dict[str, Any] = msgspec.to_builtins(feedback)
    return {name: value for name, value in described.items() if value}


def change_definition(study: Study, content: Mapping[str, Any]) -> Study:
    """Replace the definition of a study after checking it.

    Sessions keep the definition that they began with.
    """
    path = study.folder / DEFINITION
    text = definition_text(content)
    refuse_estimates(parse_definition(text, str(path)), str(path), study.folder)
    with storage.locked(study.folder):
        if read_file(path) != study.content:
            raise StudyError(
                "was changed by another program meanwhile",
                where=str(path),
                remedy="open the study again and repeat the change",
            )
        storage.replace_file(path, text, storage.PRIVATE_FILE)
    return open_study(study.folder)


def definition_text(content: Mapping[str, Any]) -> bytes:
    return json_text(content)


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


def _template(name: str) -> dict[str, Any]:
    known = {one: TEMPLATES / f"{one}.json" for one in template_names()}
    text = entry_named(known, name, Message("template")).read_text(encoding="utf-8")
    content: dict[str, Any] = json.loads(text)
    base = content.pop("base", None)
    return {**_template(base), **content} if base else content
