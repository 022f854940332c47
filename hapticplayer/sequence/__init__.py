"""The sequence on disk: a clip with its motion and its force tracks.

Each module is loaded when its first name is used: playing needs no pipeline.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.sequence.build import build_sequence
    from hapticplayer.sequence.store import Sequence, open_sequence, verify_sequence

_HOMES = {
    "Sequence": "store",
    "build_sequence": "build",
    "open_sequence": "store",
    "verify_sequence": "store",
}

__all__ = ["Sequence", "build_sequence", "open_sequence", "verify_sequence"]


def __getattr__(name: str) -> object:
    """Load the module of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = getattr(module, name)
    return globals()[name]
