"""Fields for the answers about a log, and the columns of its tables."""

import itertools
from collections.abc import Mapping

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QGridLayout,
    QLabel,
    QLineEdit,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.texts import titled
from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    FIELD_UNITS,
    RATE_UNITS,
    SWAPPED,
    TIME_UNITS,
    LogChoices,
    parse_choices,
)
from hapticplayer.capture.formats import recording_formats
from hapticplayer.capture.log_tables import (
    BETWEEN_TABLES,
    CLOCK,
    NUMBER,
    SENSORS,
    SKIP,
    TIME,
    LogTable,
)
from hapticplayer.capture.mounting import all_mountings
from hapticplayer.errors import HapticPlayerError

translate = QCoreApplication.translate

_LEAST_PX, _MOST_PX = 110, 210
_LONGEST_CELL = 26


class Choice(QComboBox):
    """One of some answers, or none; where it is open, also one that is typed."""

    changed = Signal()

    def __init__(self, name: str, options: Mapping[str, str], *, is_open: bool = False):
        super().__init__()
        self.setAccessibleName(name)
        self.setEditable(is_open)
        self.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.addItem(translate("Reading", "not stated"), "")
        for value, text in options.items():
            self.addItem(text, value)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        if field := self.lineEdit():
            field.setAccessibleName(name)
            hint = translate("Reading", "choose or type")
            field.setPlaceholderText(hint)
            self.setPlaceholderText(f"{hint}\u2003")  # never seen: makes room for it
            self.put("")
        self.currentIndexChanged.connect(lambda _row: self.changed.emit())
        self.editTextChanged.connect(lambda _text: self.changed.emit())

    def value(self) -> str:
        """The answer as the engine reads it."""
        row = self.findText(self.currentText())
        return self.currentText().strip() if row < 0 else str(self.itemData(row))

    def put(self, value: str) -> None:
        """Show an answer."""
        if self.findData(value) < 0 and not self.isEditable():
            self.addItem(value, value)
        row = -1 if self.isEditable() and not value else self.findData(value)
        self.setCurrentIndex(row)
        if row < 0:
            self.setEditText(value)


class Number(QLineEdit):
    """A number, or nothing."""

    changed = Signal()

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setPlaceholderText(translate("Reading", "not stated"))
        self.textChanged.connect(lambda _text: self.changed.emit())

    def value(self) -> str:
        """The answer as the engine reads it."""
        return self.text().strip().replace(",", ".")

    def put(self, value: str) -> None:
        """Show an answer."""
        self.setText(value)


class ColumnMap(QScrollArea):
    """The first rows of each table, below a choice of what each column holds."""

    changed = Signal()

    def __init__(self, tables: tuple[LogTable, ...]) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # Tab goes to what is inside
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.tables = tables
        self.names: list[list[QComboBox]] = []
        inside, column = QWidget(), QVBoxLayout()
        for table in tables:
            if len(tables) > 1:
                column.addWidget(QLabel(table.name))
            column.addLayout(self._grid(table))
        column.addStretch(1)
        inside.setLayout(column)
        self.setWidget(inside)
        self.setWidgetResizable(True)
        bar_px = self.horizontalScrollBar().sizeHint().height()
        wanted_px = min(_MOST_PX, inside.sizeHint().height() + bar_px + 2)
        self.setMaximumHeight(wanted_px)
        self.setMinimumHeight(min(_LEAST_PX, wanted_px))

    def _grid(self, table: LogTable) -> QGridLayout:
        grid, names = QGridLayout(), []
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(2)
        titles = itertools.chain(table.header, itertools.repeat(""))
        for at, (kind, title) in enumerate(zip(table.kinds, titles, strict=False)):
            number = self.tr("Column {number}").format(number=at + 1)
            shown = title or number
            combo = self._names_for(kind, titled(number, title) if title else number)
            caption = _cell(shown, theme.TEXT)
            caption.setBuddy(combo)
            caption.setAccessibleName(combo.accessibleName())  # titles may be alike
            grid.addWidget(caption, 0, at)
            grid.addWidget(combo, 1, at)
            for line, row in enumerate(table.rows, start=2):
                if at < len(row):
                    grid.addWidget(_cell(row[at], theme.DIM), line, at)
            names.append(combo)
        grid.setColumnStretch(len(table.kinds), 1)
        self.names.append(names)
        return grid

    def _names_for(self, kind: str, name: str) -> QComboBox:
        combo = QComboBox()
        combo.setAccessibleName(name)
        for value, text in column_texts().items():
            if value == SKIP or kind == NUMBER or (value, kind) == (TIME, CLOCK):
                combo.addItem(text, value)
        combo.setEnabled(combo.count() > 1)  # a column of text is ignored
        combo.currentIndexChanged.connect(lambda _row: self._on_named(combo))
        return combo

    def _on_named(self, chosen: QComboBox) -> None:
        """Take a name from the column that had it; each table has its own time."""
        value = chosen.currentData()
        of_table = next(names for names in self.names if chosen in names)
        every = of_table if value == TIME else list(itertools.chain(*self.names))
        for other in every:
            if value != SKIP and other is not chosen and other.currentData() == value:
                other.setCurrentIndex(0)
        self.changed.emit()

    def value(self) -> str:
        """The answer as the engine reads it; "" while no column has a name."""
        named = [[str(one.currentData()) for one in names] for names in self.names]
        if all(name == SKIP for name in itertools.chain(*named)):
            return ""
        return BETWEEN_TABLES.join(",".join(names) for names in named)

    def put(self, value: str) -> None:
        """Show an answer, as far as it fits."""
        parts = value.split(BETWEEN_TABLES) if value else [""] * len(self.names)
        for names, part in zip(self.names, parts, strict=False):
            words = itertools.chain(part.split(","), itertools.repeat(SKIP))
            for combo, word in zip(names, words, strict=False):
                combo.setCurrentIndex(max(0, combo.findData(word.strip())))

    def fits(self, value: str) -> bool:
        """Whether an answer names each column of each table; so does none."""
        wanted = [len(names) for names in self.names]
        given = [len(part.split(",")) for part in value.split(BETWEEN_TABLES)]
        return not value or given == wanted

    def kinds_of(self, name: str) -> set[str]:
        """The kinds of the columns with a name; "" for a table that has none."""
        found = set()
        for table, names in zip(self.tables, self.names, strict=True):
            chosen = [one.currentData() for one in names]
            found.add(table.kinds[chosen.index(name)] if name in chosen else "")
        return found


def column_texts() -> dict[str, str]:
    """What a column may hold, for people."""
    texts = {
        "accel": translate("Reading", "accelerometer {axis}"),
        "rate": translate("Reading", "gyroscope {axis}"),
        "field": translate("Reading", "magnetometer {axis}"),
    }
    return {
        SKIP: translate("Reading", "ignore"),
        TIME: translate("Reading", "time"),
        **{
            name: texts[sensor].format(axis=name[-1])
            for sensor, names in SENSORS.items()
            for name in names
        },
    }


def _cell(text: str, colour: str) -> QLabel:
    is_long = len(text) > _LONGEST_CELL
    made = QLabel(f"{text[:_LONGEST_CELL]}\u2026" if is_long else text)
    made.setTextFormat(Qt.TextFormat.PlainText)
    made.setStyleSheet(f"color: {colour};")
    made.setToolTip(text)
    return made


Fields = dict[str, Choice | Number]


def answer_fields() -> Fields:
    """A field for each answer about a log, by key, but format and columns."""
    return _units() | _details()


def _units() -> Fields:
    """For what the numbers are."""

    def units(name: str, known: Mapping[str, float]) -> Choice:
        texts = {one: one.replace("s2", "s\u00b2") for one in known}
        texts |= {one: f"\u00b5{one[1:]}" for one in known if one[0] == "u"}
        return Choice(name, texts, is_open=True)

    signs = {
        "+": translate("Reading", "+1 g upwards"),
        "-": translate("Reading", "\u22121 g upwards"),
    }
    samplings = {
        "instant": translate("Reading", "single values"),
        "averaged": translate("Reading", "means over a window"),
    }
    return {
        "time-unit": units(translate("Reading", "Time unit"), TIME_UNITS),
        "accel-unit": units(translate("Reading", "Accelerometer unit"), ACCEL_UNITS),
        "rate-unit": units(translate("Reading", "Gyroscope unit"), RATE_UNITS),
        "accel-sign": Choice(translate("Reading", "Accelerometer reads"), signs),
        "sampling": Choice(translate("Reading", "Values are"), samplings),
        "rate-hz": Number(translate("Reading", "Samples per second")),
        "field-unit": units(translate("Reading", "Magnetometer unit"), FIELD_UNITS),
    }


def _details() -> Fields:
    """For axes, clocks and columns that are not as they should be."""
    text = translate("Reading", "right {right}, front {front}, up {up}")
    turned = {
        axes: text.format(right=right, front=front, up=up)
        for axes in all_mountings()
        for right, front, up in [axes.split(",")]
    }
    own = {axes: axes.replace(",", ", ") for axes in _signed_permutations()}
    both = {
        "no": translate("Reading", "not swapped"),
        "accel,rate": translate("Reading", "accelerometer, gyroscope"),
        "accel,field": translate("Reading", "accelerometer, magnetometer"),
    }
    return {
        "axes": Choice(
            translate("Reading", "The wearer\u2019s axes in the log"), turned
        ),
        "accel-axes": Choice(translate("Reading", "Accelerometer x, y, z"), own),
        "rate-axes": Choice(translate("Reading", "Gyroscope x, y, z"), own),
        "rate-delay": Number(translate("Reading", "Gyroscope late by, s")),
        "swapped": Choice(
            translate("Reading", "Swapped columns"),
            {"no": both["no"], **{one: both.get(one, one) for one in SWAPPED}},
        ),
        "stuck": Choice(
            translate("Reading", "If a sensor was stuck"),
            {"no-force": translate("Reading", "no force")},
        ),
    }


def choices_of(answers: Mapping[str, str]) -> LogChoices:
    return parse_choices([f"{key}={value}" for key, value in answers.items()])


def words_of(answer: str) -> dict[str, str]:
    """The answers that a proposal of the engine holds, by key; {} if it is none."""
    words = [word.rstrip(",") for word in answer.split() if "=" in word]
    found = dict(
        word.split("=", 1) for word in words
    )  # the last of a key is an example
    try:
        choices_of(found)
    except HapticPlayerError:
        return {}
    return {} if "|" in "".join(found.values()) else found


def _signed_permutations() -> list[str]:
    """All orders and signs of three axes, those without a change first."""
    found = [
        ",".join(sign + axis for sign, axis in zip(signs, order, strict=True))
        for signs in itertools.product(("", "-"), repeat=3)
        for order in itertools.permutations("xyz")
    ]
    return sorted(found, key=lambda axes: axes.count("-"))


def named(words: Mapping[str, str]) -> str:
    """Answers in the words of their fields."""
    return "; ".join(_named(key, value) for key, value in words.items())


def _named(key: str, value: str) -> str:
    if key == "format":
        rows = {one.name: one.text for one in recording_formats()}
        shown = translated(rows.get(value, value))
        return titled(translate("Reading", "Format"), shown)
    field = answer_fields().get(key)
    row = field.findData(value) if isinstance(field, Choice) else -1
    shown = field.itemText(row) if isinstance(field, Choice) and row >= 0 else value
    return titled(field.accessibleName() if field else key, shown)


def in_words(answer: str) -> str:
    """A proposal of the engine as people read it, without its keys."""
    text = translated(answer)
    for key, value in words_of(answer).items():
        typed, rest = f"{key}={value}", text.partition(f"{key}={value}")[2]
        is_followed = rest.startswith(" ")
        text = text.replace(typed, _named(key, value) + " \u2013" * is_followed)
    return text
