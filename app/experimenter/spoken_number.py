"""Where the operator enters a number that the participant says during a clip."""

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QLabel, QSpinBox, QWidget

from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, row_of
from hapticplayer.study.definition import LiveRating
from hapticplayer.study.runner import SessionRunner

translate = QCoreApplication.translate


class SpokenNumber(QWidget):
    """Shown while a number is asked for that is said aloud."""

    def __init__(self) -> None:
        super().__init__()
        self._runner: SessionRunner | None = None
        self._asking: LiveRating | None = None
        self.text, self.box = QLabel(), QSpinBox()
        self.box.setAccessibleName(
            translate("SpokenNumber", "The number that was said")
        )
        self.enter = text_button(translate("SpokenNumber", "Enter"), "", "primary")
        self.enter.clicked.connect(self.give)
        line = self.box.lineEdit()
        line.returnPressed.connect(self.give)
        row_of(self.text, self.box, self.enter, STRETCH, spacing=8, of=self)
        self.hide()

    def follow(self, runner: SessionRunner | None) -> None:
        """Show what is asked for now, if anything."""
        self._runner = runner
        asking = runner.watching.asking if runner and runner.watching else None
        wanted = asking if asking is not None and asking.spoken else None
        if wanted is self._asking:
            return
        self._asking = wanted
        self.setVisible(wanted is not None)
        if runner is not None and wanted is not None:
            least, most = wanted.least or 0, wanted.most or 0
            self.text.setText(
                f"{wanted.text[runner.plan.language]} ({least} \u2013 {most})"
            )
            self.box.setRange(least, most)
            self.box.setValue(least)
            self.box.setFocus()
            self.box.selectAll()

    def give(self) -> None:
        """Keep the number."""
        runner, asking = self._runner, self._asking
        if runner is not None and runner.watching is not None and asking is not None:
            self.box.interpretText()
            runner.watching.give(asking.key, self.box.value())
            self.follow(runner)
