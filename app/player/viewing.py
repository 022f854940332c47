"""How the clip is looked at and listened to: zoom, shape, tracks, subtitles, frames as files."""

import contextlib
from bisect import bisect_right
from dataclasses import replace
from datetime import timedelta
from pathlib import Path

from PySide6.QtCore import QLocale, QObject, QPoint, QStandardPaths, Qt, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QLabel, QMenu, QWidget

from app.bridge.jobs import Job, in_child
from app.bridge.settings import Settings
from app.player.commands import Actions
from app.player.menus import ChoiceMenu
from app.player.session import Session
from app.player.video_surface import VideoSurface
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.errors import HapticPlayerError, MediaError, Message, Progress
from hapticplayer.media.frames import DecodedFrame, FrameConverter
from hapticplayer.media.tracks import (
    Caption,
    ClipTracks,
    OfferedTrack,
    read_subtitles,
    tracks_of,
)
from hapticplayer.playback.source import Source
from hapticplayer.sequence.library import name_from

FRAMES = "frames_folder"
"""Name in the settings: where frames are saved."""

ZOOM_STEP, LEAST_ZOOM, MOST_ZOOM = 1.1, 0.25, 3.0
_ASPECTS = {"": None, "16:9": 16 / 9, "4:3": 4 / 3, "1:1": 1.0, "2.35:1": 2.35}
_NO_TRACK = "-"
_LETTERS, _BOTTOM = 0.045, 0.06
"""Height of the letters of subtitles, and their distance from below, of the video's."""
_CAPTION_STYLE = (
    "QLabel { background: rgba(12, 14, 17, 175); color: #ffffff; padding: 3px 10px; }"
)


class CaptionLabel(QLabel):
    """Subtitles over the lower part of the video."""

    def __init__(self, over: VideoSurface) -> None:
        super().__init__(over)
        self._over = over
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setStyleSheet(_CAPTION_STYLE)
        self.hide()

    def show_caption(self, text: str) -> None:
        """Show a text in the middle; "" for none."""
        where = self._over.video_rect
        if not text:
            self.hide()
            return
        wanted_px = max(11, round(_LETTERS * where.height()))
        font = theme.scaled(self._over.font(), 1.0)
        font.setPixelSize(wanted_px)
        self.setFont(font)
        self.setText(text)
        self.adjustSize()
        left = where.center().x() - self.width() // 2
        below_px = round(_BOTTOM * where.height())
        self.move(left, where.bottom() - below_px - self.height())
        self.show()
        self.raise_()


class Viewing(QObject):
    """Zoom, shape, audio track and subtitles of the clip, and its frames as files."""

    message = Signal(str)

    def __init__(
        self,
        session: Session,
        surface: VideoSurface,
        actions: Actions,
        settings: Settings,
    ) -> None:
        super().__init__(surface)
        self._session, self._surface = session, surface
        self._actions, self._settings = actions, settings
        self.caption = CaptionLabel(surface)
        self.tracks = ClipTracks()
        self._listed: Path | None = None
        self._captions: list[Caption] = []
        self._begins_s: list[float] = []
        self._subtitles = _NO_TRACK
        self._job: Job[list[Caption]] | None = None
        self._saving: Job[Path] | None = None
        self._aspect = ""
        self._make_menus(actions)
        session.opening.connect(self._on_opening)

    def _make_menus(self, actions: Actions) -> None:
        sound = actions.add_menu("playback", self.tr("A&udio track"), "feedback")
        self.sound_menu = ChoiceMenu(
            sound,
            self._sound_choices,
            lambda: str(self._sound_track()),
            lambda value: self.choose_sound(int(value)),
        )
        texts = actions.add_menu("playback", self.tr("Subt&itles"), "feedback")
        self.subtitle_menu = ChoiceMenu(
            texts,
            self._subtitle_choices,
            lambda: self._subtitles,
            self.choose_subtitles,
        )
        shapes = actions.add_menu("view", self.tr("&Aspect ratio"), "fullscreen")
        self.aspect_menu = ChoiceMenu(
            shapes,
            lambda: [(k, k or self.tr("As recorded")) for k in _ASPECTS],
            lambda: self._aspect,
            self.choose_aspect,
        )

    # --- size and shape ------------------------------------------------------

    def zoom(self, steps: int) -> None:
        """Show the video larger (+) or smaller (-); 0 as large as fits."""
        now = self._surface.zoom * ZOOM_STEP**steps if steps else 1.0
        now = 1.0 if abs(now - 1.0) < 0.01 else now
        self._surface.set_zoom(min(max(now, LEAST_ZOOM), MOST_ZOOM))
        text = self.tr("Zoom {x:.0f}\u00a0%")
        self.message.emit(text.format(x=100 * self._surface.zoom))

    def choose_aspect(self, name: str) -> None:
        self._aspect = name
        self._surface.set_aspect(_ASPECTS[name])
        text = self.tr("Aspect ratio: {shape}")
        self.message.emit(text.format(shape=local(name) or self.tr("As recorded")))

    # --- tracks --------------------------------------------------------------

    def _source(self) -> Source | None:
        return self._session.player.snapshot().source

    def _list_tracks(self) -> ClipTracks:
        """The tracks of the clip; read when somebody first looks for them."""
        source = self._source()
        if source is None or source.clip.remote:
            return ClipTracks()
        if self._listed != source.clip.path:
            self._listed = source.clip.path
            try:
                self.tracks = tracks_of(source.clip.path)
            except MediaError as problem:
                self.tracks = ClipTracks()
                self._session.report(problem)
        return self.tracks

    def _sound_track(self) -> int:
        source = self._source()
        return source.clip.audio_track if source else 0

    def _sound_choices(self) -> list[tuple[str, str]]:
        tracks = self._list_tracks().sound
        if not tracks:
            return [("0", self.tr("No sound in this clip"))]
        return [(str(one.number), self._text(one)) for one in tracks]

    def choose_sound(self, index: int) -> None:
        """Play another audio track, from where the clip is."""
        source, player = self._source(), self._session.player
        known = [one.number for one in self._list_tracks().sound]
        if source is None or index == self._sound_track() or index not in known:
            return
        now = player.snapshot()
        held = self._subtitles, self._captions, self._begins_s
        clip = replace(source.clip, audio_track=index)
        self._session.show_source(replace(source, clip=clip), now.feedback)
        self._subtitles, self._captions, self._begins_s = held
        player.seek(now.media_s)
        if now.is_playing:
            player.play()

    def _subtitle_choices(self) -> list[tuple[str, str]]:
        tracks = self._list_tracks().subtitles
        off = self.tr("Off") if tracks else self.tr("No subtitles in this clip")
        return [(_NO_TRACK, off), *((str(t.number), self._text(t)) for t in tracks)]

    def choose_subtitles(self, name: str) -> None:
        """Show the subtitles of a track; they are read in another process."""
        source = self._source()
        self._forget_subtitles()
        if source is None or name == _NO_TRACK:
            return
        path = source.clip.path
        self._subtitles = name

        def work(progress: Progress) -> list[Caption]:
            return in_child(read_subtitles, path, int(name), progress=progress)

        self._job = Job("subtitles", work)
        self._job.start()

    def _forget_subtitles(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None
        self._subtitles, self._captions, self._begins_s = _NO_TRACK, [], []
        self.caption.show_caption("")

    def _text(self, track: OfferedTrack) -> str:
        language = QLocale(track.language)
        known = track.language and language.language() is not QLocale.Language.C
        name = language.nativeLanguageName() if known else track.language
        parts = filter(None, (name or track.language, track.title))
        number = self.tr("Track {n}").format(n=track.number + 1)
        return ", ".join((number, *parts))

    # --- frames as files -----------------------------------------------------

    @property
    def folder(self) -> Path:
        """Where frames are saved."""
        pictures = QStandardPaths.StandardLocation.PicturesLocation
        home = QStandardPaths.writableLocation(pictures)
        return Path(self._settings.text(FRAMES, home))

    def save_frame(self) -> None:
        """Write the frame that is shown, in the clip's own size, to a new file."""
        frame, source = self._surface.frame, self._source()
        if frame is None or source is None or self._saving is not None:
            return
        size_px = source.clip.width, source.clip.height
        seconds = timedelta(milliseconds=round(1e3 * frame.pts_s))
        stamp = str(seconds)[:11].replace(":", "-")
        target = self.folder / f"{name_from(source.title)} {stamp}.png"
        self._saving = Job(
            "frame", lambda _progress: write_frame(frame, size_px, target)
        )
        self._saving.start()

    # --- what happens by itself ----------------------------------------------

    def refresh(self) -> None:
        """Show the subtitles of now; take over what has been read or written."""
        self._take_subtitles()
        self._take_saved()
        if self._captions:
            text = self._caption_at(self._session.player.snapshot().media_s)
            if text != (self.caption.text() if self.caption.isVisible() else ""):
                self.caption.show_caption(text)

    def _caption_at(self, media_s: float) -> str:
        row = bisect_right(self._begins_s, media_s) - 1
        if row < 0 or media_s >= self._captions[row].end_s:
            return ""
        return self._captions[row].text

    def _take_subtitles(self) -> None:
        job = self._job
        if job is None or not job.is_done:
            return
        self._job = None
        if job.problem is None:
            self._captions = job.result or []
            self._begins_s = [one.start_s for one in self._captions]
        else:
            self._forget_subtitles()
            self._session.report(job.problem)

    def _take_saved(self) -> None:
        job = self._saving
        if job is None or not job.is_done:
            return
        self._saving = None
        if job.problem is not None:
            self._session.report(job.problem)
        elif job.result is not None:
            text = self.tr("Saved: {name}")
            self.message.emit(text.format(name=str(job.result)))

    def _on_opening(self, source: Source) -> None:
        if self._listed != source.clip.path:
            self._surface.set_zoom(1.0)
            self._listed, self.tracks = None, ClipTracks()
        self._forget_subtitles()

    def close(self) -> None:
        """End what runs."""
        self._forget_subtitles()
        if self._saving is not None:
            self._saving.join()

    # --- the menu over the video ---------------------------------------------

    def open_menu(self, at: QPoint, parent: QWidget) -> QMenu:
        """What a right click offers."""
        menu = QMenu(parent)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        actions = self._actions
        for group in _MENU:
            for name in group:
                menu.addAction(actions.by_name[name])
            menu.addSeparator()
        choices = (self.sound_menu, self.subtitle_menu, self.aspect_menu)
        for choice in choices:
            menu.addMenu(choice.menu)
        menu.addSeparator()
        menu.addAction(actions.by_name["stop"])
        menu.popup(at)
        return menu


_MENU = (
    ("play", "previous_file", "next_file", "loop", "repeat"),
    ("slower", "faster", "normal_speed"),
    ("video_larger", "video_smaller", "video_fit", "save_frame"),
    ("statistics", "fullscreen"),
)


def write_frame(frame: DecodedFrame, size_px: tuple[int, int], target: Path) -> Path:
    """Write a frame as PNG; a file that is there stays, and the new one gets a number.

    Raises:
        HapticPlayerError: when the folder cannot be written.
    """
    with contextlib.suppress(OSError):  # then nothing can be written there
        target.parent.mkdir(parents=True, exist_ok=True)
    made = FrameConverter().convert(frame, *size_px)
    shape = (made.width, made.height, made.stride_bytes)
    image = QImage(made.pixels, *shape, QImage.Format.Format_RGB32)
    names = (target.with_stem(f"{target.stem} ({n})") for n in range(2, 1000))
    free = next((one for one in (target, *names) if not one.exists()), target)
    if free.exists() or not image.save(str(free)):
        raise HapticPlayerError(
            Message(
                "{path}: the frame cannot be written; choose another folder in the "
                "preferences",
                path=str(free),
            )
        )
    return free
