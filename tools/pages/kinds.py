"""Pictures of every kind of question, rating and trial, with short and with long texts."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from app.participant.application import StudySession
from hapticplayer.study.creation import change_definition, create_study, new_definition
from hapticplayer.study.definition import When
from hapticplayer.study.pages import PageKind
from hapticplayer.study.study_folder import Study
from tools.pages.stage import Pictures, Stage
from tools.pages.study import KEYS, in_session, showing

TEMPLATES = (
    *("sickness", "incongruence", "two-interval", "staircase", "magnitude"),
    *("consistency", "haptic-experience"),
)
WORDS = {"de": "Geschwindigkeitsbegrenzung", "fr": "anticonstitutionnellement"}
LONG = "And please think of the whole clip, not only of its end, before you answer this one."
ANSWERS = ("never", "now and then, for a moment", "nearly all of the time, I am sure")
ASKED = {
    "scale": {"least": 1, "most": 7},
    "scale-21": {"least": 0, "most": 20},
    "visual": {},
    "visual-named": {},
    "number": {"least": 0, "most": 1000, "unit": "kg"},
    "choice": {},
    "choices": {},
    "yes-no": {},
    "pair": {"least": -3, "most": 3},
    "text": {"most": 300, "required": False},
}
ENDS = {
    "scale": (1, 7),
    "scale-21": (0, 20),
    "visual": (0, 100),
    "visual-named": (0, 50, 100),
    "pair": (-3, 3),
}
OF_PAGE = (("scale", "scale-21", "pair"), ("visual", "visual-named", "number"))
ALSO_OF_PAGE = (("choice", "choices", "yes-no"), ("text",))


def pictures(stage: Stage) -> Pictures:
    """Yield the pages of every template, then those of every kind with long texts."""
    for template in TEMPLATES:
        content = json.loads(new_definition(template))
        keys = [one["key"] for one in content["sequences"]]
        folders = dict.fromkeys(keys, stage.material.demo)
        study = create_study(stage.folder / template, template, folders=folders)
        study = _rated_soon(study)
        with in_session(stage, study) as session:
            session.begin_session("", stage.language)
            for name in _asked(study):
                yield from showing(
                    stage, session, ((name, "questions"),), f"-{template}"
                )
            yield from _played(stage, session, template)
    study = _with_every_kind(stage)
    with in_session(stage, study) as session:
        session.begin_session("", stage.language)
        pages = [(f"kind-{number}", "questions") for number in range(8)]
        yield from showing(stage, session, pages, "")


def _rated_soon(study: Study) -> Study:
    """A study that asks for a number at once: the demo is shorter than a minute."""
    content = json.loads(study.content)
    for one in content.get("while_watching") or ():
        if one.get("every_s"):
            one["every_s"] = 5.0
    return change_definition(study, content)


def _asked(study: Study) -> Iterator[str]:
    pages = study.definition.pages
    yield from (one.key for one in pages if one.when in (When.BEFORE, When.AFTER))
    if study.definition.pages_at(When.AFTER_CLIP):
        yield "trial-01"


def _played(stage: Stage, session: StudySession, template: str) -> Pictures:
    """Play the first trial, as far as there is something to see."""
    runner, window = session.runner, session.participant
    runner.consent(given=True)
    while runner.page.kind is not PageKind.READY:
        runner.skip("a picture of the window")
    window.refresh()
    yield f"kind-ready-{template}", stage.picture(window, 150)
    runner.proceed()
    window.refresh()
    if runner.page.kind is PageKind.INTERVAL:
        yield f"kind-interval-{template}", stage.picture(window, 150)
    stage.wait_until(lambda: runner.page.kind is PageKind.PLAYING)
    window.refresh()
    watching = runner.watching
    if watching is None:
        return
    yield f"kind-rated-{template}", stage.picture(window, 800)
    number = next((one for one in watching.ratings if one.every_s), None)
    if number is not None:
        stage.wait_until(lambda: watching.asking is not None)
        yield f"kind-asked-{template}", stage.picture(window, 150)
        watching.give(number.key, number.most or 0)
        stage.wait_until(lambda: runner.page.kind is PageKind.PAUSED)
        window.refresh()
        yield f"kind-rest-{template}", stage.picture(window, 150)


def _with_every_kind(stage: Stage) -> Study:
    folders = dict.fromkeys(KEYS, stage.material.demo)
    study = create_study(stage.folder / "kinds", folders=folders)
    content = json.loads(study.content)
    texts = _Texts(content["languages"])
    pages = [*OF_PAGE, *ALSO_OF_PAGE]
    content["pages"] += [
        {
            "key": f"kind-{4 * is_long + number}",
            "when": "before",
            "text": texts.made("More questions"),
            "questions": [texts.asked(kind, is_long) for kind in kinds],
        }
        for is_long in (False, True)
        for number, kinds in enumerate(pages)
    ]
    return change_definition(study, content)


@dataclass(frozen=True)
class _Texts:
    """Texts in every language of a study."""

    languages: list[str]

    def made(self, words: str, *, is_long: bool = False) -> dict[str, str]:
        return {
            one: f"{words} {WORDS.get(one, '')} {LONG if is_long else ''}".strip()
            for one in self.languages
        }

    def asked(self, kind: str, is_long: bool) -> dict[str, Any]:
        key = f"{kind}{'-long' if is_long else ''}"
        asked = {"key": key, "kind": kind.removesuffix("-21").removesuffix("-named")}
        asked["text"] = self.made("How strong was it?", is_long=is_long)
        asked["help"] = self.made("As you felt it.", is_long=is_long)
        ends = ("not at all", "so, so", "extremely strong")
        if is_long:
            ends = tuple(f"{end} and without any doubt at all" for end in ends)
        if points := ENDS.get(kind):
            at = zip(points, ends if len(points) > 2 else ends[::2], strict=True)
            asked["labels"] = [{"at": k, "text": self.made(end)} for k, end in at]
        if kind in ("choice", "choices"):
            given = ANSWERS * (3 if is_long else 1)
            asked["choices"] = [
                {"key": f"a{n}", "text": self.made(one)} for n, one in enumerate(given)
            ]
        return {**asked, **ASKED[kind]}
