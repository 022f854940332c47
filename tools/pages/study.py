"""Pictures of a study: every page of a participant, and the operator's windows."""

import json
from collections.abc import Iterator
from contextlib import contextmanager

from msgspec.structs import replace

from app.experimenter.study.editor import StudyEditor
from app.experimenter.study.merge_page import MergePage
from app.experimenter.study.new_study import NewStudyDialog
from app.experimenter.study.place_dialogs import export_dialog, pack_dialog
from app.experimenter.study.results import StudyResults
from app.experimenter.study.sequences import LibraryChoice
from app.participant.application import StudySession
from app.participant.pages import QuestionsPage
from app.widgets.layout import resize_within_screen
from hapticplayer.clock import SystemClock
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.definition import QuestionKind
from hapticplayer.study.pages import PageKind, PageMaker
from hapticplayer.study.session_setup import load_study_sources
from hapticplayer.study.study_folder import Study
from tools.pages.stage import Pictures, Stage

KEYS = ("bike", "horse", "car-turning", "car-braking")
PAGES = (
    ("consent", "consent"),
    ("sheet", "questions"),
    ("demonstration", "demonstration"),
    ("trial-03", "ready"),
    ("trial-03", "questions"),
    ("trial-03", "paused"),
    ("trial-03", "problem"),
    ("post-test", "questions"),
    ("end", "thanks"),
    ("end", "stopped"),
)
LONG = " And please take all the time that you need before you go on to the next one."
PLAYED_MS, PREVIEWED_MS = 1500, 3000


def pictures(stage: Stage) -> Pictures:
    """Yield every page of a study."""
    study = _study(stage)
    yield from _editor(stage, study)
    with in_session(stage, study) as session:
        yield from _begin(stage, session)
        yield from showing(stage, session, PAGES, "")
        yield from _while_it_runs(stage, session)
    with in_session(stage, _longer(study, stage.language)) as session:
        session.begin_session("", stage.language)
        yield from showing(stage, session, PAGES[4:5], "-long")


def _study(stage: Stage) -> Study:
    folder = stage.folder / "study"
    return create_study(folder, folders=dict.fromkeys(KEYS, stage.material.demo))


def _longer(study: Study, language: str) -> Study:
    content = json.loads(study.content)
    for factor in content["pages"][1]["questions"]:
        factor["text"][language] += LONG
    return change_definition(study, content)


@contextmanager
def in_session(stage: Stage, study: Study) -> Iterator[StudySession]:
    """The windows of a session, the participant's as large as the screen."""
    sources = load_study_sources(study)
    session = StudySession(study, sources, ["simulated"], SystemClock(), audio=None)
    try:
        session.show(windowed=True)
        room = session.participant.screen().geometry()
        session.participant.resize(room.width(), room.height())
        yield session
    finally:
        session.close()
        for window in (session.control, session.participant):
            window.deleteLater()  # before Python does so, item by item of its plots
        stage.wait()


def _editor(stage: Stage, study: Study) -> Pictures:
    new = NewStudyDialog(stage.folder)
    with stage.shown(new):
        new.name.setText("Bicycle rides")
        yield "study-new", stage.picture(new)
    library = stage.material.demo.parent
    choice = LibraryChoice(library)
    with stage.shown(choice):
        yield "study-choose", stage.picture(choice)
    results = StudyResults(study.folder)
    with stage.shown(results):
        stage.wait_until(lambda: results.overview is not None)
        yield "study-results", stage.picture(results)
        for name, make in (("export", export_dialog), ("pack", pack_dialog)):
            yield f"study-{name}", stage.picture(make(study.folder, results))
        merge = MergePage(study.folder, results)
        merge.add([study.folder])
        with stage.shown(merge):
            merge.merge()
            stage.wait_until(lambda: not merge.jobs.is_busy)
            yield "study-merge", stage.picture(merge)
    editor = StudyEditor(study.folder, lambda: library)
    with stage.shown(editor):
        editor.conditions.add("delayed")
        for number in range(editor.tabs.count()):
            editor.tabs.setCurrentIndex(number)
            yield f"study-editor-{number + 1}", stage.picture(editor, PREVIEWED_MS)
        editor.questions.select(("pages", 0))
        editor.questions.add(QuestionKind.CHOICE)
        editor.keep()
        editor.lead_to(("pages", 0, "questions", 4))
        yield "study-editor-error", stage.picture(editor, PREVIEWED_MS)
        while editor.document.stack.canUndo():
            editor.document.stack.undo()


def _begin(stage: Stage, session: StudySession) -> Pictures:
    stage.wait(700)  # device and disk are looked at twice a second
    yield "operator-start", session.control.grab()
    session.begin_session("", stage.language)


def showing(stage: Stage, session: StudySession, pages, more: str) -> Pictures:
    """Yield pages (step, kind, of questions), and what is said of a missing answer."""
    runner, window = session.runner, session.participant
    plan = replace(runner.plan, language=stage.language)
    runner.maker = maker = PageMaker(runner.definition, plan, runner.minutes)
    for step, kind, *asking in pages:
        window.show_page(maker.page(PageKind(kind), step, 99, *asking))
        name = f"study-{asking[0].key if asking else step}"
        yield f"{name}-{kind}{more}", stage.picture(window, 150)
        if kind == "questions" and isinstance(window.content, QuestionsPage):
            row = window.content.rows[0]
            row.take_digit(3)
            window.content.show_problem(
                window.content.rows[-1].asked.name, maker.word("missing")
            )
            yield f"{name}-missing{more}", stage.picture(window, 150)


def _while_it_runs(stage: Stage, session: StudySession) -> Pictures:
    runner, control = session.runner, session.control
    runner.consent(given=True)
    control.note.setText("The participant asked for more light.")
    control.note.returnPressed.emit()
    yield "operator-page", stage.picture(control, 200)
    runner.skip("a picture of the window")
    runner.skip("a picture of the window")
    runner.proceed()
    session.participant.refresh()
    stage.wait_until(lambda: runner.page.kind is PageKind.PLAYING)
    yield "operator-playing", stage.picture(control, PLAYED_MS)
    yield "study-playing", session.participant.grab()
    runner.pause()
    yield "operator-paused", stage.picture(control, 200)
    yield "operator-skip", stage.asked(control.buttons["skip"].click)
    yield "operator-end", stage.asked(control.buttons["end"].click)
    yield "operator-close", stage.asked(control.is_sure)
    control.show_message("study: answers.jsonl cannot be written (disk full)")
    resize_within_screen(control, control.width(), control.height())
    yield "operator-error", stage.picture(control)
