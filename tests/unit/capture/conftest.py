"""Where the real recordings lie, and a small writer of GPMF."""

import struct
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

DATA = Path(__file__).parents[3].parent / "shared" / "data" / "capture"


def recorded(name: str) -> Path:
    """Return a real recording, or skip the test."""
    path = DATA / name
    if not path.exists():
        pytest.skip(f"needs ../shared/data/capture/{name}")
    return path


def case_file(*parts: str) -> Path:
    """Return a file of the cases of other programs, or skip the test."""
    path = DATA.parent.joinpath("cases", *parts)
    if not path.exists():
        pytest.skip(f"needs ../shared/data/cases/{'/'.join(parts)}")
    return path


def klv(key: str, kind: str, payload: bytes, struct_bytes: int = 1) -> bytes:
    """Return one entry, padded to four bytes."""
    head = struct.pack(
        ">4scBH",
        key.encode(),
        kind.encode("latin-1"),
        struct_bytes,
        len(payload) // struct_bytes,
    )
    return head + payload + bytes(-len(payload) % 4)


def nested(key: str, *children: bytes) -> bytes:
    return klv(key, "\0", b"".join(children))


def text(key: str, value: str) -> bytes:
    return klv(key, "c", value.encode("latin-1"))


def shorts(key: str, rows: ArrayLike) -> bytes:
    values = np.atleast_2d(np.asarray(rows)).astype(">i2")
    return klv(key, "s", values.tobytes(), 2 * values.shape[1])


def floats(key: str, rows: ArrayLike) -> bytes:
    values = np.atleast_2d(np.asarray(rows)).astype(">f4")
    return klv(key, "f", values.tobytes(), 4 * values.shape[1])


def sensor(
    key: str,
    values: ArrayLike,
    *,
    scale: float = 1.0,
    orin: str = "ZXY",
    total: int | None = None,
    stamp_us: int | None = None,
) -> bytes:
    """Return the STRM entry of one sensor in one payload, values in stored order."""
    children = []
    if stamp_us is not None:
        children.append(klv("STMP", "J", struct.pack(">Q", stamp_us), 8))
    if total is not None:
        children.append(klv("TSMP", "L", struct.pack(">I", total), 4))
    if orin:
        children.append(text("ORIN", orin))
    if scale != 1.0:
        children.append(shorts("SCAL", [[scale]]))
    children.append(floats(key, values))
    return nested("STRM", *children)


def device(name: str, *streams: bytes, number: int = 1) -> bytes:
    """Return the DEVC entry of one payload."""
    identity = klv("DVID", "L", struct.pack(">I", number), 4)
    return nested("DEVC", identity, text("DVNM", name), *streams)
