"""The actions `study analyse`, `simulate` and `power`; standard library only."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hapticplayer.cli.commands import OpenWindow

if TYPE_CHECKING:
    from hapticplayer.console.study_analysis import StudyStore

_SEED = 2012


def register(actions: Any) -> None:
    """Add the actions to the sub-parsers of `study`, on its folders."""
    add_analysis_commands(actions, _folders)


def _folders() -> "StudyStore":
    from hapticplayer.console.study_store import StudyFolders

    return StudyFolders()


def add_analysis_commands(actions: Any, store: "Callable[[], StudyStore]") -> None:
    """Add the actions to the sub-parsers of `study`.

    Args:
        actions: sub-parsers.
        store: gives access to the folders of studies, when it is needed.
    """
    _add_analyse(actions, store)
    _add_simulate(actions, store)
    _add_power(actions, store)


def _add_analyse(actions: Any, store: "Callable[[], StudyStore]") -> None:
    analyse = _action(
        actions, "analyse", "statistics and figures of a study", "analyse", store
    )
    analyse.add_argument("study", metavar="NAME", type=Path, help="folder of the study")
    analyse.add_argument(
        "--output",
        metavar="DIR",
        type=Path,
        help="write the report (HTML, PDF), figures and numbers into a new folder",
    )
    analyse.add_argument(
        "--missing",
        choices=("paired", "complete"),
        default="paired",
        help="where answers are missing: leave their sequence out for all feedbacks of "
        "this participant (default), or leave the participant out",
    )
    analyse.add_argument(
        "--with-unsound",
        action="store_true",
        help="also count trials whose playback was not sound",
    )


def _add_simulate(actions: Any, store: "Callable[[], StudyStore]") -> None:
    simulate = _action(
        actions, "simulate", "add simulated participants to a study", "simulate", store
    )
    simulate.add_argument(
        "study",
        metavar="NAME",
        type=Path,
        help="folder of the study; made from the template qoe2012 if it is missing",
    )
    simulate.add_argument("--participants", type=int, default=15, metavar="N")
    _add_effect(simulate)


def _add_power(actions: Any, store: "Callable[[], StudyStore]") -> None:
    power = _action(
        actions, "power", "how many participants a design needs", "power", store
    )
    power.add_argument(
        "study",
        metavar="NAME",
        type=Path,
        nargs="?",
        help="a pilot study whose participants stand for the others (default: the "
        "population of --effect)",
    )
    _add_effect(power)
    power.add_argument(
        "--measure", default="qoe", help="qoe (default) or the key of a factor"
    )
    power.add_argument("--sequences", type=int, default=4, metavar="N")
    power.add_argument("--alpha", type=float, default=0.05)
    power.add_argument("--power", type=float, default=0.8, metavar="SHARE")
    power.add_argument(
        "--largest", type=int, default=60, metavar="N", help="participants to try"
    )
    power.add_argument(
        "--studies", type=int, default=2000, metavar="N", help="to simulate"
    )


def _add_effect(action: argparse.ArgumentParser) -> None:
    action.add_argument(
        "--effect",
        default="paper",
        metavar="E",
        help="paper (default), none, or a share of the paper's effect such as 0.5",
    )


def _action(
    actions: Any, name: str, summary: str, run: str, store: "Callable[[], StudyStore]"
) -> argparse.ArgumentParser:
    action: argparse.ArgumentParser = actions.add_parser(
        name, help=summary, description=summary
    )
    action.add_argument("--seed", type=_seed, default=_SEED)
    action.add_argument("--json", action="store_true", help="print the result as JSON")

    def start(chosen: argparse.Namespace, _open_window: OpenWindow | None) -> int:
        from hapticplayer.console import study_analysis

        return int(getattr(study_analysis, run)(chosen, store()))

    action.set_defaults(run=start)
    return action


def _seed(text: str) -> int:
    value = int(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text!r} is negative")
    return value
