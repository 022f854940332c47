"""How everything looks: dark, calm, and at least 4.5 to 1 in contrast."""

from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication

from app.widgets.icons import FOLDER

BACKGROUND = "#14171b"
PANEL = "#1b1f25"
RAISED = "#282e36"
HOVER = "#343c46"
BORDER = "#3a434e"
TEXT = "#e8ebef"
DIM = "#a9b3bf"
DISABLED = "#7d8794"
ACCENT = "#4aa8ff"
FOCUS = "#8ccaff"
GOOD = "#56c98d"
WARN = "#f2b84b"
BAD = "#ff7b72"
STOP = "#c2303c"
STOP_HOVER = "#d64450"

# Okabe and Ito: told apart with every kind of colour vision, and of different lightness.
AXIS_COLOURS = ("#e69f00", "#56b4e9", "#009e73")

_SMALLEST_PT = 10.0
_ICONS = FOLDER.as_posix()

_STYLE = f"""
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
QMenu::separator {{ height: 1px; background: {BORDER}; margin: 4px 6px; }}
QPushButton, QComboBox, QLineEdit {{
  background: {RAISED}; border: 1px solid {BORDER}; border-radius: 5px;
  padding: 4px 10px; min-height: 20px; outline: 0; }}
QPushButton:hover, QComboBox:hover {{ background: {HOVER}; }}
QPushButton:pressed {{ background: {BORDER}; }}
QPushButton:disabled, QComboBox:disabled, QLineEdit:disabled {{ color: {DISABLED}; background: {PANEL}; }}
QPushButton:focus, QComboBox:focus, QLineEdit:focus {{
  border: 2px solid {FOCUS}; padding: 3px 9px; }}
QDoubleSpinBox QLineEdit, QDoubleSpinBox QLineEdit:focus,
QDoubleSpinBox QLineEdit:disabled {{
  border: 0; padding: 0 6px; min-height: 0; background: transparent; }}
QDoubleSpinBox {{ min-height: 28px; }}
QPushButton[role="primary"] {{ background: #1f5f9e; border-color: #2f76bb; }}
QPushButton[role="primary"]:hover {{ background: #276cb1; }}
QPushButton[role="primary"]:disabled {{ background: {PANEL}; border-color: {BORDER}; }}
QPushButton[role="stop"] {{ background: {STOP}; border-color: {STOP};
  color: #ffffff; font-weight: bold; }}
QPushButton[role="stop"]:hover {{ background: {STOP_HOVER}; }}
QPushButton[role="rearm"] {{ background: #8a5a00; border-color: #b37800;
  color: #ffffff; font-weight: bold; }}
QPushButton[role="rearm"]:hover {{ background: #a06a00; }}
QPushButton[role="stop"]:focus, QPushButton[role="rearm"]:focus,
QPushButton[role="primary"]:focus {{ border: 2px solid {FOCUS}; }}
QPushButton[role="tool"] {{ padding: 4px; }}
QPushButton[role="tool"]:focus {{ padding: 3px; }}
QComboBox::drop-down {{ border: 0; width: 22px; }}
QComboBox::down-arrow {{ image: url({_ICONS}/down.svg); width: 12px; height: 12px; }}
QComboBox::down-arrow:disabled {{ image: none; }}
QComboBox QAbstractItemView {{ background: {PANEL}; border: 1px solid {BORDER};
  selection-background-color: {HOVER}; selection-color: {TEXT}; outline: 0; }}
QProgressBar {{ background: {RAISED}; border: 1px solid {BORDER}; border-radius: 4px;
  text-align: center; min-height: 18px; }}
QProgressBar::chunk {{ background: #2f76bb; border-radius: 3px; }}
QSplitter::handle {{ background: {BORDER}; }}
QSplitter::handle:hover {{ background: {ACCENT}; }}
"""


def apply(application: QApplication) -> None:
    """Give the application its look."""
    application.setStyle("Fusion")
    application.setPalette(palette())
    font = QFont(application.font())
    font.setPointSizeF(max(_SMALLEST_PT, font.pointSizeF()))
    application.setFont(fixed_digits(font))
    application.setStyleSheet(_STYLE)


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
        roles.BrightText: "#ffffff",
        roles.ToolTipBase: RAISED,
        roles.ToolTipText: TEXT,
        roles.PlaceholderText: DIM,
        roles.Highlight: "#2f76bb",
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
