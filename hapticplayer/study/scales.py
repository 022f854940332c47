"""Published scales: their questions and scores, from the files in `resources/scales`.

A page of a study holds a copy, so that a study does not change with the program.
"""

from collections.abc import Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Any

from hapticplayer.errors import Message, entry_named
from hapticplayer.shipped import shipped
from hapticplayer.structures import read_json
from hapticplayer.study.definition import JsonObject, Key, Line, When

SCALES, TEMPLATES = shipped("resources/scales"), shipped("resources/studies")
_OPEN, _CLOSE = "\u2039", "\u203a"  # around what is to be worded


class TemplatePage(JsonObject, frozen=True):
    """A page of questions of a template."""

    study: Key
    page: Key


class Scale(JsonObject, frozen=True):
    """A scale as its file has it.

    Attributes:
        name: for people, with the abbreviation.
        source: publication of items and key.
        licence: of the wording.
        wordings: by language, whose the wording is; none where a lab brings its own.
        note: on its use.
        text: above the questions.
        item: entries that all items have in common.
        items: questions; `about` in place of a text that is to be worded.
        template: where the items are instead.
        scores: by the published key.
        one_by_one: whether its questions are shown one after the other.
    """

    name: Line
    source: Line
    licence: Line
    wordings: dict[str, Line]
    scores: tuple[dict[str, Any], ...]
    note: str = ""
    text: dict[str, Line] | None = None
    item: Mapping[str, Any] = MappingProxyType({})
    items: tuple[dict[str, Any], ...] = ()
    template: TemplatePage | None = None
    one_by_one: bool = False


def scale_names() -> list[str]:
    return sorted(path.stem for path in SCALES.glob("*.json"))


@cache
def read_scale(name: str) -> Scale:
    known = {one: SCALES / f"{one}.json" for one in scale_names()}
    return read_json(entry_named(known, name, Message("scale")), Scale)


def questions_of(scale: Scale) -> list[dict[str, Any]]:
    """The items with all their entries."""
    if (place := scale.template) is None:
        return [{**scale.item, **one} for one in scale.items]
    content = read_json(TEMPLATES / f"{place.study}.json", dict[str, Any])
    page = next(one for one in content["pages"] if one["key"] == place.page)
    left_out = ("in_qoe", "published")
    return [
        {name: one for name, one in asked.items() if name not in left_out}
        for asked in page["questions"]
    ]


def page_of_scale(
    name: str, key: str, when: When, languages: Sequence[str]
) -> dict[str, Any]:
    """A page that asks a scale, for the definition of a study.

    Args:
        name: of the scale.
        key: of the page, and before the names of its questions and scores.
        when: it is shown.
        languages: of the study; what a wording lacks is to be written.
    """
    scale = read_scale(name)
    questions = [_worded(one, name, languages) for one in questions_of(scale)]
    page: dict[str, Any] = {
        "key": key,
        "when": str(when),
        "scale": name,
        "questions": questions,
    }
    if scale.text:
        page["text"] = _in_languages(scale.text, languages)
    if scale.scores:
        page["scores"] = [dict(one) for one in scale.scores]
    if scale.one_by_one:
        page["one_by_one"] = True
    for part in [*questions, *page.get("scores", ())]:
        part["key"] = f"{key}_{part['key']}"
        for names in {"of", "reversed"} & part.keys():
            part[names] = [f"{key}_{one}" for one in part[names]]
    return page


def _worded(part: Any, place: str, languages: Sequence[str]) -> Any:
    """A part of a question with its texts in these languages."""
    if isinstance(part, list):
        return [_worded(one, place, languages) for one in part]
    if not isinstance(part, dict):
        return part
    if "en" in part:
        return _in_languages(part, languages)
    place = f"{place} {part.get('key', '')}".strip()
    made = {name: _worded(one, place, languages) for name, one in part.items()}
    if about := made.pop("about", ""):
        made["text"] = _in_languages({"": f"{place}: {about}"}, languages)
    return made


def _in_languages(text: dict[str, str], languages: Sequence[str]) -> dict[str, str]:
    hint = f"{_OPEN}{next(iter(text.values()))}{_CLOSE}"
    return {one: text.get(one, hint) for one in languages}
