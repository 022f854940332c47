"""Whole numbers of 64 bits for D-Bus, where PySide sends the shortest that holds them.

MPRIS wants `x` for the length of a clip; some clients show nothing for another type. No
call of PySide makes one, so the operator of Qt's own library is called.
"""

import ctypes
import functools
from typing import Any

import shiboken6
from PySide6.QtDBus import QDBusArgument

_LIBRARY = "libQt6DBus.so.6"
_PUT = "_ZN13QDBusArgumentlsEx"  # QDBusArgument::operator<<(qlonglong)


def int64(value: int) -> Any:
    """Return a value that is sent as `x`; as it is where Qt's library is not found."""
    put = _operator()
    if put is None:
        return value
    made = QDBusArgument()
    put(shiboken6.getCppPointer(made)[0], value)
    return made


@functools.cache
def _operator() -> Any:
    try:
        found = getattr(ctypes.CDLL(_LIBRARY), _PUT)  # loaded already, by PySide
    except (OSError, AttributeError):
        return None
    found.argtypes, found.restype = [ctypes.c_void_p, ctypes.c_longlong], None
    return found
