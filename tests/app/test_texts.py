"""Texts that several pages show."""

import ast
from pathlib import Path

import pytest

from app.bridge import languages
from app.bridge.jobs import JobState
from app.widgets.texts import job_text, step_text

ENGINE = Path(__file__).resolve().parents[2] / "hapticplayer"
WORKING = (  # where the steps of work come from that the window shows
    "simulation/recordings.py",
    "simulation/demo.py",
    "sequence/recognising.py",
    "sequence/processing.py",
    "sequence/build.py",
    "study/analysis/analysis.py",
    "study/analysis/report.py",
)


@pytest.fixture
def spoken(application):
    yield lambda code: languages.install(application, code)
    languages.install(application, languages.ENGLISH)


def steps() -> set[str]:
    """Return what the engine says while it works; names in it are `X`."""
    found = set()
    for name in WORKING:
        for node in ast.walk(ast.parse((ENGINE / name).read_text(encoding="utf-8"))):
            is_call = isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
            if is_call and node.func.id == "progress" and len(node.args) == 2:
                found.add(words(node.args[1]))
    return found - {""}


def words(node: ast.expr) -> str:
    if isinstance(node, ast.JoinedStr):
        return "".join(words(part) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return "X"
    return node.value if isinstance(node, ast.Constant) else ""


@pytest.mark.parametrize("code", ["de", "fr"])
def test_every_step_of_long_work_is_said_in_the_windows_language(spoken, code):
    assert len(steps()) > 12
    spoken(code)
    assert [step for step in steps() if step_text(step) == step] == []


def test_names_in_steps_stay_and_unknown_steps_stay_english(spoken):
    spoken("fr")
    assert step_text("reading ride.mp4") == "lecture de ride.mp4"
    assert step_text("frame 312 of 780") == "frame 312 of 780"


def test_french_has_a_space_before_its_colon_that_does_not_break(spoken):
    spoken("fr")
    state = JobState("Importation", 0.4, "synchronising")
    assert job_text(state) == "Importation\u00a0: synchronisation"
