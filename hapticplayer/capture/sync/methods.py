"""The registry of synchronisation methods, one line for each.

Command line, window and documents use it; a new method is a line here or in an extra,
and its function, which is imported when it is used.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, cast

from hapticplayer import extension
from hapticplayer.errors import Message, entry_named

if TYPE_CHECKING:
    from hapticplayer.capture.sync.result import Synchronisation, SyncInput


class SyncMethod(NamedTuple):
    """One way to synchronise a log with a clip.

    Attributes:
        name: for `--method` and `--sync`.
        text: for people.
        home: of its function, as module:name.
        title: of a few words, for lists; the name if "".
    """

    name: str
    text: Message
    home: str
    title: Message | str = ""

    def function(self) -> "Callable[[SyncInput], Synchronisation]":
        """Import its function."""
        return cast("Callable[[SyncInput], Synchronisation]", extension.load(self.home))


AUTO = "auto"

_HERE = "hapticplayer.capture.sync.synchronize"
SYNC_METHODS: tuple[SyncMethod, ...] = (
    SyncMethod(AUTO, Message("the offset you give, if any; else the clock that clip and log share; else taps and frames"), f"{_HERE}:automatic", Message("Automatic")),
    SyncMethod("pats", Message("three taps on the camera, heard and felt"), f"{_HERE}:by_pats", Message("Tap marks")),
    SyncMethod("variance", Message("the first sudden rise of sound and motion, as in the paper"), f"{_HERE}:by_variance", Message("First sudden rise")),
    SyncMethod("embedded", Message("the recording's own clock"), f"{_HERE}:by_own_clock", Message("Own clock")),
    SyncMethod("offset", Message("the offset that is given"), f"{_HERE}:by_given_offset", Message("Given offset")),
)  # fmt: skip


def sync_methods() -> tuple[SyncMethod, ...]:
    """Those of the core and of extensions."""
    return tuple(extension.rows("sync_methods", SyncMethod, SYNC_METHODS))


def sync_method(name: str) -> SyncMethod:
    """Return a method by its name.

    Raises:
        UsageError: naming the methods there are.
    """
    return entry_named(
        {one.name: one for one in sync_methods()}, name, Message("method")
    )


def title_of(name: str) -> Message | str:
    """The title of a method; an unknown one is called by its name."""
    return next((one.title or name for one in sync_methods() if one.name == name), name)
