"""What the commands do without a window: play headless, import, process, export.

Each module is loaded when its first name is used: playing needs no pipeline.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.console.exporting import export
    from hapticplayer.console.playing import (
        advise,
        attach_log,
        play,
        record_target,
        until_s,
        wanted_scheduling,
        wanted_speed,
    )
    from hapticplayer.console.processing import process
    from hapticplayer.console.recordings import (
        demo_folder,
        import_recording,
        simulate,
    )
    from hapticplayer.console.speech import (
        complain,
        interruptible,
        say,
        say_aside,
        shown_progress,
    )
    from hapticplayer.console.synchronizing import sync

_HOMES = {
    "advise": "playing",
    "attach_log": "playing",
    "complain": "speech",
    "demo_folder": "recordings",
    "export": "exporting",
    "import_recording": "recordings",
    "interruptible": "speech",
    "play": "playing",
    "process": "processing",
    "record_target": "playing",
    "say": "speech",
    "say_aside": "speech",
    "shown_progress": "speech",
    "simulate": "recordings",
    "sync": "synchronizing",
    "until_s": "playing",
    "wanted_scheduling": "playing",
    "wanted_speed": "playing",
}

__all__ = [
    "advise",
    "attach_log",
    "complain",
    "demo_folder",
    "export",
    "import_recording",
    "interruptible",
    "play",
    "process",
    "record_target",
    "say",
    "say_aside",
    "shown_progress",
    "simulate",
    "sync",
    "until_s",
    "wanted_scheduling",
    "wanted_speed",
]


def __getattr__(name: str) -> object:
    """Load the module of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = getattr(module, name)
    return globals()[name]
