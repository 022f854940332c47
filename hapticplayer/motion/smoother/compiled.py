"""Whether the smoother runs compiled: the one place that decides.

numba is imported at the first use. It compiles once on a machine, about
three seconds, and keeps what it made, in the package's folder or else in the user's cache
folder. Where it is missing, cannot keep anything or fails otherwise, or where the environment
variable HAPTICPLAYER_COMPILED is `off`, plain numpy does the same work, slower.
"""

import functools
import gc
import os
import warnings
from types import ModuleType

SWITCH = "HAPTICPLAYER_COMPILED"


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
            from hapticplayer.motion.smoother import fast as module
    except Exception:  # noqa: BLE001 - a broken cache raises anything; numpy remains
        return None
    else:
        return module
    finally:
        if collects:
            gc.enable()
