"""Documents: their tables are current, and no block or cell is too long to read."""

import itertools
import re
import subprocess
from pathlib import Path

import pytest

from tools import numerics_page, performance_page, tables

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
MOST_OF_A_BLOCK, MOST_OF_A_CELL = 800, 300
"""Characters."""
FENCED = re.compile(r"^( *)```.*?^\1```", re.DOTALL | re.MULTILINE)
TABLE_LINE = re.compile(r"^(?:\||<!--).*$", re.MULTILINE)
ITEM = re.compile(r"^ *(?:[-*]|\d+\.) ", re.MULTILINE)
CELL_END = re.compile(r"(?<!\\)\|")
TYPED = re.compile(r"\b\d+\.\d+ ?(?:us|ms|s|mN|N|MB|kbit/s|%|times)\b")
"""As measured figures look: the conditions of a benchmark are whole numbers."""
FIGURE = re.compile(
    r"(?<![\w.,])\d+(?:[.,]\d+)? ?(?:us|µs|ms|s|mN|N|[kMG]B|kbit/s|%|times)(?!\w)"
)
MEASURED = re.compile(
    r"\b(?:median|measured|p9\d|on average|faster|slower|of a core|better than)\b",
    re.IGNORECASE,
)
WRITTEN = (performance_page.PAGE, numerics_page.PAGE)
"""Whole pages that a tool writes from results."""


def git(*words):
    done = subprocess.run(
        ["git", *words], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout.strip()


def prose(page):
    """Paragraphs and items of lists, without code and tables."""
    text = FENCED.sub("", page.read_text(encoding="utf-8"))
    text = TABLE_LINE.sub("", text)
    for block in re.split(r"\n\s*\n", text):
        starts = [0, *(match.start() for match in ITEM.finditer(block)), len(block)]
        yield from (block[a:b] for a, b in itertools.pairwise(starts))


def test_tables_of_documents_are_current():
    changed = [page.name for page in tables.changed_documents()]
    assert not changed, "run: python -m tools.tables"


@pytest.mark.parametrize("tool", [performance_page, numerics_page])
def test_pages_of_results_are_current(tool):
    page = tool.PAGE.read_text(encoding="utf-8")
    assert page == tool.page(), f"run: python -m {tool.__name__}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_figure_of_a_benchmark_is_not_typed(page):
    if page in WRITTEN:
        return
    text = tables.FIGURE.sub(
        "", tables.MARKED.sub("", page.read_text(encoding="utf-8"))
    )
    blocks = re.split(r"\n\s*\n", text)
    measured = [one for one in blocks if "benchmarks." in one and "```" not in one]
    assert not [found for one in measured for found in TYPED.findall(one)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_sentence_on_a_measurement_has_no_typed_figure(page):
    if page in WRITTEN or page.name == "CHANGELOG.md":  # which tells what was
        return
    sentences = itertools.chain.from_iterable(
        re.split(
            r"(?<=[.:;])\s+", tables.FIGURE.sub("written", tables.MARKED.sub("", one))
        )
        for one in prose(page)
    )
    assert not [
        one
        for one in sentences
        if FIGURE.search(one) and MEASURED.search(one) and "written" not in one
    ]


@pytest.mark.parametrize("tool", [performance_page, numerics_page])
def test_prose_of_pages_of_results_has_no_figure(tool):
    assert not TYPED.findall(tool.TEXT)


def test_commands_of_results_name_no_path():
    commands = [one["command"] for one in performance_page.all_results().values()]
    assert commands
    assert not [one for one in commands if "/" in one]


def test_results_are_of_commits_that_can_be_checked_out():
    if git("rev-parse", "--is-shallow-repository") != (0, "false"):
        pytest.skip("the history is not here")
    commits = {n: one["commit"] for n, one in performance_page.all_results().items()}
    assert not [
        name
        for name, commit in commits.items()
        if not commit or git("merge-base", "--is-ancestor", commit, "HEAD")[0]
    ]


def test_every_table_stands_in_a_document():
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    assert not [name for name in tables.TABLES if f"<!-- table: {name} -->" not in text]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_reader_meets_no_block_of_more_than_800_characters(page):
    assert not [block for block in prose(page) if len(block) > MOST_OF_A_BLOCK]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_reader_meets_no_cell_of_more_than_300_characters(page):
    lines = page.read_text(encoding="utf-8").splitlines()
    cells = [cell for x in lines if x.startswith("|") for cell in CELL_END.split(x)]
    assert not [cell for cell in cells if len(cell) > MOST_OF_A_CELL]
