"""What the parts of a study's definition are called in the window."""

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import NAMES, spoken
from app.experimenter.study.document import Content, Place, entry_at
from app.player.choices import feedback_words
from app.widgets.texts import quoted, titled
from hapticplayer.rendering import ChosenFeedback
from hapticplayer.study.definition import When
from hapticplayer.study.pages import number_text

translate = QCoreApplication.translate


def group_names() -> dict[str, str]:
    """When pages of questions are shown."""
    return {
        When.BEFORE: translate("StudyWords", "Before the first clip"),
        When.BEFORE_CLIP: translate("StudyWords", "Before each clip"),
        When.AFTER_CLIP: translate("StudyWords", "After each clip"),
        When.AFTER: translate("StudyWords", "After the last clip"),
    }


def text_names() -> dict[str, str]:
    """The texts of the pages."""
    return {
        "consent": translate("StudyWords", "Consent"),
        "demonstration": translate("StudyWords", "Information about the device"),
        "ready": translate("StudyWords", "Before each clip"),
        "thanks": translate("StudyWords", "Closing words"),
        "retention": translate("StudyWords", "How long data are kept"),
    }


def word_names() -> dict[str, str]:
    """The labels of the participant's buttons, and short messages."""
    return {
        "agree": translate("StudyWords", "Button: agree to take part"),
        "decline": translate("StudyWords", "Button: decline to take part"),
        "next": translate("StudyWords", "Button: next page"),
        "start": translate("StudyWords", "Button: start the clip"),
        "feel": translate("StudyWords", "Button: feel the device"),
        "yes": translate("StudyWords", "Answer: yes"),
        "no": translate("StudyWords", "Answer: no"),
        "feedback": translate("StudyWords", "Name of a feedback, before its number"),
        "clip": translate("StudyWords", "Name of a clip, before its number"),
        "optional": translate("StudyWords", "Mark of a question that may stay open"),
        "missing": translate("StudyWords", "Message: a question is not answered"),
        "centre": translate("StudyWords", "Message: bring the grip to the centre"),
        "paused": translate("StudyWords", "Page: paused"),
        "resume": translate("StudyWords", "Button: resume"),
        "leave": translate("StudyWords", "Button: end early"),
        "stopped": translate("StudyWords", "Page: ended early"),
        "problem": translate("StudyWords", "Page: answers cannot be saved"),
    }


def label_words(point: int) -> str:
    """What the label of a point of a scale is called."""
    return translate("StudyWords", "Label of {n}").format(n=number_text(point))


def condition_words(entry: str | Mapping[str, Any]) -> str:
    """Return a feedback of the definition in words."""
    if isinstance(entry, str):
        return feedback_words(ChosenFeedback(entry, {}))
    given = ChosenFeedback(entry.get("condition", ""), entry.get("parameters") or {})
    words = feedback_words(given)
    return f"{entry['key']}: {words}" if entry.get("key") else words


def text_in(texts: object, languages: list[str]) -> str:
    """Return a text in the window's language, else in the first one that has it."""
    known = texts if isinstance(texts, dict) else {}
    wanted = (spoken(), *languages)
    return next((known[one] for one in wanted if known.get(one)), "")


def place_words(content: Content, place: Place) -> str:
    """Return where a field is, such as "Questions > Age > Wording (Deutsch)"."""
    if not place:
        return translate("StudyWords", "Study")
    first = str(place[0])
    if first == "pages" and len(place) > 1:
        return _question_words(content, place)
    parts = [_room(first)]
    item = content
    if len(place) > 1 and isinstance(place[1], int):
        item = entry_at(content, place[:2])
        parts.append(_entry_words(content, first, item, place[1]))
        rest = place[2:]
    else:
        rest = place[1:]
    parts += [word for one in rest if (word := _part_words(first, one))]
    return " \u203a ".join(parts)


def page_words(content: Content, number: int) -> str:
    """A page of questions by its text, and its number among those at the same time."""
    page = entry_at(content, ("pages", number)) or {}
    text = text_in(page.get("text"), content["languages"])
    before = content["pages"][:number]
    place = 1 + sum(one.get("when") == page.get("when") for one in before)
    words = translate("StudyWords", "Page {n}").format(n=place)
    return titled(words, text) if text else words


def _question_words(content: Content, place: Place) -> str:
    number, rest = int(place[1]), place[2:]
    when = entry_at(content, ("pages", number, "when"))
    parts = [group_names().get(when, translate("StudyWords", "Questions"))]
    if sum(page.get("when") == when for page in content["pages"]) > 1:
        parts.append(page_words(content, number))
    if len(rest) > 1 and rest[0] == "questions":
        asked = entry_at(content, place[:4])
        parts.append(_entry_words(content, "pages", asked, int(rest[1])))
        rest = rest[2:]
        if len(rest) > 1 and rest[0] == "labels":  # by its point, as its row is named
            point = entry_at(content, (*place[:4], *rest[:2], "at"))
            parts.append(label_words(point or 0))
            rest = rest[2:]
    parts += [word for one in rest if (word := _part_words("pages", one))]
    return " \u203a ".join(parts)


def _room(first: str) -> str:
    rooms = {
        "sequences": translate("StudyWords", "Sequences"),
        "feedbacks": translate("StudyWords", "Conditions"),
        "levels": translate("StudyWords", "Levels"),
        "order": translate("StudyWords", "Order"),
        "texts": translate("StudyWords", "Texts"),
        "words": translate("StudyWords", "Buttons and messages"),
        "pages": translate("StudyWords", "Questions"),
        "while_watching": translate("StudyWords", "During clips"),
        "gap_s": translate("StudyWords", "Least time between two clips"),
        "limits": translate("StudyWords", "A trial is marked as invalid above"),
        "title": translate("StudyWords", "Title"),
        "languages": translate("StudyWords", "Languages"),
        "use_published": translate("StudyWords", "Published wording"),
        "checks": translate("StudyWords", "Checks"),
    }
    return rooms.get(first, first)


def _entry_words(content: Content, first: str, item: Any, number: int) -> str:
    if first == "feedbacks" and item:
        return condition_words(item)
    if not isinstance(item, dict):
        return str(number + 1)
    languages = content["languages"]
    text = text_in(item.get("title") or item.get("text"), languages)
    return quoted(text) if text else item.get("key") or str(number + 1)


def _part_words(first: str, part: str | int) -> str:
    if isinstance(part, int):
        return str(part + 1)
    if part in NAMES:
        return NAMES[part]
    known = {
        "texts": text_names(),
        "words": word_names(),
        "order": {"method": ""},
    }.get(first) or {
        "key": translate("StudyWords", "Name in the data"),
        "title": translate("StudyWords", "Title"),
        "folder": translate("StudyWords", "Recording"),
        "factors": translate("StudyWords", "Factors"),
        "text": translate("StudyWords", "Wording"),
        "published": translate("StudyWords", "Published wording"),
        "choices": translate("StudyWords", "Answers"),
        "least": translate("StudyWords", "Smallest number"),
        "most": translate("StudyWords", "Largest number or length"),
        "kind": translate("StudyWords", "Kind"),
        "parameters": translate("StudyWords", "Parameters"),
        "help": translate("StudyWords", "Help line"),
        "unit": translate("StudyWords", "Unit in the data"),
        "labels": translate("StudyWords", "Labels of points"),
        "at": translate("StudyWords", "Point"),
        "in_qoe": translate("StudyWords", "Part of the sum QoE"),
        "questions": translate("StudyWords", "Questions"),
        "scores": translate("StudyWords", "Scores"),
        "of": translate("StudyWords", "Questions of a score"),
        "value": translate("StudyWords", "Counts as"),
        "by": translate("StudyWords", "Moved by"),
        "hold": translate("StudyWords", "Key"),
        "every_s": translate("StudyWords", "Asked for every"),
        "stop_at": translate("StudyWords", "Ends clip and force from"),
        "rest": translate("StudyWords", "Text of the break after that"),
    }
    return known.get(part, part)
