"""How the program is installed, and its optional packages.

Standard library, `errors` and `shipped` only: the doctor asks here before anything is installed.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import sys
from collections.abc import Mapping
from pathlib import Path

from hapticplayer.errors import InputError, Message, shell_line
from hapticplayer.shipped import ROOT

NAME = "hapticplayer"
ADDED = Path("/usr/local/lib") / NAME
"""Where the Debian package also looks for Python packages, in a folder for each Python."""


# No slots: the doctor must also start on the older Python that it then reports.
@dataclasses.dataclass(frozen=True)
class Extra:
    """Packages that are installed on request, `hapticplayer[NAME]`.

    Attributes:
        name: of the extra.
        packages: by the module that is imported.
        without: what the program lacks without them.
        newest: Python for which they exist; () for any.
        size_mb: on disk, where it is worth saying.
    """

    name: str
    packages: Mapping[str, str]
    without: Message
    newest: tuple[int, ...] = ()
    size_mb: int = 0

    def is_here(self) -> bool:
        return all(map(importlib.util.find_spec, self.packages))


EXTRAS = {
    one.name: one
    for one in (
        Extra(
            "study",
            {"matplotlib": "matplotlib", "fpdf": "fpdf2"},
            Message("no reports of studies, no figures in files"),
        ),
        Extra(
            "vision",
            {"cv2": "opencv-python-headless"},
            Message(
                "synchronising by frames is coarse, no motion is suggested from the frames"
            ),
            size_mb=150,
        ),
        Extra(
            "cameras",
            {"telemetry_parser": "telemetry-parser"},
            Message("the motion in clips of Sony and Insta360 is not read"),
            newest=(3, 12),
        ),
        Extra(
            "websockets",
            {"websockets": "websockets"},
            Message("devices behind Intiface or Haply's service are not reached"),
        ),
        Extra(
            "lsl", {"pylsl": "pylsl"}, Message("no trial is streamed to LabRecorder")
        ),
    )
}


def how_to_get(name: str) -> str:
    """The command that adds an extra to this installation."""
    extra = EXTRAS[name]
    if extra.newest and sys.version_info[:2] > extra.newest:
        return Message(
            "{package} exists for Python up to {newest} only",
            package=", ".join(extra.packages.values()),
            newest=".".join(map(str, extra.newest)),
        )
    return install_command(*extra.packages.values())


def install_command(*packages: str) -> str:
    """The command that adds Python packages to this installation."""
    return shell_line(*_installer(), *packages)


def require(name: str, purpose: Message) -> None:
    """Refuse what needs an extra that is not installed.

    Args:
        name: of the extra.
        purpose: what needs it.

    Raises:
        InputError: says how to get it.
    """
    if not EXTRAS[name].is_here():
        raise InputError(
            "{purpose} needs {packages}, which this installation lacks",
            remedy="install hapticplayer[{name}] ({how})",
            purpose=purpose,
            packages=", ".join(EXTRAS[name].packages.values()),
            name=name,
            how=how_to_get(name),
        )


def is_beside_venv() -> bool:
    """Whether this Python is not the one of the environment that ./run makes."""
    return sys.prefix == sys.base_prefix and (ROOT / ".venv").is_dir()


def is_debian() -> bool:
    """Whether the Debian package runs, whose packages no tool of Python may change."""
    return Path(sys.prefix) == Path("/usr/lib") / NAME


def _installer() -> tuple[str, ...]:
    pip, prefix = ("-m", "pip", "install"), Path(sys.prefix)
    if is_beside_venv():
        return (str(ROOT / ".venv/bin/python"), *pip)
    if is_debian():
        folder = ADDED / "python{}.{}".format(*sys.version_info)
        return ("sudo", "/usr/bin/python3", *pip, "--target", str(folder))
    if (prefix / "pipx_metadata.json").is_file():
        return ("pipx", "inject", NAME)
    if (prefix / "uv-receipt.toml").is_file():
        return ("uv", "pip", "install", "--python", sys.executable)
    return (sys.executable, *pip)
