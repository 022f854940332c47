"""What a report of a problem holds: this machine, the run so far, nothing personal."""

import getpass
import json
import platform
import re
import socket
import traceback
import zipfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

import PySide6

from app.bridge.errors import Noted
from app.bridge.settings import LANGUAGE, THEME, Settings
from app.player.statistics import figures
from hapticplayer import __version__, doctor
from hapticplayer.devices.options import with_gain
from hapticplayer.errors import Message
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.player import Player
from hapticplayer.storage import file_written_aside

_LEFT_OUT = "[...]"
_ROOT = Path(__file__).resolve().parents[2]
_NAMED = frozenset({"Device", "Feedback"})
"""Figures with names that people have chosen."""


def check_text(say: Callable[[str], str] = str) -> str:
    """The doctor's table; `say` may translate, a report stays English."""
    lines = []
    for one in doctor.check():
        mark = "ok" if one.ok else "MISSING" if one.required else "without"
        lines.append(f"{say(Message(mark)):8} {say(one.name)}: {say(one.detail)}")
        if one.remedy and not one.ok:
            lines.append(f"{'':8} {say(one.remedy)}")
    return "\n".join(lines)


def parts_of(
    player: Player, noted: Iterable[Noted], settings: Settings, checks: str
) -> dict[str, str]:
    """File names and texts of a report."""
    return {
        "program.txt": _program(settings),
        "check.txt": without_names(checks),
        "playback.txt": _playback(player),
        "messages.txt": "\n".join(map(_line, noted)) or "none",
    }


def _program(settings: Settings) -> str:
    known: Mapping[str, str] = {
        "hapticplayer": __version__,
        "Python": platform.python_version(),
        "Qt": PySide6.__version__,
        "system": f"{platform.system()} {platform.release()} {platform.machine()}",
        "language": settings.text(LANGUAGE),
        "theme": settings.text(THEME),
        "keys": json.dumps(settings.table("keys")),
    }
    return "\n".join(f"{name}: {value}" for name, value in known.items())


def _playback(player: Player) -> str:
    outputs = player.snapshot().outputs
    kinds = (
        f"output: {with_gain(one.name).partition(':')[0]}, {Health(one.health).name}"
        for one in outputs
    )
    shown = (
        f"{name}: {value}" for name, value in figures(player) if name not in _NAMED
    )
    return "\n".join((*kinds, *shown))


def _line(noted: Noted) -> str:
    """A message without the texts in it, or where a fault happened."""
    if isinstance(noted.what, BaseException):
        frames = traceback.extract_tb(noted.what.__traceback__)
        places = (f"  {_place(f.filename)}:{f.lineno} {f.name}" for f in frames)
        return "\n".join((f"{noted.at}  {type(noted.what).__name__}", *places))
    return f"{noted.at}  {without_texts(noted.what)}"


def _place(file: str) -> str:
    """A file of the program or of a library; where it is installed does not matter."""
    path = Path(file)
    if path.is_relative_to(_ROOT):
        return str(path.relative_to(_ROOT))
    return "/".join(path.parts[-2:])


def without_texts(message: str) -> str:
    """A message whose values are only numbers and other messages: names may be people's."""
    if not isinstance(message, Message):
        return _LEFT_OUT
    kept = {
        name: without_texts(value) if isinstance(value, str) else value
        for name, value in message.values.items()
    }
    plain = re.sub(r"![rsa](?=[:}])", "", message.template)
    return plain.format(**kept) if kept else plain


def without_names(text: str) -> str:
    """A text in which home, user and machine have no names."""
    text = text.replace(str(_ROOT), ".").replace(str(Path.home()), "~")
    text = re.sub(r"/(home|Users)/[^/\s]+", "~", text)
    for name in (getpass.getuser(), socket.gethostname()):
        if len(name) > 2 and name != "root":
            text = re.sub(rf"\b{re.escape(name)}\b", _LEFT_OUT, text)
    return text


def shown(parts: Mapping[str, str]) -> str:
    """All of it, as it is shown before it is saved."""
    return "\n\n".join(f"--- {name}\n{text}" for name, text in parts.items())


def save(parts: Mapping[str, str], target: Path) -> None:
    """Write the zip; raises InputError where that is refused."""
    with (
        file_written_aside(target) as aside,
        zipfile.ZipFile(aside, "w", zipfile.ZIP_DEFLATED) as out,
    ):
        for name, text in parts.items():
            entry = zipfile.ZipInfo(name)  # without the time of this machine
            entry.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(entry, text + "\n")
