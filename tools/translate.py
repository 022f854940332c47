"""Bring resources/i18n up to date with the texts of the program.

    .venv/bin/python tools/translate.py

Reads `app/` with Qt's lupdate, and by AST the templates that the engine's messages and
errors are given. New texts are added to the .ts files, to be translated there (with
Linguist or an editor), old ones are dropped; the .qm files that the program loads are
made, and what has no translation yet is listed: it is shown in English.
"""

import ast
import errno
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

from app.bridge.languages import without_options
from app.editor.commands import EDITOR_COMMANDS
from app.player.command import CONTEXT as COMMANDS_CONTEXT
from app.player.commands import COMMANDS
from hapticplayer.doctor import RUN_GROUPS, read_apt_list

ROOT = Path(__file__).resolve().parents[1]
LANGUAGES = ("de", "fr")
CONTEXT = "engine"
ONLY_ON_A_TERMINAL = ("cli/",)
VALUES = (  # that become messages, or parts of them, only when the program runs
    *("relaxed", "normal", "firm", "simulated camera"),
    *("fifo", "slice", "starting", "gone"),
    *("complete", "ended", "failed", "ready", "stopped"),
    *("ok", "MISSING", "without"),
)
FROM_SYSTEM = (
    *("ENOENT", "EACCES", "EPERM", "ENOSPC", "EROFS", "EIO", "EISDIR", "ENOTDIR"),
    *("EEXIST", "EBUSY", "EFBIG", "EDQUOT", "EMFILE", "ENAMETOOLONG", "ENOMEM"),
    *("ENODEV", "ETIMEDOUT", "ELOOP", "EINVAL", "EPIPE"),
)


def main() -> int:
    """Update all languages."""
    bin_folder = Path(sys.executable).parent
    sources = sorted(str(path) for path in (ROOT / "app").rglob("*.py"))
    with tempfile.TemporaryDirectory() as folder:
        of_engine = Path(folder, "engine.py")
        found = [(CONTEXT, text) for text in templates()]
        found += [(COMMANDS_CONTEXT, one.text) for one in (*COMMANDS, *EDITOR_COMMANDS)]
        of_engine.write_text(
            "".join(f"translate({c!r}, {json.dumps(text)})\n" for c, text in found),
            encoding="utf-8",
        )
        for code in LANGUAGES:
            ts = ROOT / "resources" / "i18n" / f"{code}.ts"
            update = ("-no-obsolete", "-locations", "none", "-source-language", "en")
            _run(
                bin_folder / "pyside6-lupdate",
                *(*update, "-target-language", code),
                *(*sources, str(of_engine), "-ts", str(ts)),
            )
            _keep_signs_with_words(ts)
            _run(
                bin_folder / "pyside6-lrelease",
                *("-silent", str(ts), "-qm", str(ts.with_suffix(".qm"))),
            )
            for context, text in untranslated(ts):
                print(f"{code}: no translation ({context}): {text}")
    return 0


def templates() -> list[str]:
    """The sentences that the engine may show in a window, in alphabetical order."""
    found = {*VALUES, *(os.strerror(getattr(errno, name)) for name in FROM_SYSTEM)}
    for path in (ROOT / "hapticplayer").rglob("*.py"):
        place = path.relative_to(ROOT / "hapticplayer").as_posix()
        if not place.startswith(ONLY_ON_A_TERMINAL):
            templates = templates_in(path.read_text(encoding="utf-8"))
            found.update(map(without_options, templates))
    for path in (ROOT / "app").rglob("*.py"):
        found.update(templates_in(path.read_text(encoding="utf-8")))
    found.update(one.purpose for one in read_apt_list() if one.group in RUN_GROUPS)
    return sorted(found - {""})  # a notice that says nothing yet


def templates_in(source: str) -> Iterator[str]:
    """Yield the templates of the messages and errors in a module.

    They are literals, or names that have one in the function or module.
    """
    tree = ast.parse(source)
    named: dict[str, list[ast.expr]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            named.setdefault(node.targets[0].id, []).append(node.value)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _is_message(node.func):
            given = [*node.args[:1]]
            given += [k.value for k in node.keywords if k.arg == "remedy"]
            for one in given:
                known = named.get(one.id, []) if isinstance(one, ast.Name) else [one]
                yield from _literals(*known)


def untranslated(ts: Path) -> list[tuple[str, str]]:
    """Return context and text of what a language still lacks."""
    return [
        (context.findtext("name") or "", message.findtext("source") or "")
        for context in ET.parse(ts).iter("context")  # noqa: S314 - our own file
        for message in context.iter("message")
        if not message.findtext("translation")
    ]


def _keep_signs_with_words(ts: Path) -> None:
    """Give French signs the space before them that does not break."""
    if ts.stem == "fr":
        text = ts.read_text(encoding="utf-8")
        text = re.sub(r" (?=[;:!?\u00bb])(?=[^<]*</translation>)", "&#xa0;", text)
        text = re.sub(r"\u00ab (?=[^<]*</translation>)", "\u00ab&#xa0;", text)
        ts.write_text(text, encoding="utf-8")


def _is_message(function: ast.expr) -> bool:
    name = getattr(function, "id", getattr(function, "attr", ""))
    return name == "Message" or (name.endswith("Error") and name[:-5] not in _PYTHONS)


_PYTHONS = {"Value", "Type", "Index", "Key", "Attribute", "OS", "Runtime", "Lookup"}


def _literals(*nodes: ast.expr) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value
        elif isinstance(node, ast.IfExp):
            yield from _literals(node.body, node.orelse)


def _run(*command: str | Path) -> None:
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    sys.exit(main())
