"""The effects of a window that was killed, kept and offered again."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.bridge.errors import Show
from app.bridge.recovery import Kept, Recovery, fingerprint
from app.editor.document import Document
from app.widgets.messages import RecoveryBar
from hapticplayer.errors import HapticPlayerError, InputError, message_of
from hapticplayer.rendering.effects import EffectList
from hapticplayer.sequence.effects_file import effects_in, written

KIND = "effects"


class Unsaved(QObject):
    """Keeps the changes of a document aside until they are saved or discarded.

    What is recovered is a step that can be undone; only saving writes the sequence.
    """

    settled = Signal()
    """A person has taken or refused what was left."""

    def __init__(self, folder: Path, document: Document, show: Show) -> None:
        super().__init__()
        self.bar = RecoveryBar()
        self._document, self._show = document, show
        self._recovery = Recovery(KIND, folder, self)
        self._title = self._base = ""
        self._saved = document.effects
        self._found: Kept | None = None
        self._recovery.failed.connect(lambda problem: show(message_of(problem), None))
        self.bar.accepted.connect(self.recover)
        self.bar.refused.connect(self._discard)

    def begin(self, title: str, effects: EffectList) -> None:
        """The sequence is shown with these effects; offer what was left of others."""
        self._title = title
        self._take_base(effects)
        try:
            self._found = self._recovery.open()
        except HapticPlayerError as problem:
            self._show(message_of(problem), None)
            self._recovery.forget()
        if self._found is not None:
            self.bar.offer([self._found], self._sentence(self._found))
        self._document.changed.connect(self.keep)

    def _sentence(self, kept: Kept) -> str:
        if kept.base == self._base:
            return self.tr("Changes from {moment} were not saved.")
        return self.tr(
            "Changes from {moment} were not saved; the effects were changed since."
        )

    @property
    def is_asking(self) -> bool:
        """Whether a person has yet to decide; until then nothing can be edited."""
        return self._found is not None

    @property
    def file(self) -> Path:
        return self._recovery.file

    def recover(self) -> None:
        """Show what was left, as a change that is not saved."""
        kept, self._found = self._found, None
        if kept is None:
            return
        self.bar.hide()
        try:
            effects = effects_in(kept.content, str(self.file))
        except InputError as problem:
            self._show(message_of(problem), None)
            self._discard()
            return
        self._document.change(effects, self.tr("Recover"))
        self.settled.emit()

    def _discard(self) -> None:
        self._found = None
        self._recovery.forget()
        self.settled.emit()

    def keep(self) -> None:
        """Keep the effects as they are now; nothing once they are as they were saved."""
        effects = self._document.effects
        if effects != self._saved:
            self._recovery.keep(self._title, self._base, lambda: written(effects))
        elif self._found is None:
            self._recovery.forget()

    def saved(self) -> None:
        """The effects are those of the sequence now."""
        self._take_base(self._document.effects)
        self._recovery.forget()

    def _take_base(self, effects: EffectList) -> None:
        self._saved, self._base = effects, fingerprint(written(effects))

    def end(self, *, is_discarded: bool) -> None:
        """The editor closes; what nobody has decided about is offered again."""
        if is_discarded and self._found is None:
            self._recovery.forget()
        self._recovery.close()
