"""The command `study` and its actions; needs nothing but the standard library.

`register` lets other modules add actions of their own to the same command.
"""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

from hapticplayer.cli import options
from hapticplayer.cli.commands import OpenWindow

Action = Callable[[argparse.Namespace, OpenWindow | None], int]
Register = Callable[[Any], None]


def add_study(commands: Any, *register: Register) -> None:
    """Add the command `study`.

    Args:
        commands: sub-parsers of the program.
        register: each is handed the sub-parsers of `study` and adds actions.
    """
    command = commands.add_parser("study", help="run an experiment and keep its data")
    command.set_defaults(run=lambda *_: _usage(command))
    actions = command.add_subparsers(title="actions", metavar="ACTION")
    _add_new(actions)
    _add_run(actions)
    _add_status(actions)
    _add_review(actions)
    _add_export(actions)
    _add_merge(actions)
    _add_drop(actions)
    _add_delete(actions)
    for add in register:
        add(actions)


def add_action(actions: Any, name: str, summary: str, run: Action) -> Any:
    """Add an action whose first argument is the study's folder, and return it."""
    action = actions.add_parser(name, help=summary, description=summary)
    action.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    action.set_defaults(run=run)
    return action


def _add_new(actions: Any) -> None:
    new = add_action(actions, "new", "make a study of a template", _console("new"))
    new.add_argument("--template", default="qoe2012", metavar="T")
    new.add_argument(
        "--sequence",
        action="append",
        default=[],
        metavar="KEY=FOLDER",
        help="where a sequence of the study lies; may be given for each",
    )
    _add_json(new)


def _add_run(actions: Any) -> None:
    run = add_action(actions, "run", "run a participant in the window", _run)
    run.add_argument("--language", metavar="L", help="of the participant's pages")
    run.add_argument("--resume", metavar="CODE", help="go on with a session")
    options.add_device_name(run)
    run.add_argument(
        "--windowed",
        action="store_true",
        help="participant's pages in a window, for trying a study out",
    )
    run.add_argument(
        "--lsl",
        action="store_true",
        help="offer markers and force as LSL streams to programs on this machine",
    )


def _add_status(actions: Any) -> None:
    _add_json(
        add_action(
            actions,
            "status",
            "who took part, what is missing, how balanced it is",
            _console("status"),
        )
    )


def _add_review(actions: Any) -> None:
    review = add_action(
        actions,
        "review",
        "read answers in words before they are exported",
        _console("review"),
    )
    review.add_argument(
        "--pass",
        dest="passed",
        action="append",
        default=[],
        metavar="CODE[:QUESTION]",
        help="let these be exported: they name nobody",
    )
    _add_json(review)


def _add_export(actions: Any) -> None:
    export = add_action(
        actions, "export", "write the data for other programs", _console("export")
    )
    export.add_argument("-o", "--output", required=True, metavar="DIR", type=Path)
    export.add_argument(
        "--format",
        default="csv",
        choices=("csv", "bids", "xdf"),
        help="tidy CSV with a data dictionary, BIDS, or XDF (default: csv)",
    )
    _add_json(export)


def _add_merge(actions: Any) -> None:
    merge = add_action(
        actions, "merge", "add the sessions of another machine", _console("merge")
    )
    merge.add_argument("other", metavar="OTHER", type=Path, help="copy of the study")
    _add_json(merge)


def _add_drop(actions: Any) -> None:
    drop = add_action(
        actions, "drop", "end a session that will not go on", _console("drop")
    )
    drop.add_argument("code", metavar="CODE")
    drop.add_argument("--reason", required=True)


def _add_delete(actions: Any) -> None:
    delete = add_action(
        actions,
        "delete-participant",
        "remove every trace of a participant; a count stays",
        _console("delete"),
    )
    delete.add_argument("code", metavar="CODE")


def _add_json(action: Any) -> None:
    action.add_argument("--json", action="store_true", help="print a report as JSON")


def _console(name: str) -> Action:
    def run(chosen: argparse.Namespace, _open_window: OpenWindow | None) -> int:
        from hapticplayer.console import study

        actions: dict[str, Callable[[argparse.Namespace], int]] = study.ACTIONS
        return actions[name](chosen)

    return run


def _run(chosen: argparse.Namespace, open_window: OpenWindow | None) -> int:
    from hapticplayer.errors import UsageError

    if open_window is None:
        raise UsageError("a study is run in a window, and there is no display")
    return open_window(chosen)


def _usage(parser: argparse.ArgumentParser) -> NoReturn:
    parser.error("an action is needed")
