"""The files for the desktop: valid by the desktop's own programs, and by each other."""

import configparser
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from app.bridge.languages import ENGLISH, NAMES
from hapticplayer import cli
from hapticplayer.extras.desktop import command
from hapticplayer.extras.desktop.man_page import man_page
from hapticplayer.shipped import shipped

FOLDER = shipped("resources/desktop")
METADATA = FOLDER / "org.hapticplayer.hapticplayer.metainfo.xml"
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"


def entry(path: Path = FOLDER / "hapticplayer.desktop") -> configparser.SectionProxy:
    parser = configparser.RawConfigParser()
    parser.optionxform = str
    parser.read(path, encoding="utf-8")
    return parser["Desktop Entry"]


@pytest.fixture
def installed(tmp_path, monkeypatch) -> Path:
    """Where the files of this user are, in a folder with a difficult name."""
    share = tmp_path / 'a "name" $HOME 100%'
    monkeypatch.setenv("XDG_DATA_HOME", str(share))
    assert cli.main(["desktop", "install"]) == 0
    return share


def checked(*command, may_warn=r"^$") -> None:
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not on this machine")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    remarks = re.findall(r"^[EW]: .*", done.stdout, re.MULTILINE)
    forbidden = [one for one in remarks if not re.search(may_warn, one)]
    is_right = done.returncode == 0 or (remarks and not forbidden)
    assert is_right, done.stdout + done.stderr


def test_the_desktop_entry_is_valid():
    checked("desktop-file-validate", str(FOLDER / "hapticplayer.desktop"))


def test_an_entry_for_a_user_is_valid_wherever_the_program_is(monkeypatch, tmp_path):
    monkeypatch.setattr(command, "own_command", lambda: Path('/x y"z$h`q/100%'))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    assert cli.main(["desktop", "install"]) == 0
    path = tmp_path / "applications" / "hapticplayer.desktop"
    checked("desktop-file-validate", str(path))
    assert entry(path)["Exec"] == r'"/x y\\"z\\$h\\`q/100%%" %F'


def test_the_metadata_is_valid():
    """Newer validators want a homepage, which the program does not have."""
    command = ("appstreamcli", "validate", "--no-net", str(METADATA))
    checked(*command, may_warn="url-homepage-missing")


def test_the_metadata_names_what_there_is():
    root = ET.parse(METADATA).getroot()
    launchable = root.findtext("launchable")
    assert (FOLDER / launchable).is_file()
    offered = {one.text for one in root.iterfind("provides/mediatype")}
    assert offered == own_kinds()


def own_kinds() -> set[str]:
    kinds = ET.parse(FOLDER / "hapticplayer.xml").getroot()
    return {kind.get("type") for kind in kinds.iterfind(f"{MIME}mime-type")}


def test_every_kind_of_file_of_its_own_is_opened():
    assert own_kinds() <= set(entry()["MimeType"].split(";"))


KINDS = {
    "sequence.json": (b"{}", "application/x-hapticplayer-sequence"),
    "study.json": (b"{}", "application/x-hapticplayer-study"),
    "ride.haptics.mkv": (b"", "video/x-hapticplayer"),
    "ride": (b"\x1aE\xdf\xa3 matroska hapticplayer.json", "video/x-hapticplayer"),
    "ride.hjif": (b"{}", "haptics/hjif"),
    "other.mkv": (b"\x1aE\xdf\xa3 matroska", "video/x-matroska"),
    "other.json": (b"{}", "application/json"),
}
ASK_QT = """
import sys
from PySide6.QtCore import QMimeDatabase
print(*(QMimeDatabase().mimeTypeForFile(one).name() for one in sys.argv[1:]))
"""


def test_a_desktop_knows_files_by_name_and_content(installed, tmp_path):
    for name, (content, _kind) in KINDS.items():
        (tmp_path / name).write_bytes(content)
    asked = (sys.executable, "-c", ASK_QT, *(tmp_path / name for name in KINDS))
    said = subprocess.run(asked, capture_output=True, text=True, check=True)
    assert said.stdout.split() == [kind for _content, kind in KINDS.values()]


def test_the_comment_is_in_every_language():
    for code in NAMES:
        assert entry()["Comment" if code == ENGLISH else f"Comment[{code}]"]


def test_the_installed_entry_starts_this_program(installed, capsys):
    path = installed / "applications" / "hapticplayer.desktop"
    assert entry(path)["Exec"] == f'"{command.own_command()}" %F'
    assert entry(path)["TryExec"] == str(command.own_command())


def test_removing_leaves_only_what_others_have_put_there(installed):
    for name in (*command.PLACES, command.MAN):
        assert (installed / name).is_file(), name
    other = installed / "applications" / "other.desktop"
    other.touch()
    assert cli.main(["desktop", "remove"]) == 0
    left = [
        path
        for path in installed.rglob("*")
        if path.is_file() and re.search("hapticplayer|hjif", path.name)
    ]
    assert left == []
    assert other.is_file()
    assert not (installed / "icons").exists()


def test_a_file_that_cannot_be_removed_is_named(installed, capsys):
    place = installed / command.MAN
    place.unlink()
    place.mkdir()
    assert cli.main(["desktop", "remove"]) == 1
    assert str(place) in capsys.readouterr().err


def test_a_kind_of_file_of_another_program_stays(installed, tmp_path):
    if shutil.which("update-mime-database") is None:
        pytest.skip("update-mime-database is not on this machine")
    theirs = installed / "mime" / "packages" / "theirs.xml"
    theirs.write_bytes((FOLDER / "hapticplayer.xml").read_bytes())
    assert cli.main(["desktop", "remove"]) == 0
    assert (installed / command.KEPT).is_file()


def test_the_man_page_has_every_command_and_option():
    page = man_page().replace(r"\-", "-")
    for name, words in (("play", "--allow-network"), ("study analyse", "--missing")):
        part = page.split(f'.SH "hapticplayer {name}"')[1].split(".SH")[0]
        assert words in part
    assert all(f'"hapticplayer {one.name}"' in page for one in cli.commands())


def test_the_description_file_of_a_sequence_opens_the_sequence(sequence):
    from hapticplayer.playback.source import open_source

    opened = open_source(sequence / "sequence.json")
    assert opened.path == sequence
    assert "realistic" in opened.tracks
