"""The statistics on the video: everything the player knows about itself."""

import math
from typing import Any

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QFont, QFontDatabase, QFontInfo, QFontMetrics
from PySide6.QtWidgets import QWidget

from app.player.choices import feedbacks
from app.player.health import clock, device, scheduling
from app.widgets.messages import OnPicture
from app.widgets.texts import local, position_text
from hapticplayer.model import SyncStats
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Snapshot

translate = QCoreApplication.translate

REFRESH_HZ = 4.0
_DASH = "\u2013"
_AROUND_PX = 28  # of the text, above and below
_SMALLEST_PX = 6


class Statistics(OnPicture):
    """Figures over the video, in columns; costs nothing while hidden."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self._over = over
        self._usual = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
        self.setFont(self._usual)

    def refresh(self, player: Player) -> None:
        """Show the figures of now."""
        rows = figures(player)
        wide = max(len(name) for name, _ in rows)
        self._fit(len(rows))
        self.show_text("\n".join(f"{name:<{wide}}  {text}" for name, text in rows))

    def _fit(self, lines: int) -> None:
        """Take smaller letters where the video is too low for the usual ones."""
        room_px = self._over.height() - _AROUND_PX
        needed_px = lines * QFontMetrics(self._usual).lineSpacing()
        font = QFont(self._usual)
        if needed_px > room_px:
            fitting_px = QFontInfo(font).pixelSize() * room_px // needed_px
            font.setPixelSize(max(_SMALLEST_PX, fitting_px))
        if font != self.font():
            self.setFont(font)
            self.adjustSize()


def figures(player: Player) -> list[tuple[str, str]]:
    """Return (name, value) of everything that is known."""
    snapshot, measured = player.snapshot(), player.measurements()
    clip = snapshot.source.clip if snapshot.source else None
    loop = measured.loop
    rows = [
        (
            translate("Statistics", "Clip"),
            local(f"{clip.width} x {clip.height}, {clip.frame_rate_hz:.3f} Hz")
            if clip
            else _DASH,
        ),
        (
            translate("Statistics", "Position"),
            position_text(snapshot.media_s, snapshot.duration_s),
        ),
        (translate("Statistics", "Speed"), local(f"{snapshot.speed:.2f}")),
        (
            translate("Statistics", "Frames"),
            translate("Statistics", "{shown} shown, {dropped} dropped").format(
                shown=snapshot.frames_shown, dropped=snapshot.frames_dropped
            ),
        ),
        (translate("Statistics", "Clock"), f"{clock(snapshot).text}  {snapshot.audio}"),
        (translate("Statistics", "Device"), device(snapshot).text),
        (translate("Statistics", "Feedback"), _feedback(snapshot.feedback)),
        (translate("Statistics", "Scheduling"), scheduling(snapshot).text),
        (
            translate("Statistics", "Lateness, \u00b5s"),
            local(
                f"p50 {loop.lateness_p50_us:.0f}  p99 {loop.lateness_p99_us:.0f}  "
                f"p99.9 {loop.lateness_p999_us:.0f}  max {loop.lateness_max_us:.0f}"
            )
            if loop
            else _DASH,
        ),
        (
            translate("Statistics", "Ticks"),
            translate("Statistics", "{n} in 10 s, {missed} missed").format(
                n=loop.ticks, missed=loop.missed
            )
            if loop
            else _DASH,
        ),
        (
            translate("Statistics", "Force \u2212 video, ms"),
            _sync(measured.force_minus_video),
        ),
        (
            translate("Statistics", "Force \u2212 sound, ms"),
            _sync(measured.force_minus_audio),
        ),
        (translate("Statistics", "Latency, ms"), _latency(snapshot)),
    ]
    return rows + _tick(snapshot.leading.tick)


def _tick(latest: Any) -> list[tuple[str, str]]:
    """Force and grip in the newest tick."""
    if latest is None:
        return []
    position_mm = [1e3 * value for value in latest["position_m"].tolist()]
    names = (
        (translate("Statistics", "Planned, N"), latest["planned_n"].tolist()),
        (translate("Statistics", "Sent, N"), latest["force_n"].tolist()),
        (translate("Statistics", "Centring, N"), latest["centring_n"].tolist()),
        (translate("Statistics", "Grip, mm"), position_mm),
    )
    return [(name, _vector(values)) for name, values in names]


def _vector(values: list[float]) -> str:
    parts = "  ".join(f"{value:+7.2f}" for value in values)
    return local(f"{parts}  |{math.hypot(*values):6.2f}|")


def _latency(snapshot: Snapshot) -> str:
    """The compensated latencies, and the sound output's own."""
    known, reported_s = snapshot.latency, snapshot.reported_latency_s
    values = (known.display_s, known.sound_s, known.device_s, reported_s)
    text = translate(
        "Statistics", "video {0:.0f}  sound {1:.0f}  force {2:.0f}  reported {3:.0f}"
    )
    return text.format(*(1e3 * value for value in values))


def _feedback(name: str) -> str:
    return feedbacks([name])[0].text if name else _DASH


def _sync(stats: SyncStats | None) -> str:
    if stats is None:
        return _DASH
    return local(
        f"p05 {stats.p05_ms:+.2f}  p50 {stats.p50_ms:+.2f}  p95 {stats.p95_ms:+.2f}"
    )
