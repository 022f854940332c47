"""How the smoother's inner loops are compiled: numba's decorator, with types.

Each kernel has one signature, so that all are compiled, or loaded from numba's cache,
when their module is imported. Nothing reorders sums (of `fastmath` only products may
go into a sum unrounded), or the results would not be those of numpy.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import numba
import numpy as np
from numba import types
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import PassManager

F = TypeVar("F", bound=Callable[..., Any])

# What vectorising and the last optimisations win here is less than what they cost to
# compile.
numba.config.LOOP_VECTORIZE = numba.config.SLP_VECTORIZE = 0
numba.config.OPT = type(numba.config.OPT)(1)
numba.config.LLVM_REFPRUNE_PASS = 0  # no references are counted: see below

# What numba does to a kernel on the way and these have no use for: closures, arithmetic
# of whole arrays, functions that are put into others before LLVM does it, branches on
# arguments that are None, and what is raised.
_SPARED = {
    "DeadBranchPrune",
    "FindLiterallyCalls",
    "InlineClosureLikes",
    "InlineInlinables",
    "InlineOverloads",
    "LiteralUnroll",
    "MakeFunctionToJitFunction",
    "NopythonRewrites",
    "RewriteDynamicRaises",
    "RewriteSemanticConstants",
}

INT, BOOL = types.int64, types.boolean
FLOAT, COMPLEX = types.float64, types.complex128
NOTHING = types.void

# Rows of tables are records: to read or write a field compiles in a tenth of the time
# that an element of a matrix takes.
_AXES = "x", "y", "z"
_SPENT = "duration", "power", "lost", "doubt"
XYZ = np.dtype([(name, np.float64) for name in _AXES])
PAIR = np.dtype([("first", np.complex128), ("second", np.complex128)])
WINDOW = np.dtype(
    [(name, np.float64) for name in (*_AXES, "turn_x", "turn_y", "turn_z", *_SPENT)]
)
NODE = np.dtype([(name, np.float64) for name in (*_AXES, *_SPENT, "turned")])
BAND = np.dtype([(name, np.float64) for name in ("main", "first", "second", "third")])
NOISE = np.dtype(
    [
        (name, np.float64)
        for name in (
            *("gravity", "rate", "rotation", "lost"),
            *("force", "force_error", "doubt"),
        )
    ]
)
SUMS = np.dtype([(name, np.float64) for name in ("time", "value", "width")])


def _array(element: Any, dimensions: int, *, readonly: bool) -> Any:
    return types.Array(element, dimensions, "C", readonly=readonly)


# arrays that are read, which may or may not be written to
FLAGS = _array(BOOL, 1, readonly=True)
INDICES = _array(INT, 1, readonly=True)
IN1, IN2, IN4 = (_array(FLOAT, n, readonly=True) for n in (1, 2, 4))
# the same, with any strides
COLUMN = types.Array(COMPLEX, 1, "A", readonly=True)
STRIDED2 = types.Array(FLOAT, 2, "A", readonly=True)
VECTORS = _array(numba.from_dtype(XYZ), 1, readonly=True)
# arrays that are written
OUT1, OUT2, OUT3, OUT4 = (_array(FLOAT, n, readonly=False) for n in (1, 2, 3, 4))
PAIRS, PAIRS_BY_TWO = (
    _array(numba.from_dtype(PAIR), n, readonly=False) for n in (1, 2)
)
OUT_VECTORS, WINDOWS, NODES, BANDS, NOISES, ALL_SUMS = (
    _array(numba.from_dtype(row), 1, readonly=False)
    for row in (XYZ, WINDOW, NODE, BAND, NOISE, SUMS)
)


class _FewPasses(CompilerBase):  # type: ignore[misc]  # of which mypy knows nothing
    """Numba's compiler without what these kernels have no use for, a twelfth of the time."""

    def define_pipelines(self) -> list[Any]:
        """Return the one pipeline."""
        usual = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes = PassManager(usual.pipeline_name)
        for one, description in usual.passes:
            if one.__name__ not in _SPARED:
                passes.add_pass(one, description)
        passes.finalize()
        return [passes]


_OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "fastmath": {"contract"},
    "no_cfunc_wrapper": True,
    "pipeline_class": _FewPasses,
    "_nrt": False,  # nothing is allocated inside, and no argument is let go of
}


def compiled(result: Any, *arguments: Any) -> Callable[[F], F]:
    """Return a decorator that compiles a function for these types, and keeps it."""
    found: Callable[[F], F] = numba.njit(result(*arguments), cache=True, **_OPTIONS)
    return found


def inner(function: F) -> F:
    """Compile what only other kernels of the same file call, when one of them is.

    Nothing of it is kept: what is kept of its callers holds it.
    """
    found: F = numba.njit(no_cpython_wrapper=True, **_OPTIONS)(function)
    return found
