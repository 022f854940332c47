"""What a person does to effects, by mouse, keys and buttons alike; each can be undone."""

from dataclasses import replace

from PySide6.QtCore import QObject

from app.editor import edits
from app.editor.document import Document
from app.editor.spans import Part
from hapticplayer.rendering.effects import Effect
from hapticplayer.rendering.effects.values import MAX_EFFECTS


class Editing(QObject):
    """Changes a document within a clip; what needs an effect takes the selected one."""

    def __init__(self, document: Document, duration_s: float = 0.0) -> None:
        super().__init__()
        self.document, self.duration_s = document, duration_s
        self._copied: Effect | None = None
        self._gestures = 0

    @property
    def can_add(self) -> bool:
        """Whether the list has room for one more."""
        return len(self.document.effects) < MAX_EFFECTS

    def begin_gesture(self) -> str:
        """Return a name for changes that are one step."""
        self._gestures += 1
        return f"gesture {self._gestures}"

    def add_kind(self, kind: str, at_s: float) -> None:
        self.add(edits.new_effect(kind, at_s, self.duration_s), self.tr("Add"))

    def add(self, effect: Effect, text: str) -> None:
        if self.can_add:
            self.document.change(edits.added(self.document.effects, effect), text)

    def put(self, effect: Effect, text: str, gesture: str = "") -> None:
        """Put an effect in place of the selected one."""
        number = self.document.selected
        if number is not None:
            changed = edits.replaced(self.document.effects, number, effect)
            self.document.change(changed, text, gesture and f"{gesture} {number}")

    def move(self, effect: Effect, by_s: float, gesture: str) -> None:
        moved = edits.moved(effect, by_s, self.duration_s)
        self.put(moved, self.tr("Move"), gesture)

    def stretch(self, effect: Effect, part: Part, to_s: float, gesture: str) -> None:
        """Let the selected effect begin or end somewhere else."""
        made = edits.stretched(effect, part, to_s, self.duration_s)
        self.put(made, self.tr("Stretch"), gesture)

    def delete(self) -> None:
        """Delete the selected effect."""
        number = self.document.selected
        if number is not None:
            left = edits.removed(self.document.effects, number)
            self.document.change(left, self.tr("Delete"))

    def reorder(self, by: int) -> None:
        """Apply the selected effect earlier (-1) or later (+1) than now."""
        number, count = self.document.selected, len(self.document.effects)
        if number is None or not 0 <= number + by < count:
            return
        changed = edits.reordered(self.document.effects, number, number + by)
        self.document.change(changed, self.tr("Change the order"))
        self.document.select(number + by)

    def duplicate(self) -> None:
        """Add a copy after the selected effect."""
        effect = self.document.effect
        if effect is not None:
            copy = edits.copied_to(effect, effect.end_s, self.duration_s)
            self.add(copy, self.tr("Duplicate"))

    def copy(self) -> None:
        """Remember the selected effect."""
        self._copied = self.document.effect or self._copied

    def paste(self, at_s: float) -> None:
        if self._copied is not None:
            copy = edits.copied_to(self._copied, at_s, self.duration_s)
            self.add(copy, self.tr("Paste"))

    def switch(self, *, is_on: bool) -> None:
        """Switch the selected effect on or off."""
        effect = self.document.effect
        if effect is not None:
            text = self.tr("Switch on") if is_on else self.tr("Switch off")
            self.put(replace(effect, enabled=is_on), text)

    def toggle(self) -> None:
        """Switch the selected effect on if it is off, and back."""
        if self.document.effect is not None:
            self.switch(is_on=not self.document.effect.enabled)
