"""Pictures of every kind of question, rating and trial, with short and with long texts."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest

from app.participant.application import StudySession
from hapticplayer.study.creation import change_definition, create_study, new_definition
from hapticplayer.study.definition import QuestionPage, When
from hapticplayer.study.pages import PageKind
from hapticplayer.study.scales import page_of_scale, scale_names
from hapticplayer.study.study_folder import Study
from tools.pages.stage import Pictures, Stage
from tools.pages.study import KEYS, in_session, showing

TEMPLATES = (
    *("sickness", "incongruence", "two-interval", "staircase", "magnitude"),
    *("consistency", "haptic-experience", "qoe2012", "viewpoint"),
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
    """Yield the pages of every template, then of every scale and kind of question."""
    seen: set[str] = set()  # several templates share a page
    for template in TEMPLATES:
        content = json.loads(new_definition(template))
        keys = [one["key"] for one in content["sequences"]]
        folders = dict.fromkeys(keys, stage.material.demo)
        study = create_study(stage.folder / template, template, folders=folders)
        study = _ready(study)
        with in_session(stage, study) as session:
            session.begin_session("", stage.language)
            if (text := str(study.definition.texts)) not in seen:
                seen.add(text)
                consent = (("consent", "consent"),)
                yield from showing(stage, session, consent, f"-{template}")
            yield from showing(stage, session, _asked(study, seen), f"-{template}")
            yield from _played(stage, session, template)
    study = _with_every_kind(stage)
    with in_session(stage, study) as session:
        session.begin_session("", stage.language)
        yield from showing(stage, session, _asked(study, seen), "")


def _ready(study: Study) -> Study:
    """The study with a wording, which asks for a number within the short demo."""
    text = study.content.decode()
    content = json.loads(text.replace("\u2039", "").replace("\u203a", ""))
    for one in content.get("while_watching") or ():
        if one.get("every_s"):
            one["every_s"] = 5.0
    content["gap_s"] = min(content.get("gap_s", 0.0), 1.0)
    return change_definition(study, content)


def _asked(study: Study, seen: set[str]) -> Iterator[tuple[str, str, QuestionPage]]:
    pages = [one for one in study.definition.pages if str(one) not in seen]
    seen.update(map(str, pages))
    for one in pages:
        step = "trial-01" if one.when is When.AFTER_CLIP else one.key
        yield step, "questions", one


def _played(stage: Stage, session: StudySession, template: str) -> Pictures:
    """Play the first trial, as far as there is something to see."""
    runner, window = session.runner, session.participant
    runner.consent(given=True)
    while runner.page.kind is not PageKind.READY:
        runner.skip("a picture of the window")
    window.refresh()
    yield f"kind-ready-{template}", stage.picture(window, 150)
    if runner.definition.gap_s:
        window.content.show_problem(runner.maker.word("centre"))
        stage.wait(150)
        window.content.wait(60.0)  # until the window looks next
        QCoreApplication.sendPostedEvents()
        yield f"kind-waits-{template}", window.grab()
    runner.proceed()
    window.refresh()
    if runner.page.kind is PageKind.INTERVAL:
        yield f"kind-interval-{template}", stage.picture(window, 150)
    stage.wait_until(lambda: runner.page.kind is PageKind.PLAYING)
    window.refresh()
    if runner.watching is None:
        return
    yield f"kind-rated-{template}", stage.picture(window, 800)
    number = next((one for one in runner.watching.ratings if one.every_s), None)
    if number is not None:
        stage.wait_until(lambda: _asks(session))
        yield f"kind-asked-{template}", stage.picture(window, 150)
        for key in (Qt.Key.Key_V, Qt.Key.Key_1):
            QTest.keyPress(window, key)
        yield f"kind-typed-{template}", stage.picture(window, 150)
        if runner.watching is not None:
            runner.watching.give(number.key, number.most or 0)
        stage.wait_until(lambda: runner.page.kind is PageKind.PAUSED)
        window.refresh()
        yield f"kind-rest-{template}", stage.picture(window, 150)


def _asks(session: StudySession) -> bool:
    """Whether a number is due; a play that a busy machine has stopped begins again."""
    runner = session.runner
    if runner.page.kind in (PageKind.READY, PageKind.PAUSED):
        runner.proceed()
    return runner.watching is not None and runner.watching.asking is not None


def _with_every_kind(stage: Stage) -> Study:
    folders = dict.fromkeys(KEYS, stage.material.demo)
    study = create_study(stage.folder / "kinds", folders=folders)
    content = json.loads(study.content)
    languages = content["languages"]
    texts = _Texts(languages)
    pages = [*OF_PAGE, *ALSO_OF_PAGE]
    content["pages"] += [
        page_of_scale(name, f"scale-{name}", When.BEFORE, languages)
        for name in scale_names()
    ]
    content["pages"] += [
        {
            "key": f"kind-{4 * is_long + number}{'-alone' if is_alone else ''}",
            "when": "before",
            "text": texts.made("More questions"),
            "questions": [texts.asked(kind, is_long, is_alone) for kind in kinds],
            "one_by_one": is_alone,
        }
        for is_long in (False, True)
        for number, kinds in enumerate(pages)
        for is_alone in (False, True)
    ]
    return _ready(change_definition(study, content))


@dataclass(frozen=True)
class _Texts:
    """Texts in every language of a study."""

    languages: list[str]

    def made(self, words: str, *, is_long: bool = False) -> dict[str, str]:
        return {
            one: f"{words} {WORDS.get(one, '')} {LONG if is_long else ''}".strip()
            for one in self.languages
        }

    def asked(self, kind: str, is_long: bool, is_alone: bool) -> dict[str, Any]:
        key = f"{kind}{'-long' if is_long else ''}{'-alone' if is_alone else ''}"
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
