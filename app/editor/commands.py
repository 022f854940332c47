"""What keys do in the editor, one row each, beside those that the window has too."""

from typing import Any, Protocol

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.editor.editing import Editing
from app.editor.editing_lanes import EditingLanes
from app.editor.kind_list import KindList
from app.editor.playing import Playing
from app.editor.selection_keys import SelectionKeys
from app.editor.spans import Part
from app.player.command import SHARED, TIMELINE, Command


class Editor(Protocol):
    """What a command can act on: the editor's page."""

    kinds: KindList
    lanes: EditingLanes
    editing: Editing
    keys: SelectionKeys
    playing: Playing

    def mark(self) -> None: ...
    def undo(self) -> None: ...
    def redo(self) -> None: ...
    def save(self) -> None: ...


Row = Command[Editor]
ON_TIMELINE: tuple[Row, ...] = (
    Row("timeline_back", "Effects, point or cursor a frame back", TIMELINE, 0, lambda e: e.keys.go(-1), ("Left",)),
    Row("timeline_forward", "Effects, point or cursor a frame forward", TIMELINE, 0, lambda e: e.keys.go(1), ("Right",)),
    Row("timeline_far_back", "Effects or point ten frames, or cursor 1 s back", TIMELINE, 0, lambda e: e.keys.go_far(-1), ("Shift+Left",)),
    Row("timeline_far_forward", "Effects or point ten frames, or cursor 1 s forward", TIMELINE, 0, lambda e: e.keys.go_far(1), ("Shift+Right",)),
    Row("end_back", "End of the effect a frame back", TIMELINE, 0, lambda e: e.keys.move_edge(Part.END, -1), ("Ctrl+Left",)),
    Row("end_forward", "End of the effect a frame forward", TIMELINE, 0, lambda e: e.keys.move_edge(Part.END, 1), ("Ctrl+Right",)),
    Row("start_back", "Start of the effect a frame back", TIMELINE, 0, lambda e: e.keys.move_edge(Part.START, -1), ("Ctrl+Shift+Left",)),
    Row("start_forward", "Start of the effect a frame forward", TIMELINE, 0, lambda e: e.keys.move_edge(Part.START, 1), ("Ctrl+Shift+Right",)),
    Row("cursor_back", "Cursor a frame back", TIMELINE, 1, lambda e: e.lanes.step(-1), (",",)),
    Row("cursor_forward", "Cursor a frame forward", TIMELINE, 1, lambda e: e.lanes.step(1), (".",)),
    Row("cursor_to_start", "Cursor to the beginning", TIMELINE, 1, lambda e: e.lanes.point_at(0.0), ("Home",)),
    Row("cursor_to_end", "Cursor to the end", TIMELINE, 1, lambda e: e.lanes.point_at(e.lanes.view.duration_s), ("End",)),
    Row("zoom_in", "Zoom in", TIMELINE, 1, lambda e: e.lanes.zoom(-1), ("+",)),
    Row("zoom_out", "Zoom out", TIMELINE, 1, lambda e: e.lanes.zoom(1), ("-",)),
    Row("event_back", "Previous event", TIMELINE, 2, lambda e: e.lanes.go_to_event(-1), ("PgUp",)),
    Row("event_forward", "Next event", TIMELINE, 2, lambda e: e.lanes.go_to_event(1), ("PgDown",)),
    Row("event_offer", "Offer the effect of the event at the cursor", TIMELINE, 2, lambda e: e.lanes.offer_at_cursor(), ("Return", "Enter")),
    Row("marker_back", "Previous marker", TIMELINE, 2, lambda e: e.lanes.go_to_marker(-1), ("Shift+PgUp",)),
    Row("marker_forward", "Next marker", TIMELINE, 2, lambda e: e.lanes.go_to_marker(1), ("Shift+PgDown",)),
    Row("select_all", "Select all effects", TIMELINE, 3, lambda e: e.editing.select_all(), ("Ctrl+A",)),
    Row("select_next", "Select the next effect as well", TIMELINE, 3, lambda e: e.keys.extend(1), ("Ctrl+Down",)),
    Row("select_previous", "Select the previous effect as well", TIMELINE, 3, lambda e: e.keys.extend(-1), ("Ctrl+Up",)),
    Row("handle_next", "Next fade or point of the effect", TIMELINE, 3, lambda e: e.keys.step_handle(1), ("P",)),
    Row("handle_previous", "Previous fade or point of the effect", TIMELINE, 3, lambda e: e.keys.step_handle(-1), ("Shift+P",)),
    Row("point_up", "Raise the point", TIMELINE, 3, lambda e: e.keys.change_value(1), ("Up",)),
    Row("point_down", "Lower the point", TIMELINE, 3, lambda e: e.keys.change_value(-1), ("Down",)),
    Row("point_far_up", "Raise the point by ten steps", TIMELINE, 3, lambda e: e.keys.change_value(10), ("Shift+Up",)),
    Row("point_far_down", "Lower the point by ten steps", TIMELINE, 3, lambda e: e.keys.change_value(-10), ("Shift+Down",)),
    Row("point_add", "Add a control point at the cursor", TIMELINE, 3, lambda e: e.editing.add_point(e.lanes.cursor_s), ("A", "Ins")),
    Row("effect_toggle", "Switch the effects on or off", TIMELINE, 3, lambda e: e.editing.toggle(), ("E",)),
    Row("effect_delete", "Delete the effects, or the point", TIMELINE, 3, lambda e: e.editing.delete(), ("Del", "Backspace")),
    Row("effect_duplicate", "Duplicate the effects", TIMELINE, 3, lambda e: e.editing.duplicate(), ("Ctrl+D",)),
    Row("effect_copy", "Copy the effects", TIMELINE, 3, lambda e: e.editing.copy(), ("Ctrl+C",)),
    Row("effect_paste", "Paste the effects at the cursor", TIMELINE, 3, lambda e: e.editing.paste(e.lanes.cursor_s), ("Ctrl+V",)),
)  # fmt: skip
OF_EDITOR: tuple[Row, ...] = (
    Row("shuttle_back", "Go back without force; again for faster", TIMELINE, 1, lambda e: e.playing.shuttle.back(), ("J",)),
    Row("shuttle_stop", "Pause", TIMELINE, 1, lambda e: e.playing.pause(), ("K",)),
    Row("shuttle_forward", "Play; again for faster", TIMELINE, 1, lambda e: e.playing.shuttle.forward(), ("L",)),
    Row("mark", "Set a marker at the cursor", TIMELINE, 2, lambda e: e.mark(), ("M",)),
    Row("undo", "Undo the change of effects", TIMELINE, 4, lambda e: e.undo(), ("Ctrl+Z",)),
    Row("redo", "Redo the change of effects", TIMELINE, 4, lambda e: e.redo(), ("Ctrl+Shift+Z",)),
    Row("save_effects", "Save the effects", TIMELINE, 4, lambda e: e.save(), ("Ctrl+S",)),
)  # fmt: skip
EDITOR_COMMANDS = (*ON_TIMELINE, *OF_EDITOR)


_REPEATED = ("undo", "redo")
_REARM: Row = Row(
    "rearm", "", TIMELINE, 5, lambda e: e.playing.rearm(), SHARED["rearm"]
)
_PLAY: Row = Row("play", "", TIMELINE, 5, lambda e: e.playing.toggle(), SHARED["play"])


def bind(page: QWidget, editor: Editor, chosen: dict[str, Any]) -> None:
    """Let every key do what its row says.

    Space plays also from lists and numbers; a button or box that Tab has gone to takes it.
    """
    for row in (*OF_EDITOR, _REARM, _PLAY):
        # a key that is held down does it once
        row.add_action(chosen, editor, page).setAutoRepeat(row.name in _REPEATED)
    focused = Qt.ShortcutContext.WidgetShortcut
    for row in ON_TIMELINE:
        row.add_action(chosen, editor, editor.lanes).setShortcutContext(focused)
