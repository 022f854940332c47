"""A study that asks a question of each kind before, after each, and after all clips."""

import numpy as np

from hapticplayer.study.definition import QuestionKind, When
from hapticplayer.study.questions import kind_of

_MORE = {
    "scale": {"least": -3, "most": 3, "labels": ((-3, "bad"), (0, "so"), (3, "good"))},
    "visual": {"labels": ((0, "none"), (100, "most"))},
    "number": {"least": -5, "most": 5, "unit": "kg"},
    "choice": {"choices": ("car", "bike")},
    "choices": {"choices": ("sea", "air", "land")},
    "pair": {"least": -3, "most": 3, "labels": ((-3, "dull"), (3, "exciting"))},
    "text": {"most": 30, "required": False},
}


def with_every_kind(content: dict) -> dict:
    """The content of a definition with a page more at each time."""
    languages = content["languages"]

    def text(words):
        return {one: f"{words} {one}" for one in languages}

    def asked(kind, when):
        more = dict(_MORE.get(kind, {}))
        if labels := more.pop("labels", ()):
            more["labels"] = [{"at": at, "text": text(words)} for at, words in labels]
        if keys := more.pop("choices", ()):
            more["choices"] = [{"key": key, "text": text(key)} for key in keys]
        name = {"key": f"{kind}_{when}", "kind": str(kind), "help": text("Help")}
        return {**name, "text": text(f"{kind} {when}?"), **more}

    pages = [
        {
            "key": f"more-{when}",
            "when": str(when),
            "text": text("More"),
            "questions": [asked(kind, when) for kind in QuestionKind],
        }
        for when in When
    ]
    return {**content, "pages": [*content["pages"], *pages]}


def drawn(page, rng: np.random.Generator) -> dict:
    """An answer at random to each question of a page."""
    return {one.name: kind_of(one.question).drawn(rng) for one in page.questions}
