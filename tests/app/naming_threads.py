"""Two threads that name the same classes of Qt for the first time, at the same moment."""

import sys
import threading

import app  # noqa: F401 - which comes before Qt in the program, too

sys.setswitchinterval(1e-6)

from PySide6 import QtCore, QtWidgets  # noqa: E402

NAMES = [
    "QGraphicsView",
    "QGraphicsScene",
    "QGraphicsObject",
    "QGraphicsWidget",
    "QComboBox",
    "QSpinBox",
    "QDoubleSpinBox",
    "QSlider",
    "QTreeWidget",
    "QTableWidget",
    "QDialog",
    "QMenu",
    "QToolButton",
    "QPushButton",
    "QCheckBox",
    "QLineEdit",
    "QTextEdit",
    "QSplitter",
    "QTabWidget",
    "QProgressDialog",
]


def make(together: threading.Barrier) -> None:
    """Make a class of each, with a signal."""
    together.wait()
    for name in NAMES:
        base = getattr(QtWidgets, name)
        made = type(name, (base,), {"changed": QtCore.Signal()})
        if threading.current_thread() is threading.main_thread():
            one = made()
            one.changed.connect(print)


if __name__ == "__main__":
    application = QtWidgets.QApplication([])
    both = threading.Barrier(2)
    other = threading.Thread(target=make, args=(both,))
    other.start()
    make(both)
    other.join()
    sys.stdout.write("made\n")
