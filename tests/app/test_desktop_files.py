"""The files for the desktop: valid by the desktop's own programs, and by each other."""

import configparser
import re
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from app.bridge.languages import ENGLISH, NAMES
from hapticplayer import __version__

FOLDER = Path(__file__).resolve().parents[2] / "packaging" / "desktop"
METADATA = FOLDER / "org.hapticplayer.hapticplayer.metainfo.xml"
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"


def entry(name: str) -> configparser.SectionProxy:
    parser = configparser.RawConfigParser()
    parser.optionxform = str
    parser.read(FOLDER / f"{name}.desktop", encoding="utf-8")
    return parser["Desktop Entry"]


def checked(*command, may_warn=r"^$") -> None:
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not on this machine")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    remarks = re.findall(r"^[EW]: .*", done.stdout, re.MULTILINE)
    forbidden = [one for one in remarks if not re.search(may_warn, one)]
    is_right = done.returncode == 0 or (remarks and not forbidden)
    assert is_right, done.stdout + done.stderr


@pytest.mark.parametrize("name", ["hapticplayer", "hapticplayer-open"])
def test_the_desktop_entries_are_valid(name):
    checked("desktop-file-validate", str(FOLDER / f"{name}.desktop"))


def test_the_metadata_is_valid():
    """Newer validators want a homepage, which the program does not have."""
    command = ("appstreamcli", "validate", "--no-net", str(METADATA))
    checked(*command, may_warn="url-homepage-missing")


def test_the_metadata_names_what_there_is():
    root = ET.parse(METADATA).getroot()
    launchable = root.findtext("launchable")
    assert (FOLDER / launchable).is_file()
    assert root.find("releases/release").get("version") == __version__
    offered = entry("hapticplayer-open")["MimeType"].split(";")
    assert root.findtext("provides/mediatype") in offered


def test_the_mime_type_of_a_sequence_is_the_one_that_is_opened():
    kind = ET.parse(FOLDER / "hapticplayer-mime.xml").getroot().find(f"{MIME}mime-type")
    assert kind.get("type") in entry("hapticplayer-open")["MimeType"].split(";")
    assert kind.find(f"{MIME}glob").get("pattern") == "sequence.json"


def test_the_comment_is_in_every_language():
    for name in ("hapticplayer", "hapticplayer-open"):
        for code in NAMES:
            key = "Comment" if code == ENGLISH else f"Comment[{code}]"
            assert entry(name)[key]


def test_the_entries_start_commands_that_there_are(capsys):
    from hapticplayer import cli

    assert entry("hapticplayer")["Exec"] == "hapticplayer"
    _, command, file = entry("hapticplayer-open")["Exec"].split()
    assert file == "%f"
    assert cli.main([command, "--help"]) == 0
    assert "SEQUENCE" in capsys.readouterr().out


def test_the_installer_puts_every_file_in_its_place(tmp_path):
    subprocess.run(
        ["bash", FOLDER / "install.sh", tmp_path], check=True, capture_output=True
    )
    share = tmp_path / "share"
    for place in (
        "applications/hapticplayer.desktop",
        "applications/hapticplayer-open.desktop",
        "metainfo/org.hapticplayer.hapticplayer.metainfo.xml",
        "mime/packages/hapticplayer.xml",
        "icons/hicolor/scalable/apps/hapticplayer.svg",
    ):
        assert (share / place).is_file(), place


def test_the_description_file_of_a_sequence_opens_the_sequence(sequence):
    from hapticplayer.playback.source import open_source

    opened = open_source(sequence / "sequence.json")
    assert opened.path == sequence
    assert "realistic" in opened.tracks
