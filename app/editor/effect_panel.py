"""The effect that is selected: what it is, and whether it is switched on."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QLabel, QWidget

from app.editor.editing import Editing
from app.editor.lanes import effect_title, span_text
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, column_of, paragraph, row_of

LEAST_PX = 230


class EffectPanel(QWidget):
    """Shows the selected effect of a document, and changes it."""

    def __init__(self, editing: Editing, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.editing = editing
        self.setMinimumWidth(LEAST_PX)
        self.title, self.span = QLabel(), QLabel()
        self.title.setFont(theme.scaled(self.font(), 1.1, bold=True))
        self.span.setStyleSheet(f"color: {theme.DIM};")
        for label in (self.title, self.span):
            label.setTextFormat(Qt.TextFormat.PlainText)
        self.hint = paragraph(
            self.tr(
                "Drag a kind of effect onto the time line, or click an event there. "
                "The recorded motion never changes."
            ),
            theme.DIM,
        )
        self.enabled = QCheckBox(self.tr("Switched &on"))
        self.duplicate = text_button(
            self.tr("Dupl&icate"), self.tr("Add a copy after it (Ctrl+D)")
        )
        self.delete = text_button(self.tr("De&lete"), self.tr("Delete it (Del)"))
        self.enabled.clicked.connect(lambda is_on: self.editing.switch(is_on=is_on))
        self.duplicate.clicked.connect(editing.duplicate)
        self.delete.clicked.connect(editing.delete)
        column_of(
            *(self.title, self.span, self.hint, self.enabled),
            STRETCH,
            row_of(self.duplicate, self.delete, STRETCH, spacing=8),
            spacing=6,
            of=self,
        )
        editing.document.changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show what is selected now."""
        effect = self.editing.document.effect
        is_there = effect is not None
        for widget in (self.enabled, self.duplicate, self.delete):
            widget.setVisible(is_there)
        self.span.setVisible(is_there)
        self.hint.setVisible(not is_there)
        self.title.setText(self.tr("No effect is selected"))
        if effect is not None:
            self.title.setText(effect_title(effect))
            self.span.setText(span_text(effect.start_s, effect.end_s))
            self.enabled.setChecked(effect.enabled)
            self.duplicate.setEnabled(self.editing.can_add)
