import re
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hapticplayer import installation, shipped
from hapticplayer.errors import InputError, Message
from hapticplayer.media.clip_info import probe
from hapticplayer.playback.snippet import pats_sound
from hapticplayer.playback.sound_ring import RATE_HZ
from hapticplayer.sequence.packed import read_packed

ROOT = shipped.ROOT
BUILD = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"][
    "hatch"
]["build"]["targets"]["wheel"]
PLACES = {
    place
    for folder in ("app", "hapticplayer")
    for path in (ROOT / folder).rglob("*.py")
    for place in re.findall(r'\bshipped\(\s*"([^"]+)"', path.read_text("utf-8"))
}


def test_each_shipped_file_is_in_the_tree_and_in_a_wheel() -> None:
    """A wheel holds the resources as they are, and what is copied into them."""
    assert len(PLACES) >= 6
    for place in PLACES:
        assert (ROOT / place).exists(), place
        copied = BUILD["force-include"]
        source = next((one for one in copied if f"{place}/".startswith(f"{one}/")), "")
        assert place.startswith("resources/") or copied[source] == f"resources/{source}"


def test_a_wheel_finds_its_files_below_resources(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(shipped, "ROOT", tmp_path)
    (tmp_path / "resources" / "docs").mkdir(parents=True)

    assert shipped.shipped("docs") == tmp_path / "resources" / "docs"
    assert shipped.shipped("resources/icons") == tmp_path / "resources" / "icons"


@pytest.mark.parametrize(
    ("marker", "command"),
    [
        ("pipx_metadata.json", "pipx inject hapticplayer pylsl"),
        ("uv-receipt.toml", f"uv pip install --python {sys.executable} pylsl"),
        ("pyvenv.cfg", f"{sys.executable} -m pip install pylsl"),
    ],
)
def test_an_extra_is_added_as_the_program_was_installed(
    monkeypatch, tmp_path, marker, command
) -> None:
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    (tmp_path / marker).touch()

    assert installation.how_to_get("lsl") == command


def test_the_debian_package_takes_extras_beside_it(monkeypatch) -> None:
    monkeypatch.setattr(sys, "prefix", "/usr/lib/hapticplayer")

    folder = Path("/usr/local/lib/hapticplayer") / "python{}.{}".format(
        *sys.version_info
    )
    assert installation.how_to_get("lsl").endswith(f"--target {folder} pylsl")


def test_an_extra_that_is_too_old_for_this_python_says_so(monkeypatch) -> None:
    cameras = replace(installation.EXTRAS["cameras"], newest=(3, 10))
    monkeypatch.setitem(installation.EXTRAS, "cameras", cameras)

    assert "exists for Python up to 3.10 only" in installation.how_to_get("cameras")


def test_work_without_its_extra_is_refused_with_the_command(monkeypatch) -> None:
    gone = replace(installation.EXTRAS["study"], packages={"gone": "gone-package"})
    monkeypatch.setitem(installation.EXTRAS, "study", gone)

    with pytest.raises(InputError, match="writing a report needs gone-package") as said:
        installation.require("study", Message("writing a report"))
    assert "-m pip install gone-package" in str(said.value)


def test_the_demo_is_small_and_moves_in_three_ways() -> None:
    """Cobbles, bends and a hard stop, each where the film shows it."""
    packed = read_packed(shipped.DEMO)
    assert shipped.DEMO.stat().st_size < 5_000_000
    assert packed is not None
    assert packed.sequence.motion is not None
    assert probe(packed.sequence.clip).duration_s == pytest.approx(30.0, abs=0.1)
    motion = packed.sequence.motion
    right, front, up = motion.acceleration_mps2.T
    cobbles, bend, stop = (
        (motion.time_s > begin_s) & (motion.time_s < end_s)
        for begin_s, end_s in ((10.0, 15.0), (17.8, 24.0), (26.3, 28.5))
    )
    assert np.std(up[cobbles]) > 2.0
    assert np.abs(right[bend]).max() > 4.0
    assert front[stop].min() < -6.0
    w, x, y, z = motion.quaternion_wxyz.T
    tilt_deg = np.degrees(np.arcsin(2.0 * (y * z + w * x)))  # of the camera, up
    nod_degps = np.gradient(tilt_deg, motion.time_s)
    assert np.std(nod_degps[cobbles]) > 2.0 * np.std(nod_degps[bend])


def test_the_demo_is_louder_on_cobbles() -> None:
    heard = pats_sound(shipped.DEMO, 10.0, 17.0, ())[:, 0]
    cobbles, asphalt = heard[: 5 * RATE_HZ], heard[round(5.6 * RATE_HZ) :]
    assert np.std(cobbles) > 1.5 * np.std(asphalt)
