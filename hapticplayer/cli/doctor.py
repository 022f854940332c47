"""The command `doctor`; needs nothing but the standard library."""

import argparse

from hapticplayer import doctor


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--json", action="store_true")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Print what is missing."""
    return doctor.main(["--json"] if options.json else [])
