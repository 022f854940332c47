"""A study in a folder, and a manual clock."""

import json
from pathlib import Path

import pytest

from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.creation import TEMPLATES, create_study

VALUES = {"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1}
SHEET = {
    "age": 31,
    "gender": "female",
    "handedness": "left",
    "used_device_before": True,
}


@pytest.fixture
def study(tmp_path):
    return create_study(tmp_path / "study")


@pytest.fixture
def template() -> dict:
    """The built-in definition as JSON, to be changed."""
    return json.loads((TEMPLATES / "qoe2012.json").read_text(encoding="utf-8"))


@pytest.fixture
def scripted(manual_clock):
    """Write a simulated session, and return its code."""

    def write(study, rate=lambda _condition: VALUES) -> str:
        return write_scripted_session(
            study, SHEET, rate, manual_clock, origin={"scripted": True}
        )

    return write


def tree(folder: Path) -> dict[str, bytes]:
    """Return all files below a folder with their content."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }
