"""The man page, made from the help of each command."""

import argparse
from collections.abc import Iterator
from functools import partial
from typing import Any

from hapticplayer import __version__, cli

_WIDTH = 78


def man_page() -> str:
    """The page in roff; the same on every machine."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    whole = cli.build_parser(None)
    yield f'.TH HAPTICPLAYER 1 "" "hapticplayer {__version__}" "User Commands"'
    yield from (".SH NAME", r"hapticplayer \- play a video and feel its motion")
    yield from (".SH DESCRIPTION", _escaped(whole.description or ""))
    yield from _help(whole, "SYNOPSIS")
    yield from (".SH EXIT STATUS", "0 done, 1 refused or failed, 2 wrong usage or a")
    yield "decision is needed, 128 + n ended by signal n."
    for command in cli.commands():
        parser = dict(_subparsers(cli.build_parser(command.name)))[command.name]
        yield from _command(f"hapticplayer {command.name}", parser)


def _command(name: str, parser: argparse.ArgumentParser) -> Iterator[str]:
    yield from _help(parser, name)
    for word, part in _subparsers(parser):
        yield from _command(f"{name} {word}", part)


def _help(parser: argparse.ArgumentParser, heading: str) -> Iterator[str]:
    formatter: Any = parser.formatter_class
    parser.formatter_class = partial(formatter, width=_WIDTH)
    yield from (f'.SH "{heading}"', ".nf")
    yield from map(_escaped, parser.format_help().rstrip().splitlines())
    yield ".fi"


def _escaped(text: str) -> str:
    """Lines that begin with a dot or a quote would be taken for requests."""
    plain = text.replace("\\", r"\e").replace("-", r"\-")
    return rf"\&{plain}" if plain[:1] in (".", "'") else plain


def _subparsers(
    parser: argparse.ArgumentParser,
) -> Iterator[tuple[str, argparse.ArgumentParser]]:
    for action in parser._actions:  # noqa: SLF001 - argparse tells them no other way
        if isinstance(action.choices, dict):
            yield from (
                (name, part)
                for name, part in action.choices.items()
                if isinstance(part, argparse.ArgumentParser)
            )
