"""New studies from templates, and changes of their definition."""

import json
import re
import secrets
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from hapticplayer import storage
from hapticplayer.errors import Message, StudyError, UsageError, entry_named
from hapticplayer.rendering import chosen_feedback
from hapticplayer.storage import json_text
from hapticplayer.study.definition import StudyFeedback, When, read_file
from hapticplayer.study.definition_reader import DEFINITION, parse_definition
from hapticplayer.study.plan import LETTERS
from hapticplayer.study.scales import TEMPLATES, page_of_scale, scale_names
from hapticplayer.study.sequence_folders import refuse_estimates
from hapticplayer.study.study_folder import Study, open_study

_ID_LETTERS = 10
_KEY_OF = re.compile(r"(?:([a-z0-9_-]+)=)?(.*)", re.DOTALL)


class StudyTemplate(NamedTuple):
    """A study to begin with; its definition is the file of its name in TEMPLATES."""

    name: str
    title: Message
    text: Message


STUDY_TEMPLATES = (
    StudyTemplate(
        "qoe2012",
        Message("Quality of experience"),
        Message(
            "The protocol of Danieau et al. (2012): each clip with the recorded force, "
            "without force and with a random one; four questions after each."
        ),
    ),
    StudyTemplate(
        "controls",
        Message("Recorded force and controls"),
        Message(
            "The same questions; the recorded force beside no force, the force of "
            "another clip, and the recorded force half a second late."
        ),
    ),
    StudyTemplate(
        "consistency",
        Message("Consistency of force and video"),
        Message(
            "The recorded force earlier or later than the video; after each clip, "
            "whether both went together."
        ),
    ),
    StudyTemplate(
        "two-interval",
        Message("Just noticeable change"),
        Message(
            "Each clip twice, once with a stronger or weaker force; in which one it was "
            "stronger (forced choice)."
        ),
    ),
    StudyTemplate(
        "staircase",
        Message("Staircase"),
        Message(
            "Each clip twice, once with a late force; the delay follows the answers "
            "(2-down 1-up)."
        ),
    ),
    StudyTemplate(
        "magnitude",
        Message("Magnitude estimation"),
        Message("Forces of several strengths; a number in proportion after each clip."),
    ),
    StudyTemplate(
        "haptic-experience",
        Message("Haptic experience"),
        Message(
            "The Haptic Experience Inventory (HXI) after each clip; its wording is to be "
            "entered from your copy."
        ),
    ),
    StudyTemplate(
        "sickness",
        Message("Motion sickness and vection"),
        Message(
            "Susceptibility (MSSQ-short) and symptoms (SSQ) before and after; during each "
            "clip sickness (FMS) each minute, which can end it, and vection by a held key."
        ),
    ),
    StudyTemplate(
        "incongruence",
        Message("Motion incongruence"),
        Message(
            "During each clip a slider says how badly force and video fit; the recorded "
            "force beside a weaker and a late one and none."
        ),
    ),
    StudyTemplate(
        "viewpoint",
        Message("Third person against first"),
        Message(
            "The same questions about rides that were filmed by the rider and from "
            "outside; whether the force adds as much to both."
        ),
    ),
)


def template_names() -> list[str]:
    return [one.name for one in STUDY_TEMPLATES]


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
    languages: Sequence[str] = (),
    title: str = "",
) -> Study:
    """Make a study's folder, which must not exist yet; see `new_definition`."""
    text = new_definition(template, folders, feedbacks, languages, title)
    refuse_estimates(parse_definition(text, template), template, folder)
    with storage.folder_written_aside(folder, storage.PRIVATE_FOLDER) as aside:
        storage.write_private(aside / DEFINITION, text)
    return open_study(folder)


def new_definition(
    template: str = "qoe2012",
    folders: Mapping[str, Path] | None = None,
    feedbacks: Sequence[str] = (),
    languages: Sequence[str] = (),
    title: str = "",
) -> bytes:
    """The definition of a new study, from a template.

    Args:
        template: one of `template_names()`.
        folders: of the sequences, by key; others stay empty.
        feedbacks: in place of the template's, see `chosen_text`.
        languages: of those that the template has; all by default.
        title: for people, in place of the template's.
    """
    content = _template(template)
    letters = LETTERS.lower()
    content["id"] = "".join(secrets.choice(letters) for _ in range(_ID_LETTERS))
    known = {entry["key"]: entry for entry in content["sequences"]}
    for key, path in (folders or {}).items():
        sequence = entry_named(known, key, Message("sequence"))
        sequence["folder"] = str(path.resolve())
    if feedbacks:
        content["feedbacks"] = [described(chosen_text(text)) for text in feedbacks]
    if title:
        content["title"] = title
    if languages:
        content = with_languages(content, languages)
    return definition_text(content)


def with_languages(content: dict[str, Any], languages: Sequence[str]) -> dict[str, Any]:
    """The definition in these languages.

    A text that lacks one has that of its template or scale, else it is empty: to be
    written.
    """
    try:
        template = _template(content["template"])
    except UsageError:
        template = {"pages": []}
    of_scales = [
        page_of_scale(page["scale"], page["key"], page["when"], languages)
        for page in content["pages"]
        if page.get("scale") in scale_names()
    ]
    template["pages"] = [*template["pages"], *of_scales]
    before = set(content["languages"])

    def changed(part: Any, old: Any) -> Any:
        if isinstance(part, list):
            known = _by_key(old)
            return [changed(one, known.get(_key_in(one))) for one in part]
        if not isinstance(part, dict):
            return part
        of = old if isinstance(old, dict) else {}
        if part.keys() and part.keys() <= before:
            return {one: part.get(one, of.get(one, "")) for one in languages}
        made = {name: changed(one, of.get(name)) for name, one in part.items()}
        if isinstance(made.get("published"), dict):  # need not have all
            made["published"] = {k: v for k, v in made["published"].items() if v}
        return made

    return {**changed(content, template), "languages": list(languages)}


def _by_key(old: Any) -> dict[str, Any]:
    parts = old if isinstance(old, list) else []
    return {key: one for one in parts if (key := _key_in(one))}


def _key_in(part: Any) -> str:
    """What tells an entry from its neighbours; of a label, its point."""
    of = part if isinstance(part, dict) else {}
    return str(of.get("key", of.get("at", "")))


def described(feedback: StudyFeedback) -> str | dict[str, Any]:
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


def _template(name: str) -> dict[str, Any]:
    known = {one: TEMPLATES / f"{one}.json" for one in template_names()}
    text = entry_named(known, name, Message("template")).read_text(encoding="utf-8")
    content: dict[str, Any] = json.loads(text)
    if not (base := content.pop("base", None)):
        return content
    found = _template(base)
    pages = _by_key(found["pages"])

    def whole(page: dict[str, Any]) -> dict[str, Any]:
        """A page without questions is that of its scale, or the one of the base."""
        if "questions" in page:
            return page
        if scale := page.get("scale"):
            made = page_of_scale(scale, page["key"], page["when"], found["languages"])
            return {**made, **page}
        return dict(pages[page["key"]])

    if "pages" in content:
        content["pages"] = [whole(one) for one in content["pages"]]
    content["texts"] = {**found["texts"], **content.get("texts", {})}
    return {**found, **content}


def add_scale(study: Study, name: str, key: str, when: When) -> Study:
    """Add a page that asks a scale, after the other pages."""
    content = json.loads(study.content)
    page = page_of_scale(name, key, when, content["languages"])
    return change_definition(study, {**content, "pages": [*content["pages"], page]})
