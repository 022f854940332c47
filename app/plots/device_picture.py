"""A picture of what a device is sent, by what it can do: a grip, a platform, a wheel, bars.

Which one it is comes from the capability record alone, so that devices of other
packages have theirs.
"""

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QStackedLayout, QWidget

from app.plots.grip_scene import (
    ACTIVITIES,
    Activity,
    Grip,
    force_of,
    position_of,
    trail_of,
)
from app.plots.grip_view import GripView
from app.plots.rig_platform import Follower, PlatformPose, reached
from app.plots.rig_view import RigView, floor_painter
from app.widgets import theme
from app.widgets.layout import read_in_order
from app.widgets.level_meter import LEAST_DB
from app.widgets.texts import local
from hapticplayer.haptics.contract import Mode
from hapticplayer.model.device import ChannelLevel, DeviceCapabilities, Signal
from hapticplayer.model.rig import RigMotion

translate = QCoreApplication.translate

LEAST_PX, WANTED_PX = QSize(260, 170), QSize(380, 250)
KEPT_TICKS = 600
"""Of the last half second, for the trail of a grip."""
STEP = 0.005
"""Of a share, too small to be seen: it is not painted again."""
_WHEEL_RAD = math.radians(100.0)
"""How far the wheel of the picture turns at full strength; a real one turns on."""
ENLARGED = 6
"""Of a rig's motion: with a small gain a gentle test would hardly be seen."""
_MOTION = ("planned_n", "force_n", "position_m", "velocity_mps", "centring_n")
"""Columns of a tick that hold a `RigMotion` in ticks of a rig's loop."""


class Bar(NamedTuple):
    """One bar: its label, how full it is (0 to 1), whether it is at its limit."""

    label: str
    share: float
    is_limited: bool = False


class GripPicture(GripView):
    """The force on a grip that is free to go in two or three directions."""

    def __init__(self, record: DeviceCapabilities) -> None:
        super().__init__()
        self._record = record
        self._ticks: NDArray[Any] | None = None

    def show_sent(self, ticks: NDArray[Any], _levels: tuple[ChannelLevel, ...]) -> None:
        """Show the newest of some ticks (see TICK), none for a device at rest."""
        title = translate("DevicePicture", "Grip")
        if not len(ticks):
            self._ticks = None
            state = translate("DevicePicture", "Force is off")
            self.show_grip(self._sized(Grip(title, state)))
            return
        kept = ticks if self._ticks is None else np.concatenate([self._ticks, ticks])
        self._ticks = kept = kept[-KEPT_TICKS:]
        last, mode = kept[-1], Mode(int(kept["mode"][-1]))
        self.show_grip(
            self._sized(
                Grip(
                    title,
                    translate("DevicePicture", "Test"),
                    ACTIVITIES.get(mode, Activity.CHANGING),
                    position_of(last),
                    force_of(last, "force_n"),
                    force_of(last, "planned_n"),
                    force_of(last, "centring_n"),
                    trail_of(kept),
                )
            )
        )

    def _sized(self, grip: Grip) -> Grip:
        """Return it in the workspace and with the arrows of this device."""
        record = self._record
        return replace(
            grip,
            radius_m=record.workspace_radius_m or grip.radius_m,
            full_force_n=record.continuous_force_n or grip.full_force_n,
        )


class RigPicture(RigView):
    """The platform of a motion rig, as the packets ask for it."""

    def __init__(self, _record: DeviceCapabilities) -> None:
        super().__init__()
        self._follower = Follower()

    def show_sent(self, ticks: NDArray[Any], _levels: tuple[ChannelLevel, ...]) -> None:
        """Show the newest of some ticks, whose columns are a `RigMotion`."""
        if not len(ticks):
            self._follower = Follower()
            self.show_pose(PlatformPose(), is_clamped=False)
            return
        last = ticks[-1]
        sent = RigMotion(*np.concatenate([last[name] for name in _MOTION]).tolist())
        shown = RigMotion(*(ENLARGED * value for value in sent[:6]))
        asked = self._follower.pose(shown, float(last["monotonic_s"]))
        pose, share = reached(asked)
        self.show_pose(pose, is_clamped=share < 1.0)

    def spoken(self) -> str:
        """The pose, as large as it is drawn."""
        return f"{super().spoken()}. {_enlargement()}"

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        painter.setPen(QColor(theme.DIM))
        place = self.rect().adjusted(8, 6, -8, -6)
        painter.drawText(
            place,
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom,
            _enlargement(),
        )


def _enlargement() -> str:
    text = translate("DevicePicture", "Motion shown {factor}\u00d7 larger")
    return text.format(factor=ENLARGED)


_AT_THE_TOP = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop


class _Drawn(QWidget):
    """What is painted here from shares of the largest force."""

    def __init__(self, record: DeviceCapabilities) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(LEAST_PX)
        self._record = record

    def sizeHint(self) -> QSize:
        return WANTED_PX

    def paint_name(self, painter: QPainter) -> None:
        """Write what is shown over the picture."""
        painter.setPen(QColor(theme.DIM))
        place = self.rect().adjusted(8, 6, -8, -6)
        painter.drawText(place, _AT_THE_TOP, self.accessibleName())

    def share_of(self, force_n: float) -> float:
        """Return a force as a share of the largest one, in steps that are seen."""
        share = force_n / (self._record.peak_force_n or 1.0)
        if not math.isfinite(share):
            return 0.0
        return STEP * round(max(-1.0, min(1.0, share)) / STEP)


class WheelPicture(_Drawn):
    """A wheel that turns with a force along one axis, and a bar to both sides."""

    def __init__(self, record: DeviceCapabilities) -> None:
        super().__init__(record)
        self.setAccessibleName(translate("DevicePicture", "Force along one axis"))
        self.share = 0.0

    def show_sent(self, ticks: NDArray[Any], _levels: tuple[ChannelLevel, ...]) -> None:
        """Show the newest of some ticks, none for a device at rest."""
        axis = self._record.first_axis
        share = self.share_of(float(ticks["force_n"][-1][axis])) if len(ticks) else 0.0
        if share != self.share:
            self.share = share
            self.update()

    def spoken(self) -> str:
        """The force as a share of the largest one."""
        return _percent(self.share)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = floor_painter(self)
        self.paint_name(painter)
        wide, high = float(self.width()), float(self.height())
        bar_px, radius = 0.07 * high, 0.29 * min(0.9 * wide, high)
        self._paint_wheel(painter, QPointF(0.5 * wide, 0.47 * high), radius)
        groove = QRectF(0.15 * wide, 0.88 * high - bar_px, 0.7 * wide, bar_px)
        _paint_groove(painter, groove)
        middle = groove.center().x()
        end = middle + 0.5 * groove.width() * self.share
        filled = QRectF(min(middle, end), groove.top(), abs(end - middle), bar_px)
        painter.fillRect(filled, QColor(theme.GOOD))
        painter.setPen(QPen(QColor(theme.TEXT), 2.0))
        painter.drawLine(
            QPointF(middle, groove.top() - 3.0), QPointF(middle, groove.bottom() + 3.0)
        )

    def _paint_wheel(self, painter: QPainter, centre: QPointF, radius: float) -> None:
        colour = QColor(theme.GOOD if self.share else theme.DIM)
        painter.setPen(QPen(colour, 0.16 * radius))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawEllipse(centre, radius, radius)
        turned = _WHEEL_RAD * self.share
        for spoke_rad in (math.pi, 0.0, 0.5 * math.pi):
            angle = spoke_rad + turned
            rim = QPointF(radius * math.cos(angle), radius * math.sin(angle))
            painter.drawLine(centre, centre + rim)
        top = turned - 0.5 * math.pi
        mark = QPointF(radius * math.cos(top), radius * math.sin(top))
        painter.setPen(QPen(QColor(theme.TEXT), 0.18 * radius))
        painter.drawPoint(centre + mark)


class BarsPicture(_Drawn):
    """A bar for the strength of a vibration, or one for each channel of a sound card."""

    def __init__(self, record: DeviceCapabilities) -> None:
        super().__init__(record)
        self.setAccessibleName(translate("DevicePicture", "Strength of the vibration"))
        self.bars: tuple[Bar, ...] = (Bar("", 0.0),)

    def show_sent(self, ticks: NDArray[Any], levels: tuple[ChannelLevel, ...]) -> None:
        """Show what channels play, or else the newest of some ticks."""
        size_n = float(np.linalg.norm(ticks["force_n"][-1])) if len(ticks) else 0.0
        bars = tuple(map(_bar_of, levels)) or (Bar("", self.share_of(size_n)),)
        if bars != self.bars:
            self.bars = bars
            self.update()

    def spoken(self) -> str:
        """Each bar as a share of the largest force."""
        said = (f"{bar.label} {_percent(bar.share)}".strip() for bar in self.bars)
        return ", ".join(said)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = floor_painter(self)
        self.paint_name(painter)
        wide, high = float(self.width()), float(self.height())
        words = self.fontMetrics().height() + 8.0
        each = 0.8 * wide / max(3, len(self.bars))
        left = 0.5 * (wide - each * len(self.bars))
        for place, bar in enumerate(self.bars):
            at = left + each * place
            long = high - 2.0 * words - 16.0
            groove = QRectF(at + 0.2 * each, words + 12.0, 0.6 * each, long)
            _paint_groove(painter, groove)
            top = groove.bottom() - bar.share * groove.height()
            filled = QRectF(groove.left(), top, groove.width(), groove.bottom() - top)
            painter.fillRect(
                filled, QColor(theme.BAD if bar.is_limited else theme.GOOD)
            )
            painter.setPen(QColor(theme.TEXT))
            below = QRectF(at, groove.bottom() + 4.0, each, words - 4.0)
            painter.drawText(below, Qt.AlignmentFlag.AlignCenter, bar.label)


def _bar_of(level: ChannelLevel) -> Bar:
    share = min(1.0, max(0.0, 1.0 - level.peak_db / LEAST_DB))
    return Bar(str(level.channel), STEP * round(share / STEP), level.is_limited)


def _percent(share: float) -> str:
    return local(f"{100 * share:.0f}\u00a0%")


def _paint_groove(painter: QPainter, groove: QRectF) -> None:
    painter.setPen(QPen(QColor(theme.BORDER), 1.0))
    painter.setBrush(QColor(theme.BACKGROUND))
    painter.drawRect(groove)


Inner = GripPicture | RigPicture | WheelPicture | BarsPicture


def picture_of(record: DeviceCapabilities) -> Inner:
    """Return the picture of a device that can do this."""
    if record.signal is Signal.MOTION:
        return RigPicture(record)
    if record.axes >= 2:
        return GripPicture(record)
    return WheelPicture(record) if record.axes else BarsPicture(record)


class DevicePicture(QWidget):
    """The picture of one device after the other."""

    def __init__(self) -> None:
        super().__init__()
        self._record: DeviceCapabilities | None = None
        self.shown: Inner | None = None
        self._stack = QStackedLayout(self)

    def set_record(self, record: DeviceCapabilities) -> None:
        """Show a device at rest that can do this."""
        if record == self._record:
            self.show_sent(_NO_TICKS, ())
            return
        self._record = record
        if self.shown is not None:
            self._stack.removeWidget(self.shown)
            self.shown.deleteLater()
        self.shown = picture_of(record)
        self._stack.addWidget(self.shown)
        read_in_order(self.window())
        self.show_sent(_NO_TICKS, ())

    def show_sent(self, ticks: NDArray[Any], levels: tuple[ChannelLevel, ...]) -> None:
        """Show the newest of some ticks (see TICK); none is a device at rest."""
        if self.shown is not None:
            self.shown.show_sent(ticks, levels)


_NO_TICKS: NDArray[Any] = np.empty(0)
