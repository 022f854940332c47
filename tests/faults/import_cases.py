"""Damage to the files of a recording, and what must hold in every case."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import parse_choices
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import HapticPlayerError, InputError, UsageError
from tests.faults.import_formats import FORMATS, Files, Written, put, zipped
from tests.faults.import_signal import sample

MUTATIONS = 200
MUTATED_S = 8.0
READ, REFUSED, ASKED = "read", "refused", "asked"


@dataclass(frozen=True)
class Verdict:
    """What became of a recording.

    Attributes:
        outcome: read, refused or asked.
        message: of a refusal or a question.
        recording: what was read.
    """

    outcome: str
    message: str = ""
    recording: Recording | None = None


def judge(path: Path, one: Written) -> Verdict:
    """Read, and check what holds for every recording and every refusal.

    Anything but the errors that are meant for people goes through.
    """
    try:
        recording = read_recording(path, parse_choices(one.choices))
    except (InputError, UsageError) as error:
        message = str(error)
        check_sentence(message)
        return Verdict(ASKED if isinstance(error, UsageError) else REFUSED, message)
    except HapticPlayerError as error:
        raise AssertionError(f"neither refused nor asked: {error!r}") from error
    check_sound(recording)
    return Verdict(READ, recording=recording)


def check_sentence(message: str) -> None:
    """A refusal is one sentence: one line, not a page, no trace of Python."""
    assert message.strip()
    assert "\n" not in message, message
    assert len(message) < 900, message
    for trace in ("Traceback", "Error(", "object at 0x", "numpy."):
        assert trace not in message, message


def check_sound(recording: Recording) -> None:
    """Times increase strictly, and every number is finite."""
    imu = recording.imu
    assert len(imu) >= 2
    assert np.isfinite(imu.time_s).all()
    assert (np.diff(imu.time_s) > 0.0).all()
    for values in (imu.specific_force_mps2, imu.angular_rate_radps):
        assert np.isfinite(values).all()
    if imu.magnetic_field_ut is not None:
        assert np.isfinite(imu.magnetic_field_ut).all()
    assert np.isfinite(recording.clock_map.offset_s)


@cache
def clean_files(key: str) -> Files:
    one = FORMATS[key]
    return one.write(sample(MUTATED_S, apart=one.apart))


def mutated(files: Files, rng: np.random.Generator) -> Files:
    """Damage one file of a recording: bits, spans, lengths, lines or numbers."""
    names = sorted(files)
    name = names[int(rng.integers(len(names)))]
    return {**files, name: _damaged(bytearray(files[name]), rng)}


def _damaged(content: bytearray, rng: np.random.Generator) -> bytes:
    size = len(content)
    kind = int(rng.integers(8))
    at, length = int(rng.integers(size)), int(rng.integers(1, 400))
    if kind <= 2:
        for _ in range(int(rng.choice([1, 20, 300]))):
            content[int(rng.integers(size))] ^= 1 << int(rng.integers(8))
    elif kind == 3:
        content[at : at + length] = bytes(len(content[at : at + length]))
    elif kind == 4:
        content[at:at] = content[at : at + 20 * length]
    elif kind == 5:
        del content[at:]
    elif kind == 6:
        del content[at : at + 20 * length]
    else:
        hostile = (
            b"-1e308",
            b"nan",
            b"inf",
            b"9" * 40,
            b"\n" * 40,
            b",,,,",
            b"\x7f\xff" * 4,
        )
        word = hostile[int(rng.integers(len(hostile)))]
        content[at : at + len(word)] = word
    return bytes(content)


def damaged_zip(files: Files, rng: np.random.Generator) -> bytes:
    return _damaged(bytearray(zipped(files)), rng)


def mutation(key: str, number: int, folder: Path) -> Path:
    """Write the numbered mutation of a format; every tenth damages a zip itself."""
    rng = np.random.default_rng([number, sorted(FORMATS).index(key)])
    files = clean_files(key)
    if number % 10 == 9 and key != "GoPro, raw":
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / "recording.zip"
        path.write_bytes(damaged_zip(files, rng))
        return path
    return put(mutated(files, rng), folder)
