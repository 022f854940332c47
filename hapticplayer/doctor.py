"""Finds what this machine lacks to run the program, and names it by package.

Standard library, `errors` and two files beside it only, and able to start on a bare system Python before
anything is installed: `python3 hapticplayer/doctor.py`. The set-up asks it what to
install.
"""

from __future__ import annotations

import argparse
import ctypes
import dataclasses
import importlib.util
import json
import os
import platform
import re
import shutil
import socket
import sys
from collections.abc import Callable, Collection
from importlib.machinery import PathFinder
from pathlib import Path

if not __package__:  # a program of its own
    sys.path.append(str(Path(__file__).resolve().parent.parent))

from hapticplayer.errors import Message, joined
from hapticplayer.installation import (
    EXTRAS,
    NAME,
    Extra,
    how_to_get,
    is_beside_venv,
    is_debian,
)
from hapticplayer.shipped import IS_CLONE, ROOT, UDEV_RULE, shipped

APT_LIST = shipped("packaging/apt-packages.txt")
APT_INSTALL = "apt-get install --no-install-recommends"
OLDEST_PYTHON = (3, 11)
RUN_GROUPS = (
    *["base"] * IS_CLONE,  # to set it up
    *("qt", "window", "wayland", "sound", "device"),
)
CHECKS_GROUP = "checks"

# What is imported, and the Python package that brings it.
PYTHON_PACKAGES = {
    "PySide6": "PySide6-Essentials",
    "usb": "pyusb",
    **{
        name: name
        for name in (
            *("av", "defusedxml", "jeepney", "msgspec", "numpy"),
            *("pyqtgraph", "scipy", "sounddevice", "vqf"),
        )
    },
}

FALCON_USB_ID = ("0403", "cb48")
USB_DEVICES = Path("/sys/bus/usb/devices")
SOUND_CARDS = Path("/proc/asound/cards")
SOCKET_TIMEOUT_S = 1.0


# No slots: this file must also start on the older Python that it then reports.
@dataclasses.dataclass(frozen=True)
class AptPackage:
    """One line of the list of system packages."""

    name: str
    proof: str
    group: str
    required: bool
    purpose: str


@dataclasses.dataclass(frozen=True)
class MachineCheck:
    """What was looked at, what was found, and what would mend it.

    Attributes:
        name: what was looked at, a package or a property of the machine; as the texts,
            a `Message` where it is words.
        ok: it is there.
        detail: what was found, in a few words.
        remedy: what a person can do, empty when there is nothing to do.
        required: the program has no window without it.
    """

    name: str
    ok: bool
    detail: str
    remedy: str = ""
    required: bool = False


def read_apt_list() -> list[AptPackage]:
    """The list of system packages."""
    packages = []
    for line in APT_LIST.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            name, proof, group, need, purpose = line.split(None, 4)
            packages.append(AptPackage(name, proof, group, need == "required", purpose))
    return packages


def _loads(soname: str) -> bool:
    try:
        ctypes.CDLL(soname)
    except OSError:
        return False
    return True


def _python_is(version: str) -> bool:
    return sys.version_info >= tuple(map(int, version.split(".")))


PROOFS: dict[str, Callable[[str], bool]] = {
    "lib": _loads,
    "module": lambda name: importlib.util.find_spec(name) is not None,
    "file": lambda pattern: any(Path("/").glob(pattern.lstrip("/"))),
    "command": lambda name: shutil.which(name) is not None,
    "python": _python_is,
}


def is_there(proof: str) -> bool:
    """Whether what a package brings is on this machine, wherever it came from."""
    kind, _, what = proof.partition(":")
    return PROOFS[kind](what)


def missing_packages(groups: Collection[str] = RUN_GROUPS) -> list[AptPackage]:
    """The system packages of these groups that bring something this machine lacks."""
    return [
        package
        for package in read_apt_list()
        if package.group in groups and not is_there(package.proof)
    ]


def missing_apt(groups: Collection[str] = RUN_GROUPS) -> list[str]:
    return [package.name for package in missing_packages(groups)]


def check() -> list[MachineCheck]:
    """Look at all that the program needs or uses, the required things first."""
    return [
        _check_python(),
        *_check_apt(),
        _check_python_packages(),
        *map(_check_extra, EXTRAS.values()),
        _check_display(),
        _check_sound(),
        *_check_facilities(),
        _check_falcon(),
    ]


def _check_python() -> MachineCheck:
    oldest = ".".join(map(str, OLDEST_PYTHON))
    return MachineCheck(
        "Python",
        sys.version_info >= OLDEST_PYTHON,
        required=True,
        detail=f"{platform.python_version()} ({sys.executable})",
        remedy=Message(
            "use Python {oldest} or newer, as in Debian 12 and 13", oldest=oldest
        ),
    )


def _check_apt() -> list[MachineCheck]:
    return [
        MachineCheck(
            package.name,
            is_there(package.proof),
            required=package.required,
            detail=Message(
                "{what} ({proof})", what=Message(package.purpose), proof=package.proof
            ),
            remedy=f"{APT_INSTALL} {package.name}",
        )
        for package in read_apt_list()
        if package.group in RUN_GROUPS
    ]


def _version(module: str, name: str) -> str | None:
    """Metadata and finders only: importing them all would take seconds."""
    import importlib.metadata  # with all of email's: a start must not wait for it

    paths = sys.path
    if is_beside_venv():
        paths = [str(path) for path in ROOT.glob(".venv/lib/python3*/site-packages")]
    if PathFinder.find_spec(module, paths) is None:
        return None
    found = importlib.metadata.distributions(name=name, path=paths)
    return next((one.version for one in found), None)


def _check_python_packages() -> MachineCheck:
    found, missing = [], []
    for module, name in PYTHON_PACKAGES.items():
        version = _version(module, name)
        if version is None:
            missing.append(name)
        else:
            found.append(f"{name} {version}")
    return MachineCheck(
        Message("Python packages"),
        not missing,
        required=True,
        detail=Message("missing: {names}", names=", ".join(missing))
        if missing
        else ", ".join(found),
        remedy=Message("./run sets them up in .venv")
        if IS_CLONE
        else Message("install the program again"),
    )


def _check_extra(extra: Extra) -> MachineCheck:
    versions = {name: _version(at, name) for at, name in extra.packages.items()}
    ok = all(versions.values())
    remedy = how_to_get(extra.name)
    if extra.size_mb:
        remedy = Message("{how} ({size} MB)", how=remedy, size=extra.size_mb)
    return MachineCheck(
        f"[{extra.name}]",
        ok,
        detail=", ".join(f"{name} {found}" for name, found in versions.items())
        if ok
        else extra.without,
        remedy=remedy,
    )


def _answers(family: int, address: str | tuple[str, int]) -> bool:
    with socket.socket(family, socket.SOCK_STREAM) as connection:
        connection.settimeout(SOCKET_TIMEOUT_S)
        try:
            connection.connect(address)
        except OSError:
            return False
    return True


def x_server_answers(display: str) -> bool:
    """Whether there is a server behind this value of DISPLAY."""
    host, _, number = display.rpartition(":")
    number = number.split(".")[0]
    if not number.isdigit():
        return False
    if host in ("", "unix"):
        path = f"/tmp/.X11-unix/X{number}"  # noqa: S108 (where X servers listen)
        return any(_answers(socket.AF_UNIX, name) for name in (path, "\0" + path))
    return _answers(socket.AF_INET, (host, 6000 + int(number)))


def _runtime_directory() -> Path:
    return Path(os.environ.get("XDG_RUNTIME_DIR") or f"/run/user/{os.getuid()}")


def _check_display() -> MachineCheck:
    wayland = os.environ.get("WAYLAND_DISPLAY", "")
    x11 = os.environ.get("DISPLAY", "")
    tried = []
    if wayland:
        ok = _answers(socket.AF_UNIX, str(_runtime_directory() / wayland))
        tried.append((f"Wayland {wayland}", ok))
    if x11:
        tried.append((f"X11 {x11}", x_server_answers(x11)))
    words = [
        Message("{server} answers", server=name)
        if ok
        else Message("{server} is silent", server=name)
        for name, ok in tried
    ]
    return MachineCheck(
        Message("display"),
        any(ok for _, ok in tried),
        detail=joined(", ", words)
        or Message("neither DISPLAY nor WAYLAND_DISPLAY is set"),
        remedy=Message(
            "start from a desktop session (--headless plays without a window)"
        ),
    )


def _check_sound() -> MachineCheck:
    server = os.environ.get("PULSE_SERVER", "")
    if server.startswith(("unix:", "/")):
        path = Path(server.removeprefix("unix:"))
    else:
        path = _runtime_directory() / "pulse" / "native"
    ways = []
    if _answers(socket.AF_UNIX, str(path)):
        ways.append(Message("a PulseAudio or PipeWire server answers"))
    cards = SOUND_CARDS.read_text() if SOUND_CARDS.is_file() else ""
    if re.search(r"^\s*\d+ \[", cards, re.MULTILINE):
        ways.append(Message("there is a sound card"))
    return MachineCheck(
        Message("sound"),
        bool(ways),
        detail=joined(", ", ways) or Message("neither a sound server nor a sound card"),
        remedy=Message(
            "clips play silently, led by the system clock, until there is one"
        ),
    )


def _check_facilities() -> list[MachineCheck]:
    if sys.version_info < OLDEST_PYTHON:
        return []
    from hapticplayer.facilities import FACILITIES, has
    from hapticplayer.linux import GUARD_PRIORITY, SWITCH, taken_away

    remedies = {
        "": "",
        "udev": Message("copy {file} to /etc/udev/rules.d", file=UDEV_RULE),
        "limits": Message("add yourself to the group {name}, log in again", name=NAME)
        if is_debian()
        else Message(
            "allow rtprio {n} and memlock in /etc/security/limits.d", n=GUARD_PRIORITY
        ),
    }
    is_away = Message("unset {switch}", switch=SWITCH)
    return [
        MachineCheck(
            name,
            is_here := has(name),
            detail=one.gives if is_here else one.without,
            remedy=is_away if name in taken_away() else remedies[one.right],
        )
        for name, one in FACILITIES.items()
    ]


def _check_falcon() -> MachineCheck:
    ok = False
    detail, remedy = (
        Message("none on USB"),
        Message("the simulated device stands in"),
    )
    for device in USB_DEVICES.glob("*"):
        try:
            usb_id = tuple(
                (device / name).read_text().strip()
                for name in ("idVendor", "idProduct")
            )
            place = [int((device / name).read_text()) for name in ("busnum", "devnum")]
        except (OSError, ValueError):
            continue
        if usb_id == FALCON_USB_ID:
            node = Path("/dev/bus/usb/{:03}/{:03}".format(*place))
            ok = os.access(node, os.R_OK | os.W_OK)
            held = Message("{node}, but this user may not open it", node=node)
            detail = Message(str(node)) if ok else held
            remedy = Message(
                "copy {file} to /etc/udev/rules.d and plug it in again", file=UDEV_RULE
            )
    return MachineCheck("Falcon", ok, detail=detail, remedy=remedy)


def missing_for_window() -> str:
    """What Qt would end the process for, in a sentence with one command; else "".

    Under X11 Qt loads libraries that nothing imports, and aborts without them.
    """
    platform_name = os.environ.get("QT_QPA_PLATFORM", "")
    on_x11 = not platform_name and not os.environ.get("WAYLAND_DISPLAY")
    if not on_x11 and not platform_name.startswith("xcb"):
        return ""
    missing = missing_packages(("qt", "window"))
    if not missing:
        return ""
    return (
        "no window can be opened, as system libraries are missing; install them with: "
        f"{APT_INSTALL} {' '.join(one.name for one in missing)}"
    )


def explain_import_error(error: ImportError | OSError) -> str:
    """Say in one sentence which package would have prevented an import error.

    An OSError is how sounddevice reports that PortAudio is missing.
    """
    text = str(error)
    if isinstance(error, ModuleNotFoundError) and error.name:
        module = error.name.partition(".")[0]
        package = PYTHON_PACKAGES.get(module, module)
        how = "./run sets it up in .venv" if IS_CLONE else "install the program again"
        return f"The Python package {package} is missing; {how}."
    if "PortAudio library not found" in text:
        return _explain_library("libportaudio.so.2")
    library = re.search(r"(\S+\.so[.\d]*): cannot open shared object file", text)
    if library:
        return _explain_library(Path(library[1]).name)
    symbol = re.search(r"version [`'](GLIBC\w*_[\d.]+)' not found", text)
    if symbol:
        return f"This system is too old for the program: it has no {symbol[1]}."
    return f"A part of the program could not be loaded: {text}."


def _explain_library(soname: str) -> str:
    for package in read_apt_list():
        if package.proof == f"lib:{soname}":
            return (
                f"The system library {soname} is missing; "
                f"install it with: {APT_INSTALL} {package.name}"
            )
    return f"The system library {soname} is missing, and no package is known for it."


def _print_table(checks: list[MachineCheck]) -> None:
    width = max(len(each.name) for each in checks)
    for each in checks:
        mark = "ok" if each.ok else "MISSING" if each.required else "without"
        line = f"{mark:8}{each.name:{width}}  {each.detail}"
        print(line if each.ok or not each.remedy else f"{line}: {each.remedy}")


def _missing_of_need(need: str) -> list[str]:
    if need == CHECKS_GROUP:
        return missing_apt([CHECKS_GROUP])
    return [
        package.name
        for package in missing_packages()
        if need in ("all", "required" if package.required else "optional")
    ]


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.add_argument("--json", action="store_true", help="report as JSON")
    parser.set_defaults(run=report)


def report(options: argparse.Namespace, _open_window: object = None) -> int:
    """Print what is there and what is missing; 0 when all that is required is there."""
    checks = check()
    missing = missing_apt()
    ok = all(each.ok for each in checks if each.required)
    if options.json:
        rows = [dataclasses.asdict(each) for each in checks]
        print(json.dumps({"ok": ok, "missing_apt": missing, "checks": rows}, indent=2))
    else:
        _print_table(checks)
        if missing:
            print(f"\nMissing system packages: {APT_INSTALL} {' '.join(missing)}")
        print(
            "Everything required is there." if ok else "Something required is missing."
        )
    return 0 if ok else 1


def main(argv: list[str]) -> int:
    """Run as a program of its own, which the set-up asks; return the exit status."""
    parser = argparse.ArgumentParser(
        prog="hapticplayer doctor",
        description="Look for what the program needs and name what is missing.",
    )
    add_options(parser)
    parser.add_argument(
        "--missing-apt",
        nargs="?",
        const="all",
        choices=("all", "required", "optional", CHECKS_GROUP),
        help="only print the names of the missing system packages, in one line; "
        "checks: of those that tests compare with",
    )
    arguments = parser.parse_args(argv)
    if not arguments.missing_apt:
        return report(arguments)
    print(*_missing_of_need(arguments.missing_apt))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
