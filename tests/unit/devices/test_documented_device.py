"""The device of docs/devices.md, installed as a stranger's package."""

import re
import sys
import tomllib
from pathlib import Path

import pytest

from hapticplayer import extension
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.devices.guides import checks_of, guide_of
from hapticplayer.errors import DeviceError

TEXT = (Path(__file__).parents[3] / "docs/devices.md").read_text(encoding="utf-8")
DEVICE, ROWS, PAGE = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
(PROJECT,) = re.findall(r"```toml\n(.*?)```", TEXT, re.DOTALL)


@pytest.fixture
def seat(tmp_path, monkeypatch):
    """The entry, once the package is installed as its pyproject.toml says."""
    project = tomllib.loads(PROJECT)["project"]
    about = tmp_path / f"{project['name']}-{project['version']}.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(
        "Name: {name}\nVersion: {version}\n".format(**project)
    )
    ((group, points),) = project["entry-points"].items()
    lines = [f"[{group}]", *(f"{name} = {where}" for name, where in points.items())]
    (about / "entry_points.txt").write_text("\n".join(lines))
    for name, text in zip(
        tomllib.loads(PROJECT)["tool"]["setuptools"]["py-modules"],
        (DEVICE + ROWS, PAGE),
        strict=True,
    ):
        (tmp_path / f"{name}.py").write_text(text)
    monkeypatch.syspath_prepend(str(tmp_path))
    extension.forget()
    installed_devices.cache_clear()
    yield find_device("seat:127.0.0.1:4999")
    for name in ("seat", "seat_page"):
        sys.modules.pop(name, None)
    extension.forget()
    installed_devices.cache_clear()


def test_the_documented_device_is_offered_with_its_address(seat):
    assert "seat" in installed_devices()
    assert seat.make(-1).options.address == "127.0.0.1:4999"
    assert seat.capabilities.axes == 2
    assert seat.silence(-1)()
    with pytest.raises(DeviceError, match="not HOST:PORT"):
        find_device("seat:here")


def test_the_documented_page_says_what_the_device_needs(seat):
    assert guide_of(seat).hold == "Sit down, and fasten the belt."
    (check,) = checks_of(seat)
    assert "127.0.0.1:4999" in check.what
    assert (check.is_met, check.remedy) == (False, "Switch it on.")
