"""Remedies that name options of another command say which."""

import argparse
import re
from collections.abc import Callable, Iterable

_QUOTED, _OPTION = re.compile(r"`[^`]*`"), re.compile(r"(?<![\w-])--[a-z][a-z-]+")


Parsers = Callable[[str], argparse.ArgumentParser]


def with_commands(
    sentence: str, command: str | None, parser_of: Parsers, others: Iterable[str]
) -> str:
    """A sentence, and the commands of those options in it that `command` lacks.

    What stands in backquotes names its command itself.
    """
    if command is None:
        return sentence
    named = dict.fromkeys(_OPTION.findall(_QUOTED.sub("", sentence)))
    own = _options_of(parser_of(command))
    foreign = [one for one in named if one not in own]
    homes: dict[str, list[str]] = {}
    for other in others if foreign else ():
        theirs = _options_of(parser_of(other))
        found = [one for one in foreign if one in theirs]
        if found:
            homes[other] = found
            foreign = [one for one in foreign if one not in found]
    return sentence + "".join(
        f" ({', '.join(options)}: see `hapticplayer {name} --help`)"
        for name, options in homes.items()
    )


def _options_of(parser: argparse.ArgumentParser) -> set[str]:
    """The options of a command and its actions."""
    parsers, found = [parser], set[str]()
    while parsers:
        for action in parsers.pop()._actions:  # noqa: SLF001 - argparse has no other way
            found.update(action.option_strings)
            if isinstance(action, argparse._SubParsersAction):  # noqa: SLF001
                parsers += action.choices.values()
    return found
