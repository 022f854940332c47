"""What holds for all tests and benchmarks, as far as their text tells."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LONG_NAME = re.compile(r"^ *def (test_\w{56,})", re.MULTILINE)
NOBODY = re.compile(r"^ *def (test_(?:it|what|that|nothing)_\w+)", re.MULTILINE)
IMPORTED = re.compile(r"^ *(?:from|import) (\w+)", re.MULTILINE)
OF_TESTS = re.compile(r"^ *(?:from|import) tests\.?(\w*)", re.MULTILINE)
PRIVATE = re.compile(r"_[^_]")
PUBLIC = {"_asdict", "_fields", "_make", "_replace"}
"""Of named tuples."""
NOT_OTHERS = {"cls", "os", "self", "sys"}
"""Whose private names are a module's own, or documented."""
MOST_PRIVATE = 30
"""Places that reach into what other modules keep to themselves; may only fall."""
RETURN_WHAT = re.compile(r'"""(?:Return|Yield) what \b')
LINK = re.compile(r"\]\((?!https?:|mailto:|#)([^)#\s]+)")


def found(folder, pattern):
    """Yield file and match of all that the Python files below a folder hold of it."""
    for path in sorted((ROOT / folder).rglob("*.py")):
        for match in pattern.findall(path.read_text(encoding="utf-8")):
            yield str(path.relative_to(ROOT)), match


def private_names(tree):
    """Yield private names of other modules: imported, patched or reached through a dot."""
    nodes = list(ast.walk(tree))
    own = PUBLIC | {
        n.name for n in nodes if isinstance(n, ast.FunctionDef | ast.ClassDef)
    }
    made = [n for n in nodes if isinstance(getattr(n, "ctx", None), ast.Store)]
    own |= {n.id for n in made if isinstance(n, ast.Name)}
    own |= {
        n.attr for n in made if isinstance(n, ast.Attribute) and owner_of(n) == "self"
    }
    for node in nodes:
        names = []
        if isinstance(node, ast.Attribute) and owner_of(node) not in NOT_OTHERS:
            names = [node.attr]
        elif isinstance(node, ast.ImportFrom):
            names = [one.name for one in node.names]
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "setattr":
            named = [one for one in node.args[:2] if isinstance(one, ast.Constant)]
            names = [str(one.value).rpartition(".")[2] for one in named]
        yield from (x for x in names if PRIVATE.match(x) and x not in own)


def owner_of(attribute):
    return getattr(attribute.value, "id", "")


def test_no_class_name_is_used_twice_in_the_engine():
    names = Counter(
        node.name
        for path in (ROOT / "hapticplayer").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ClassDef)
    )
    assert not [name for name, count in names.items() if count > 1]


def bound_names(tree):
    """Yield each name that a module gives at its top level."""
    for node in tree.body:
        for target in getattr(node, "targets", []):
            made = getattr(target, "elts", [target])
            yield from (x.id for x in made if isinstance(x, ast.Name))
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name


@pytest.mark.parametrize("folder", ["hapticplayer", "app", "benchmarks", "tools"])
def test_a_module_gives_each_name_once(folder):
    """The second constant of a name would count everywhere, and no tool says so."""
    twice = [
        f"{path}: {name}"
        for path in sorted((ROOT / folder).rglob("*.py"))
        for name, count in Counter(
            bound_names(ast.parse(path.read_text(encoding="utf-8")))
        ).items()
        if count > 1
    ]
    assert twice == []


def test_few_places_reach_into_what_others_keep_private():
    places = [
        f"{path.relative_to(ROOT)}: {name}"
        for folder in ("tests", "tools", "benchmarks")
        for path in sorted((ROOT / folder).rglob("*.py"))
        for name in private_names(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert len(places) <= MOST_PRIVATE, places


def test_no_test_has_a_name_longer_than_60_characters():
    assert not list(found("tests", LONG_NAME))


def test_a_test_name_says_what_happens_to_whom():
    assert not list(found("tests", NOBODY))


def test_tests_import_no_benchmark():
    modules = {path.stem for path in (ROOT / "benchmarks").rglob("*.py")}
    theirs = {"benchmarks", *modules - {"__init__", "conftest"}}
    assert not [(name, x) for name, x in found("tests", IMPORTED) if x in theirs]


@pytest.mark.parametrize("folder", ["benchmarks", "tools"])
def test_benchmarks_and_tools_import_no_test(folder):
    of_tests = [one for one in found(folder, OF_TESTS) if one[1] != "material"]
    assert not of_tests  # `tests.material` is made for both


@pytest.mark.parametrize(
    ("name", "most"),
    [("README.md", 100), ("docs/performance.md", 215), ("docs/numerics.md", 150)],
)
def test_documents_of_results_and_readme_stay_short(name, most):
    assert len((ROOT / name).read_text(encoding="utf-8").splitlines()) <= most


def test_every_file_that_a_document_links_to_exists():
    pages = [*ROOT.glob("*.md"), *ROOT.glob("*/*.md")]
    links = [
        (page.name, link)
        for page in pages
        for link in LINK.findall(page.read_text(encoding="utf-8"))
        if not (page.parent / link).exists()
    ]
    assert not links


@pytest.mark.parametrize("folder", ["hapticplayer", "app", "tools", "benchmarks"])
def test_docstrings_name_the_thing_that_is_returned(folder):
    assert not list(found(folder, RETURN_WHAT))


PASTED = re.compile(
    r"\bhapticplayer (?:[a-z-]+|\{\}) [^`'\";\n]*\{|\} -m \w|\b(?:sudo|pip install) [^`\n]*\{"
)
"""A command for the shell with a value in it."""


def texts(tree):
    """Yield the texts of a module, with {} for the values of f-strings."""
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts = (getattr(part, "value", "{}") for part in node.values)
            yield "".join(p if isinstance(p, str) else "{}" for p in parts)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


@pytest.mark.parametrize("folder", ["hapticplayer", "app"])
def test_commands_with_values_are_printed_by_shell_line(folder):
    assert not [
        f"{path.relative_to(ROOT)}: {text}"
        for path in sorted((ROOT / folder).rglob("*.py"))
        for text in texts(ast.parse(path.read_text(encoding="utf-8")))
        if PASTED.search(text)
    ]
