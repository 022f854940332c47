"""What a recording is told of its disk, and which streams end while there is room for it."""

import shutil
from collections.abc import Iterator
from pathlib import Path

from hapticplayer.errors import Message, message_of
from hapticplayer.storage import StorageError, disk_of, write_problem

LOW_BYTES = 500 << 20
"""Of free disk, below which a person is told."""

FILM_BYTES, LOG_BYTES = 32 << 20, 1 << 20
"""Of free disk, below which film and log end, so that each gets its end and is whole."""


class DiskWatch:
    """The disk of a folder that is recorded into.

    Attributes:
        ended: streams that may not write any more.
    """

    def __init__(self, folder: Path) -> None:
        self._folder, self._is_low = folder, False
        self.ended: set[str] = set()

    def free_bytes(self) -> int:
        place = (
            self._folder if self._folder.exists() else self._folder.absolute().parent
        )
        return shutil.disk_usage(place).free

    def look(self, elapsed_s: float, recorded: set[str]) -> Iterator[Message]:
        """What to tell now, of a recording so long with these streams."""
        free_bytes = self.free_bytes()
        if free_bytes < LOW_BYTES and not self._is_low:
            self._is_low = True
            written = sum(one.stat().st_size for one in self._folder.iterdir())
            yield Message(
                "only {free_mb} MB of the disk are free, enough for {minutes:.0f} min",
                free_mb=free_bytes >> 20,
                minutes=elapsed_s / 60.0 * free_bytes / max(1, written),
            )
        for stream, least_bytes in (("camera", FILM_BYTES), ("imu", LOG_BYTES)):
            if free_bytes < least_bytes and stream in recorded - self.ended:
                self.ended.add(stream)
                yield Message(
                    "{stream}: ends here, the disk at {disk} is full; what was recorded "
                    "is kept",
                    stream=stream,
                    disk=disk_of(self._folder),
                )


def of_writing(problem: Exception, folder: Path) -> Message | None:
    """What to tell where the folder failed, not a device; None for a device."""
    where = getattr(problem, "where", "") or ""
    is_ours = isinstance(problem, (StorageError, OSError))
    if not is_ours and not where.startswith(str(folder)):
        return None
    cause = problem if isinstance(problem, OSError) else problem.__cause__
    reason = message_of(problem)
    if isinstance(cause, OSError):
        reason = write_problem(cause, folder)
    return Message(
        "{folder} cannot be written ({reason}); what was recorded until now is kept",
        folder=folder,
        reason=reason,
    )
