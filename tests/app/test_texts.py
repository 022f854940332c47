"""Texts that several pages show, and what no text of the window says."""

import ast
import re

import pytest

from app.bridge.jobs import JobState
from app.bridge.languages import translated
from app.widgets.texts import breakable, job_text
from hapticplayer.errors import InputError, Message, message_of
from tools.translate import ROOT, templates, templates_in


def test_french_has_a_space_before_its_colon_that_does_not_break(spoken):
    spoken("fr")
    state = JobState("Importation", 0.4, Message("synchronising"))
    assert job_text(state) == "Importation\u00a0: synchronisation"


def test_long_names_can_be_broken_between_lines():
    assert breakable("all of these are short") == "all of these are short"
    name = 60 * "x"
    assert max(map(len, breakable(f"the {name}!").split("\u200b"))) <= 28
    assert breakable(name).replace("\u200b", "") == name


OPTION = re.compile(r"(?<![\w-])--[a-z]|`hapticplayer|\bKEY=|\b[a-z]+=[a-z]")


def texts_of_the_window() -> list[str]:
    """What `app` says: all literals with a space that are no docstrings or patterns."""
    found = []
    for path in sorted((ROOT / "app").rglob("*.py")):
        nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
        alone = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
        found += [
            node.value
            for node in nodes
            if isinstance(node, ast.Constant) and id(node) not in alone
        ]
    return [text for text in found if isinstance(text, str) and " " in text.strip()]


def test_no_text_of_the_window_names_a_command_line_option():
    texts = texts_of_the_window()
    assert len(texts) > 500
    assert [text for text in texts if OPTION.search(text)] == []


def test_no_text_is_translated_inside_an_f_string():
    """Where it is not at the beginning, lupdate does not find it."""
    for path in (ROOT / "app").rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        inside = [
            getattr(node.func, "attr", getattr(node.func, "id", ""))
            for string in ast.walk(tree)
            if isinstance(string, ast.JoinedStr)
            for node in ast.walk(string)
            if isinstance(node, ast.Call)
        ]
        assert not {"tr", "translate"} & {*inside}, path


def test_no_message_shown_in_the_window_names_an_option():
    """Answers to a question on a log, such as stuck=no-force, are what is typed there."""
    texts = templates()
    assert len(texts) > 1000
    option = re.compile(r"(?<![\w-])--[a-z]|`hapticplayer")
    assert [text for text in texts if option.search(text)] == []


def test_templates_that_have_a_name_are_translated_too():
    source = """
def refuse(limits):
    if limits:
        text = "between {a} and {b}"
    else:
        text = "at least {a}"
    raise InputError(text, a=1, b=2)
"""
    assert set(templates_in(source)) == {"between {a} and {b}", "at least {a}"}


@pytest.mark.parametrize(
    ("template", "shown"),
    [
        ("record with sound (--sync pats)", "record with sound"),
        ("keep it (`hapticplayer play --log FILE`), or not", "keep it, or not"),
        ("choose {name} (--mounting {name})", "choose forward"),
        ("stays (as it is)", "stays (as it is)"),
    ],
)
def test_options_are_left_out_of_the_window_only(template, shown):
    problem = InputError(template, remedy=template, name="forward")
    whole = template.format(name="forward")
    assert str(problem) == f"{whole}; {whole}"
    assert translated(message_of(problem)) == f"{shown}; {shown}"
