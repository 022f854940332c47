"""Of a real clip of a GoPro with GPS nothing personal goes along unless it is asked for."""

import re
import shutil

import pytest

from hapticplayer import cli

NAME = "Anna Elm Street 5"
TELLING = re.compile(
    rb"GLPI|GPRI|GPS5|GPSU|SYST|MUID|LENS|CAME|CASN|HD5\.02|Anna|Elm Street|2017-04|19:26:48"
)
"""Blocks of places, times and numbers of the camera, the file's name, the clip's date."""


@pytest.fixture(scope="module")
def ride(tmp_path_factory, shared_data):
    folder = tmp_path_factory.mktemp("places")
    clip = folder / f"{NAME}.mp4"
    shutil.copy(shared_data / "capture" / "gopro" / "karma.mp4", clip)
    assert {b"GLPI", b"GPRI", b"SYST", b"LENS"} <= told_by(clip)
    status = cli.main(
        ["import", str(clip), "--sync", "embedded", "-o", str(folder / "ride")]
    )
    assert status == 0
    return folder / "ride"


def told_by(path) -> set[bytes]:
    return set(TELLING.findall(path.read_bytes()))


def packed(ride, tmp_path, ending, *options):
    target = tmp_path / f"out.{ending}"
    assert cli.main(["pack", str(ride), "-o", str(target), *options]) == 0
    return set().union(*map(told_by, tmp_path.glob("out.*")))


@pytest.mark.parametrize("ending", ["mkv", "mp4"])
@pytest.mark.parametrize("options", [(), ("--with-motion",)])
def test_a_packed_ride_tells_no_place_name_or_date(
    ride, tmp_path, capsys, ending, options
):
    assert packed(ride, tmp_path, ending, *options) == set()
    said = capsys.readouterr().out
    assert (
        cli.main(
            [
                "pack",
                str(ride),
                "-o",
                str(tmp_path / f"b.{ending}"),
                "--dry-run",
                *options,
            ]
        )
        == 0
    )
    for text in (said, capsys.readouterr().out):
        assert f"left out, see --with-places: name of a file {NAME}.mp4" in text
        assert "left out, see --with-places: motion track of the camera" in text
        assert "left out, see --with-places: date 20" in text


@pytest.mark.parametrize("ending", ["mkv", "mp4"])
def test_places_that_were_asked_for_go_along_and_are_said(
    ride, tmp_path, capsys, ending
):
    told = packed(ride, tmp_path, ending, "--with-motion", "--with-places")
    places = {b"GLPI", b"GPRI", b"SYST"} if ending == "mp4" else set()
    assert told == {b"Anna", b"Elm Street", *places}
    said = capsys.readouterr().out
    assert f"included: name of a file {NAME}.mp4" in said
    assert ("included: motion track of the camera" in said) is (ending == "mp4")


@pytest.mark.parametrize("form", ["csv", "hjif", "wav", "mpegv", "funscript", "ahap"])
def test_an_exported_force_tells_no_name_or_date(ride, tmp_path, form):
    target = tmp_path / f"out.{form}"
    assert cli.main(["export", str(ride), "--format", form, "-o", str(target)]) == 0
    assert set().union(*map(told_by, tmp_path.glob("out*"))) == set()


@pytest.fixture(scope="module")
def study(ride, tmp_path_factory):
    folder = tmp_path_factory.mktemp("study") / "study"
    keys = ("bike", "horse", "car-turning", "car-braking")
    given = [word for key in keys for word in ("--sequence", f"{key}={ride}")]
    assert cli.main(["study", "new", str(folder), *given]) == 0
    assert cli.main(["study", "simulate", str(folder), "--participants", "1"]) == 0
    return folder


@pytest.mark.parametrize("form", ["csv", "excel", "bids", "xdf"])
def test_an_exported_study_tells_nothing_of_its_clips(study, tmp_path, form):
    out = tmp_path / form
    words = ["study", "export", str(study), "-o", str(out), "--format", form]
    assert cli.main(words) == 0
    files = [one for one in out.rglob("*") if one.is_file()]
    assert files
    assert set().union(*map(told_by, files)) == set()
