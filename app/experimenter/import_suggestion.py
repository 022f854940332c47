"""Import, a video without motion: an estimate from the picture is offered."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QFrame

from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.layout import column_of, paragraph
from app.widgets.texts import titled
from hapticplayer.errors import TelemetryError
from hapticplayer.sequence.synchronizing import is_exact


class SuggestionBox(QFrame):
    """Offers to estimate motion from the frames, and says what to expect."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.is_wanted = False
        self.setObjectName("suggestion")
        self.setStyleSheet(
            f"QFrame#suggestion {{ border: 1px solid {theme.BORDER}; "
            "border-radius: 5px; }"
        )
        self.reason, self.expect = paragraph(), paragraph("", theme.DIM)
        self.reason.setTextFormat(Qt.TextFormat.PlainText)
        self.choice = QCheckBox(self.tr("S&uggest motion from the frames (estimate)"))
        self.choice.toggled.connect(self.changed)
        self.expect.setText(
            self.tr(
                "Expect to feel turns of a vehicle, and steps when walking or riding; "
                "braking, knocks and potholes will be missing. Nothing measures this "
                "motion: set its strength by hand with the gain, and do not use it in a "
                "study without saying so. Slow motion and time lapse are taken as they "
                "play."
            )
        )
        self.missing = paragraph(
            self.tr("This needs OpenCV: see Help > System check."),
            theme.WARN,
        )
        parts = (self.reason, self.choice, self.expect, self.missing)
        column_of(*parts, margins=(9, 9, 9, 9), of=self)
        self.hide()

    @property
    def is_chosen(self) -> bool:
        """Whether the motion is to be estimated."""
        return not self.isHidden() and self.choice.isChecked()

    def offer(self, video: Path, problem: TelemetryError) -> None:
        """Say why the video alone has no motion, and what can be done."""
        way = self.tr("Choose its motion log above, if there is one.")
        reason = titled(video.name, translated(problem.what))
        self.reason.setText(f"{reason}. {way}")
        self.choice.setChecked(self.is_wanted and is_exact())
        self.choice.setEnabled(is_exact())
        self.is_wanted = False  # of this video alone
        self.missing.setVisible(not is_exact())
        self.show()
