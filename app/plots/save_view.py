"""Saves what a plot shows: as PNG, SVG or CSV."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import (
    QBuffer,
    QByteArray,
    QCoreApplication,
    QIODevice,
    QPoint,
    QSaveFile,
    QSize,
    Qt,
)
from PySide6.QtGui import QImage, QImageWriter, QPainter
from PySide6.QtSvg import QSvgGenerator
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from app.widgets import theme
from app.widgets.buttons import Button, set_role
from app.widgets.theme import control_icon

if TYPE_CHECKING:
    from app.plots.playhead_plot import PlayheadPlot

translate = QCoreApplication.translate

SCALE = 2.0  # of a PNG: fit for print
_ICON_PX = 16
_NAMES = ("planned", "sent")


class SaveButton(Button):
    """Asks where to, and saves what its plot shows now."""

    def __init__(self, plot: "PlayheadPlot") -> None:
        super().__init__()
        self._plot = plot
        set_role(self, "small")
        self.setIcon(control_icon("save", _ICON_PX, theme.DIM))
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setFixedSize(QSize(_ICON_PX + 10, _ICON_PX + 8))
        self.setAccessibleName(
            translate("PlotPanel", "Save this view: {plot}").format(
                plot=plot.accessibleName()
            )
        )
        self.setToolTip(translate("PlotPanel", "Save this view as PNG, SVG or CSV"))
        self.clicked.connect(self._ask)

    def _ask(self) -> None:
        kinds = translate(
            "PlotPanel", "PNG image (*.png);;SVG drawing (*.svg);;CSV data (*.csv)"
        )
        dialog = QFileDialog(self, self.toolTip(), "", kinds)
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setDefaultSuffix("png")
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.filterSelected.connect(
            lambda kind: dialog.setDefaultSuffix(kind.split("*.")[-1].rstrip(")"))
        )
        dialog.fileSelected.connect(self._save)
        dialog.open()

    def _save(self, path: str) -> None:
        problem = save_view(self._plot, Path(path))
        if problem:
            box = QMessageBox(QMessageBox.Icon.Warning, self.toolTip(), problem)
            box.setParent(self.window(), Qt.WindowType.Dialog)
            box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            box.open()


def save_view(plot: "PlayheadPlot", path: Path) -> str:
    """Write the view by the ending of the name; return what went wrong, "" if nothing."""
    makers = {".png": _png, ".svg": _svg, ".csv": _csv}
    maker = makers.get(path.suffix.lower())
    if maker is None:
        text = translate(
            "PlotPanel", "{name}: unsupported file type; choose one of {kinds}"
        )
        return text.format(name=path.name, kinds=", ".join(makers))
    file = QSaveFile(str(path))
    is_written = (
        file.open(QIODevice.OpenModeFlag.WriteOnly)
        and file.write(maker(plot)) >= 0
        and file.commit()
    )
    return "" if is_written else f"{path.name}: {file.errorString()}"


def _png(plot: QWidget) -> QByteArray:
    size = plot.size() * SCALE
    image = QImage(size, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(SCALE)
    QWidget.render(plot, image)
    return _bytes_of(lambda buffer: QImageWriter(buffer, b"png").write(image))


def _svg(plot: QWidget) -> QByteArray:
    def draw(buffer: QBuffer) -> None:
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setSize(plot.size())
        generator.setViewBox(plot.rect())
        generator.setTitle(plot.accessibleName())
        with QPainter(generator) as painter:
            QWidget.render(plot, painter, QPoint())

    return _bytes_of(draw)


def _csv(plot: "PlayheadPlot") -> QByteArray:
    lines = ["series,time_s,x,y,z"]
    pages = plot.pages()
    names = _NAMES if len(pages) > 1 else ("acceleration",)
    for name, page in zip(names, pages, strict=True):
        for time_s, values in zip(page.time_s, page.values, strict=True):
            numbers = ",".join(f"{value:.6g}" for value in values)
            lines.append(f"{name},{time_s:.6f},{numbers}")
    return QByteArray("\n".join([*lines, ""]).encode())


def _bytes_of(write: Callable[[QBuffer], object]) -> QByteArray:
    content = QByteArray()
    buffer = QBuffer(content)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    write(buffer)
    buffer.close()
    return content
