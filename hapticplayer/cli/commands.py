"""The commands: each loads what it needs and hands over to `hapticplayer.console`."""

import argparse
from collections.abc import Callable

OpenWindow = Callable[[argparse.Namespace], int]


def demo(options: argparse.Namespace, open_window: OpenWindow | None) -> int:
    """Open the window on the demo, or play it without one."""
    from hapticplayer import console

    if open_window is not None:
        return open_window(options)
    options.source = console.demo_folder()
    return console.play(options)


def play(options: argparse.Namespace, open_window: OpenWindow | None) -> int:
    """Play in the window, or without one."""
    from hapticplayer import console

    if options.headless or open_window is None:
        return console.play(options)
    return open_window(options)


def import_(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Make a sequence of a recording."""
    from hapticplayer import console

    return console.import_recording(options)


def sync(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Say how a log lies to a clip."""
    from hapticplayer import console
    from hapticplayer.cli import sync_plot

    return console.sync(options, sync_plot.draw_sync)


def process(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Say how good a recording's motion is."""
    from hapticplayer import console
    from hapticplayer.cli import plots

    return console.process(options, plots.draw_motion)


def simulate(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Write a simulated ride."""
    from hapticplayer import console

    return console.simulate(options)


def export(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Convert a record of the haptic loop."""
    from hapticplayer import console

    return console.export(options)


def doctor(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    """Tell what is missing."""
    from hapticplayer import doctor

    return doctor.main(["--json"] if options.json else [])
