"""The actions `study scales` and `study add-scale`."""

import argparse
import json
import textwrap
from pathlib import Path
from typing import Any

from hapticplayer.cli.common import say, say_aside
from hapticplayer.structures import convert
from hapticplayer.study.creation import add_scale
from hapticplayer.study.definition import Score, When
from hapticplayer.study.definition_reader import to_be_worded
from hapticplayer.study.scales import questions_of, read_scale, scale_names
from hapticplayer.study.scoring import formula_of
from hapticplayer.study.study_folder import open_study

_WIDTH = 88


def add_actions(actions: Any) -> None:
    """Add the actions to the sub-parsers of `study`."""
    summary = "published scales: items, scores, source, licence"
    listing = actions.add_parser("scales", help=summary, description=summary)
    listing.add_argument(
        "name", nargs="?", metavar="SCALE", help="one of them, in full"
    )
    listing.add_argument("--json", action="store_true", help="print a report as JSON")
    listing.set_defaults(run=lambda chosen, _open_window: scales(chosen))
    summary = "add a page that asks a scale"
    adding = actions.add_parser("add-scale", help=summary, description=summary)
    adding.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    adding.add_argument("scale", metavar="SCALE", help=", ".join(scale_names()))
    adding.add_argument(
        "--when",
        required=True,
        choices=[one.value for one in When],
        help="before the first clip, before or after each one, or after the last",
    )
    adding.add_argument(
        "--key",
        help="name of the page, and the beginning of its columns (default: the scale's)",
    )
    adding.set_defaults(run=lambda chosen, _open_window: add(chosen))


def described(name: str) -> dict[str, Any]:
    """A scale as JSON."""
    scale = read_scale(name)
    scores = [convert(dict(one), Score, name) for one in scale.scores]
    return {
        "scale": name,
        "name": scale.name,
        "items": len(questions_of(scale)),
        "scores": {one.key: formula_of(one) for one in scores},
        "wordings": dict(scale.wordings),
        "licence": scale.licence,
        "source": scale.source,
        "note": scale.note,
    }


def scales(options: argparse.Namespace) -> int:
    """List the scales, or describe one."""
    names = [options.name] if options.name else scale_names()
    found = [described(name) for name in names]
    if options.json:
        say(json.dumps(found[0] if options.name else found))
    elif options.name:
        say("\n".join(_in_full(found[0])))
    else:
        for one in found:
            languages = ", ".join(one["wordings"]) or "bring your wording"
            count = f"{one['items']} item" + "s" * (one["items"] > 1)
            say(f"{one['scale']:<12}{one['name']}: {count}; {languages}")
    return 0


def _in_full(one: dict[str, Any]) -> list[str]:
    lines = [f"{one['name']}: {one['items']} items"]
    lines += [f"  {key:<12}{text}" for key, text in one["scores"].items()]
    lines += [f"wording {language}: {of}" for language, of in one["wordings"].items()]
    lines += [f"licence: {one['licence']}", f"source: {one['source']}", one["note"]]
    indent = " " * 14
    filled = [textwrap.fill(line, _WIDTH, subsequent_indent=indent) for line in lines]
    return [line for line in filled if line]


def add(options: argparse.Namespace) -> int:
    """Add a page that asks a scale."""
    key = options.key or options.scale
    study = open_study(options.study)
    study = add_scale(study, options.scale, key, When(options.when))
    page = study.definition.pages[-1]
    say(f"{options.study}: page {key!r} with {len(page.questions)} questions")
    if count := len(list(to_be_worded(study.definition))):
        say_aside(
            f"{count} texts are to be written in study.json, in place of \u2039 \u203a"
        )
    return 0
