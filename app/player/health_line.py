"""The line at the bottom: is everything in order?"""

from collections import deque
from typing import NamedTuple

from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QWidget

from app.player.health import Frames, Level, Reading, level_word, readings
from app.widgets import theme
from app.widgets.layout import ElidedLabel, column_of, row_of
from app.widgets.level_meter import LevelMeter
from app.widgets.texts import titled
from hapticplayer.playback.snapshot import Measurements, Snapshot

_SIGN_ROOM_PX = 20
_LATELY = 20
"""Readings, two a second: what was dropped earlier does not make the sign red."""
_APART_PX = 4
BETWEEN_PX = 14
_IN_FIRST_ROW = 3  # of two: device, scheduling, real-time
_LETTERS = (1.0, 0.92, 0.84)  # smaller ones where what is said needs it


class _Column(NamedTuple):
    title: str
    tip: str
    widest: str


class HealthEntry(QWidget):
    """A title, and under it a sign and a value."""

    def __init__(self, of: _Column) -> None:
        super().__init__()
        self._title, self._tip = of.title, of.tip
        title = self._name = ElidedLabel(of.title, theme.DIM)
        title.setFont(theme.scaled(self.font(), 0.85))
        self._sign = ElidedLabel("\u25cb", theme.DIM)
        self._sign.fix_width(self.fontMetrics().horizontalAdvance("\u25a0") + 2)
        self._value = ElidedLabel("\u2013")
        self.meter = LevelMeter(self._title, is_narrow=True)
        value = row_of(self._sign, (self._value, 1), self.meter, spacing=_APART_PX)
        column_of(title, value, spacing=1, of=self)

    def set_font_size(self, factor: float) -> None:
        """Take letters of this share of the usual size."""
        self._name.setFont(theme.scaled(self.font(), 0.85 * factor))
        for label in (self._sign, self._value):
            label.setFont(theme.scaled(self.font(), factor))

    def needed_px(self) -> int:
        """Return the width with which nothing is shortened now."""
        value_px = self._sign.width() + _APART_PX + self._value.sizeHint().width()
        if self.meter.levels:
            value_px += _APART_PX + self.meter.sizeHint().width()
        return max(self._name.sizeHint().width(), value_px)

    def text(self) -> str:
        return self._value.text()

    def show_reading(self, reading: Reading) -> None:
        """Show a value; its judgement as sign, colour and word."""
        sign, colour = _signs()[reading.level]
        self._sign.set_text(sign, colour)
        is_alarming = reading.level >= Level.WATCH
        self._value.set_text(reading.text, colour if is_alarming else theme.TEXT)
        said = titled(self._title, f"{reading.text} ({level_word(reading.level)})")
        if said != self.accessibleName():
            self.setAccessibleName(said)
            self.setToolTip(f"{said}\n{self._tip}")


class HealthLine(QFrame):
    """All entries side by side; each keeps its width, whatever its value is.

    Where not all have room, those that say more take it from those that say less; then
    letters are smaller, and where that is not enough there are two rows.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"HealthLine {{ background: {theme.PANEL}; "
            f"border: 0; border-top: 1px solid {theme.BORDER}; }}"
        )
        self.setAccessibleName(self.tr("Health"))
        self._rows = [row_of(spacing=BETWEEN_PX) for _ in range(2)]
        column_of(*self._rows, spacing=3, margins=(12, 4, 12, 5), of=self)
        self.entries = []
        self._rooms_px = []
        for one in self._columns():
            entry = HealthEntry(one)
            wide = max(one.widest, one.title, key=len)
            room_px = self.fontMetrics().horizontalAdvance(wide) + _SIGN_ROOM_PX
            self._rows[0].addWidget(entry, room_px)
            self.entries.append(entry)
            self._rooms_px.append(room_px)
        self._needed_px = [0] * len(self.entries)
        self._letters = 0
        self._frames: deque[Frames] = deque(maxlen=_LATELY)
        self._parts = [range(len(self.entries)), range(0)]
        """Which entries are in which row."""

    def show_readings(self, snapshot: Snapshot, measured: Measurements) -> None:
        """Show what the player reports."""
        found = readings(snapshot, measured, self._frames_before(snapshot))
        for entry, reading in zip(self.entries, found, strict=True):
            entry.show_reading(reading)
        self.entries[0].meter.show_levels(snapshot.leading.levels)
        # why the force has stopped is not cut off while there is room
        self._rooms_px[0] = max(self._rooms_px[0], self.entries[0].needed_px())
        self._share_room()
        layout = self.layout()
        assert layout is not None
        layout.activate()  # now: else new values are drawn once in the old room

    def _frames_before(self, snapshot: Snapshot) -> Frames:
        """The frames of some seconds ago; of another clip there were none."""
        now = Frames(snapshot.frames_shown, snapshot.frames_dropped)
        if self._frames and now < self._frames[-1]:
            self._frames.clear()
        self._frames.append(now)
        return self._frames[0] if len(self._frames) == self._frames.maxlen else Frames()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():  # another row is no reason
            self._take_letters(0)
            self._divide(len(self.entries))
        self._share_room()

    def _take_letters(self, size: int) -> None:
        self._needed_px = [0] * len(self.entries)
        if size != self._letters:
            self._letters = size
            for entry in self.entries:
                entry.set_font_size(_LETTERS[size])

    def _share_room(self) -> None:
        """Entries only grow until the window has another size: nothing jitters."""
        layout = self.layout()
        assert layout is not None
        around = layout.contentsMargins()
        room_px = self.width() - around.left() - around.right()
        now = (entry.needed_px() for entry in self.entries)
        self._needed_px = [
            max(*both) for both in zip(now, self._needed_px, strict=True)
        ]
        if not self._is_room(self._needed_px, room_px):
            if self._letters < len(_LETTERS) - 1:
                self._take_letters(self._letters + 1)
                self._share_room()
                return
            if not self._parts[1]:
                self._take_letters(0)
                self._divide(_IN_FIRST_ROW)
                self._share_room()
                return
        is_wide = self._is_room(self._rooms_px, room_px)
        shares_px = self._rooms_px if is_wide else self._needed_px
        for row, part in zip(self._rows, self._parts, strict=True):
            for place, entry in enumerate(part):
                row.setStretch(place, shares_px[entry])

    def _is_room(self, widths_px: list[int], room_px: int) -> bool:
        """Whether entries of these widths fit into their rows."""
        return all(
            sum(widths_px[k] for k in part) + BETWEEN_PX * (len(part) - 1) <= room_px
            for part in self._parts
        )

    def _divide(self, in_first: int) -> None:
        """Put so many entries into the first row, and the others into the second."""
        self._parts = [range(in_first), range(in_first, len(self.entries))]
        for row, part in zip(self._rows, self._parts, strict=True):
            for place, entry in enumerate(part):
                row.insertWidget(place, self.entries[entry])

    def _columns(self) -> list[_Column]:
        return [
            _Column(
                self.tr("Device"),
                self.tr("The haptic device and what it does"),
                self.tr("Simulated, fading out"),
            ),
            _Column(
                self.tr("Scheduling"),
                self.tr(
                    "Scheduling class of the 1 kHz loop: FIFO is best, slice nearly "
                    "as good; with normal it may be milliseconds late"
                ),
                self.tr("Scheduling"),
            ),
            _Column(
                self.tr("Real-time"),
                self.tr(
                    "99 % of the loop's wake-ups in the last 10 s were no later "
                    "than this. Missed: skipped periods; above 1 % the force is "
                    "limited to 3 N"
                ),
                self.tr("no, 888 \u00b5s, 888 missed"),
            ),
            _Column(
                self.tr("Force \u2212 video"),
                self.tr(
                    "How much later the force comes than the video: median and 95th "
                    "percentile of the last 20 s. More than 15 ms early or 50 ms "
                    "late is noticeable"
                ),
                self.tr("early +88.8, +88.8 ms"),
            ),
            _Column(
                self.tr("Force \u2212 sound"),
                self.tr(
                    "How much later the force comes than the sound: median and 95th "
                    "percentile of the last 20 s. More than 15 ms early or 50 ms "
                    "late is noticeable"
                ),
                self.tr("early +88.8, +88.8 ms"),
            ),
            _Column(
                self.tr("Frames"),
                self.tr(
                    "Frames shown on time, and dropped because they were late; the sign "
                    "tells of the last 10 s"
                ),
                self.tr("88888 shown, 88 dropped"),
            ),
            _Column(
                self.tr("Clock"),
                self.tr(
                    "Master clock: the audio output, or the computer's monotonic "
                    "clock when there is no sound"
                ),
                self.tr("monotonic"),
            ),
        ]


def _signs() -> dict[Level, tuple[str, str]]:
    """Return a sign for each level: not everyone can tell the colours."""
    return {
        Level.NEUTRAL: ("\u25cb", theme.DIM),
        Level.GOOD: ("\u25cf", theme.GOOD),
        Level.WATCH: ("\u25b2", theme.WARN),
        Level.BAD: ("\u25a0", theme.BAD),
    }
