"""`device rig-monitor`: what a motion rig at the other end would do."""

import argparse
import contextlib
import json
from typing import Any

from hapticplayer.cli.common import add_number, say
from hapticplayer.clock import SystemClock
from hapticplayer.extras.rigs.packets import FORMATS
from hapticplayer.extras.rigs.receiver import PacketReceiver
from hapticplayer.model import ranges

LINE_PERIOD_S = 1.0
_WAIT_S = 0.1


def add_options(action: argparse.ArgumentParser) -> None:
    """Add the options."""
    action.set_defaults(run=lambda chosen, _open_window: monitor(chosen))
    action.add_argument("--json", action="store_true", help="report as JSON")
    ports = ", ".join(str(kind.port) for kind in FORMATS.values())
    action.add_argument(
        "--port",
        type=int,
        action="append",
        metavar="PORT",
        help=f"UDP port of this machine, once for each (default: {ports})",
    )
    add_number(
        action,
        "--duration",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="end after S seconds (default: with Ctrl-C)",
    )


def monitor(options: argparse.Namespace) -> int:
    """Listen, print a line a second for each rig that moves, and report at the end."""
    clock = SystemClock()
    receiver = PacketReceiver(
        clock, options.port or [kind.port for kind in FORMATS.values()]
    )
    if not options.json:
        say(f"listening at {', '.join(map(str, receiver.rigs))}; Ctrl-C ends")
    end_s = clock.now_s() + (options.duration or float("inf"))
    next_s = clock.now_s()
    quiet = contextlib.suppress(KeyboardInterrupt)
    with contextlib.closing(receiver), quiet:
        while (now_s := clock.now_s()) < end_s:
            for _ in receiver.listen(_WAIT_S):
                pass
            if now_s >= next_s and not options.json:
                next_s = now_s + LINE_PERIOD_S
                _show(receiver)
    report = receiver.report()
    if options.json:
        say(json.dumps(report))
        return 0
    for port, one in report.items():
        say(_sentence(port, one))
    return 0


def _show(receiver: Any) -> None:
    for port, one in receiver.report().items():
        if one["is_silent"]:
            continue
        last = receiver.rigs[port].last
        x, y, z = last.acceleration_mps2
        say(
            f"{port} {last.format:<12}{one['rate_hz']:6.1f} Hz  "
            f"{x:+6.2f} {y:+6.2f} {z:+6.2f} m/s2  pitch {last.pitch_rad:+.3f} "
            f"roll {last.roll_rad:+.3f} heading {last.heading_rad:+.3f} rad"
        )


def _sentence(port: int, one: dict[str, Any]) -> str:
    if not one["packets"]:
        return f"{port}: nothing came that is known, {one['unknown']} other packets"
    left = (
        f"left in neutral after {one['neutral_s']:.1f} s of neutral packets"
        if one["is_neutral"]
        else "left in its last pose, not neutral"
    )
    return (
        f"{port}: {one['packets']} packets of {one['format']} at {one['rate_hz']:g} Hz, "
        f"peak {one['peak_mps2']:g} m/s2, time went back from a pose "
        f"{one['time_went_back']} times; {left}"
    )
