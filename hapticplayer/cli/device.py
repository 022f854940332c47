"""The command `device`: list, info, home, upload-firmware, test, measure."""

import argparse
import contextlib
import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import asdict
from importlib import import_module
from pathlib import Path
from typing import Any

from hapticplayer.cli import Command
from hapticplayer.cli.common import (
    add_device_name,
    add_number,
    add_overwrite,
    agreed,
    interruptible,
    say,
    say_aside,
    shown_progress,
)
from hapticplayer.cli.device_forces import test_forces
from hapticplayer.cli.device_measure import measure_falcon
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
from hapticplayer.devices.guides import checks_of
from hapticplayer.errors import DeviceError
from hapticplayer.extension import rows
from hapticplayer.model import ranges

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
    _add_yes(upload)
    slow = "move or vibrate a device gently, after asking"
    _add_yes(add("test", slow, test_forces, motion=True))
    measure = add(
        "measure",
        "measure what is not known of a Falcon, at low force",
        measure_falcon,
    )
    measure.add_argument("-o", "--output", metavar="FILE", help="the report, as JSON")
    add_overwrite(measure)
    _add_yes(measure)
    for one in rows("device_actions", Command):
        text = f"{one.summary[0].upper()}{one.summary[1:]}."
        more = actions.add_parser(one.name, help=one.summary, description=text)
        import_module(one.module).add_options(more)


_MET = {True: "found", False: "missing", None: "not visible from here"}


def _add_yes(action: argparse.ArgumentParser) -> None:
    action.add_argument("--yes", action="store_true", help="do not ask")


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
    with interruptible(), _open(reach_of(options.device), clock) as driver:
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
        with interruptible(), shown_progress() as progress:
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
