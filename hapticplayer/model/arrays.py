"""Validation of arrays at the border: checked once, then read-only for ever."""

from dataclasses import fields
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hapticplayer.errors import InputError

Floats = NDArray[np.float64]


def frozen(
    values: ArrayLike,
    shape: tuple[int | None, ...],
    name: str,
    dtype: Any = np.float64,
) -> NDArray[Any]:
    """Return `values` as a read-only C-contiguous array of the given shape.

    Copied, unless it is read-only already.

    Args:
        values: anything numpy can read.
        shape: the expected shape; None stands for any length.
        name: how the error message calls it.
        dtype: element type of the result.
    """
    array: NDArray[Any]
    array = values if _is_frozen(values, dtype) else _converted(values, name, dtype)
    if array.ndim != len(shape) or any(
        want is not None and got != want
        for got, want in zip(array.shape, shape, strict=True)
    ):
        wanted = " x ".join("N" if n is None else str(n) for n in shape)
        got = " x ".join(map(str, array.shape))
        raise InputError(
            "{name} has the shape {shape}, expected {expected}",
            name=name,
            shape=got,
            expected=wanted,
        )
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0, 0])
        raise InputError(
            "{name} holds a value that is not finite in row {row}", name=name, row=row
        )
    array.setflags(write=False)
    return array


def _converted(values: ArrayLike, name: str, dtype: Any) -> NDArray[Any]:
    """Return a copy of real numbers; of complex ones numpy would drop a part."""
    kind = values.dtype.kind if isinstance(values, np.ndarray) else "f"
    try:
        with np.errstate(over="ignore"):  # what does not fit is refused as infinite
            array = np.array(values, dtype=dtype, order="C") if kind in "biuf" else None
    except (TypeError, ValueError, OverflowError):
        array = None
    if array is None:
        raise InputError("{name} must hold real numbers", name=name)
    return array


def _is_frozen(values: ArrayLike, dtype: Any) -> TypeGuard[NDArray[Any]]:
    """Return whether the array, and what it is a view of, can stay as it is."""
    if type(values) is not np.ndarray:
        return False
    if values.dtype != dtype or not values.flags.c_contiguous:
        return False
    array: Any = values
    while isinstance(array, np.ndarray):
        if array.flags.writeable:
            return False
        array = array.base
    return array is None


def frozen_times(values: ArrayLike, name: str) -> Floats:
    """Return strictly increasing, finite times as a read-only array."""
    times = frozen(values, (None,), name)
    increases = times[1:] > times[:-1]
    if not increases.all():
        row = int(np.argmin(increases)) + 1
        raise InputError(
            "{name} must increase strictly, but row {row} has {time_s:.6f} s "
            "after {last_s:.6f} s",
            name=name,
            row=row,
            time_s=times[row],
            last_s=times[row - 1],
        )
    return times


def same_length(reference: NDArray[Any], **others: NDArray[Any] | None) -> None:
    """Raise InputError unless all arrays have as many rows as `reference`."""
    for name, array in others.items():
        if array is not None and len(array) != len(reference):
            raise InputError(
                "{name} has {count} rows, but there are {expected} times",
                name=name,
                count=len(array),
                expected=len(reference),
            )


def all_of_rows(flags: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which rows (n, few) are all True; numpy is slow along short axes."""
    out = flags[:, 0].copy()
    for column in flags.T[1:]:
        out &= column
    return out


def arrays_of(value: Any, chosen: slice | NDArray[np.bool_]) -> dict[str, Any]:
    """Return the arrays of a dataclass by name, some of their rows."""
    held = {field.name: getattr(value, field.name) for field in fields(value)}
    arrays = {k: one for k, one in held.items() if isinstance(one, np.ndarray)}
    return {name: array[chosen] for name, array in arrays.items()}
