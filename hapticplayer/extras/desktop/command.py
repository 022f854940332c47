"""`desktop install` and `desktop remove`: the files by which a desktop knows a program."""

import argparse
import contextlib
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from hapticplayer.cli.common import say
from hapticplayer.errors import InputError, shell_line
from hapticplayer.extras.desktop.man_page import man_page
from hapticplayer.shipped import IS_CLONE, ROOT, UDEV_RULE, shipped
from hapticplayer.storage import data_home

RESOURCES = shipped("resources/desktop")
ENTRY = "hapticplayer.desktop"
MAN = "man/man1/hapticplayer.1"
PLACES = {
    f"applications/{ENTRY}": RESOURCES / ENTRY,
    "metainfo/org.hapticplayer.hapticplayer.metainfo.xml": RESOURCES
    / "org.hapticplayer.hapticplayer.metainfo.xml",
    "mime/packages/hapticplayer.xml": RESOURCES / "hapticplayer.xml",
    "icons/hicolor/scalable/apps/hapticplayer.svg": shipped("resources/icons")
    / "hapticplayer.svg",
}
"""Places below `share`, and what is copied there."""

KEPT = "mime/haptics/hjif.xml"
"""What update-mime-database makes and forgets to remove, as no other type is haptics/."""

_CACHES = (
    ("update-mime-database", "mime"),
    ("update-desktop-database", "applications"),
)
_QUOTED = re.compile(r'(["`$\\])')


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the actions of the command."""
    actions = parser.add_subparsers(metavar="ACTION", required=True)
    for name, run, text in (
        ("install", install, "add entry, icon, kinds of files and man page"),
        ("remove", remove, "remove them again"),
    ):
        action = actions.add_parser(
            name, help=text, description=f"{text.capitalize()}."
        )
        action.set_defaults(run=lambda options, _window, run=run: run(options.prefix))
        action.add_argument(
            "--prefix",
            type=Path,
            metavar="DIR",
            help="for packages: below DIR/share, starting whatever `hapticplayer` is, "
            "and no cache of the desktop is updated (default: for this user)",
        )


def install(prefix: Path | None) -> int:
    """Write the files, over older ones of this program."""
    share = share_of(prefix)
    texts = {place: path.read_text("utf-8") for place, path in PLACES.items()}
    texts[MAN] = man_page()
    if prefix is None:
        place = f"applications/{ENTRY}"
        texts[place] = starting(texts[place], own_command())
    for place, text in texts.items():
        _write(share / place, text)
    if prefix is None:
        _update_caches(share)
        rule = shell_line("cp", UDEV_RULE, "/etc/udev/rules.d")
        say(f"installed below {share}; for a Falcon also, as root: {rule}")
    return 0


def remove(prefix: Path | None) -> int:
    """Remove the files, and the folders that become empty."""
    share = share_of(prefix)
    paths = [share / place for place in (*PLACES, MAN)]
    for path in (*paths, share / KEPT):
        with _named(path):
            path.unlink(missing_ok=True)
    if prefix is None:
        _update_caches(share)  # which makes KEPT anew where others have that type, too
        say(f"removed below {share}")
    for path in (*paths, share / KEPT):
        with contextlib.suppress(OSError):  # the first that holds something else
            for folder in _folders_between(path, share):
                folder.rmdir()
    return 0


def share_of(prefix: Path | None) -> Path:
    if prefix is not None:
        return prefix / "share"
    return data_home().parent


def own_command() -> Path:
    """What starts this installation, whatever the PATH of the desktop is."""
    if IS_CLONE:  # it sets up what is missing
        return ROOT / "run"
    beside = Path(sys.executable).with_name("hapticplayer")
    return beside if beside.is_file() else Path(shutil.which("hapticplayer") or beside)


def starting(entry: str, command: Path) -> str:
    """A desktop entry that starts a command by its path."""
    quoted = _QUOTED.sub(r"\\\1", str(command)).replace("%", "%%")
    quoted = quoted.replace("\\", r"\\")  # of the value, behind those of the argument
    entry = entry.replace("Exec=hapticplayer ", f'Exec="{quoted}" ')
    return entry.replace("TryExec=hapticplayer", f"TryExec={command}")


def _write(path: Path, text: str) -> None:
    with _named(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


@contextlib.contextmanager
def _named(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as problem:
        raise InputError(
            "cannot be written ({reason})",
            where=str(path),
            remedy="choose another folder (--prefix)",
            reason=problem,
        ) from problem


def _folders_between(path: Path, top: Path) -> Iterator[Path]:
    yield from (one for one in path.parents if top in one.parents)


def _update_caches(share: Path) -> None:
    """What a desktop keeps of these files; where the programs are missing it looks itself."""
    for program, folder in _CACHES:
        if (share / folder).is_dir() and (found := shutil.which(program)):
            subprocess.run([found, share / folder], check=False, capture_output=True)
