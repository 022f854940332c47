"""What was opened before, and where each clip was left."""

import math
from pathlib import Path

from app.bridge.settings import Settings
from hapticplayer.playback.player import Player

RECENT, POSITIONS = "recent", "positions"
"""Names in the settings."""

MOST_RECENT, MOST_POSITIONS = 10, 200
FROM_START_S, FROM_END_S = 5.0, 5.0
"""Nearer to an end of the clip than this, it begins anew."""


class History:
    """Remembers paths and positions, nothing else, and nothing beside the clips."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings

    def recent(self) -> list[Path]:
        """Return what was opened, the latest first."""
        return [Path(text) for text in self._settings.texts(RECENT)[:MOST_RECENT]]

    def note_opened(self, path: Path) -> None:
        """Put a path at the top of the list."""
        whole = str(path.absolute())
        others = [text for text in self._settings.texts(RECENT) if text != whole]
        self._settings.keep(RECENT, [whole, *others][:MOST_RECENT])

    def forget(self) -> None:
        """Empty the list, and forget the positions."""
        self._settings.keep(RECENT, [])
        self._settings.keep(POSITIONS, {})

    def note_position(self, player: Player) -> None:
        """Remember where the clip is; not at its ends."""
        now = player.snapshot()
        if now.source is None:
            return
        place, kept = str(now.source.path.absolute()), self._positions()
        kept.pop(place, None)
        media_s = now.media_s
        if is_worth_keeping(media_s, now.duration_s):
            kept[place] = round(media_s, 3)
        newest = list(kept.items())[-MOST_POSITIONS:]
        self._settings.keep(POSITIONS, dict(newest))

    def position_s(self, path: Path, duration_s: float) -> float:
        """Return where a clip was left, 0 where it is to begin at its beginning."""
        kept_s = self._positions().get(str(path.absolute()), 0.0)
        return kept_s if is_worth_keeping(kept_s, duration_s) else 0.0

    def _positions(self) -> dict[str, float]:
        kept = self._settings.table(POSITIONS)
        return {
            path: float(value)
            for path, value in kept.items()
            if isinstance(value, int | float) and math.isfinite(value)
        }


def is_worth_keeping(media_s: float, duration_s: float) -> bool:
    """Whether somebody would want to go on here."""
    return FROM_START_S <= media_s <= duration_s - FROM_END_S
