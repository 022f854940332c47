"""What a screen reader hears of a page, and in which order the keyboard reads it."""

from collections import Counter
from collections.abc import Iterator

from face_checks import spoken_name
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QComboBox, QScrollArea, QTabWidget, QWidget


def heard(widget: QWidget) -> tuple[str, str]:
    """Return role and name; a list of choices is named by its caption.

    On Linux Qt gives the chosen text as its name.
    """
    face = QAccessible.queryAccessibleInterface(widget)
    role = str(face.role()).rpartition(".")[2]
    captions = [
        one.text(QAccessible.Text.Name)
        for one, kind in face.relations()
        if kind & QAccessible.RelationFlag.Label
    ]
    if isinstance(widget, QComboBox):
        return role, " ".join(captions)
    return role, spoken_name(widget)


def description(widget: QWidget) -> str:
    """Return what follows the name."""
    face = QAccessible.queryAccessibleInterface(widget)
    return face.text(QAccessible.Text.Description)


def value(widget: QWidget) -> str:
    """Return the state of what is drawn."""
    face = QAccessible.queryAccessibleInterface(widget)
    return face.text(QAccessible.Text.Value)


def focusable(face: QWidget) -> list[QWidget]:
    """Return what can have the keyboard now, once each."""
    return [
        w
        for w in face.findChildren(QWidget)
        if w.focusPolicy() & Qt.FocusPolicy.TabFocus
        and w.focusProxy() is None
        and w.isVisibleTo(face)
        and w.isEnabled()
        and w.window() is face.window()
        and not isinstance(w, QTabWidget)  # its bar has the keyboard
        and not w.objectName().startswith("qt_")
    ]


def wrong_names(face: QWidget) -> Iterator[str]:
    """Yield what has no name, and names that two things of one kind have."""
    counts = Counter(heard(widget) for widget in focusable(face))
    for (role, name), count in counts.items():
        if not name.strip():
            yield f"{role} without a name"
        elif count > 1:
            yield f"{count} times {role} {name!r}"


# --- the order -----------------------------------------------------------------


def wrong_order(face: QWidget, stops: list[QWidget]) -> str:
    """Return the stops of the Tab key unless they are in reading order.

    That is: those before a place are all above or all left of those after it, and the
    same is true of both parts; what scrolls is read whole. Where it begins is free.
    """
    turns = [stops[k:] + stops[:k] for k in range(len(stops))]
    if any(_is_read_in_order(turn, face) for turn in turns):
        return ""
    return ", ".join(f"{heard(one)[1]}{_place(one, face).getCoords()}" for one in stops)


def _is_read_in_order(stops: list[QWidget], within: QWidget) -> bool:
    groups: list[tuple[QWidget, list[QWidget]]] = []
    for stop in stops:
        area = _area_of(stop, within)
        if groups and groups[-1][0] is (area or stop):
            groups[-1][1].append(stop)
        else:
            groups.append((area or stop, [stop]))
    owners = [owner for owner, _ in groups]
    if len({id(owner) for owner in owners}) < len(owners):
        return False  # left an area, and came back to it
    insides = [
        _is_read_in_order(members, owner.widget())
        for owner, members in groups
        if isinstance(owner, QScrollArea)
    ]
    return all(insides) and _is_readable([_place(one, within) for one in owners])


def _area_of(widget: QWidget, within: QWidget) -> QScrollArea | None:
    """Return the outermost scrolling area between both."""
    found = None
    above = widget.parentWidget()
    while above is not None and above is not within:
        if isinstance(above, QScrollArea):
            found = above
        above = above.parentWidget()
    return found


def _place(widget: QWidget, within: QWidget) -> QRect:
    return QRect(widget.mapTo(within, QPoint()), widget.size())


def _is_readable(places: list[QRect]) -> bool:
    if len(places) < 2:
        return True
    for k in range(1, len(places)):
        first, then = places[:k], places[k:]
        lowest = max(one.bottom() for one in first)
        rightmost = max(one.right() for one in first)
        is_above = all(one.top() > lowest for one in then)
        is_left = all(one.left() > rightmost for one in then)
        if (is_above or is_left) and _is_readable(first) and _is_readable(then):
            return True
    return False
