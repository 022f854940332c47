"""`device measure`: an owner's measurements, step by step, and a report of them."""

import argparse
import contextlib
import json
import math
import re
import sys
from pathlib import Path
from typing import Any

from hapticplayer import __version__, storage
from hapticplayer.cli.common import (
    add_agreement,
    add_device_name,
    add_overwrite,
    agreed,
    say,
    shown_progress,
)
from hapticplayer.clock import SystemClock, utc_now_iso
from hapticplayer.devices import find_device
from hapticplayer.devices.falcon.firmware import open_running
from hapticplayer.devices.falcon.homing import home
from hapticplayer.devices.falcon.link import ThreadedLink
from hapticplayer.devices.falcon.reach import Reach, reach_of
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.measuring import measuring
from hapticplayer.extras.measuring.guarded_clock import GuardedClock
from hapticplayer.linux import acquire
from hapticplayer.storage import FILE, IsOurs, refuse_existing

STOPS_S = 20.0
HOMING_S = 120.0


def add_options(action: argparse.ArgumentParser) -> None:
    """Add the options."""
    action.set_defaults(run=lambda chosen, _open_window: measure_falcon(chosen))
    add_device_name(action, "falcon", motion=False)
    action.add_argument("--json", action="store_true", help="report as JSON")
    action.add_argument("-o", "--output", metavar="FILE", help="the report, as JSON")
    add_overwrite(action, "--output")
    add_agreement(action)


def measure_falcon(options: argparse.Namespace) -> int:
    """Measure, print, and save where asked."""
    reach_of(options.device)  # refuse a wrong name before anything else
    target = None if options.output is None else Path(options.output)
    is_ours = _is_report if options.overwrite else None
    if target is not None:
        refuse_existing(target, FILE, is_ours)
    agreed(
        options,
        f"The Falcon will exert up to {measuring.MOST_N} N, partly without a hand "
        "on it. A button on the grip stops. A guard takes the force away should this "
        "program die; switch the Falcon off if the force stays. Continue?",
    )
    report: dict[str, Any] = {
        "program": f"hapticplayer {__version__}",
        "device": options.device,
        "utc": utc_now_iso(),
    }
    with contextlib.closing(_guarded_clock(options.device)) as watch:
        reach = reach_of(options.device, watch.handle())
        report["round_trip"] = _round_trips(reach, SystemClock())
        report |= _with_forces(options, reach, watch)
    text = json.dumps(_finite(report), indent=None if options.json else 1)
    say(text)
    if target is not None:
        _save(target, text, is_ours)
    return 0


def _round_trips(reach: Reach, clock: SystemClock) -> dict[str, Any]:
    with shown_progress() as progress:
        ftdi = open_running(
            reach.open_transport,
            reach.image,
            clock,
            progress=lambda part: progress(part, "loading the firmware"),
        )
    try:
        return {
            "latency_timer": measuring.round_trips(ftdi, clock, event_character=False),
            "event_character": measuring.round_trips(ftdi, clock, event_character=True),
        }
    finally:
        ftdi.close()


def _guarded_clock(device: str) -> GuardedClock:
    is_real = find_device(device).server == ""
    return GuardedClock(SystemClock(), device, [] if is_real else ["--unhomed"])


def _with_forces(
    options: argparse.Namespace, reach: Reach, watch: GuardedClock
) -> dict[str, Any]:
    clock = SystemClock()
    driver = reach.driver(clock)
    driver.open()
    try:
        _wait(options, "Home the grip: pull it out all the way, then push it in.")
        for _ in home(driver, clock, HOMING_S):
            pass
    finally:
        driver.close()
    acquire(None)  # the best there is, as for the loop: a stand-still wakes the guard
    driver = reach.driver(clock, make_link=ThreadedLink)
    driver.open()
    try:
        _wait(options, "Move the grip to all its ends for 20 s; there is no force.")
        stops = measuring.stops(driver, clock, STOPS_S)
        _wait(
            options,
            "Hold the grip loosely in the middle; it will be pushed to the right.",
        )
        with watch.force():
            silence = measuring.force_after_silence(driver, watch, watch.was_disturbed)
        _wait(options, "Leave the grip in the middle and take the hand away.")
        with watch.force():
            friction = measuring.friction(driver, watch)
    finally:
        driver.close()
    return {"stops": stops, "silence": silence, "friction_n": friction}


def _wait(options: argparse.Namespace, text: str) -> None:
    sys.stderr.write(text + "\n")
    if not options.yes:
        sys.stderr.write("  Press ENTER to start. ")
        sys.stderr.flush()
        sys.stdin.readline()


def _finite(value: Any) -> Any:
    """Return the same with None for what is not finite, as JSON has no such numbers."""
    if isinstance(value, dict):
        return {name: _finite(each) for name, each in value.items()}
    if isinstance(value, float):
        return round(value, 6) if math.isfinite(value) else None
    return value


def _is_report(head: bytes) -> bool:
    return (
        re.match(rb'\{\s*"program": "hapticplayer [^"]*",\s*"device"', head) is not None
    )


def _save(path: Path, text: str, is_ours: IsOurs | None) -> None:
    try:
        with storage.file_written_aside(path, is_ours) as part:
            part.write_text(text + "\n", encoding="utf-8")
    except InputError as problem:
        remedy = Message("choose another place; the report was printed")
        raise InputError(problem.what, where=problem.where, remedy=remedy) from problem
