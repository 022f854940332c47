"""What holds for every test: names that fit a line of a report."""

import ast
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
LONGEST_NAME = 60


def test_no_test_has_a_name_longer_than_60_characters():
    long = [
        f"{path.relative_to(TESTS)}: {node.name}"
        for path in sorted(TESTS.rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
        if len(node.name) > LONGEST_NAME
    ]
    assert not long
