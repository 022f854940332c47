"""Whether the smoother runs compiled: the one place that decides.

numba is imported at the first use. It compiles once on a machine, two to three
seconds with two cores, and keeps what it made, in the package's folder or else in the user's cache
folder. Where it is missing, cannot keep anything or fails otherwise, or where the environment
variable HAPTICPLAYER_COMPILED is `off`, plain numpy does the same work, slower.
"""

import contextlib
import functools
import gc
import importlib
import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from types import ModuleType

SWITCH = "HAPTICPLAYER_COMPILED"
_ROOM = "hapticplayer.motion.smoother"
_HERE, _BESIDE = "kernels", ("solver_kernel", "means_kernel")
"""Modules of kernels: each half takes about as long to compile, the process counted."""
_BESIDE_TIMEOUT_S = 60.0


@functools.cache
def fast() -> ModuleType | None:
    """Return the module of compiled stages, or None where numpy has to do.

    Decided at the first use; `fast.cache_clear()` asks again.
    """
    if os.environ.get(SWITCH, "").lower() in ("off", "0", "no", "false"):
        return None
    collects = gc.isenabled()
    gc.disable()  # compiling makes many objects, and a sixth of it is looking at them
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # numba's about its cache: see above
            with _compiling_beside():
                importlib.import_module(f"{_ROOM}.{_HERE}")
            from hapticplayer.motion.smoother import fast as module
    except Exception:  # noqa: BLE001 - a broken cache raises anything; numpy remains
        return None
    else:
        return module
    finally:
        if collects:
            gc.enable()


@contextlib.contextmanager
def _compiling_beside() -> Iterator[None]:
    """At the first use on a machine, let a process compile the other half meanwhile.

    What it has kept is loaded afterwards; whatever goes wrong with it, the rest is
    compiled here then.
    """
    from hapticplayer.motion.smoother import jit

    if jit.is_kept(_BESIDE[0]) or (os.cpu_count() or 1) < 2:
        yield
        return
    imports = f"from {_ROOM} import {', '.join(_BESIDE)}"
    process = subprocess.Popen(
        [sys.executable, "-P", "-c", f"import gc; gc.disable(); {imports}"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(_BESIDE_TIMEOUT_S)
    finally:
        process.kill()
        process.wait()
