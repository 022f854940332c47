"""Where this platform keeps a person's documents, and where the library is."""

from pathlib import Path

from PySide6.QtCore import QStandardPaths

from app.bridge.settings import Settings

LIBRARY = "library"
"""Name in the settings."""


def library_folder(settings: Settings) -> Path:
    """Return the folder of the sequences; it may not exist yet."""
    chosen = settings.text(LIBRARY)
    if chosen:
        return Path(chosen)
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Path(QStandardPaths.writableLocation(documents)) / "hapticplayer"


def choose_library(settings: Settings, folder: Path) -> None:
    """Remember another one."""
    if folder != library_folder(settings):
        settings.keep(LIBRARY, str(folder))
        settings.save()
