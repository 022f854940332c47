"""Installs what lies beside this file for one user; `install.sh` finds the Python for it.

Standard library only, without pip: a wheel is a zip. Each is compared with SHA256SUMS
before anything is written.
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MARK = "hapticplayer-offline"
"""File in the folder that is installed; no other folder is removed."""


def main() -> int:
    """Install or remove; return the exit status."""
    parser = argparse.ArgumentParser(prog="install.sh", description=__doc__)
    parser.add_argument("folder", nargs="?", default="~/.local/lib/hapticplayer")
    parser.add_argument("--remove", action="store_true")
    options = parser.parse_args()
    folder = Path(options.folder).expanduser().absolute()
    if folder.exists() and not (folder / MARK).is_file():
        return complain(f"{folder} holds something else; name another folder")
    return remove(folder) if options.remove else install(folder)


def install(folder: Path) -> int:
    """Make an environment of this Python with the wheels for it."""
    try:
        wheels = [path for path in checked_wheels() if suits(path.name)]
    except ValueError as problem:
        return complain(str(problem))
    if folder.exists():
        shutil.rmtree(folder)
    venv.create(folder, with_pip=False, symlinks=True)
    (folder / MARK).touch()
    version = "python{}.{}".format(*sys.version_info)
    for wheel in wheels:
        with zipfile.ZipFile(wheel) as file:
            file.extractall(folder / "lib" / version / "site-packages")
    command = folder / "bin" / "hapticplayer"
    command.write_text(
        f'#!/bin/sh\nexec "{folder}/bin/python3" -P -m app "$@"\n', encoding="utf-8"
    )
    command.chmod(0o755)
    link = own_link()
    link.parent.mkdir(parents=True, exist_ok=True)
    if not link.exists() or link.is_symlink():
        link.unlink(missing_ok=True)
        link.symlink_to(command)
    subprocess.run([command, "desktop", "install"], check=True)
    print(f"installed in {folder}; start it with {link}", flush=True)
    if str(link.parent) not in os.environ.get("PATH", "").split(":"):
        print(f"log in again, or add {link.parent} to PATH, to type its name only")
    return subprocess.run([command, "doctor"], check=False).returncode


def remove(folder: Path) -> int:
    """Take everything away again."""
    if not folder.exists():
        return complain(f"{folder} is not there")
    subprocess.run([folder / "bin/hapticplayer", "desktop", "remove"], check=False)
    link = own_link()
    if link.is_symlink() and folder in link.readlink().parents:
        link.unlink()
    shutil.rmtree(folder)
    print(f"removed {folder}")
    return 0


def own_link() -> Path:
    return Path.home() / ".local" / "bin" / "hapticplayer"


def checked_wheels() -> list[Path]:
    """All wheels, whose checksums are as listed.

    Raises:
        ValueError: one is missing or damaged.
    """
    wheels = []
    for line in (HERE / "SHA256SUMS").read_text(encoding="utf-8").splitlines():
        digest, _, name = line.partition("  ")
        path = HERE / name
        content = path.read_bytes() if path.is_file() else b""
        if hashlib.sha256(content).hexdigest() != digest:
            raise ValueError(f"{path} is missing or damaged; copy the archive again")
        wheels.append(path)
    return wheels


def suits(wheel: str) -> bool:
    """Whether a wheel is for this Python; platforms were chosen when it was fetched."""
    python, abi = wheel.removesuffix(".whl").split("-")[-3:-1]
    return abi in ("none", "abi3") or python == "cp{}{}".format(*sys.version_info)


def complain(sentence: str) -> int:
    print(f"install.sh: {sentence}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
