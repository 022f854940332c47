"""AHAP (Apple): the size of the force as intensity, its frequency as sharpness, for phones.

Written only: a phone has no direction. Intensity 1 is the largest force of the track.
Continuous events last 30 s and curves have 16 points at most, as Core Haptics has it;
sharpness is the logarithm of the mean frequency in each second, 1 Hz to 100 Hz.
"""

import json
import math
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.thinning import Polyline, thinned
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import Loss, WriteChoices, origin
from hapticplayer.sequence.milliseconds import end_ms, pieces
from hapticplayer.untrusted import parse_json, read_regular

_STEPS_PER_TOLERANCE = 20  # rounding may take a fortieth of it

OF_SIZE = Message("size of the force, every millisecond")
_MARK = b"written by hapticplayer"
_EVENT_MS, _POINTS = 30_000, 16
_LOW_HZ, _HIGH_HZ = 1.0, 100.0
_MAX_BYTES = 256 << 20


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b'{"Version"') and _MARK in head[:200]


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write the size of a track's force."""
    refuse_large_force(track.force_n, "ahap")
    until_ms = end_ms(track, choices.duration_s)
    # corners may lie above the largest force by the tolerance
    tolerance_n: float = choices.take("tolerance_n")
    scale_n = math.ceil((track.peak_n() + tolerance_n) * 1000.0) / 1000.0
    digits = math.ceil(math.log10(_STEPS_PER_TOLERANCE * scale_n / tolerance_n))
    quantum_n = scale_n * 10.0**-digits
    curve = thinned(track, until_ms, tolerance_n, quantum_n, _size, 0.0)[0]
    mark = _MARK.decode() + origin(track)
    about = {"Description": f"{mark}; newton = intensity * {scale_n:.3f}"}
    head = _json({"Version": 1.0, "Metadata": about, "Pattern": []})
    out.write(head.removesuffix(b"]}"))
    between = b""
    for one in chain(
        ({"Event": _event(*span)} for span in pieces(until_ms, _EVENT_MS)),
        _curves("HapticIntensityControl", (curve[0], curve[1] / scale_n), digits),
        _curves("HapticSharpnessControl", _sharpness(track, until_ms), 3),
    ):
        out.write(between + _json(one))
        between = b","
    out.write(b"]}")
    return (
        Message("the direction of the force"),
        Message("changes of the frequency within a second"),
    )


def _json(value: dict[str, Any]) -> bytes:
    return json.dumps(value, separators=(",", ":")).encode()


def loss(track: ForceTrack, path: Path, choices: WriteChoices) -> Loss:
    """Return how the size of the force differs."""
    content = parse_json(read_regular(path, _MAX_BYTES), str(path), InputError, "")
    scale_n = float(content["Metadata"]["Description"].rpartition(" ")[2])
    curves = [
        one["ParameterCurve"]
        for one in content["Pattern"]
        if len(one) == 1 and "ParameterCurve" in one
    ]
    points = np.array(
        [
            (curve["Time"] + point["Time"], point["ParameterValue"])
            for curve in curves
            if curve["ParameterID"] == "HapticIntensityControl"
            for point in curve["ParameterCurveControlPoints"]
        ]
    )
    squares, largest, count = 0.0, 0.0, 0
    for first, last in pieces(end_ms(track, choices.duration_s), 60_000):
        at_s = np.arange(first, last) / 1000.0
        error_n = scale_n * np.interp(at_s, *points.T) - _size(track.at(at_s))[:, 0]
        squares += float(np.square(error_n).sum())
        largest, count = max(largest, float(np.abs(error_n).max())), count + len(at_s)
    return Loss((squares / count) ** 0.5, largest, OF_SIZE)


def _size(force_n: Floats) -> Floats:
    return np.asarray(np.linalg.norm(force_n, axis=1)[:, None])


def _event(first_ms: int, last_ms: int) -> dict[str, Any]:
    parameters = [
        {"ParameterID": "HapticIntensity", "ParameterValue": 1.0},
        {"ParameterID": "HapticSharpness", "ParameterValue": 0.0},
    ]
    return {
        "Time": first_ms / 1000.0,
        "EventType": "HapticContinuous",
        "EventDuration": (last_ms - first_ms) / 1000.0,
        "EventParameters": parameters,
    }


def _curves(name: str, curve: Polyline, digits: int) -> Iterator[dict[str, Any]]:
    """Yield parameter curves that follow each other, with a point in common."""
    ticks, values = curve
    for first in range(0, max(1, len(ticks) - 1), _POINTS - 1):
        begin = int(ticks[first])
        points = [
            {
                "Time": round((tick - begin) / 1000.0, 3),
                "ParameterValue": round(min(1.0, max(0.0, value)), digits),
            }
            for tick, value in zip(
                ticks[first : first + _POINTS].tolist(),
                values[first : first + _POINTS].tolist(),
                strict=True,
            )
        ]
        one = {"ParameterID": name, "Time": begin / 1000.0}
        yield {"ParameterCurve": {**one, "ParameterCurveControlPoints": points}}


def _sharpness(track: ForceTrack, until_ms: int) -> Polyline:
    """Return sharpness, one value in the middle of each second."""
    middles, values = [], []
    for begin, end in pieces(until_ms, 60_000):
        force_n = track.at(np.arange(begin, end) / 1000.0)
        for first, last in pieces(end - begin, 1000):
            middles.append(begin + (first + last) // 2)
            values.append(_share(force_n[first:last]))
    return np.array(middles, np.int64), np.array(values)


def _share(force_n: Floats) -> float:
    """Return where the mean frequency of a second lies, 0 to 1."""
    power = np.square(np.abs(np.fft.rfft(force_n, 1000, axis=0))).sum(axis=1)
    hertz = float(np.sum(power[1:] * np.arange(1, 501)) / max(power[1:].sum(), 1e-12))
    share = np.log(max(hertz, _LOW_HZ) / _LOW_HZ) / np.log(_HIGH_HZ / _LOW_HZ)
    return float(np.clip(share, 0.0, 1.0))
