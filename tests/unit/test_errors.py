"""Messages: English sentences that carry what they were made of."""

import copy
import json
import os
import pickle  # noqa: TID251 - as processes of one program do
import shutil
import subprocess
import sys
import wave
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.errors import (
    Cancelled,
    InputError,
    Message,
    from_json,
    joined,
    message_of,
    shell_line,
    to_json,
)
from hapticplayer.untrusted import without_controls

RATE = Message("runs at {rate:.1f} Hz ({name!r})", rate=np.float32(9.54), name="a")


def test_message_is_the_english_sentence():
    assert RATE == "runs at 9.5 Hz ('a')"
    assert RATE.template == "runs at {rate:.1f} Hz ({name!r})"
    assert Message(RATE) is RATE
    assert Message("{0} and {") == "{0} and {"  # without values it is taken as it is


def test_error_carries_where_what_and_remedy():
    problem = InputError("has {n} rows", where="a{b}.csv", remedy="give {n} more", n=2)
    assert str(problem) == "a{b}.csv: has 2 rows; give 2 more"
    assert message_of(problem).values["remedy"] == "give 2 more"
    again = InputError(problem.what, where="b.csv", remedy=problem.remedy)
    assert str(again) == "b.csv: has 2 rows; give 2 more"
    assert again.what.template == "has {n} rows"


@pytest.mark.parametrize(
    ("problem", "text"),
    [
        (OSError(2, "No such file or directory"), "No such file or directory"),
        (ValueError(RATE), RATE),
        (KeyError(), "KeyError"),
        (Cancelled(), "cancelled; nothing was written"),
    ],
)
def test_message_of_an_exception(problem, text):
    assert message_of(problem) == text
    assert Message("failed ({reason})", reason=problem) == f"failed ({text})"


def test_joined_parts_stay_messages():
    both = joined(Message(" or "), [RATE, "b"])
    assert both == f"{RATE} or b"
    assert [both.values[name] for name in ("part0", "separator")] == [RATE, " or "]
    assert joined(", ", []) == ""


def test_messages_survive_processes_and_files():
    nested = InputError("{what}, but", where="a", what=RATE)
    for made in (pickle.loads(pickle.dumps(nested)), copy.copy(nested)):
        assert message_of(made).values["what"].values["what"].template == RATE.template
    kept = from_json(json.loads(json.dumps(to_json(message_of(nested)))))
    assert kept == str(nested)
    assert kept.values["what"].values["what"].values == RATE.values
    assert to_json(Message("plain")) == to_json("plain") == "plain"
    assert from_json("old {0} text") == "old {0} text"


@pytest.mark.parametrize(
    "value",
    [
        {},
        3,
        None,
        {"template": "{a}", "values": {"b": 1}},
        {"template": "{a", "values": {"a": 1}},
        {"template": "{a.__class__}", "values": {"a": 1}},
        {"template": "{a[0]}", "values": {"a": "b"}},
        {"template": "{a:999999999d}", "values": {"a": 1}},
        {"template": "{a:{b}}", "values": {"a": 1, "b": "999999999d"}},
        {"template": "{a:d}", "values": {"a": "text"}},
    ],
)
def test_stored_message_of_a_stranger_is_refused(value):
    with pytest.raises(ValueError, match=r"message|field|format|expected"):
        from_json(value)


NAMES = [
    'the rider\'s "best" $HOME ride',
    "-c",
    "--imu",
    "12:30 ride.wav",
    "\u00fcber den Fluss.mp4",
    "two\nlines.csv",
    "tab\tand \\ back",
    "bell\x07 \x1b[31m",
    "no\u00a0break",
    "not utf-8 \udcff.mp4",
    "~/ride",
    "a;b&c|d>e",
    "!history",
    "*?[x]{a,b}",
    "caf\u0065\u0301",
]


@pytest.mark.parametrize("name", NAMES)
def test_printed_command_is_pasted_with_any_name(tmp_path, name):
    """By a shell, from a terminal that shows no control characters."""
    path = Path(name)
    command = shell_line(sys.executable, "-c", ARGUMENTS, "say", path, "")
    assert without_controls(command) == command
    run = ["bash", "-c", command.encode(errors="surrogateescape")]
    said = subprocess.run(run, cwd=tmp_path, capture_output=True, check=True).stdout
    words = said.split(b"\0")
    assert words[::2] == [b"say", b""]
    assert not words[1].startswith(b"-")
    assert Path(os.fsdecode(words[1])) == path


ARGUMENTS = (
    "import os, sys; "
    "sys.stdout.buffer.write(b'\\0'.join(map(os.fsencode, sys.argv[1:])))"
)


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs ffmpeg")
@pytest.mark.parametrize("name", [*NAMES[:9], *NAMES[10:]])
def test_ffmpeg_finds_the_files_of_a_printed_command(tmp_path, name):
    stem = name.replace("/", "-")
    source, target = Path(f"{stem}.wav"), Path(f"{stem}-pcm.wav")
    with wave.open(str(tmp_path / source), "wb") as out:
        out.setparams((1, 2, 8000, 800, "NONE", ""))
        out.writeframes(bytes(1600))
    command = shell_line("ffmpeg", "-v", "error", "-i", source, target)
    run = ["bash", "-c", command.encode(errors="surrogateescape")]
    subprocess.run(run, cwd=tmp_path, check=True, stdin=subprocess.DEVNULL)
    assert (tmp_path / target).stat().st_size > 1600
