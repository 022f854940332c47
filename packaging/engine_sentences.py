# ruff: noqa: INP001 - a script, no package
"""Collect the sentences that the engine says and the window shows.

The engine speaks English, on the command line, in logs and between processes; the window
translates what it is given (`app/bridge/engine_words.py`). This script reads by AST what
there is to translate, for `packaging/translate.sh`:

    python packaging/engine_sentences.py NOOP

It writes the templates to resources/i18n/engine.json, and to the file NOOP a source that
lupdate reads, so that the .ts files hold them in the context `engine`.
"""

import ast
import errno
import json
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ENGINE, LIST = ROOT / "hapticplayer", ROOT / "resources/i18n/engine.json"

SILENT = (  # speak to a terminal, to a file, or to nobody
    "cli/",
    "console/",
    "doctor.py",
    "simulation/film/",
    "simulation/rides/",
    "devices/falcon/measuring.py",
    "simulation/usb/",
    "simulation/falcon/options.py",
    "haptics/__main__.py",
    "simulation/faults/loop.py",
    "haptics/record_reader.py",
    "haptics/watched.py",
    "playback/sync_alarm.py",
    "interchange/bids.py",
    "interchange/session_data.py",
    "interchange/study_",
    "interchange/xdf.py",
    "motion/ekf/",
    "motion/conditioning/clipping.py",
    "motion/conditioning/rails.py",
    "motion/conditioning/spike",
    "motion/methods.py",
    "motion/smoother/parameters.py",
    "motion/stillness.py",
    "simulation/recordings.py",
    "simulation/effects.py",
    "study/analysis/power.py",
    "simulation/participants.py",
    "study/merging.py",
    "simulation/sessions.py",
)
ERRORS_ONLY = (  # their other texts are a document, or the window has its own for them
    "study/analysis/",
    "study/page_maker.py",
    "study/preflight.py",
    "haptics/contract.py",
    "haptics/recorder.py",
    "haptics/records.py",
    "rendering/demonstration.py",
    "simulation/demo.py",
    "devices/__init__.py",
    "devices/falcon/firmware/store.py",
    "devices/falcon/homing.py",
    "devices/falcon/setting_up.py",
)
NOT_FOR_PEOPLE = {  # calls whose texts are patterns, options, events or steps of work
    "add_argument",
    "ArgumentParser",
    "compile",
    "progress",
    "report",
    "_event",
    "_keep",
    "mark",
    "_mark",
    "exception",
}
NOT_SHOWN = {  # names in files
    "Gyroscope rate",
    "Magnetic field",
    "Time (s)",
    "consent refused",
    "force csv",
    "hapticplayer {0}",
    "slow sensor",
}
DEFECTS = {"AttributeError", "IndexError", "NotImplementedError", "RuntimeError"}
WHY = {"TypeError", "ValueError"}  # a reason that a sentence for people quotes
WITH_WHY = ("capture/", "devices/falcon/firmware/", "sequence/", "study/tree.py")
WORDS = (  # that stand for themselves, as values
    "participant",
    "sequence",
    "feedback",
    "factor",
    "name",
    "file",
    "folder",
    "number",
    "repeats",
    "semicolons",
    "simulated camera",
    "tabs",
    "opened",
    "closed",
    "accel",
    "gyro",
    "relaxed",
    "normal",
    "firm",
    "ended",
    "complete",
    "stopped",
    "ready",
    "failed",
    "{0}: {1}",
    "{0}; {1}",
)
FROM_SYSTEM = (
    errno.ENOENT,
    errno.EACCES,
    errno.EPERM,
    errno.ENOSPC,
    errno.EROFS,
    errno.EIO,
    errno.EISDIR,
    errno.ENOTDIR,
    errno.EEXIST,
    errno.EBUSY,
    errno.EFBIG,
    errno.EDQUOT,
    errno.EMFILE,
    errno.ENAMETOOLONG,
    errno.ENOMEM,
    errno.ENODEV,
    errno.ETIMEDOUT,
    errno.ELOOP,
    errno.EINVAL,
    errno.EPIPE,
)
_WORD = re.compile(r"[A-Za-z]*[a-z]{2,}")
_SENTENCE = re.compile(r"[a-z]{2,}[,;:]? [a-z(\-]|[ ][a-z]{3,}")
_LINK = re.compile(r",? [a-z]{2,} ([a-z]+ )?")
_ROW = re.compile(r"\b(row|rows from) (?=\{)")


class Sentences(ast.NodeVisitor):
    """The templates of one module.

    Args:
        errors_only: whether only what an error is given counts.
        has_why: whether its errors of Python are quoted for people.
    """

    def __init__(self, *, errors_only: bool, has_why: bool) -> None:
        self.found: list[str] = []
        self._has_why = has_why
        self._errors_only = errors_only
        self._in_error = False

    def visit_Expr(self, node: ast.Expr) -> None:
        """Leave docstrings out."""
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        """Leave names of kinds out."""
        if not any(_called(base).endswith("Enum") for base in node.bases):
            self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        """Leave out what is only looked for."""

    def visit_Subscript(self, node: ast.Subscript) -> None:
        """Leave keys out."""
        self.visit(node.value)

    def visit_Constant(self, node: ast.Constant) -> None:
        """Take a plain text."""
        if isinstance(node.value, str):
            self._take(node.value)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Take a text with values in it, and what is said within the values."""
        self._take(_template(node))
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                self.visit(part.value)

    def visit_Call(self, node: ast.Call) -> None:
        """Look into errors and all other calls that may hold sentences."""
        name = _called(node.func)
        is_defect = name in DEFECTS or (name in WHY and not self._has_why)
        if name in NOT_FOR_PEOPLE or is_defect:
            return
        is_list = name == "join" and isinstance(node.func, ast.Attribute)
        if is_list:
            self._take_list(node.func.value)
        before, self._in_error = self._in_error, name.endswith("Error")
        for argument in node.args:
            self.visit(argument)
        for keyword in node.keywords:
            is_path = keyword.arg == "where" and isinstance(keyword.value, ast.Call)
            if not is_path:
                self.visit(keyword.value)
        self._in_error = before
        if isinstance(node.func, ast.Attribute) and not is_list:
            self.visit(node.func.value)

    def _take_list(self, separator: ast.expr) -> None:
        if isinstance(separator, ast.Constant):
            link = separator.value
            if isinstance(link, str) and _LINK.fullmatch(link):
                self.found.append(f"{{0}}{link}{{1}}")

    def _take(self, text: str) -> None:
        is_said = bool(_WORD.search(re.sub(r"\{\d+\}", "", text)))
        if not self._in_error:
            plain = re.sub(r"\{\d+\}", "ab", text)
            is_said &= not self._errors_only and bool(_SENTENCE.search(plain))
        if is_said and "\n" not in text and "://" not in text:
            self.found.append(_whole(text))


def _called(function: ast.expr) -> str:
    if isinstance(function, ast.Name):
        return function.id
    return function.attr if isinstance(function, ast.Attribute) else ""


def _template(node: ast.JoinedStr) -> str:
    parts, count = [], 0
    for part in node.values:
        if isinstance(part, ast.Constant):
            parts.append(str(part.value))
        else:
            parts.append(f"{{{count}}}")
            count += 1
    return "".join(parts)


def _whole(text: str) -> str:
    """Return a text that is put behind another one with a place for that one."""
    if text[0] not in " ,;":
        return text.rstrip()
    for number in reversed(range(text.count("{"))):
        text = text.replace(f"{{{number}}}", f"{{{number + 1}}}")
    return f"{{0}}{text.rstrip()}"


def _of_module(path: Path) -> Iterator[str]:
    place = path.relative_to(ENGINE).as_posix()
    if place.startswith(SILENT):
        return
    reader = Sentences(
        errors_only=place.startswith(ERRORS_ONLY), has_why=place.startswith(WITH_WHY)
    )
    reader.visit(ast.parse(path.read_text(encoding="utf-8")))
    for text in reader.found:
        yield text
        # the reader of a CSV names the line of the file in place of the row
        if _ROW.search(text):
            yield _ROW.sub(lambda found: found[0].replace("row", "line"), text)


def sentences() -> list[str]:
    """Return all templates, in the order of the alphabet."""
    found = {text for path in ENGINE.rglob("*.py") for text in _of_module(path)}
    for path in (ROOT / "app").rglob("*.py"):
        reader = Sentences(errors_only=True, has_why=False)
        reader.visit(ast.parse(path.read_text(encoding="utf-8")))
        found.update(reader.found)
    found.update(WORDS, map(os.strerror, FROM_SYSTEM))
    return sorted(found - NOT_SHOWN)


def main(noop: str) -> None:
    """Write the list, and the source for lupdate."""
    templates = sentences()
    listed = json.dumps(templates, ensure_ascii=False, indent=0)
    LIST.write_text(listed + "\n", encoding="utf-8")
    lines = [f'translate("engine", {json.dumps(text)})' for text in templates]
    Path(noop).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
