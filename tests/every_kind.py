"""A study that asks a question of each kind before, after each, and after all clips."""

import numpy as np

from hapticplayer.study.definition import QuestionKind, RatingKind, When
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
_RATED = {
    "slider": {"least": -5, "most": 5, "by": ["mouse", "grip-x"]},
    "number": {"least": 0, "most": 20, "every_s": 60.0, "stop_at": 15, "spoken": True},
    "held-key": {"hold": "v"},
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
    ratings = [
        {"key": f"rate_{kind}", "kind": str(kind), "text": text(kind), **_RATED[kind]}
        for kind in RatingKind
    ]
    slider, number, _ = ratings
    slider["labels"] = [{"at": 0, "text": text("fits")}]
    number["rest"] = text("Rest")
    pages = [*content["pages"], *pages]
    if content.get("standard"):  # two clips in a trial are not rated meanwhile
        ratings = []
    return {**content, "pages": pages, "while_watching": ratings, "gap_s": 1.0}


def drawn(page, rng: np.random.Generator) -> dict:
    """An answer at random to each question of a page."""
    return {one.name: kind_of(one.question).drawn(rng) for one in page.questions}
