import ast
import json
import os
import re
import socket
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from hapticplayer import doctor, errors, facilities, installation, linux, shipped
from hapticplayer.facilities import FACILITIES
from hapticplayer.linux import GUARD_PRIORITY

RUN_PACKAGES = [
    package for package in doctor.read_apt_list() if package.group in doctor.RUN_GROUPS
]
NOT_FOUND = "cannot open shared object file: No such file or directory"


@pytest.fixture
def lack(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Pretend that these packages are missing, and no other."""

    def pretend(*names: str) -> None:
        proofs = {each.proof for each in RUN_PACKAGES if each.name in names}
        monkeypatch.setattr(doctor, "is_there", lambda proof: proof not in proofs)

    return pretend


@pytest.fixture
def listener(tmp_path: Path) -> Iterator[Path]:
    """A local socket that answers."""
    path = tmp_path / "socket"
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(str(path))
        server.listen()
        yield path


def _missing_library(soname: str, package: str) -> str:
    command = f"apt-get install --no-install-recommends {package}"
    return f"The system library {soname} is missing; install it with: {command}"


def _by_name(name: str) -> doctor.MachineCheck:
    return next(each for each in doctor.check() if each.name == name)


@pytest.mark.parametrize("package", RUN_PACKAGES, ids=lambda each: each.name)
def test_a_missing_package_is_named(lack, capsys, package) -> None:
    lack(package.name)

    status = doctor.main([])

    assert doctor.missing_apt() == [package.name]
    assert _by_name(package.name).remedy == f"{doctor.APT_INSTALL} {package.name}"
    assert f"{doctor.APT_INSTALL} {package.name}\n" in capsys.readouterr().out
    assert status == (1 if package.required else 0)


def test_all_missing_packages_stand_in_one_command(lack, capsys) -> None:
    lack("libgl1", "libportaudio2", "libxcb-cursor0")

    assert doctor.main([]) == 1

    command = f"{doctor.APT_INSTALL} libxcb-cursor0 libgl1 libportaudio2\n"
    assert command in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["--missing-apt"], "libgl1 libportaudio2\n"),
        (["--missing-apt", "required"], "libgl1\n"),
        (["--missing-apt", "optional"], "libportaudio2\n"),
    ],
)
def test_missing_apt_prints_names_in_one_line(lack, capsys, arguments, line) -> None:
    lack("libgl1", "libportaudio2")

    assert doctor.main(arguments) == 0
    assert capsys.readouterr().out == line


def test_groups_choose_what_is_looked_for(monkeypatch) -> None:
    monkeypatch.setattr(doctor, "is_there", lambda _proof: False)

    assert doctor.missing_apt(["sound"]) == ["libportaudio2", "libasound2-plugins"]
    assert "mpv" not in doctor.missing_apt()
    assert "mpv" in doctor.missing_apt(["benchmarks"])


def test_json_holds_every_check_and_the_verdict(lack, capsys) -> None:
    lack("libegl1")

    assert doctor.main(["--json"]) == 1

    report = json.loads(capsys.readouterr().out)
    assert report["ok"] is False
    assert report["missing_apt"] == ["libegl1"]
    assert len(report["checks"]) == len(doctor.check())
    assert {"name", "ok", "required", "detail", "remedy"} == set(report["checks"][0])


def test_a_missing_python_package_is_named(monkeypatch, lack, capsys) -> None:
    lack()
    monkeypatch.setitem(doctor.PYTHON_PACKAGES, "gone", "gone-package")

    assert doctor.main([]) == 1
    assert "missing: gone-package: ./run sets them up" in capsys.readouterr().out


@pytest.mark.parametrize("name", sorted(installation.EXTRAS))
def test_a_missing_extra_is_named_with_what_it_brings(
    monkeypatch, lack, capsys, name
) -> None:
    lack()
    extra = replace(installation.EXTRAS[name], packages={"gone": "gone-package"})
    monkeypatch.setitem(installation.EXTRAS, name, replace(extra, newest=()))

    assert doctor.main([]) == 0
    said = capsys.readouterr().out
    assert f"[{name}]" in said
    assert extra.without in said
    assert f"{sys.executable} -m pip install gone-package" in said


def test_python_packages_are_those_of_the_project() -> None:
    project = tomllib.loads((doctor.ROOT / "pyproject.toml").read_text())["project"]
    wanted = {re.split(r"[<>=;]", each)[0] for each in project["dependencies"]}
    optional = {
        name: sorted(re.split(r"[<>=;]", each)[0] for each in packages)
        for name, packages in project["optional-dependencies"].items()
        if name != "dev"
    }

    assert set(doctor.PYTHON_PACKAGES.values()) == wanted
    assert optional == {
        name: sorted(extra.packages.values())
        for name, extra in installation.EXTRAS.items()
    }


def test_the_file_runs_alone_on_a_bare_python(tmp_path) -> None:
    command = [sys.executable, "-I", "-S", doctor.__file__, "--json"]
    result = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True, check=False
    )

    assert json.loads(result.stdout)["checks"][0]["name"] == "Python"
    assert result.stderr == ""


@pytest.mark.parametrize(
    "module", [doctor, errors, installation, shipped, facilities, linux]
)
def test_the_doctor_needs_only_the_standard_library(module) -> None:
    source = Path(module.__file__).read_text(encoding="utf-8")
    imported = set()
    for node in ast.walk(ast.parse(source, feature_version=(3, 9))):
        if isinstance(node, ast.Import):
            imported |= {each.name.partition(".")[0] for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            imported.add(node.module)

    assert imported - {
        "hapticplayer",
        "hapticplayer.errors",
        "hapticplayer.facilities",
        "hapticplayer.installation",
        "hapticplayer.linux",
        "hapticplayer.shipped",
        "collections.abc",
        "importlib.machinery",
    } <= (sys.stdlib_module_names)


@pytest.mark.parametrize(
    ("proof", "there"),
    [
        ("lib:libc.so.6", True),
        ("lib:libnothing.so.1", False),
        ("module:json", True),
        ("module:nothing_of_this_name", False),
        ("file:/pro*/self/stat", True),
        ("file:/proc/self/no-*", False),
        ("command:sh", True),
        ("command:no-such-command", False),
        ("python:3.11", True),
        ("python:4.0", False),
    ],
)
def test_proofs_look_at_the_machine(proof, there) -> None:
    assert doctor.is_there(proof) is there


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        (
            ImportError(f"libGL.so.1: {NOT_FOUND}"),
            _missing_library("libGL.so.1", "libgl1"),
        ),
        (
            ImportError(f"libxcb-cursor.so.0: {NOT_FOUND}"),
            _missing_library("libxcb-cursor.so.0", "libxcb-cursor0"),
        ),
        (
            OSError(f"cannot load library 'libz': libportaudio.so.2: {NOT_FOUND}"),
            _missing_library("libportaudio.so.2", "libportaudio2"),
        ),
        (
            OSError("PortAudio library not found"),
            _missing_library("libportaudio.so.2", "libportaudio2"),
        ),
        (
            ImportError(f"libstrange.so.3: {NOT_FOUND}"),
            "The system library libstrange.so.3 is missing, and no package is known for it.",
        ),
        (
            ModuleNotFoundError("No module named 'usb.core'", name="usb.core"),
            "The Python package pyusb is missing; ./run sets it up in .venv.",
        ),
        (
            ImportError("libm.so.6: version `GLIBC_2.38' not found (required by x)"),
            "This system is too old for the program: it has no GLIBC_2.38.",
        ),
        (
            ImportError("undefined symbol: foo"),
            "A part of the program could not be loaded: undefined symbol: foo.",
        ),
    ],
)
def test_import_errors_are_explained(error, sentence) -> None:
    assert doctor.explain_import_error(error) == sentence


@pytest.mark.parametrize(
    ("environment", "is_refused"),
    [
        ({"DISPLAY": ":0"}, True),
        ({"QT_QPA_PLATFORM": "xcb"}, True),
        ({"DISPLAY": ":0", "WAYLAND_DISPLAY": "wayland-0"}, False),
        ({"QT_QPA_PLATFORM": "offscreen"}, False),
    ],
)
def test_a_window_that_qt_would_abort_is_refused(
    monkeypatch, lack, capsys, environment, is_refused
) -> None:
    lack("libxcb-cursor0", "libxcb-icccm4", "libportaudio2")
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)

    said = doctor.missing_for_window()

    assert bool(said) is is_refused
    if is_refused:
        assert said.endswith(f"{doctor.APT_INSTALL} libxcb-cursor0 libxcb-icccm4")


def test_a_display_that_answers_is_found(monkeypatch, listener) -> None:
    monkeypatch.setenv("WAYLAND_DISPLAY", str(listener))
    monkeypatch.delenv("DISPLAY", raising=False)

    assert _by_name("display").ok


@pytest.mark.parametrize("display", [":4094", "nonsense", ":", ":x.0"])
def test_a_silent_display_is_not_a_display(monkeypatch, display) -> None:
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setenv("DISPLAY", display)

    check = _by_name("display")

    assert not check.ok
    assert "is silent" in check.detail


def test_a_sound_server_that_answers_is_found(monkeypatch, listener) -> None:
    monkeypatch.setenv("PULSE_SERVER", f"unix:{listener}")

    assert "server answers" in _by_name("sound").detail


def test_no_sound_is_said_but_not_required(monkeypatch, tmp_path) -> None:
    monkeypatch.setenv("PULSE_SERVER", str(tmp_path / "none"))
    monkeypatch.setattr(doctor, "SOUND_CARDS", tmp_path / "cards")

    check = _by_name("sound")

    assert (check.ok, check.required) == (False, False)


def test_a_sound_card_is_found(monkeypatch, tmp_path) -> None:
    monkeypatch.setenv("PULSE_SERVER", str(tmp_path / "none"))
    monkeypatch.setattr(doctor, "SOUND_CARDS", tmp_path / "cards")
    (tmp_path / "cards").write_text(" 0 [PCH            ]: HDA-Intel - HDA Intel PCH\n")

    assert "sound card" in _by_name("sound").detail


def test_asking_for_the_scheduling_leaves_it_as_it_was() -> None:
    before = os.sched_getscheduler(0)

    doctor.check()

    assert os.sched_getscheduler(0) == before


def test_a_falcon_on_usb_is_found(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(doctor, "USB_DEVICES", tmp_path)
    assert _by_name("Falcon").detail == "none on USB"

    device = tmp_path / "1-2"
    device.mkdir()
    values = {"idVendor": "0403", "idProduct": "cb48", "busnum": "1", "devnum": "12"}
    for name, value in values.items():
        (device / name).write_text(f"{value}\n")

    check = _by_name("Falcon")

    assert check.detail.startswith("/dev/bus/usb/001/012")
    assert not check.required


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("cpu-latency", "udev"),
        ("fifo", f"rtprio {GUARD_PRIORITY}"),
        ("mlock", "memlock"),
    ],
)
def test_a_right_that_this_user_lacks_names_who_gives_it(monkeypatch, name, remedy):
    refused = FACILITIES[name]._replace(is_granted=lambda: False)
    monkeypatch.setitem(FACILITIES, name, refused)
    check = _by_name(name)
    assert check.detail == refused.without
    assert remedy in check.remedy
    monkeypatch.setitem(FACILITIES, name, refused._replace(is_granted=lambda: True))
    assert _by_name(name).ok
