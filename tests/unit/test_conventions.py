"""What holds for all tests and benchmarks, as far as their text tells."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LONG_NAME = re.compile(r"^ *def (test_\w{56,})", re.MULTILINE)
IMPORTED = re.compile(r"^ *(?:from|import) (\w+)", re.MULTILINE)
LINK = re.compile(r"\]\((?!https?:|mailto:|#)([^)#\s]+)")


def found(folder, pattern):
    """Yield file and match of all that the Python files below a folder hold of it."""
    for path in sorted((ROOT / folder).rglob("*.py")):
        for match in pattern.findall(path.read_text(encoding="utf-8")):
            yield str(path.relative_to(ROOT)), match


def test_no_class_name_is_used_twice_in_the_engine():
    names = Counter(
        node.name
        for path in (ROOT / "hapticplayer").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ClassDef)
    )
    assert not [name for name, count in names.items() if count > 1]


def test_no_test_has_a_name_longer_than_60_characters():
    assert not list(found("tests", LONG_NAME))


def test_tests_import_no_benchmark():
    modules = {path.stem for path in (ROOT / "benchmarks").rglob("*.py")}
    theirs = {"benchmarks", *modules - {"__init__", "conftest"}}
    assert not [(name, x) for name, x in found("tests", IMPORTED) if x in theirs]


@pytest.mark.parametrize("folder", ["benchmarks", "tools"])
def test_benchmarks_and_tools_import_no_test(folder):
    assert not [name for name, x in found(folder, IMPORTED) if x == "tests"]


@pytest.mark.parametrize(
    ("name", "most"),
    [("README.md", 100), ("docs/performance.md", 150), ("docs/numerics.md", 150)],
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
