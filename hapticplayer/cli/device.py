"""The command `device`: list, info, home, upload-firmware, test."""

import argparse
import contextlib
import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import asdict
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.cli import Command
from hapticplayer.cli.common import (
    add_agreement,
    add_device_name,
    add_number,
    agreed,
    complain,
    peak_text,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.devices.falcon import firmware
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.homing import Advice, Guidance, home
from hapticplayer.devices.falcon.reach import Reach, reach_of
from hapticplayer.devices.falcon.transport import (
    FalconGoneError,
    Transport,
    list_falcons,
)
from hapticplayer.devices.guides import checks_of, guide_of, hold_text
from hapticplayer.errors import DeviceError
from hapticplayer.extension import rows
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.model import ranges
from hapticplayer.playback.device_test import DevicePart, DeviceTest, parts_of
from hapticplayer.playback.faults import trip_text
from hapticplayer.playback.forces import moved_along

Action = Callable[[argparse.Namespace], int]
HOMING_S = 120.0
_EXCHANGES = 5
_ZERO = (0.0, 0.0, 0.0)
_ENCODERS = ("top", "right", "lower left")


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the actions of the command and their options."""
    command.set_defaults(run=lambda *_: command.error("an action is needed"))
    actions = command.add_subparsers(title="actions", metavar="ACTION")

    def add(
        name: str,
        text: str,
        run: Action,
        device: str = "falcon",
        *,
        motion: bool = False,
    ) -> argparse.ArgumentParser:
        action: argparse.ArgumentParser = actions.add_parser(
            name, help=text, description=f"{text[0].upper()}{text[1:]}."
        )
        action.set_defaults(run=lambda chosen, _open_window: run(chosen))
        if device:
            add_device_name(action, device, motion=motion)
        action.add_argument("--json", action="store_true", help="report as JSON")
        return action

    add(
        "list",
        "devices that can be chosen, and what is plugged in",
        list_devices,
        device="",
    )
    what = "what a device can do and needs here, its firmware, whether it is homed"
    add("info", what, info, motion=True)
    home = add("home", "home the Falcon, with guidance", home_falcon)
    add_number(
        home,
        "--timeout",
        ranges.TIMEOUT_S,
        default=HOMING_S,
        metavar="S",
        help=f"give up after S seconds (default {HOMING_S:g})",
    )
    upload = add(
        "upload-firmware",
        "store your copy of the Falcon's firmware, and load it",
        upload_firmware,
    )
    upload.add_argument(
        "file", nargs="?", metavar="FILE", help="without it: load the stored one"
    )
    upload.add_argument(
        "--accept-unknown",
        action="store_true",
        help="also accept an intact image that is not among the known ones",
    )
    add_agreement(upload)
    slow = "move or vibrate a device gently, after asking"
    add_agreement(add("test", slow, test_forces, motion=True))
    for one in rows("device_actions", Command):
        text = f"{one.summary[0].upper()}{one.summary[1:]}."
        more = actions.add_parser(one.name, help=one.summary, description=text)
        import_module(one.module).add_options(more)


_MET = {True: "found", False: "missing", None: "not visible from here"}


def list_devices(options: argparse.Namespace) -> int:
    """Print the devices that this version can drive, and what is plugged in."""
    known = installed_devices().values()
    entries = [{"name": d.name, "title": d.title} for d in known]
    entries.append({"name": "none", "title": "no force at all"})
    falcons: list[dict[str, Any]] = []
    try:
        falcons = [asdict(found) for found in list_falcons()]
    except DeviceError as problem:
        say_aside(str(problem))
    if options.json:
        say(json.dumps({"devices": entries, "falcons": falcons}))
        return 0
    width = max(len(entry["name"]) for entry in entries) + 2
    for entry in entries:
        say(f"{entry['name']:<{width}}{entry['title']}")
    say("Falcons plugged in: " + ("none" if not falcons else ""))
    for found in falcons:
        serial = found["serial"] or "(permission denied for its number)"
        say(f"  {serial:<16}bus {found['bus']}, address {found['address']}")
    return 0


def info(options: argparse.Namespace) -> int:
    """Print what a device can do, and the state of a Falcon."""
    entry = find_device(options.device)
    report: dict[str, Any] = {"device": entry.name, "title": entry.title}
    report["capabilities"] = asdict(entry.capabilities)
    report["needs"] = [check._asdict() for check in checks_of(entry)]
    if entry.direct:
        report |= _falcon_report(reach_of(entry.name))
    if options.json:
        say(json.dumps(report))
        return 0
    say(f"{entry.title}")
    for name, value in report["capabilities"].items():
        say(f"  {name:<22}{_shown(value)}")
    for need in report["needs"]:
        say(f"  {_MET[need['is_met']]:<22}{need['what']}")
        if need["is_met"] is False:
            say(f"  {'':<22}{need['remedy']}")
    for name in ("firmware", "kept_firmware", "homed", "position_m", "buttons"):
        if name in report:
            say(f"  {name:<22}{report[name]}")
    return 0


def home_falcon(options: argparse.Namespace) -> int:
    """Guide through homing; the device exerts no force."""
    clock = SystemClock()
    with _open(reach_of(options.device), clock) as driver:
        line = _GuidanceLine(is_quiet=options.json)
        for guidance in home(driver, clock, options.timeout):
            line.show(guidance)
        reading = driver.exchange(_ZERO, clock.now_s())
    if options.json:
        say(json.dumps({"homed": True, "position_m": reading.position_m}))
    else:
        say("The Falcon is homed; its ring is green.")
    return 0


def upload_firmware(options: argparse.Namespace) -> int:
    """Keep the user's copy of the firmware, and load it into a Falcon."""
    reach = reach_of(options.device)
    if options.file is not None:
        if not options.json:
            say(firmware.LICENCE_NOTE)
        agreed(options, "Do you accept that licence, and may you use this file?")
        image = firmware.install_image(
            Path(options.file), accept_unknown=options.accept_unknown
        )
        say_aside(f"stored as {firmware.kept_path()}")
    else:
        image = reach.image()
    report: dict[str, Any] = {
        "image": image.known_name or "unknown",
        "sha256": image.sha256,
        "loaded": False,
    }
    clock = SystemClock()
    try:
        with shown_progress() as progress:
            driver = reach.driver(clock)
            driver.open(lambda part: progress(part, "loading the firmware"))
            driver.close()
        report["loaded"] = True
    except FalconGoneError as problem:
        if options.file is None:
            raise
        say_aside(f"{problem}; it will be loaded when a Falcon is chosen")
    if options.json:
        say(json.dumps(report))
    elif report["loaded"]:
        say("The Falcon runs its firmware.")
    return 0


def _shown(value: Any) -> str:
    """Return a value of a capability record."""
    if isinstance(value, str):
        return value
    return ("no", "yes")[value] if isinstance(value, bool) else f"{value:g}"


class _GuidanceLine:
    """Shows guidance: on a terminal in one line, else a line for each news."""

    def __init__(self, *, is_quiet: bool) -> None:
        self._is_terminal = sys.stderr.isatty() and not is_quiet
        self._is_quiet, self._last = is_quiet, ""

    def show(self, guidance: Guidance) -> None:
        """Show it if it is news."""
        if self._is_quiet:
            return
        pairs = zip(_ENCODERS, guidance.homed, strict=True)
        found = ", ".join(name for name, is_homed in pairs if is_homed) or "none yet"
        text = f"{guidance.advice.value} (encoders homed: {found})"
        if self._is_terminal:
            end = "\n" if guidance.advice is Advice.DONE else ""
            sys.stderr.write(f"\r{text}, {guidance.out:+5.0f} counts   {end}")
            sys.stderr.flush()
        elif text != self._last:
            sys.stderr.write(text + "\n")
        self._last = text


@contextlib.contextmanager
def _open(reach: Reach, clock: SystemClock) -> Iterator[FalconDriver]:
    driver = reach.driver(clock)
    with shown_progress() as progress:
        driver.open(lambda part: progress(part, "loading the firmware"))
    try:
        yield driver
    finally:
        driver.close()


def _falcon_report(reach: Reach) -> dict[str, Any]:
    """Look at a Falcon without loading anything into it."""
    clock = SystemClock()
    transport: Transport = reach.open_transport()
    try:
        runs = firmware.is_running(Ftdi(transport), clock)
    finally:
        transport.close()
    report: dict[str, Any] = {"firmware": "runs" if runs else "not loaded"}
    try:
        kept = firmware.find_image()
        report["kept_firmware"] = kept.known_name or f"unknown ({kept.sha256[:16]})"
    except DeviceError as problem:
        report["kept_firmware"] = str(problem)
    if runs:
        driver = reach.driver(clock)
        driver.open()
        try:
            reading = driver.exchange(_ZERO, clock.now_s())
            for _ in range(_EXCHANGES):
                clock.sleep_until(clock.now_s() + 0.005)
                reading = driver.exchange(_ZERO, clock.now_s())
        finally:
            driver.close()
        report["homed"] = reading.is_homed
        report["position_m"] = reading.position_m if reading.is_homed else None
        report["buttons"] = reading.buttons
    return report


POLL_S = 0.02
_WAIT_FOR_HOMING = "pull the grip out as far as it goes, then push it in until it locks"


def test_forces(options: argparse.Namespace) -> int:
    """Test a device and say how it took it."""
    entry, parts = find_device(options.device), parts_of(options.device)
    hold = hold_text(guide_of(entry), entry.capabilities)
    agreed(
        options,
        f"The device will move or vibrate gently for {sum(p.end_s for p in parts):.0f} s"
        f"{_what(parts)}. {hold} Ctrl-C or a button on it stops. Ready?",
    )
    test, ticks = _tested(options.device, has_grip=bool(entry.capabilities.axes))
    report = {"device": entry.name, "ticks": len(ticks)}
    report |= _packets(ticks) if entry.takes_motion else _forces(ticks)
    if test.loudest:
        report["channels"] = test.loudest
    say(json.dumps(report) if options.json else _text(report))
    if test.problem:
        complain(test.problem)
    elif test.mode is Mode.TRIPPED:
        complain(trip_text(test.cause))
    return int(bool(test.problem) or test.mode is Mode.TRIPPED)


def _what(parts: tuple[DevicePart, ...]) -> str:
    labels = ", ".join(part.label for part in parts if part.label)
    if labels:
        return f", channel by channel: {labels}"
    sizes = (getattr(step, "strength_n", 0.0) for step in parts[0].steps)
    largest_n = max(sizes, default=0.0)
    return f" with up to {largest_n:.1f} N" if largest_n else ""


def _tested(device: str, *, has_grip: bool) -> tuple[DeviceTest, NDArray[Any]]:
    """A test that is over, and its ticks."""
    clock, is_told = SystemClock(), not has_grip
    test = DeviceTest(clock, device, homing_s=HOMING_S)
    ticks = []
    try:
        while not test.is_over:
            ticks.append(test.poll())
            if test.cause is Cause.NOT_HOMED and len(ticks) > 1 and not is_told:
                is_told = True
                sys.stderr.write(_WAIT_FOR_HOMING + "\n")
            clock.sleep_until(clock.now_s() + POLL_S)
    finally:
        test.stop()
        test.wait()
    return test, np.concatenate(ticks)


def _packets(ticks: NDArray[Any]) -> dict[str, Any]:
    flags = ticks["buttons"]
    return {
        "packets": int(np.count_nonzero(flags & SENT)),
        "is_heard": not np.any(flags & REFUSED),
    }


def _forces(ticks: NDArray[Any]) -> dict[str, Any]:
    played = ticks[ticks["mode"] == Mode.FOLLOWING]
    if not len(played):
        return {}
    age_ms = 1e3 * np.percentile(played["reply_age_s"], (50, 99))
    late_us = 1e6 * np.percentile(played["lateness_s"], (50, 99))
    size_n = np.linalg.norm(played["force_n"], axis=1)
    travel_mm = 1e3 * np.ptp(played["position_m"], axis=0)
    return {
        "largest_force_n": round(float(size_n.max()), 3),
        "travel_mm": [round(float(way), 1) for way in travel_mm],
        "moved_along_the_force": round(moved_along(played), 3),
        "reply_age_ms": {"p50": round(age_ms[0], 3), "p99": round(age_ms[1], 3)},
        "lateness_us": {"p50": round(late_us[0], 1), "p99": round(late_us[1], 1)},
        "missed": int(played["missed"].sum()),
    }


def _text(report: dict[str, Any]) -> str:
    if "packets" in report:
        return f"{report['packets']} packets sent" + (
            ", but nobody listens there" * (not report["is_heard"])
        )
    if "channels" in report:
        return "\n".join(
            f"channel {one['channel']} played, {peak_text(one)}"
            for one in report["channels"]
        )
    if "travel_mm" not in report:
        return "No force was made."
    x, y, z = report["travel_mm"]
    age, late = report["reply_age_ms"], report["lateness_us"]
    return (
        f"force      up to {report['largest_force_n']} N\n"
        f"way        {x} x {y} x {z} mm; along the force "
        f"{report['moved_along_the_force']:+.2f} (1 is exactly)\n"
        f"answers    p50 {age['p50']} ms, p99 {age['p99']} ms old\n"
        f"loop       late by p50 {late['p50']} us, p99 {late['p99']} us; "
        f"{report['missed']} missed"
    )
