"""The table of commands, and what each of them loads."""

import json
import re
import shlex
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.player import choices
from app.player.device_form import kinds
from hapticplayer import cli, extension, rendering
from hapticplayer.cli import export, play
from hapticplayer.devices import find_device, installed_devices
from hapticplayer.devices.guides import guide_of
from hapticplayer.errors import Message
from hapticplayer.model.ranges import Range
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.source import open_source
from hapticplayer.rendering import (
    FeedbackCondition,
    Parameter,
    ParameterKind,
    feedback,
)
from hapticplayer.sequence import editing, open_sequence, store
from hapticplayer.sequence.build import write_sequence
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.session_setup import load_study_sources
from tests.needed_extras import needs

KEYS, SHARE = ("bike", "horse", "car-turning", "car-braking"), Range(0.0, 1.0)

SEAT = """
from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import Message

ENTRY = DeviceEntry(
    "falcon-seat",  # by its name only is it a Falcon
    Message("Seat"), "a seat by UDP", FALCON, "seat:make", "", guide="page:GUIDE"
)


def devices():
    return (ENTRY,)
"""
COMMAND = """
from hapticplayer.cli import Command


def commands():
    return (
        Command("shake", "shakes", "seat"),
        Command("play", "plays otherwise", "seat"),
    )


def add_options(command):
    command.add_argument("what")
    command.set_defaults(run=lambda options, window: print(options.what) or 0)
"""
PAGE = """
from hapticplayer.devices.checks import Check
from hapticplayer.devices.guides import Guide
from hapticplayer.errors import Message

NEEDS = (Check(Message("Ticket"), False, Message("Pay it.")),)
GUIDE = Guide(Message("A seat by UDP."), Message("Push it in."), checks=lambda _: NEEDS)
"""


@pytest.fixture
def install(tmp_path, monkeypatch):
    """Install a package beside this program that offers a device."""

    def install_with(text: str) -> None:
        about = tmp_path / "seat-1.0.dist-info"
        about.mkdir()
        (about / "METADATA").write_text("Name: seat\nVersion: 1.0\n")
        (about / "entry_points.txt").write_text(
            "[hapticplayer.extensions]\nseat = seat\n"
        )
        (tmp_path / "seat.py").write_text(text)
        (tmp_path / "page.py").write_text(PAGE)
        monkeypatch.syspath_prepend(str(tmp_path))
        extension.forget()
        installed_devices.cache_clear()

    yield install_with
    for name in ("seat", "page"):
        sys.modules.pop(name, None)
    extension.forget()
    installed_devices.cache_clear()


_PRINT_MODULES = (
    "import json, sys; print(json.dumps(sorted(sys.modules)), file=sys.stderr)"
)


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


@pytest.mark.parametrize("command", list(cli.commands()))
def test_every_command_has_help(command, capsys):
    assert cli.main([command.name, "--help"]) == 0
    assert f"usage: hapticplayer {command.name}" in capsys.readouterr().out


@pytest.mark.parametrize("command", tuple(cli.commands()), ids=lambda one: one.name)
def test_each_example_in_help_is_a_command_line(command, capsys):
    for example in command.examples:
        words = [command.name, *shlex.split(example)]
        assert callable(cli.build_parser(command.name).parse_args(words).run)
        assert cli.main([command.name, "--help"]) == 0
        assert f"  hapticplayer {command.name} {example}\n" in capsys.readouterr().out


def test_no_help_of_an_option_begins_in_mid_sentence():
    """The generated reference has every option of every command and action."""
    text = (
        Path(__file__)
        .parents[3]
        .joinpath("docs/reference.md")
        .read_text(encoding="utf-8")
    )
    options = re.findall(r"^- `-[^:]*`: (.*)", text, re.MULTILINE)
    assert len(options) > 100
    assert [one for one in options if one.startswith("of ")] == []


def test_options_of_import_stand_in_groups(capsys):
    """Nobody reads thirty options in a row."""
    assert cli.main(["import", "--help"]) == 0
    groups = re.split(r"^(\S.*):$", capsys.readouterr().out, flags=re.MULTILINE)
    sizes = {
        title: len(re.findall(r"^  -", text, re.MULTILINE))
        for title, text in zip(groups[1::2], groups[2::2], strict=True)
    }
    assert {"motion log", "synchronisation", "motion", "force"} <= set(sizes)
    assert max(sizes.values()) <= 10


def test_formats_of_logs_are_listed_in_one_document_only(capsys):
    for name in ("import", "sync", "process"):
        assert cli.main([name, "--help"]) == 0
        assert "razor-m0" not in capsys.readouterr().out


def test_a_device_may_be_named_without_its_option(capsys):
    said = []
    for words in (["simulated"], ["--device", "simulated"]):
        assert cli.main(["device", "info", *words, "--json"]) == 0
        said.append(json.loads(capsys.readouterr().out)["device"])
    assert said == ["simulated"] * 2
    assert cli.main(["device", "info", "simulated", "--device", "shaker"]) == 2
    assert "not allowed with" in capsys.readouterr().err


def test_help_and_doctor_need_the_standard_library_only():
    code = (
        "from hapticplayer import cli\ncli.main(['--help'])\n"
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
    pretending = ("hapticplayer.simulation", "hapticplayer.extras.rides.rec")
    assert not {name for name in loaded if name.startswith(pretending)}
    assert not loaded & {"scipy", "vqf", "matplotlib", "hapticplayer.motion"}


def test_an_installed_device_is_offered_everywhere(install, capsys, qapp):
    install(SEAT)
    assert cli.main(["play", "--help"]) == 0
    assert "seat" in capsys.readouterr().out
    assert cli.main(["device", "list"]) == 0
    assert "a seat by UDP" in capsys.readouterr().out
    assert "Seat" in [choice.text for choice in choices.devices()]
    assert "Seat" in [choice.text for choice in kinds()]
    assert "Push it in." in guide_of(find_device("falcon-seat")).connect
    assert cli.main(["device", "info", "--device", "falcon-seat"]) == 0
    said = capsys.readouterr().out.split("\n")
    (need,) = [row for row in said if "Ticket" in row]
    assert need.split() == ["missing", "Ticket"]
    assert said[said.index(need) + 1].strip() == "Pay it."


@pytest.mark.parametrize(
    "device", ["simulated", pytest.param("rig:outsim", marks=needs("rigs"))]
)
def test_capabilities_of_a_device_are_printed(capsys, device):
    assert cli.main(["device", "info", "--device", device]) == 0
    said = capsys.readouterr().out
    assert "latency_s" in said
    assert cli.main(["device", "info", "--device", device, "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["capabilities"]["signal"] in said
    assert all(need["what"] in said for need in report["needs"])


@pytest.mark.parametrize("scheme", ["https", "ftp"])
def test_an_address_without_its_extra_is_refused(monkeypatch, capsys, scheme):
    monkeypatch.setattr(extension, "rows", lambda _kind, _of, own=(): iter(own))
    words = [f"{scheme}://example.org/s3cret.mkv", "--allow-network"]
    assert cli.main(["play", "--headless", *words]) == 2
    said = capsys.readouterr().err
    assert f"plays addresses that begin with {scheme}://; download" in said
    assert "s3cret" not in said


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("def devices():\n    return (1,)", "devices() has 1, not a DeviceEntry"),
        ("def devices():\n    return 1 / 0", "division by zero"),
        ("import no_such_seat", "No module named 'no_such_seat'"),
        ("a seat", "invalid syntax"),
    ],
)
def test_a_broken_extension_is_reported_and_left_out(install, capsys, text, why):
    install(text)
    assert cli.main(["device", "list"]) == 0
    said = capsys.readouterr()
    assert f"the extension 'seat' cannot be used: {why}" in said.err
    assert "falcon" in said.out
    assert cli.main(["device", "list"]) == 0
    assert not capsys.readouterr().err  # it is said once


def test_an_installed_command_is_run_and_cannot_replace_one(install, capsys):
    install(COMMAND)
    assert cli.main(["shake", "hands"]) == 0
    assert cli.main(["--help"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("hands\n")
    assert "shakes" in said
    assert "plays otherwise" not in said


def test_a_new_feedback_condition_is_offered_everywhere(
    monkeypatch, capsys, tmp_path, tiny_clip, recording, qapp
):
    half = FeedbackCondition(
        "half",
        Message("Half"),
        lambda of: replace(of.realistic, force_n=of.realistic.force_n / 2),
    )
    for module in (feedback, rendering, store, editing, choices, play):
        if hasattr(module, "FEEDBACKS"):
            monkeypatch.setattr(module, "FEEDBACKS", (*feedback.FEEDBACKS, half))
    assert cli.main(["play", "--help"]) == 0
    assert "half" in capsys.readouterr().out
    folder = write_sequence(tiny_clip, recording, tmp_path / "ride")
    tracks = open_sequence(folder).tracks
    np.testing.assert_array_equal(
        tracks["half"].force_n, tracks["realistic"].force_n / 2
    )
    assert "Half" in [choice.text for choice in choices.feedbacks(tracks)]


def test_a_new_derived_condition_is_previewed_and_in_studies(
    monkeypatch, capsys, sequence_folder, tmp_path
):
    share = Parameter("share", Message("Share"), ParameterKind.NUMBER, 1.0, SHARE)
    part = FeedbackCondition(
        "part",
        Message("Part"),
        lambda of, share: replace(of.realistic, force_n=of.realistic.force_n * share),
        parameters=(share,),
        is_stored=False,
        is_derived=True,
    )
    monkeypatch.setattr(feedback, "FEEDBACKS", (*feedback.FEEDBACKS, part))
    monkeypatch.setattr(play, "FEEDBACKS", feedback.FEEDBACKS)
    assert cli.main(["play", "--help"]) == 0
    assert "part[:share=...]" in " ".join(capsys.readouterr().out.split())
    source, name = with_feedback(open_source(sequence_folder), "part:share=0.25")
    whole = source.tracks["realistic"].force_n
    np.testing.assert_array_equal(source.tracks[name].force_n, whole * 0.25)
    made = create_study(
        tmp_path / "study", folders=dict.fromkeys(KEYS, sequence_folder)
    )
    chosen = {"key": "low", "condition": "part", "parameters": {"share": 0.5}}
    content = {**json.loads(made.content), "feedbacks": ["realistic", chosen]}
    loaded = load_study_sources(change_definition(made, content))
    np.testing.assert_array_equal(
        loaded.sources["bike"].tracks["low"].force_n, whole * 0.5
    )


def test_a_new_exporter_is_offered_and_used(monkeypatch, capsys):
    dummy = export.RecordExporter("dots", "a dot per tick", lambda *_: {}, bool)
    monkeypatch.setattr(export, "record_exporters", lambda: {"dots": dummy})
    assert cli.main(["export", "--help"]) == 0
    assert "dots: a dot per tick" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize("command", ["sync", "process"])
def test_remedies_name_the_command_of_foreign_options(command, tiny_clip, capsys):
    assert cli.main([command, str(tiny_clip.path)]) == 1
    said = capsys.readouterr().err
    foreign = "--suggest-motion" if command == "sync" else "--imu, --suggest-motion"
    assert f"({foreign}: see `hapticplayer import --help`)" in said


def test_own_options_and_quoted_commands_stand_as_they_are(capsys):
    assert cli.main(["import", "a.mp4", "-o", "x", "--suggest-gain", "2"]) == 2
    assert "--help" not in capsys.readouterr().err


LONG = "x" * 300 + ".mkv"


@pytest.mark.parametrize(
    "words",
    [[LONG], ["process", LONG], ["import", LONG, "-o", "ride"], ["pack", LONG, "-o", "y.mkv"], ["sync", LONG, LONG]],
)  # fmt: skip
def test_a_name_that_is_too_long_is_told_in_one_sentence(words, capsys):
    assert cli.main(words) == 1
    assert "ame too long" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words", [["--", "-x.mkv"], ["--device", "simulated", "./-x.mkv"], ["./-x.mkv"]]
)
def test_a_file_is_played_wherever_its_name_stands(
    words, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "-x.mkv").write_bytes(b"no film")
    assert cli.main(words) == 1
    assert "-x.mkv: it is not a video" in capsys.readouterr().err


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT])
def test_a_signal_ends_any_command_in_order(monkeypatch, capsys, number):
    """Each has something to tidy up, the merging of studies too."""
    tidied = []

    def run(*_):
        try:
            signal.raise_signal(number)
        finally:
            tidied.append(number)

    monkeypatch.setattr("hapticplayer.cli.study.merge_copies", run)
    monkeypatch.setattr("hapticplayer.cli.study.open_study", str)
    assert cli.main(["study", "merge", "here", "there"]) == 128 + number
    assert tidied == [number]
    assert "no file was left half written" in capsys.readouterr().err
