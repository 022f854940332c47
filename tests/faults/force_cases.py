"""Damage to files of force, and what must hold in every case."""

import tempfile
from pathlib import Path

import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack
from hapticplayer.sequence.force_files import WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    read_force,
    read_formats,
    written_formats,
)
from tests.faults.import_cases import READ as WAS_READ
from tests.faults.import_cases import REFUSED, check_sentence, mutated

MUTATIONS = 2000
KINDS = tuple(name for name in read_formats() if name in written_formats())
_SWAPS = (
    (b"Curve", b"Transient"),
    (b"Curve", b"VectorialWave"),
    (b"Curve", b"WaveletWave"),
    (b"Linear", b"Akima"),
    (b"Linear", b"Cubic"),
    (b"Basis", b"Reference"),
    (b"PassiveKinestheticForceType", b"VibrationType"),
    (b'"duration="', b'"duration="999999999'),
    (b'position":', b'position":99999'),
    (b'timescale":1000', b'timescale":1'),
)


def clean_file(name: str) -> bytes:
    """Return a file of two seconds."""
    wave = np.sin(np.outer(np.arange(400) / 30.0, [1.0, 1.7, 2.3]))
    track = ForceTrack(np.arange(400) / 199.0, 2.0 * wave)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "clean"
        export_track(track, path, written_formats()[name], WriteChoices())
        return path.read_bytes()


def judge(name: str, clean: bytes, number: int, folder: Path) -> str:
    """Read a numbered mutation; anything but one sentence goes through."""
    rng = np.random.default_rng([number, KINDS.index(name)])
    content = clean
    if number % 4 == 0:  # whole words, so that other readers are reached
        old, new = _SWAPS[int(rng.integers(len(_SWAPS)))]
        content = content.replace(old, new)
    if number % 8:
        content = mutated({"a": content}, rng)["a"]
    path = folder / f"damaged{read_formats()[name].suffix}"
    path.write_bytes(content)
    try:
        track = read_force(path, name=name).track
    except InputError as error:
        check_sentence(str(error))
        return REFUSED
    assert np.isfinite(track.force_n).all()
    assert (np.diff(track.time_s) > 0.0).all()
    return WAS_READ
