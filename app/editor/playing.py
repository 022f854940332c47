"""The player of the editor, on which edits are felt while it plays."""

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QObject, QTimer, Signal

from app.bridge.errors import Show
from app.bridge.pump import Cadence, Pump
from app.bridge.settings import Settings, latencies_of
from app.editor.shuttle import Shuttle
from app.player.controls import kept_volume
from app.player.fullscreen import EscapeFilter
from app.player.session import Session
from app.player.video_surface import SurfaceSink, VideoSurface
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.model import Feedback, ForceTrack, rendered_feedback
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source

DRAW_HZ, WATCH_HZ = 30.0, 15.0


class PlayerSetup(NamedTuple):
    """What the page plays with: a device by name, and what makes a player."""

    clock: Clock
    device: str
    settings: Settings
    make_player: Callable[[Clock, SurfaceSink, str], Player]


class Playing(QObject):
    """Plays the realistic force of a clip; Escape stops it, whatever has the keyboard.

    Before `begin` and after `end` it does nothing.
    """

    moved = Signal(float)
    """Where the clip is, s, while it plays and where a loop takes it."""

    changed = Signal()
    """It plays or not, or the force was stopped or is back."""

    def __init__(self, setup: PlayerSetup, show: Show, parent: QObject) -> None:
        super().__init__(parent)
        self.surface, self.session = VideoSurface(), None
        self.track: ForceTrack | None = None
        self._feedback = Feedback.REALISTIC
        self._setup, self._show = setup, show
        self._pump: Pump | None = None
        self._draw_cadence, self._watch_cadence = Cadence(DRAW_HZ), Cadence(WATCH_HZ)
        self._has_just_stopped = False
        self.shuttle = Shuttle(setup.clock, self._player)
        self.shuttle.moved.connect(self.moved)
        self.shuttle.changed.connect(self.changed)
        self._escape = EscapeFilter(self._on_escape, self)
        self._escape.install()

    session: Session | None

    def begin(self, source: Source, screen: str) -> bool:
        """Take the device and show the first frame; return whether it can play."""
        player = self._made_player()
        if player is None:
            return False
        self.session = Session(player, self._show)
        self.session.changed.connect(self.changed)
        player.set_latencies(latencies_of(self._setup.settings, screen))
        player.set_volume(kept_volume(self._setup.settings))
        self.surface.set_clip_size(source.clip.width, source.clip.height)
        player.open(source)
        self._feedback = rendered_feedback(source.tracks)
        self.track = source.tracks[self._feedback]
        self._pump = Pump(player.poll, self._setup.clock, self._on_gap, self)
        self._pump.start()
        return True

    def _made_player(self) -> Player | None:
        """Return a player, without a device where that cannot be taken."""
        clock, device, _settings, make = self._setup
        sink = SurfaceSink(self.surface)
        for name in (device, NO_DEVICE):
            try:
                return make(clock, sink, name)
            except HapticPlayerError as problem:
                self._show(message_of(problem), None)
        return None

    def _player(self) -> Player | None:
        return self.session.player if self.session else None

    def end(self) -> None:
        """Stop the force, and let go of everything."""
        self._escape.remove()
        self.shuttle.stop()
        session, self.session = self.session, None
        if session is not None:
            session.player.pause()
            if self._pump is not None:
                self._pump.stop()
            session.close()

    # --- commands ------------------------------------------------------------

    @property
    def is_playing(self) -> bool:
        """Whether it plays, or goes back."""
        if self.session is None:
            return False
        return self.shuttle.is_back or self.session.player.snapshot().is_playing

    @property
    def is_stopped(self) -> bool:
        """Whether the force was stopped and waits for a person."""
        return self.session is not None and self.session.is_stopped

    def toggle(self) -> None:
        """Pause in either direction, or play."""
        if self.is_playing:
            self.pause()
        else:
            self.shuttle.forward()

    def pause(self) -> None:
        self.shuttle.stop()

    def stop(self) -> None:
        """Take the force away at once."""
        if self.session is not None:
            self.session.stop()
            self.shuttle.stop()

    def stop_or_rearm(self) -> None:
        """Take the force away at once, or let it come back."""
        if self.is_stopped:
            self.rearm()
        else:
            self.stop()

    def rearm(self) -> None:
        """Let the force come back."""
        if self.session is not None:
            self.session.rearm()

    def seek(self, media_s: float) -> None:
        """Go to a time, where a clip that went back stays."""
        if self.shuttle.is_back:
            self.shuttle.stop()
        if self.session is not None:
            self.session.player.seek(media_s)

    def set_loop(self, span_s: tuple[float, float] | None) -> None:
        """Repeat a span, or nothing; go there from outside of it."""
        if self.session is None:
            return
        player = self.session.player
        player.set_loop(span_s)
        if span_s is not None:
            begin_s, end_s = span_s
            if not begin_s <= player.snapshot().media_s < end_s:
                player.seek(begin_s)
                self.moved.emit(begin_s)

    def replace(self, track: ForceTrack) -> None:
        """Play another version of the force from here on, without a pause."""
        if self.session is not None and track is not self.track:
            self.session.player.replace_track(self._feedback, track)
        self.track = track

    # --- what happens by itself ----------------------------------------------

    def stops(self) -> bool:
        """Stop; return whether there was anything to stop, also just before."""
        self._on_escape()
        has_stopped, self._has_just_stopped = self._has_just_stopped, False
        return has_stopped

    def _on_escape(self) -> None:
        """Stop, whichever menu or field has the keyboard."""
        if not self.is_playing:
            return
        self.stop()
        self._has_just_stopped = True
        # the same press comes to the page after this, if at all
        QTimer.singleShot(0, self, self._forget_escape)

    def _forget_escape(self) -> None:
        self._has_just_stopped = False

    def _on_gap(self) -> None:
        session, now_s = self.session, self._setup.clock.now_s()
        if session is None:
            return
        if self._watch_cadence.is_due(now_s):
            session.watch()
        if self._draw_cadence.is_due(now_s):
            now = session.player.snapshot()
            if now.is_playing:
                self.moved.emit(now.media_s)
