"""Reads the record of a simulated Falcon; see `hapticplayer.simulation.falcon.process`."""

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.simulation.falcon.process import (
    MAGIC,
    RECORD_BYTES,
    RECORD_FIELDS,
    RING_AT,
    RING_RECORDS,
)

RECORD = np.dtype(
    [
        ("monotonic_s", "<f8"),
        ("applied_since_s", "<f8"),
        ("commanded_n", "<f4", (3,)),
        ("applied_n", "<f4", (3,)),
        ("position_m", "<f4", (3,)),
        ("refused", "<u4"),
    ]
)
"""One turn of the device: at `monotonic_s` it had `applied_n` on its motors, since
`applied_since_s`; `commanded_n` is the newest accepted command, `position_m` the true
position, `refused` the number of commands that came too late or made no sense."""

assert RECORD_FIELDS.size == RECORD.itemsize


def read_record(descriptor: int) -> NDArray[Any]:
    """Return the newest turns, dtype RECORD, oldest first.

    While the device still writes, the oldest of a full ring may be torn.

    Raises:
        ValueError: when nothing was ever recorded there.
    """
    data = os.pread(descriptor, RECORD_BYTES, 0)
    if len(data) != RECORD_BYTES or data[:8] != MAGIC:
        raise ValueError("this is no record of the simulated device")
    head = int.from_bytes(data[8:16], "little")
    ring: NDArray[Any] = np.frombuffer(data, RECORD, RING_RECORDS, RING_AT)
    if head <= RING_RECORDS:
        return ring[:head].copy()
    return np.roll(ring, -(head % RING_RECORDS))
