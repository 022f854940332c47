"""The figures of the realistic track before and after a change, as commands say them."""

import dataclasses
from typing import Any

from hapticplayer.cli.common import say
from hapticplayer.sequence.figures import ForceFigures


def say_figures(before: ForceFigures, after: ForceFigures) -> None:
    """Print both, one below the other."""
    for name, figures in (("before", before), ("after", after)):
        say(f"{name:6}  {_text(figures)}")


def described_figures(before: ForceFigures, after: ForceFigures) -> dict[str, Any]:
    """The report as JSON."""
    return {
        "before": dataclasses.asdict(before),
        "after": dataclasses.asdict(after),
    }


def _text(figures: ForceFigures) -> str:
    reaches = ", ".join(f"{hand} {r:.0%}" for hand, r in figures.reaches.items())
    text = (
        f"RMS {figures.rms_n:.2f} N, peak {figures.peak_n:.2f} N, at the limit "
        f"{figures.saturated_share:.1%} of the time; workspace used: {reaches}"
    )
    trips = ", ".join(figures.trips)
    return f"{text}; a {trips} hand trips the device" if trips else text
