"""What is done with files that are dropped, and what is offered for a clip without force."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from app.player.dialogs import Dialogs
from app.player.playlist import Playlist, is_playable
from app.player.session import Session
from app.widgets.messages import OfferBar
from hapticplayer.model import Feedback
from hapticplayer.playback.source import Source


class Dropping(QObject):
    """Opens, lists or imports what comes to a window.

    Args:
        window: that shows it.
        session: opens a clip or sequence.
        dialogs: import others.
        playlist: of what is dropped together.
        offer: says what can be done with a clip.
        open_study: edits the study in a folder, or returns False.
    """

    def __init__(
        self,
        window: QWidget,
        session: Session,
        dialogs: Dialogs,
        playlist: Playlist,
        offer: OfferBar,
        open_study: Callable[[Path], bool],
    ) -> None:
        super().__init__(window)
        self._window, self._session, self._dialogs = window, session, dialogs
        self._playlist, self._offer = playlist, offer
        self._open_study = open_study
        self._clips: list[Path] = []
        """Dropped together, for which one import is offered."""
        session.chosen.connect(self.offer)
        offer.accepted.connect(self._import_shown)

    def take(self, paths: list[Path]) -> None:
        """Open a file; several clips are a playlist, all others are imported."""
        self._clips = []
        if len(paths) == 1:
            self._take_one(paths[0])
        elif all(map(is_playable, paths)):
            self._clips = [path.resolve() for path in paths if path.is_file()]
            self._playlist.take(paths)
        else:
            self._dialogs.import_files(paths)

    def _take_one(self, path: Path) -> None:
        """Open what plays, import a folder of clips, ask for the clip of a log."""
        if is_playable(path):
            self._session.open_path(path)
            return
        if path.is_dir() and self._open_study(path):
            return
        from hapticplayer.sequence.import_batch import is_log, items_of

        if path.is_dir() and any(item.video for item in items_of([path])):
            self._dialogs.import_files([path])
        elif is_log(path):
            self._dialogs.import_recording([*self._open_clip(), path])
        else:
            self._session.open_path(path)

    def _open_clip(self) -> list[Path]:
        """The clip that is open and has no force; a log that is dropped is its log."""
        source = self._session.player.snapshot().source
        return [source.path] if source is not None and _is_plain(source) else []

    def offer(self, source: Source) -> None:
        """Say how a clip that a person has opened comes to be felt, where it is not."""
        if not _is_plain(source) or self._window.isFullScreen():
            return
        if len(self._clips) > 1 and source.path in self._clips:
            text = self.tr("Clips: {count}. Imported, those with motion can be felt.")
            text = text.format(count=len(self._clips))
            button = self.tr("Import all\u2026")
        elif source.clip.has_telemetry:
            text = self.tr(
                "{name} contains motion data, which plays once it is imported."
            )
            button = self.tr("Import and feel it\u2026")
        else:
            text = self.tr(
                "{name} has no motion data; drop its log here, or let its frames suggest it."
            )
            button = self.tr("Suggest motion from the frames\u2026")
        self._offer.show_offer(text.format(name=source.path.name), button)

    def _import_shown(self) -> None:
        source = self._session.player.snapshot().source
        if source is None:
            return
        if len(self._clips) > 1 and source.path in self._clips:
            self._dialogs.import_several(self._clips)
        else:
            suggests = not source.clip.has_telemetry
            self._dialogs.import_recording([source.path], suggests=suggests)


def _is_plain(source: Source) -> bool:
    """Whether it is a video of this machine without any force."""
    is_felt = set(source.tracks) != {Feedback.NONE}
    return not (is_felt or source.clip.remote or source.notice)
