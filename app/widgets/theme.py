"""Colours, fonts and icons; contrast is at least 4.5 to 1."""

from functools import cache

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QFont, QIcon, QPainter, QPalette, QPixmap
from PySide6.QtWidgets import QApplication

from hapticplayer.shipped import shipped

FOLDER = shipped("resources/icons")
_OFF_OPACITY = 0.35
_ONLY_ITS_SHAPE = QPainter.CompositionMode.CompositionMode_SourceIn
_RATIOS = (1.0, 1.25, 1.5, 2.0, 3.0)  # of screens


@cache
def icon(name: str) -> QIcon:
    """Return an icon by the name of its file; empty where it is missing."""
    return QIcon(str(FOLDER / f"{name}.svg"))


@cache
def control_icon(name: str, size_px: int, colour: str) -> QIcon:
    """Return an icon of one size and colour that fades when its control is disabled.

    Qt's own way of greying leaves a light drawing as light as it was.
    """
    made = QIcon()
    for ratio in _RATIOS:
        drawing = icon(name).pixmap(QSize(size_px, size_px), ratio)
        with QPainter(drawing) as painter:
            painter.setCompositionMode(_ONLY_ITS_SHAPE)
            painter.fillRect(drawing.rect(), QColor(colour))
        made.addPixmap(drawing, QIcon.Mode.Normal)
        made.addPixmap(_faded(drawing), QIcon.Mode.Disabled)
    return made


def _faded(drawing: QPixmap) -> QPixmap:
    faded = QPixmap(drawing.size())
    faded.setDevicePixelRatio(drawing.devicePixelRatio())
    faded.fill(Qt.GlobalColor.transparent)
    with QPainter(faded) as painter:
        painter.setOpacity(_OFF_OPACITY)
        painter.drawPixmap(0, 0, drawing)
    return faded


DARK, LIGHT, CONTRAST, SYSTEM = "dark", "light", "contrast", "system"
THEMES = {
    DARK: {
        "BACKGROUND": "#14171b", "PANEL": "#1b1f25", "RAISED": "#282e36",
        "HOVER": "#343c46", "BORDER": "#3a434e", "TEXT": "#e8ebef", "DIM": "#a9b3bf",
        "DISABLED": "#7d8794", "ACCENT": "#4aa8ff", "FOCUS": "#8ccaff",
        "GOOD": "#56c98d", "WARN": "#f2b84b", "BAD": "#ff7b72", "ALARM": "#4a1d22",
        "PRIMARY": "#1f5f9e", "PRIMARY_TEXT": "#ffffff", "CHOSEN": "#2f76bb",
        "GRID": "#30373f", "ZERO": "#59636f", "FLOOR": "#20262d",
    },
    LIGHT: {
        "BACKGROUND": "#f3f4f6", "PANEL": "#ffffff", "RAISED": "#eceef1",
        "HOVER": "#dfe3e8", "BORDER": "#8d96a1", "TEXT": "#16191d", "DIM": "#4b5560",
        "DISABLED": "#767f8a", "ACCENT": "#1565c0", "FOCUS": "#0b57b0",
        "GOOD": "#0f7a45", "WARN": "#8a5a00", "BAD": "#b3261e", "ALARM": "#fde7e7",
        "PRIMARY": "#1f5f9e", "PRIMARY_TEXT": "#ffffff", "CHOSEN": "#2f76bb",
        "GRID": "#e3e6ea", "ZERO": "#9aa3ad", "FLOOR": "#eef0f3",
    },
    CONTRAST: {
        "BACKGROUND": "#000000", "PANEL": "#000000", "RAISED": "#000000",
        "HOVER": "#303030", "BORDER": "#ffffff", "TEXT": "#ffffff", "DIM": "#ffffff",
        "DISABLED": "#b0b0b0", "ACCENT": "#ffff00", "FOCUS": "#ffff00",
        "GOOD": "#40ff90", "WARN": "#ffd500", "BAD": "#ff9090", "ALARM": "#500000",
        "PRIMARY": "#003f8f", "PRIMARY_TEXT": "#ffffff", "CHOSEN": "#0050c0",
        "GRID": "#404040", "ZERO": "#a0a0a0", "FLOOR": "#101010",
    },
}  # fmt: skip

# named here for readers and checkers; `use` gives them their values
BACKGROUND = PANEL = RAISED = HOVER = BORDER = ""
TEXT = DIM = DISABLED = ACCENT = FOCUS = ""
GOOD = WARN = BAD = ALARM = PRIMARY = ""
PRIMARY_TEXT = CHOSEN = GRID = ZERO = FLOOR = ""
STOP = "#c2303c"
STOP_HOVER = "#d64450"

# Okabe and Ito: distinguishable with every kind of colour vision, and of different
# lightness; darker on light ground, in the same order of hue.
AXES = {
    DARK: ("#e69f00", "#56b4e9", "#009e73"),
    LIGHT: ("#a86800", "#0072b2", "#006b4e"),
    CONTRAST: ("#ffb000", "#66c2ff", "#00d69a"),
}
AXIS_COLOURS = AXES[DARK]
name = DARK
"""Of the theme in use; its colours are names of this module."""


def use(chosen: str) -> None:
    """Take the colours of a theme; existing widgets have to be rebuilt."""
    global name  # noqa: PLW0603 - one theme, as there is one application
    name = chosen if chosen in THEMES else DARK
    globals().update(THEMES[name], AXIS_COLOURS=AXES[name])


use(DARK)

_SMALLEST_PT = 10.0
_APPLIED = "hapticplayer_theme"  # property of the application that wears it
_ICONS = FOLDER.as_posix()


def style_sheet() -> str:
    """Return the style sheet of Qt's own widgets."""
    arrow = "down-dark" if name == LIGHT else "down"
    check = "check-dark" if name == LIGHT else "check"
    dot = CHOSEN if name == LIGHT else ACCENT
    filled = "#9cc4ee" if name == LIGHT else CHOSEN  # the percentage is drawn on it
    more = _edges() if name == CONTRAST else ""
    return f"""
QMainWindow, QDialog {{ background: {BACKGROUND}; }}
QDialog {{ border: 1px solid {BORDER}; }}
QToolTip {{ background: {RAISED}; color: {TEXT}; border: 1px solid {BORDER};
  padding: 3px; }}
QMenuBar {{ background: {PANEL}; padding: 2px 4px; }}
QMenuBar::item {{ padding: 4px 10px; border-radius: 4px; background: transparent; }}
QMenuBar::item:selected {{ background: {HOVER}; }}
QMenu {{ background: {PANEL}; border: 1px solid {BORDER}; padding: 4px; }}
QMenu::item {{ padding: 5px 24px 5px 12px; border-radius: 4px; }}
QMenu::item:selected {{ background: {HOVER}; }}
QMenu::item:disabled {{ color: {DISABLED}; }}
QMenu::indicator {{ width: 14px; height: 14px; margin-left: 6px; }}
QMenu::indicator:checked {{ image: url({_ICONS}/{check}.svg); }}
QMenu::separator {{ height: 1px; background: {BORDER}; margin: 4px 6px; }}
QPushButton, QComboBox, QLineEdit {{
  background: {RAISED}; border: 1px solid {BORDER}; border-radius: 5px;
  padding: 4px 10px; min-height: 20px; outline: 0; }}
QPushButton:hover, QComboBox:hover {{ background: {HOVER}; }}
QPushButton:pressed {{ background: {BORDER}; }}
QPushButton:disabled, QComboBox:disabled, QLineEdit:disabled {{ color: {DISABLED}; background: {PANEL}; }}
QPushButton:focus, QComboBox:focus, QLineEdit:focus {{
  border: 2px solid {FOCUS}; padding: 3px 9px; }}
/* of a choice the height gives way: its list is placed within its padding */
QComboBox:focus {{ padding: 4px 9px; min-height: 18px; }}
QAbstractSpinBox QLineEdit, QAbstractSpinBox QLineEdit:focus,
QAbstractSpinBox QLineEdit:disabled {{
  border: 0; padding: 0 6px; min-height: 0; background: transparent; }}
QAbstractSpinBox {{ min-height: 26px; background: {RAISED};
  border: 1px solid {BORDER}; border-radius: 5px; padding: 1px 1px 1px 7px; }}
QAbstractSpinBox:focus {{ border: 2px solid {FOCUS}; padding: 0 0 0 6px; }}
QAbstractSpinBox:disabled {{ color: {DISABLED}; background: {PANEL}; }}
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{ border: 0; width: 20px; }}
QAbstractSpinBox::up-arrow {{ image: url({_ICONS}/{arrow.replace("down", "up")}.svg);
  width: 10px; height: 10px; }}
QAbstractSpinBox::down-arrow {{ image: url({_ICONS}/{arrow}.svg);
  width: 10px; height: 10px; }}
QPushButton[role="primary"] {{ background: {PRIMARY}; border-color: {CHOSEN};
  color: {PRIMARY_TEXT}; }}
QPushButton[role="primary"]:hover {{ background: {CHOSEN}; }}
QPushButton[role="primary"]:disabled {{ background: {PANEL}; border-color: {BORDER};
  color: {DISABLED}; }}
QPushButton[role="stop"] {{ background: {STOP}; border-color: {STOP};
  color: #ffffff; font-weight: bold; }}
QPushButton[role="stop"]:hover {{ background: {STOP_HOVER}; }}
QPushButton[role="rearm"] {{ background: #8a5a00; border-color: #b37800;
  color: #ffffff; font-weight: bold; }}
QPushButton[role="rearm"]:hover {{ background: #a06a00; }}
QPushButton[role="stop"]:disabled {{ background: {PANEL}; border-color: {BORDER};
  color: {DISABLED}; }}
QPushButton[role="stop"]:focus, QPushButton[role="rearm"]:focus {{
  border: 2px solid {FOCUS}; }}
QPushButton[role="primary"]:focus {{ border: 2px solid {TEXT}; }}
QPushButton[role="tool"] {{ padding: 4px; }}
QPushButton[role="tool"]:focus {{ padding: 3px; }}
QPushButton[role="small"] {{ padding: 0; min-height: 0; background: transparent; }}
QPushButton[role="small"]:focus {{ padding: 0; }}
QListView, QTableView, QTreeView, QTextEdit, QPlainTextEdit {{
  border: 1px solid {BORDER}; padding: 1px; }}
QTableView::item {{ padding: 0 6px; }}
QHeaderView {{ background: {PANEL}; }}
QHeaderView::section {{ background: {PANEL}; color: {DIM}; border: 0;
  border-bottom: 1px solid {BORDER}; padding: 4px 6px; }}
QListView:focus, QTableView:focus, QTreeView:focus, QTextEdit:focus,
QPlainTextEdit:focus {{ border: 2px solid {FOCUS}; padding: 0; }}
QCheckBox, QRadioButton {{ border: 2px solid transparent; border-radius: 5px;
  padding: 1px 3px; }}
QCheckBox:focus, QRadioButton:focus {{ border-color: {FOCUS}; }}
QTabWidget::pane {{ border: 1px solid {BORDER}; background: {BACKGROUND}; }}
QTabBar::tab {{ background: {PANEL}; border: 1px solid {BORDER}; padding: 6px 13px;
  margin-right: 2px; border-top-left-radius: 5px; border-top-right-radius: 5px; }}
QTabBar::tab:selected {{ background: {HOVER}; border-bottom: 3px solid {ACCENT};
  padding: 6px 13px 4px 13px; }}
QTabBar::tab:focus {{ border: 2px solid {FOCUS}; padding: 5px 12px; }}
.QSlider {{ border: 2px solid transparent; border-radius: 5px; }}
.QSlider::groove:horizontal {{ height: 4px; border-radius: 2px;
  background: {BORDER}; }}
.QSlider::sub-page:horizontal {{ border-radius: 2px; background: {ACCENT}; }}
.QSlider::handle:horizontal {{ width: 14px; margin: -5px 0; border-radius: 7px;
  background: {TEXT}; }}
.QSlider::handle:horizontal:disabled {{ background: {DISABLED}; }}
.QSlider:focus {{ border-color: {FOCUS}; }}
QComboBox::drop-down {{ border: 0; width: 22px; }}
QComboBox::down-arrow {{ image: url({_ICONS}/{arrow}.svg); width: 12px; height: 12px; }}
QComboBox::down-arrow:disabled {{ image: none; }}
QComboBox QAbstractItemView {{ background: {PANEL}; border: 1px solid {BORDER};
  selection-background-color: {HOVER}; selection-color: {TEXT}; outline: 0; }}
QCheckBox::indicator, QRadioButton::indicator {{ width: 14px; height: 14px;
  background: {PANEL}; border: 1px solid {DIM}; border-radius: 3px; }}
QRadioButton::indicator {{ border-radius: 8px; }}
QCheckBox::indicator:checked {{ background: {CHOSEN}; border-color: {FOCUS};
  image: url({_ICONS}/check.svg); }}
QRadioButton::indicator:checked {{ background: qradialgradient(cx: 0.5, cy: 0.5,
  radius: 0.5, fx: 0.5, fy: 0.5, stop: 0 {dot}, stop: 0.55 {dot}, stop: 0.65 {PANEL},
  stop: 1 {PANEL}); }}
QCheckBox:focus, QRadioButton:focus {{ color: {FOCUS}; }}
QCheckBox::indicator:focus, QRadioButton::indicator:focus {{ border: 2px solid {FOCUS}; }}
QProgressBar {{ background: {RAISED}; border: 1px solid {BORDER}; border-radius: 4px;
  text-align: center; min-height: 18px; }}
QProgressBar::chunk {{ background: {filled}; border-radius: 3px; }}
QSplitter::handle {{ background: {BORDER}; }}
QSplitter::handle:hover {{ background: {ACCENT}; }}
{more}"""


def _edges() -> str:
    """The style of widgets that have no edge on black ground."""
    return f"""
QPushButton[role="primary"]:enabled, QPushButton[role="stop"]:enabled {{
  border-color: {BORDER}; }}
QPushButton[role="primary"]:focus, QPushButton[role="stop"]:focus,
QPushButton[role="rearm"]:focus {{ border-color: {FOCUS}; }}
QScrollBar {{ background: {BACKGROUND}; border: 0; }}
QScrollBar:vertical {{ width: 14px; }}
QScrollBar:horizontal {{ height: 14px; }}
QScrollBar::handle {{ background: {BORDER}; border-radius: 5px; margin: 2px; }}
QScrollBar::handle:vertical {{ min-height: 24px; }}
QScrollBar::handle:horizontal {{ min-width: 24px; }}
QScrollBar::handle:hover {{ background: {ACCENT}; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: none; }}
"""


def wanted(application: QApplication, chosen: str) -> str:
    """Return the theme for a setting; the desktop's own for SYSTEM."""
    if chosen in THEMES:
        return chosen
    is_light = application.styleHints().colorScheme() is Qt.ColorScheme.Light
    return LIGHT if is_light else DARK


def apply(application: QApplication, chosen: str = DARK) -> None:
    """Apply a theme to the application.

    Each call of Qt in here polishes every widget there is, in 30 to 60 ms: another
    language keeps the theme, and another theme keeps style and font.
    """
    use(wanted(application, chosen))
    before = application.property(_APPLIED)
    if before == name:
        return
    if before is None:
        application.setStyle("Fusion")
        font = QFont(application.font())
        font.setPointSizeF(max(_SMALLEST_PT, font.pointSizeF()))
        application.setFont(fixed_digits(font))
    application.setPalette(palette())
    application.setStyleSheet(style_sheet())
    application.setProperty(_APPLIED, name)


def palette() -> QPalette:
    """Return the colours for what the style sheet does not name."""
    roles = QPalette.ColorRole
    colours = {
        roles.Window: BACKGROUND,
        roles.WindowText: TEXT,
        roles.Base: PANEL,
        roles.AlternateBase: RAISED,
        roles.Text: TEXT,
        roles.Button: RAISED,
        roles.ButtonText: TEXT,
        roles.BrightText: TEXT,
        roles.ToolTipBase: RAISED,
        roles.ToolTipText: TEXT,
        roles.PlaceholderText: DIM,
        roles.Highlight: CHOSEN,
        roles.HighlightedText: "#ffffff",
        roles.Link: FOCUS,
    }
    made = QPalette()
    for role, colour in colours.items():
        made.setColor(role, QColor(colour))
    for role in (roles.WindowText, roles.Text, roles.ButtonText):
        made.setColor(QPalette.ColorGroup.Disabled, role, QColor(DISABLED))
    return made


def fixed_digits(font: QFont) -> QFont:
    """Return the font with digits of one width: numbers change without jumping."""
    made = QFont(font)
    if hasattr(made, "setFeature"):  # Qt 6.7
        made.setFeature(QFont.Tag("tnum"), 1)
    return made


def scaled(font: QFont, factor: float, *, bold: bool = False) -> QFont:
    """Return a larger or smaller font, never below what can be read."""
    made = QFont(font)
    made.setPointSizeF(max(8.0, factor * font.pointSizeF()))
    made.setBold(bold)
    return made
