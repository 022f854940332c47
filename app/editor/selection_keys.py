"""What keys do to what is selected on the timeline, so that no task needs a mouse."""

from app.editor.curve_lane import handle_s, handles_of, value_step
from app.editor.editing_lanes import EditingLanes
from app.editor.spans import Part


class SelectionKeys:
    """Moves effects, their fades and their control points by frames and steps."""

    def __init__(self, lanes: EditingLanes) -> None:
        self._lanes, self._editing = lanes, lanes.editing
        self._document = lanes.editing.document

    def extend(self, step: int) -> None:
        """Select the next effect (1) or the previous one (-1) as well."""
        to = self._lanes.beside(step)
        if to is not None:
            self._document.add_to_selection(to)

    def step_handle(self, step: int) -> None:
        """Select the next fade or control point of the effect; after the last, none."""
        if (effect := self._lanes.leading) is not None:
            document = self._document
            every = [None, *handles_of(effect)]
            document.hold(every[(every.index(document.handle) + step) % len(every)])

    def go(self, frames: int) -> None:
        """Move what is selected by frames, or the cursor without anything."""
        document = self._document
        if document.handle is not None:
            self._move_handle(frames * self._lanes.frame_s, 0.0)
        elif document.selection:
            gesture = f"keys {document.selection}"
            self._editing.move(frames * self._lanes.frame_s, gesture)
        else:
            self._lanes.step(frames)

    def change_value(self, steps: int) -> None:
        """Give the selected control point a higher or lower value."""
        if (effect := self._lanes.leading) is not None:
            self._move_handle(0.0, steps * value_step(effect))

    def _move_handle(self, by_s: float, by_value: float) -> None:
        effect, handle = self._lanes.leading, self._document.handle
        if effect is None or handle is None:
            return
        to_s, gesture = handle_s(effect, handle) + by_s, f"keys {handle}"
        if handle.part is Part.POINT:
            since_s, value = effect.curve[handle.point]
            # rounded: 1.1 + 0.1 is no 1.2000000000000002
            place = since_s + by_s, round(value + by_value, 9)
            self._editing.move_point(effect, handle.point, place, gesture)
        elif by_s:
            is_in = handle.part is Part.FADE_IN
            fade_s = to_s - effect.start_s if is_in else effect.end_s - to_s
            self._editing.fade(effect, handle.part, fade_s, gesture)

    def go_far(self, steps: int) -> None:
        """Move what is selected by tens of frames, or the cursor by seconds."""
        if self._document.effect is None:
            self._lanes.point_at(self._lanes.cursor_s + steps)
        else:
            self.go(10 * steps)

    def move_edge(self, part: Part, frames: int) -> None:
        """Let the selected effect begin or end some frames later."""
        effect = self._document.effect
        if effect is not None:
            at_s = effect.start_s if part is Part.START else effect.end_s
            to_s = at_s + frames * self._lanes.frame_s
            self._editing.stretch(effect, part, to_s, f"keys {part.name}")
