"""The effects that are being edited, with undo and redo."""

from typing import NamedTuple

from app.editor.edits import changed_numbers
from app.editor.spans import Part
from app.widgets.steps import Steps
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList


class Handle(NamedTuple):
    """What of the leading effect is selected: a fade, or one of its control points."""

    part: Part
    point: int = 0


class Document(Steps[EffectList]):
    """A list of effects of which some may be selected; the last of them leads.

    `changed` means that the effects are others, or what is selected.
    """

    def __init__(self, effects: EffectList = NO_EFFECTS) -> None:
        super().__init__(effects)
        self.selection: tuple[int, ...] = ()
        self.handle: Handle | None = None

    @property
    def effects(self) -> EffectList:
        return self.value

    @property
    def selected(self) -> int | None:
        """Number of the effect that leads."""
        return self.selection[-1] if self.selection else None

    @property
    def effect(self) -> Effect | None:
        number = self.selected
        return None if number is None else self.effects.effects[number]

    @property
    def chosen(self) -> dict[int, Effect]:
        """All that are selected, by their numbers."""
        return {k: self.effects.effects[k] for k in sorted(self.selection)}

    def open(self, effects: EffectList) -> None:
        """Begin with other effects; there is nothing to undo."""
        self.selection, self.handle = (), None
        self.begin(effects)

    def select(self, *numbers: int) -> None:
        """Select these alone; the last one leads."""
        if numbers != self.selection or self.handle is not None:
            self.selection, self.handle = numbers, None
            self.changed.emit()

    def add_to_selection(self, number: int) -> None:
        """Let it lead, beside what is selected."""
        self.select(*(k for k in self.selection if k != number), number)

    def toggle(self, number: int) -> None:
        """Select it as well, or no longer."""
        if number in self.selection:
            self.select(*(k for k in self.selection if k != number))
        else:
            self.add_to_selection(number)

    def hold(self, handle: Handle | None) -> None:
        """Select a part of the leading effect."""
        if handle != self.handle:
            self.handle = handle
            self.changed.emit()

    def put(self, value: EffectList) -> None:
        """Show effects, and select what has changed; for the steps themselves."""
        changed = changed_numbers(self.value, value)
        is_same = len(value) == len(self.value) and set(changed) <= set(self.selection)
        if not is_same:
            self.selection, self.handle = changed, None
        elif self.handle is not None and self.handle.part is Part.POINT:
            curve = value.effects[self.selection[-1]].curve
            if self.handle.point >= len(curve):
                self.handle = None
        super().put(value)
