"""The files that come with the program, in a clone and in a wheel."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IS_CLONE = (ROOT / "run").is_file()


def shipped(place: str) -> Path:
    """A file or folder by its place in the source tree; a wheel has all in resources."""
    inside = ROOT / "resources" / place
    return inside if inside.exists() else ROOT / place


UDEV_RULE = shipped("packaging/udev/70-novint-falcon.rules")

DEMO = shipped("resources/demo.mkv")
"""A packed ride, made by `tools.demo`."""
