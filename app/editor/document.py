"""The effects that are being edited, with undo and redo."""

from app.editor.edits import changed_number
from app.widgets.steps import Steps
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList


class Document(Steps[EffectList]):
    """A list of effects of which one may be selected.

    `changed` means that the effects are others, or what is selected.
    """

    def __init__(self, effects: EffectList = NO_EFFECTS) -> None:
        super().__init__(effects)
        self.selected: int | None = None

    @property
    def effects(self) -> EffectList:
        return self.value

    @property
    def effect(self) -> Effect | None:
        number = self.selected
        return None if number is None else self.effects.effects[number]

    def open(self, effects: EffectList) -> None:
        """Begin with other effects; there is nothing to undo."""
        self.selected = None
        self.begin(effects)

    def select(self, number: int | None) -> None:
        if number != self.selected:
            self.selected = number
            self.changed.emit()

    def put(self, value: EffectList) -> None:
        """Show effects, and select what has changed; for the steps themselves."""
        self.selected = changed_number(self.value, value)
        super().put(value)
