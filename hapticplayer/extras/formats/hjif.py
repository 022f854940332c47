"""hjif (ISO/IEC 23090-31): three Force channels with linear curves.

The newton is amplitude times `maximum_amplitude` of the reference device, the directions
are those of frame D. Positions are milliseconds. Each channel has one effect that begins
at 0, as the published synthesizer misplaces others (2de9ff1). The loader wants a date:
it is empty.
"""

import io
import json
import math
from typing import Any, BinaryIO

import numpy as np

from hapticplayer import __version__
from hapticplayer.errors import Message
from hapticplayer.extras.formats.thinning import Polyline, thinned
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ForceTrack
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence import Sequence
from hapticplayer.sequence.force_files import WriteChoices, origin
from hapticplayer.sequence.milliseconds import end_ms

MARK = b"written by hapticplayer"
_STEPS_PER_TOLERANCE = 20  # rounding may take a fortieth of the tolerance
_DIRECTIONS = ((127, 0, 0), (0, 127, 0), (0, 0, 127))


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b'{"version":') and MARK in head[:400]


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write a track.

    The force vector stays within the tolerance: each axis gets its share.
    """
    refuse_large_force(track.force_n, "hjif")
    tolerance_n: float = choices.take("tolerance_n")
    largest_n = float(np.abs(track.force_n).max())
    digits = math.ceil(
        math.log10(
            _STEPS_PER_TOLERANCE * math.sqrt(3.0) * max(1.0, largest_n) / tolerance_n
        )
    )
    # corners may lie above the largest force by the tolerance
    scale_n = math.ceil((largest_n + tolerance_n) * 1000.0) / 1000.0
    curves = thinned(
        track,
        end_ms(track, choices.duration_s),
        tolerance_n / math.sqrt(3.0),
        scale_n * 10.0**-digits,
    )
    channels = [
        _channel(number, curve, scale_n, digits) for number, curve in enumerate(curves)
    ]
    text = json.dumps(
        _described(channels, scale_n, origin(track)), separators=(",", ":")
    )
    out.write(text.encode())
    return ()


def _described(
    channels: list[dict[str, Any]], scale_n: float, origin_text: str
) -> dict[str, Any]:
    device = {"id": 0, "name": "force feedback", "maximum_amplitude": scale_n}
    perception = {
        "id": 0,
        "avatar_id": 0,
        "description": "force on the hand",
        "perception_modality": "Force",
        "perception_unit_exponent": 0,
        "reference_devices": [device],
        "effect_library": [],
        "channels": channels,
    }
    return {
        "version": "2023",
        "profile": "Main",
        "level": 1,
        "date": "",
        "description": f"{MARK.decode()} {__version__}{origin_text}; newton = amplitude * "
        "maximum_amplitude; X right, Y up, Z towards the user",
        "timescale": 1000,
        "avatars": [],
        "syncs": [],
        "perceptions": [perception],
    }


def _channel(
    number: int, curve: Polyline, scale_n: float, digits: int
) -> dict[str, Any]:
    ticks, values = curve
    amplitudes = np.clip(np.round(values / scale_n, digits), -1.0, 1.0) + 0.0
    keyframes = [
        {"relative_position": tick, "amplitude_modulation": amplitude}
        for tick, amplitude in zip(ticks.tolist(), amplitudes.tolist(), strict=True)
    ]
    effect = {"effect_type": "Basis", "position": 0, "keyframes": keyframes}
    band = {
        "band_type": "Curve",
        "curve_type": "Linear",
        "lower_frequency_limit": 0,
        "upper_frequency_limit": 500,
        "effects": [effect],
    }
    return {
        "id": number,
        "description": "xyz"[number],
        "gain": 1.0,
        "mixing_coefficient": 1.0,
        "body_part_mask": 0,
        "reference_device_id": 0,
        "direction": dict(zip("XYZ", _DIRECTIONS[number], strict=True)),
        "bands": [band],
    }


def attached(sequence: Sequence) -> tuple[str, bytes]:
    """Name and content of the rendered force of a sequence that is shared."""
    track, out = sequence.rendered, io.BytesIO()
    duration_s = probe(sequence.clip).duration_s
    write(track, out, WriteChoices(duration_s=duration_s))
    what = "estimated" if track.is_estimated else "realistic"
    return f"force_{what}.hjif", out.getvalue()
