"""How the smoother's inner loops are compiled: numba's decorator, with types.

Each kernel has one signature, so that all are compiled, or loaded from numba's cache,
when their module is imported. Nothing reorders sums (no `fastmath`), or the results
would not be those of numpy.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import numba
from numba import types

F = TypeVar("F", bound=Callable[..., Any])

# What vectorising wins here is less than what it costs to compile.
numba.config.LOOP_VECTORIZE = numba.config.SLP_VECTORIZE = 0

INT, BOOL = types.int64, types.boolean
FLOAT, COMPLEX = types.float64, types.complex128
NOTHING = types.void
PAIR = types.UniTuple(COMPLEX, 2)
VECTOR = types.UniTuple(FLOAT, 3)


def _array(element: Any, dimensions: int, *, readonly: bool) -> Any:
    return types.Array(element, dimensions, "C", readonly=readonly)


# arrays that are read, which may or may not be written to
FLAGS = _array(BOOL, 1, readonly=True)
INDICES = _array(INT, 1, readonly=True)
IN1, IN2, IN4 = (_array(FLOAT, n, readonly=True) for n in (1, 2, 4))
PAIRS, PAIRS_BY_TWO = (_array(COMPLEX, n, readonly=True) for n in (2, 3))
COLUMN = types.Array(COMPLEX, 1, "A", readonly=True)
# arrays that are written
OUT1, OUT2, OUT3, OUT4 = (_array(FLOAT, n, readonly=False) for n in (1, 2, 3, 4))
OUT_PAIRS, OUT_PAIRS_BY_TWO = (_array(COMPLEX, n, readonly=False) for n in (2, 3))


def compiled(result: Any, *arguments: Any) -> Callable[[F], F]:
    """Return a decorator that compiles a function for these types."""
    return _decorator(result(*arguments))


def inner(result: Any, *arguments: Any) -> Callable[[F], F]:
    """The same for what only other kernels of the same file call."""
    return _decorator(result(*arguments), no_cpython_wrapper=True)


def _decorator(signature: Any, **options: bool) -> Callable[[F], F]:
    found: Callable[[F], F] = numba.njit(
        signature,
        cache=True,
        nogil=True,
        error_model="numpy",
        no_cfunc_wrapper=True,
        **options,
    )
    return found
