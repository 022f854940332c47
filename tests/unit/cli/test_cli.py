"""The table of commands, and what each of them loads."""

import json
import subprocess
import sys

import pytest

from hapticplayer import cli
from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.capabilities import FALCON

WOOD = DeviceEntry("wood", "a Falcon of wood", FALCON, "wood:make", "wood:silence")


_PRINT_MODULES = (
    "import json, sys; print(json.dumps(sorted(sys.modules)), file=sys.stderr)"
)


class Point:
    """An entry point as an installed package would have it."""

    value = "wood:ENTRY"

    def __init__(self, loaded: object = WOOD) -> None:
        self.load = lambda: loaded


def modules_after(code: str) -> set[str]:
    """Return what a new interpreter has loaded after some code."""
    result = subprocess.run(
        [
            sys.executable,
            "-c",
            f"{code}\n{_PRINT_MODULES}",
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    return set(json.loads(result.stderr.splitlines()[-1]))


@pytest.mark.parametrize("command", cli.COMMANDS)
def test_every_command_has_help(command, capsys):
    with pytest.raises(SystemExit) as ended:
        cli.main([command.name, "--help"])
    assert ended.value.code == 0
    assert f"usage: hapticplayer {command.name}" in capsys.readouterr().out


def test_help_and_doctor_need_the_standard_library_only():
    code = (
        "import contextlib\nfrom hapticplayer import cli\n"
        "with contextlib.suppress(SystemExit): cli.main(['--help'])\n"
        "cli.main(['doctor', '--json'])"
    )
    assert not modules_after(code) & {"numpy", "av", "PySide6", "scipy"}


def test_playing_a_sequence_loads_nothing_that_pretends(sequence_folder):
    code = (
        "from hapticplayer import cli\n"
        f"cli.main(['play', {str(sequence_folder)!r}, '--headless', '--mute',"
        " '--device', 'none', '--duration', '0.2'])"
    )
    loaded = modules_after(code)
    assert "hapticplayer.playback.player" in loaded
    assert not {name for name in loaded if name.startswith("hapticplayer.simulation")}
    assert not loaded & {"scipy", "vqf", "matplotlib", "hapticplayer.motion"}


def test_an_installed_device_is_offered_everywhere(monkeypatch, capsys, qapp):
    from app.player.choices import devices

    monkeypatch.setattr("importlib.metadata.entry_points", lambda **_: [Point()])
    with pytest.raises(SystemExit):
        cli.main(["play", "--help"])
    assert "wood" in capsys.readouterr().out
    assert cli.main(["device", "list"]) == 0
    assert "a Falcon of wood" in capsys.readouterr().out
    assert "wood" in [choice.name for choice in devices()]


def test_an_entry_point_that_is_no_device_is_told(monkeypatch, capsys):
    monkeypatch.setattr("importlib.metadata.entry_points", lambda **_: [Point(1)])
    assert cli.main(["device", "list"]) == 1
    assert "'wood:ENTRY' cannot be loaded" in capsys.readouterr().err
