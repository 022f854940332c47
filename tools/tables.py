"""Writes the tables of documents between their markers, from the rows of registries.

    python -m tools.tables            # writes what has changed
    python -m tools.tables --check    # names what has, exit status 1

A table stands between `<!-- table: NAME -->` and `<!-- end of table -->`; a figure that a
benchmark measured between `<!-- figure: RESULT, TARGET -->` and `<!-- end -->`.
"""

import argparse
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

from app.editor.commands import EDITOR_COMMANDS
from app.player.command import Command
from app.player.commands import COMMANDS as WINDOW_COMMANDS
from hapticplayer import cli
from hapticplayer.capture import formats
from hapticplayer.capture.live import source
from hapticplayer.capture.sync import methods
from hapticplayer.devices import installed_devices
from hapticplayer.extension import load
from hapticplayer.facilities import FACILITIES
from hapticplayer.motion import METHODS
from hapticplayer.rendering import FEEDBACKS
from hapticplayer.rendering.condition import Parameter
from hapticplayer.rendering.effects import EFFECTS
from hapticplayer.sequence import force_formats as forces
from hapticplayer.sequence.events import event_detectors
from hapticplayer.sequence.presets import PRESETS
from hapticplayer.study.analysis.analysis import STATISTICS
from hapticplayer.study.questions import ANSWER_KINDS
from hapticplayer.study.scales import questions_of, read_scale, scale_names
from hapticplayer.study.study_export import study_exporters
from tools.media_tried import rows as media_tried_rows
from tools.performance_page import RESULTS, result

ROOT = Path(__file__).resolve().parents[1]
MARKED = re.compile(
    r"(?<=<!-- table: )([\w-]+)( -->\n).*?(?=<!-- end of table -->)", re.DOTALL
)
FIGURE = re.compile(r"(<!-- figure: ([\w-]+), ([^>]+) -->)[^<]*(?=<!-- end -->)")
Row = Iterable[object]


def table(head: str, rows: Iterable[Row]) -> str:
    """A table in Markdown; the head is divided by bars."""
    heads = [cell.strip() for cell in head.split("|")]
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join(f"| {' | '.join(map(_cell, line))} |\n" for line in lines)


def _cell(value: object) -> str:
    return str(value).replace("|", "\\|").replace("\n", " ")


def _code(*names: str) -> str:
    return ", ".join(f"`{name}`" for name in names)


def recording_formats() -> str:
    """Logs and cameras that are read."""
    return table(
        "format | recording | recognised by | its clock reads zero | checked against",
        (
            (_code(f.name), f.text, f.marks, f.zero, f.checked)
            for f in formats.recording_formats()
        ),
    )


def live_sources() -> str:
    """Sources of `record` and `feel`."""
    return table(
        "source | what | such as | options | its axes",
        (
            (_code(s.name), s.text, _code(f"{s.name}:{s.example}"), s.options, s.declares.axes_words)
            for s in source.live_sources()
        ),
    )  # fmt: skip


def media_tried() -> str:
    """Containers and codecs, as they play."""
    return table("container | files | video | sound", media_tried_rows())


def sync_methods() -> str:
    """Ways to synchronise a log with a clip."""
    return table(
        "method | goes by",
        ((_code(one.name), one.text) for one in methods.sync_methods()),
    )


def facilities() -> str:
    rows = ((f"`{name}`", one.gives, one.without) for name, one in FACILITIES.items())
    return table("facility | with it | without", rows)


def gravity_methods() -> str:
    """Ways to remove gravity."""
    return table(
        "method | what", ((_code(one.name), one.text) for one in METHODS.values())
    )


def conditions() -> str:
    """Feedback conditions with what can be chosen of each."""
    return table(
        "condition | force | parameters",
        (
            (_code(one.name), one.meaning, "; ".join(map(_choice, one.parameters)))
            for one in FEEDBACKS
        ),
    )


def _choice(one: Parameter) -> str:
    if one.choices:
        return f"`{one.name}`: {_code(*one.choices)}"
    if one.range is None:
        return f"`{one.name}`: {one.text.lower()}"
    span = f"{one.range.least:g} to {one.range.largest:g} {one.range.unit}".strip()
    return f"`{one.name}` {one.default:g} ({span})"


def effects() -> str:
    """Kinds of effects."""
    return table(
        "kind | parameters: usual value (range) | control points stand for",
        (
            (
                _code(one.name),
                "; ".join(map(_choice, one.parameters)),
                one.curve and _code(one.curve),
            )
            for one in EFFECTS
        ),
    )


def events() -> str:
    rows = ((_code(one.name), one.text) for one in event_detectors().values())
    return table("kind | found where", rows)


def presets() -> str:
    return table("preset | what it does", ((_code(p.name), p.text) for p in PRESETS))


def statistics() -> str:
    """Statistics of a study."""
    return table(
        "statistic | what | references",
        (
            (_code(one.name), one.title, "; ".join(map(_short, one.references)))
            for one in STATISTICS.values()
        ),
    )


def _short(reference: str) -> str:
    """Authors and year."""
    return reference[: reference.find(")") + 1] or reference


def question_kinds() -> str:
    """Kinds of questions of a study."""
    return table(
        "kind | answer | entries",
        (
            (_code(kind.value), str(row.name).lower(), _code(*row.uses))
            for kind, row in ANSWER_KINDS.items()
        ),
    )


def scales() -> str:
    """Published scales."""
    found = {name: read_scale(name) for name in scale_names()}
    return table(
        "scale | what | items | scores | wording",
        (
            (
                _code(name),
                one.name,
                str(len(questions_of(one))),
                _code(*(score["key"] for score in one.scores)) or "the answer",
                ", ".join(one.wordings) or "bring yours",
            )
            for name, one in found.items()
        ),
    )


def study_exports() -> str:
    """Formats of `study export`."""
    return table(
        "format | what",
        ((_code(one.name), one.text) for one in study_exporters().values()),
    )


def force_formats() -> str:
    """Formats of force."""
    return table(
        "format | what | keeps | export | import",
        (
            (
                _code(one.name, one.suffix, *one.other_suffixes),
                one.text,
                one.keeps,
                "yes" if one.write else "no",
                "yes" if one.read else "no",
            )
            for one in forces.force_formats().values()
        ),
    )


def devices() -> str:
    """Devices that can be chosen."""
    found = installed_devices().values()
    return table(
        "device | what | axes | peak force | rate | latency, assumed",
        (
            (
                _code(one.name),
                one.title,
                one.capabilities.axes or "none",
                f"{one.capabilities.peak_force_n:g} N"
                if one.capabilities.has_newtons and one.capabilities.axes
                else "no newtons",
                f"{one.capabilities.rate_hz:g} Hz",
                f"{1000 * one.capabilities.latency_s:g} ms",
            )
            for one in found
        ),
    )


def rig_signs() -> str:
    """Which way the numbers of packets for rigs are positive."""
    rows: list[Row] = []
    if "rig" in installed_devices():
        for kind in load("hapticplayer.extras.rigs.packets:FORMATS").values():
            for source, signs in groupby(kind.signs, lambda one: one.source):
                said = ", ".join(f"{one.field} {one.positive}" for one in signs)
                rows.append((_code(kind.name), said, source))
    return table("format | positive | source", rows)


def window_commands() -> str:
    """Commands of the window with their first keys."""
    return table(
        "menu | command | keys",
        ((one.menu.capitalize(), *_words_and_keys(one)) for one in WINDOW_COMMANDS),
    )


def editor_commands() -> str:
    return table("on the timeline | keys", map(_words_and_keys, EDITOR_COMMANDS))


def _words_and_keys(one: Command[Any]) -> tuple[str, str]:
    return one.plain_title, " ".join(_code(key) for key in one.keys)


def command_line() -> str:
    return "\n".join(_command(one) for one in cli.commands()) + "\n"


def _command(command: cli.Command) -> str:
    parser = cli.build_parser(command.name)
    made = dict(_subcommands(parser))[command.name]
    head = f"### `{command.name}`: {command.summary}\n\n"
    return head + "".join(_options(made, command.name))


def _actions(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    return [action for action in parser._actions if action.dest != "help"]


def _subcommands(
    parser: argparse.ArgumentParser,
) -> Iterator[tuple[str, argparse.ArgumentParser]]:
    for action in _actions(parser):
        choices = action.choices if isinstance(action.choices, dict) else {}
        for name, made in choices.items():
            if isinstance(made, argparse.ArgumentParser):
                yield name, made


def _options(parser: argparse.ArgumentParser, name: str) -> Iterator[str]:
    subcommands = dict(_subcommands(parser))
    for action in _actions(parser):
        if subcommands and action.choices and set(action.choices) == set(subcommands):
            continue
        text = (action.help or "").replace("%%", "%").replace("|", "\\|")
        words = [*action.option_strings] or [_argument(action)]
        value = _argument(action) if action.option_strings else ""
        shown = ", ".join(f"`{f'{word} {value}'.strip()}`" for word in words)
        yield f"- {shown}{': ' if text else ''}{text}\n"
    for word, made in subcommands.items():
        yield f"\n**`{name} {word}`**\n\n"
        yield from _options(made, f"{name} {word}")


def _argument(action: argparse.Action) -> str:
    if action.nargs == 0:
        return ""
    if action.metavar is not None:
        return str(action.metavar)
    if action.choices:
        return "|".join(map(str, action.choices))
    return action.dest.upper()


def figure(name: str, what: str) -> str:
    """What a benchmark measured, by its result and the first words of its target."""
    targets = result(RESULTS / f"{name}.json")["targets"]
    (value,) = (one["measured"] for one in targets if one["what"].startswith(what))
    return rounded(value) if isinstance(value, float) else str(value)


def rounded(value: float) -> str:
    """Two digits that count."""
    return f"{float(f'{value:.2g}'):g}"


def format_costs() -> str:
    """Size, error and time of each format of force."""
    costs = result(RESULTS / "formats.json")["costs"]

    def cell(value: float | None, unit: float = 1.0) -> str:
        return "" if value is None else rounded(unit * value)

    rows = []
    for name in next(iter(costs.values())):
        each = [of[name] for of in costs.values()]
        sizes = [
            f"{rounded(of['kbit_s'])} ({rounded(of['kbit_s_compressed'])})"
            for of in each
        ]
        errors = [of["error_max_n"] for of in each if of["error_max_n"] is not None]
        first = each[0]
        times = (cell(first[f"{way}_s_min"], 1000.0) for way in ("write", "read"))
        largest = cell(max(errors)) if errors else ""
        rows.append([f"`{name}`", *sizes, largest, *times])
    head = ["format", *costs, "error, N", "write, ms", "read, ms"]
    return table(" | ".join(head), rows)


TABLES: dict[str, Callable[[], str]] = {
    one.__name__.replace("_", "-"): one
    for one in (
        recording_formats,
        live_sources,
        media_tried,
        sync_methods,
        facilities,
        gravity_methods,
        conditions,
        effects,
        events,
        presets,
        statistics,
        question_kinds,
        scales,
        study_exports,
        force_formats,
        format_costs,
        devices,
        rig_signs,
        window_commands,
        editor_commands,
        command_line,
    )
}


def filled(text: str) -> str:
    """A document with its tables made anew."""
    text = MARKED.sub(lambda found: f"{found[1]}{found[2]}{TABLES[found[1]]()}", text)
    return FIGURE.sub(lambda found: f"{found[1]}{figure(found[2], found[3])}", text)


def changed_documents() -> dict[Path, str]:
    """The documents whose tables are not current, with the text they should have."""
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    texts = {page: page.read_text(encoding="utf-8") for page in pages}
    made = {page: filled(text) for page, text in texts.items()}
    return {page: text for page, text in made.items() if text != texts[page]}


def main() -> int:
    """Write or check the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    is_check = parser.parse_args().check
    changed = changed_documents()
    for page, text in changed.items():
        print(page.relative_to(ROOT))
        if not is_check:
            page.write_text(text, encoding="utf-8")
    return 1 if is_check and changed else 0


if __name__ == "__main__":
    sys.exit(main())
