"""The latency of a device: measured, entered here, or assumed; it is compensated."""

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtWidgets import QDoubleSpinBox, QLabel

from app.bridge.settings import (
    DEVICE,
    Settings,
    enter_latency,
    keep_latency,
    latencies_of,
)
from app.widgets import theme
from app.widgets.layout import captioned, indent, paragraph
from hapticplayer.playback.latency import MOST_S, LatencySource

translate = QCoreApplication.translate

_STEP_MS = 5.0


def source_text(source: LatencySource) -> str:
    """Return how a latency is known."""
    return {
        LatencySource.MEASURED: translate("LatencyField", "measured"),
        LatencySource.ENTERED: translate("LatencyField", "entered"),
        LatencySource.SETTINGS: translate("LatencyField", "entered in its settings"),
        LatencySource.KEPT: translate("LatencyField", "kept by the device's clock"),
        LatencySource.ASSUMED: translate("LatencyField", "typical value, not measured"),
    }[source]


class LatencyField(QObject):
    """A number with its source; what is entered or measured is kept at once.

    Signals:
        changed: another latency is compensated from here on.
    """

    changed = Signal()

    def __init__(self, settings: Settings, parent: QObject) -> None:
        super().__init__(parent)
        self._settings, self._name = settings, ""
        self.number, self.source = QDoubleSpinBox(), paragraph("", theme.DIM)
        self.caption: QLabel
        self.caption, _ = captioned(self.tr("Latency"), self.number)
        self.number.setRange(0.0, 1e3 * MOST_S)
        self.number.setDecimals(1)
        self.number.setSingleStep(_STEP_MS)
        self.number.setSuffix("\u00a0ms")
        self.number.setToolTip(self.tr("From a command to what is felt: compensated"))
        indent(self.number)
        self.number.editingFinished.connect(self._on_entered)

    def follow(self, name: str) -> None:
        """Show what is known of a device; its settings are right."""
        self._name = name
        known = latencies_of(self._settings, "").of_device(name)
        self.number.setValue(1e3 * known.latency_s)
        self.number.setEnabled(known.source is not LatencySource.SETTINGS)
        self.source.setText(source_text(known.source))
        self._shown_ms = self.number.value()

    def take(self, latency_s: float) -> None:
        """Keep what a test has measured, unless a person knows better."""
        known = latencies_of(self._settings, "").of_device(self._name)
        if known.source in (LatencySource.ASSUMED, LatencySource.MEASURED):
            keep_latency(
                self._settings, DEVICE, self._name, 1e3 * min(latency_s, MOST_S)
            )
            self._keep()

    def _on_entered(self) -> None:
        if self._name and self.number.value() != self._shown_ms:
            enter_latency(self._settings, self._name, self.number.value())
            self._keep()

    def _keep(self) -> None:
        self._settings.save()
        self.follow(self._name)
        self.changed.emit()
