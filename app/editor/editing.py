"""What a person does to effects, by mouse, keys and buttons alike; each can be undone."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from PySide6.QtCore import QObject

from app.editor import edits
from app.editor.document import Document, Handle
from app.editor.spans import Part
from hapticplayer.rendering.effects import Effect, EffectList, TimeMarker, kind_of
from hapticplayer.rendering.effects.values import MAX_EFFECTS, MAX_MARKERS, MAX_POINTS


class Editing(QObject):
    """Changes a document within a clip; what needs effects takes the selected ones."""

    def __init__(self, document: Document, duration_s: float = 0.0) -> None:
        super().__init__()
        self.document, self.duration_s = document, duration_s
        self._copied: list[Effect] = []
        self._gestures = 0

    def begin_gesture(self) -> str:
        """Return a name for changes that are one step."""
        self._gestures += 1
        return f"gesture {self._gestures}"

    # --- the list --------------------------------------------------------------

    @property
    def can_add(self) -> bool:
        """Whether the list has room for one more."""
        return len(self.document.effects) < MAX_EFFECTS

    def add_kind(self, kind: str, at_s: float) -> None:
        self.add(edits.new_effect(kind, at_s, self.duration_s), self.tr("Add"))

    def add(self, effect: Effect, text: str) -> None:
        self.add_all([effect], text)

    def add_all(self, effects: Iterable[Effect], text: str) -> None:
        """Add these, if the list has room for all of them."""
        every = list(effects)
        if every and len(self.document.effects) + len(every) <= MAX_EFFECTS:
            self.document.change(edits.added(self.document.effects, *every), text)

    def put(self, effect: Effect, text: str, gesture: str = "") -> None:
        """Put an effect in place of the one that leads."""
        number = self.document.selected
        if number is not None:
            self._put({number: effect}, text, gesture)

    def _put(self, changed: Mapping[int, Effect], text: str, gesture: str = "") -> None:
        made = edits.replaced(self.document.effects, changed)
        self.document.change(made, text, self._step(gesture))

    def _step(self, gesture: str) -> str:
        return gesture and f"{gesture} {self.document.selection}"

    def take_back(self, before: EffectList, gesture: str) -> None:
        """Let a gesture that goes on have done nothing."""
        self.document.change(before, "", self._step(gesture))

    # --- all that are selected -------------------------------------------------

    def move(
        self, by_s: float, gesture: str, effects: Mapping[int, Effect] | None = None
    ) -> None:
        """Move effects from where they are, or from where they were."""
        effects = effects or self.document.chosen
        if effects:
            made = edits.moved_together(effects.values(), by_s, self.duration_s)
            moved = dict(zip(effects, made, strict=True))
            self._put(moved, self.tr("Move"), gesture)

    def delete(self) -> None:
        """Delete the control point that is selected, else the effects."""
        handle, effect = self.document.handle, self.document.effect
        if effect is not None and handle is not None and handle.part is Part.POINT:
            left = edits.without_point(effect, handle.point)
            self.put(left, self.tr("Delete the point"))
        elif self.document.selection:
            left_over = edits.removed(self.document.effects, self.document.selection)
            self.document.change(left_over, self.tr("Delete"))

    def duplicate(self) -> None:
        """Add copies after the selected effects."""
        chosen = self.document.chosen.values()
        if chosen:
            last_s = max(one.end_s for one in chosen)
            self.add_all(self._copies(chosen, last_s), self.tr("Duplicate"))

    def copy(self) -> None:
        """Remember the selected effects."""
        self._copied = list(self.document.chosen.values()) or self._copied

    def paste(self, at_s: float) -> None:
        if self._copied:
            self.add_all(self._copies(self._copied, at_s), self.tr("Paste"))

    def _copies(self, effects: Iterable[Effect], at_s: float) -> list[Effect]:
        return edits.copies_at(effects, at_s, self.duration_s)

    def switch(self, *, is_on: bool) -> None:
        """Switch the selected effects on or off."""
        text = self.tr("Switch on") if is_on else self.tr("Switch off")
        chosen = self.document.chosen.items()
        self._put({k: replace(one, enabled=is_on) for k, one in chosen}, text)

    def toggle(self) -> None:
        """Switch the selected effects on if the leading one is off, and back."""
        if self.document.effect is not None:
            self.switch(is_on=not self.document.effect.enabled)

    def select_all(self) -> None:
        self.document.select(*range(len(self.document.effects)))

    # --- the one that leads ----------------------------------------------------

    def stretch(self, effect: Effect, part: Part, to_s: float, gesture: str) -> None:
        """Let the leading effect begin or end somewhere else."""
        made = edits.stretched(effect, part, to_s, self.duration_s)
        self.put(made, self.tr("Stretch"), gesture)

    def fade(self, effect: Effect, part: Part, fade_s: float, gesture: str) -> None:
        """Give the leading effect another fade."""
        name = "fade_in_s" if part is Part.FADE_IN else "fade_out_s"
        made = edits.with_fade(effect, name, fade_s)
        self.put(made, self.tr("Fade"), gesture)

    def move_point(
        self, effect: Effect, point: int, to: tuple[float, float], gesture: str
    ) -> None:
        """Put a control point at a time since the start and a value."""
        made = edits.with_point(effect, point, *to)
        self.put(made, self.tr("Move the point"), gesture)

    def add_point(self, at_s: float, value: float | None = None) -> None:
        """Add a control point at a media time, and select it."""
        effect = self.document.effect
        if (
            effect is None
            or not kind_of(effect.kind).curve
            or len(effect.curve) + 3 > MAX_POINTS
        ):
            return
        made, point = edits.with_new_point(effect, at_s - effect.start_s, value)
        self.put(made, self.tr("Add a point"))
        self.document.hold(Handle(Part.POINT, point))

    def reorder(self, by: int) -> None:
        """Apply the leading effect earlier (-1) or later (+1) than now."""
        number, count = self.document.selected, len(self.document.effects)
        if number is None or not 0 <= number + by < count:
            return
        changed = edits.reordered(self.document.effects, number, number + by)
        self.document.change(changed, self.tr("Change the order"))
        self.document.select(number + by)

    # --- markers ---------------------------------------------------------------

    def mark(self, at_s: float) -> None:
        """Set a marker with the next free name, unless there is one."""
        effects, at_s = self.document.effects, round(at_s, 3)
        is_there = any(abs(one.time_s - at_s) < 5e-4 for one in effects.markers)
        if is_there or len(effects.markers) >= MAX_MARKERS:
            return
        names = {one.name for one in effects.markers}
        numbers = range(1, len(names) + 2)
        usual = (self.tr("Marker {number}").format(number=k) for k in numbers)
        name = next(one for one in usual if one not in names)
        made = edits.with_marker(effects, at_s, name)
        self.document.change(made, self.tr("Set a marker"))

    def rename_marker(self, marker: TimeMarker, name: str) -> None:
        """Give it another name; raises UsageError."""
        made = edits.with_marker(self.document.effects, marker.time_s, name)
        self.document.change(made, self.tr("Rename the marker"))

    def remove_marker(self, marker: TimeMarker) -> None:
        made = edits.without_marker(self.document.effects, marker)
        self.document.change(made, self.tr("Remove the marker"))
