"""Records camera, microphone and IMU on one machine's clock, into a folder.

Each has a thread; another one looks after them: what is on disk, what is silent, what is
left of the disk. What fails is told and marked, and the other streams continue.
"""

import contextlib
import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from hapticplayer.capture.live.disk_watch import DiskWatch, of_writing
from hapticplayer.capture.live.imu_file import ImuFile
from hapticplayer.capture.live.recorder_state import RecorderState
from hapticplayer.capture.live.source import (
    ClockRestarted,
    LiveSource,
    OpenedSource,
    SourceLost,
)
from hapticplayer.capture.live.stream_watch import StreamWatch
from hapticplayer.capture.recorded import CLIP, LOG, SOURCE, Gap, Stream, Take
from hapticplayer.clock import Clock, utc_now_iso
from hapticplayer.errors import (
    HapticPlayerError,
    InputError,
    Message,
    UsageError,
    message_of,
)
from hapticplayer.media.live_clip import LiveClip, first_shown
from hapticplayer.media.live_input import CAMERAS, MICROPHONES, Live, LiveInput
from hapticplayer.storage import (
    FOLDER,
    StorageError,
    lock_folder,
    refuse_existing,
    sync_folder,
)

GRAVITY_AT_S, CHECK_AT_S = 3.0, 20.0
"""When what an IMU has sent is searched for gravity, and when it is compared with it."""

MOST_RESTARTS, MOST_NOTICES = 1000, 1000
"""Of an IMU, such as of two phones that send to one address; then it is given up."""

_LOOK_S, _SYNC_S, _DESCRIBE_S, _JOIN_S = 0.1, 1.0, 5.0, 3.0
_AGAIN_S = 0.5
_CAMERA_STALL_S, _SOURCE_STALL_S, _SOUND_STALL_S = 1.0, 0.5, 1.0
_SHOWN_FOR_S, _TOLD_EVERY_S = 1.0, 10.0


class Recorder:
    """Camera, microphone and source, each optional, into a new folder.

    Args:
        folder: must not exist.
        camera: name for `LiveInput`, or None.
        audio: name of the microphone, or None; needs a camera.
        source: an open IMU, or None; it is closed at the end.
        clock: the machine's.
        source_name: as a person gave it.
        mounting: of the IMU on the actor, as `--mounting` of an import; "" if not known.
    """

    def __init__(  # noqa: PLR0913 - three streams, one folder
        self,
        folder: str | os.PathLike[str],
        camera: str | None,
        audio: str | None,
        source: LiveSource | None,
        clock: Clock,
        *,
        source_name: str = "",
        mounting: str = "",
    ) -> None:
        if camera is None and audio is not None:
            raise UsageError("sound is recorded with a camera; give one (--camera)")
        if camera is None and source is None:
            raise UsageError("nothing is recorded; give a camera, an IMU, or both")
        self.folder, self._clock, self._mounting = Path(folder), clock, mounting
        self._names = camera, audio, source_name
        self._source = source
        self._camera: LiveInput | None = None
        self._microphone: LiveInput | None = None
        self._clip: LiveClip | None = None
        self._log: ImuFile | None = None
        self._film = StreamWatch("camera", _CAMERA_STALL_S)
        self._sound = StreamWatch("microphone", _SOUND_STALL_S)
        self._motion = StreamWatch("imu", _SOURCE_STALL_S)
        self._stopping = threading.Event()
        self._threads: dict[str, threading.Thread] = {}
        self._over: set[str] = set()
        self._silent: set[str] = set()
        self._quiet_until_s: dict[str, float] = {}
        self._notices: list[Message] = []
        self._marks_s: list[float] = []
        self._zero_s, self._began, self._shown_until_s = 0.0, "", 0.0
        self._lock: int | None = None
        self._is_damaged = self._ended_alone = False
        self._is_away = self._is_news = False
        self._disk = DiskWatch(self.folder)

    def start(self) -> None:
        """Open the devices, make the folder, and record.

        Raises:
            InputError: when something cannot be opened; no folder is left.
        """
        refuse_existing(self.folder, FOLDER)
        with contextlib.ExitStack() as undo:
            if self._source is not None:
                undo.callback(self._source.close)
            filmed = self._open(undo)
            self._make_folder()
            if self._source is not None:
                self._log = ImuFile(self.folder / LOG, self._source, self._zero_s)
            if self._camera is not None:
                self._clip = LiveClip(
                    self.folder / CLIP, self._camera, self._microphone, self._zero_s
                )
            undo.pop_all()
        if filmed is not None:
            self._run("camera", lambda: self._record_camera(*filmed))
        if self._microphone is not None:
            self._run("microphone", self._record_sound)
        if self._log is not None:
            self._run("imu", self._record_source)
        self._run("", self._look_after)

    def _open(self, undo: contextlib.ExitStack) -> tuple[Live, Iterator[Live]] | None:
        """Open camera and microphone; the first frame is media time 0."""
        camera, audio, _ = self._names
        self._zero_s = self._clock.now_s()
        if audio is not None:
            self._microphone = LiveInput(audio, MICROPHONES, self._clock)
            undo.callback(self._microphone.close)
        if camera is None:
            return None
        self._camera = LiveInput(camera, CAMERAS, self._clock)
        undo.callback(self._camera.close)
        frames = self._camera.packets()
        first = first_shown(self._camera, frames)
        self._zero_s = first.host_s
        return first, frames

    def _make_folder(self) -> None:
        self._began = utc_now_iso()
        try:
            self.folder.mkdir(parents=True)
        except OSError as problem:
            raise StorageError.of(problem, self.folder) from problem
        self._lock = lock_folder(self.folder)
        self._description().write(self.folder)

    def _run(self, name: str, record: Callable[[], None]) -> None:
        """Run a thread; what ends it before the stop is told."""

        def until_it_ends() -> None:
            try:
                record()
            except (HapticPlayerError, OSError) as problem:
                what = message_of(problem)
                if (written := of_writing(problem, self.folder)) is not None:
                    self._is_damaged, what = True, written
                self._tell(Message("{stream}: {what}", stream=name, what=what))
            finally:
                self._over.add(name)

        thread = threading.Thread(
            target=until_it_ends, name=f"record-{name or 'watch'}", daemon=True
        )
        self._threads[name] = thread
        thread.start()

    def _tell(self, what: Message) -> None:
        if not self._stopping.is_set() and len(self._notices) < MOST_NOTICES:
            at_s = self._elapsed_s()
            self._notices.append(Message("{at_s:.1f} s: {what}", at_s=at_s, what=what))

    def _elapsed_s(self) -> float:
        return self._clock.now_s() - self._zero_s

    def _record_camera(self, first: Live, others: Iterator[Live]) -> None:
        assert self._camera is not None
        try:
            self._add_frame(first)
            for live in others:
                self._add_frame(live)
                if self._is_to_end("camera"):
                    return
        finally:
            self._camera.close()

    def _is_to_end(self, stream: str) -> bool:
        return self._stopping.is_set() or stream in self._disk.ended

    def _add_frame(self, live: Live) -> None:
        assert self._clip is not None
        now_s = self._clock.now_s()
        if self._clip.add(live, is_shown=now_s < self._shown_until_s):
            at_s = np.array([live.host_s - self._zero_s])
            self._film.take(at_s, now_s - self._zero_s)
        else:
            self._film.drop()

    def _record_sound(self) -> None:
        assert self._clip is not None
        assert self._microphone is not None
        try:
            for live in self._microphone.packets():
                if self._is_to_end("camera"):
                    return
                self._clip.add_sound(live)
                self._sound.take(
                    np.array([live.host_s - self._zero_s]), self._elapsed_s()
                )
        finally:
            self._microphone.close()

    def _record_source(self) -> None:
        assert self._log is not None
        try:
            while not self._is_to_end("imu"):
                try:
                    media_s, stamp_s = self._log.read(self._clock)
                except SourceLost as problem:
                    self._take_up_again(self._log, problem)
                    continue
                if len(media_s):
                    self._motion.take(media_s, self._elapsed_s(), stamp_s)
                    self._is_away = False
        finally:
            self._log.close()

    def _take_up_again(self, log: ImuFile, lost: SourceLost) -> None:
        """Wait for an IMU that was lost; what comes then has a clock of its own."""
        source = self._source
        if not isinstance(source, OpenedSource) or log.stretches > MOST_RESTARTS:
            raise lost
        if isinstance(lost, ClockRestarted):
            self._tell(
                Message("imu: {what}; from now on it has another clock", what=lost.what)
            )
            source.forget_clock()
        elif not self._is_opened_again(source, lost):
            return
        log.begin_anew()
        self._is_news = True

    def _is_opened_again(self, source: OpenedSource, lost: SourceLost) -> bool:
        """Whether it came back before the stop; told once for as long as it is away."""
        if not self._is_away:
            self._is_away = True
            self._motion.lose()
            self._silent.add("imu")
            self._tell(
                Message(
                    "imu: {what}; the other streams continue, and it is recorded again as soon as "
                    "it is back",
                    what=message_of(lost),
                )
            )
        while not self._stopping.wait(_AGAIN_S):
            try:
                source.open_again()
            except HapticPlayerError:  # as was told
                continue
            return True
        return False

    def _watches(self) -> Iterator[StreamWatch]:
        for watch in (self._film, self._sound, self._motion):
            if watch.name in self._threads:
                yield watch

    def _look_after(self) -> None:
        synced_s = described_s = self._clock.now_s()
        checks: list[tuple[float, Callable[[OpenedSource], object]]] = [
            (GRAVITY_AT_S, OpenedSource.check_gravity),
            (CHECK_AT_S, OpenedSource.checked),
        ]
        while not self._stopping.wait(_LOOK_S):
            now_s = self._clock.now_s()
            self._tell_of_silence()
            if now_s - synced_s >= _SYNC_S:
                synced_s = now_s
                for notice in self._disk.look(self._elapsed_s(), self._recorded()):
                    self._tell(notice)
                self._sync()
            if self._is_news or now_s - described_s >= _DESCRIBE_S:
                described_s, self._is_news = now_s, False
                self._describe()
            is_due = checks and self._elapsed_s() >= checks[0][0]
            if is_due and not self._passes(checks.pop(0)[1]):
                checks = []

    def _passes(self, check: Callable[[OpenedSource], object]) -> bool:
        """Tell where gravity contradicts what is known of the IMU."""
        if isinstance(self._source, OpenedSource) and self._motion.count:
            try:
                check(self._source)
            except (InputError, UsageError) as problem:
                self._tell(message_of(problem))
                return False
        return True

    def _tell_of_silence(self) -> None:
        """Tell when a stream falls silent and is back; of one that stutters, now and then."""
        now_s = self._elapsed_s()
        for watch in self._watches():
            if watch.name in self._over:
                continue
            if watch.stalls(now_s):
                if now_s < self._quiet_until_s.get(watch.name, 0.0):
                    continue
                self._quiet_until_s[watch.name] = now_s + _TOLD_EVERY_S
                self._silent.add(watch.name)
                self._tell(
                    Message(
                        "{stream}: nothing for {stall_s:.1f} s (check the cable, or wake "
                        "the phone up); the other streams continue",
                        stream=watch.name,
                        stall_s=watch.stall_s,
                    )
                )
            elif watch.name in self._silent and not watch.is_stalled:
                self._silent.discard(watch.name)
                self._tell(Message("{stream}: is back", stream=watch.name))

    def _recorded(self) -> set[str]:
        return self._threads.keys() - self._over

    def _sync(self) -> None:
        """Put what was written on disk, should the power fail; end a film that is over."""
        try:
            if self._log is not None and "imu" not in self._over:
                self._log.sync()
            if self._clip is not None:
                sync_folder(self._clip.path)
        except (OSError, ValueError) as problem:  # ValueError: has just been closed
            self._tell_of_writing(problem)
        films = {"camera", "microphone"} & self._threads.keys()
        if self._clip is not None and films <= self._over:
            self._end_clip(self._clip)

    def _end_clip(self, clip: LiveClip) -> None:
        try:
            clip.close()
        except HapticPlayerError as problem:
            self._tell_of_writing(problem)

    def _tell_of_writing(self, problem: Exception) -> None:
        """Tell, once, that the folder cannot be written."""
        what = of_writing(problem, self.folder)
        if what is not None and not self._is_damaged:
            self._tell(what)
        self._is_damaged |= what is not None

    def _describe(self, *, is_finished: bool = False) -> None:
        try:
            self._description(is_finished=is_finished).write(self.folder)
        except StorageError as problem:
            self._tell_of_writing(problem)

    def _description(self, *, is_finished: bool = False) -> Take:
        camera, audio, source = self._names
        film, sound, motion = self._film, self._sound, self._motion
        lines = self._log.lines() if self._log else []
        return Take(
            began=self._began,
            zero_s=self._zero_s,
            is_finished=is_finished,
            camera=self._stream(camera, self._camera, film),
            microphone=self._stream(
                audio,
                self._microphone,
                sound,
                self._clip.sound.residual_s if self._clip and self._clip.sound else 0.0,
            ),
            imu=None
            if self._source is None
            else Stream(
                source,
                self._log.stamped_by if self._log else SOURCE,
                0.0,
                motion.count,
                motion.dropped,
            ),
            clock=lines[0] if lines else None,
            restarts=lines[1:],
            mounting=self._mounting,
            marks_s=list(self._marks_s),
            gaps=self._gaps(),
            notices=[str(one) for one in self._notices],
        )

    @staticmethod
    def _stream(
        name: str | None,
        device: LiveInput | None,
        watch: StreamWatch,
        residual_s: float = 0.0,
    ) -> Stream | None:
        if name is None or device is None:
            return None
        dropped = watch.dropped + device.undated
        return Stream(name, device.clock_name, residual_s, watch.count, dropped)

    def _gaps(self) -> list[Gap]:
        return sorted(
            (gap for watch in self._watches() for gap in watch.gaps),
            key=lambda gap: gap.begin_s,
        )

    def _are_all_over(self) -> bool:
        is_stopped = self._stopping.is_set()
        return not is_stopped and self._over >= {name for name in self._threads if name}

    def mark(self) -> float:
        """Mark this moment; its media time."""
        at_s = round(self._elapsed_s(), 3)
        self._marks_s.append(at_s)
        return at_s

    def stop(self) -> Path:
        """End all streams and write the description; the folder."""
        if self._stopping.is_set():
            return self.folder
        end_s, self._ended_alone = self._elapsed_s(), self._are_all_over()
        self._stopping.set()
        for thread in self._threads.values():
            thread.join(_JOIN_S)
        for watch in self._watches():
            watch.end(end_s)
        if self._clip is not None:
            self._end_clip(self._clip)
        self._describe(is_finished=not self._is_damaged)
        if self._lock is not None:
            os.close(self._lock)
        return self.folder

    def snapshot(self, *, with_frame: bool = True) -> RecorderState:
        """What a window or a terminal shows of it."""
        if with_frame:
            self._shown_until_s = self._clock.now_s() + _SHOWN_FOR_S
        clip, film, motion = self._clip, self._film, self._motion
        undated = self._camera.undated if self._camera else 0
        shown = self._log.shown() if self._log else np.empty((0, 7))
        return RecorderState(
            elapsed_s=self._elapsed_s(),
            frame=clip.shown() if clip and with_frame else None,
            level_db=clip.sound.level_db if clip and clip.sound else None,
            time_s=shown[:, 0],
            accel_mps2=shown[:, 1:4],
            rate_radps=shown[:, 4:7],
            camera_hz=film.rate_hz,
            imu_hz=motion.rate_hz,
            frames=film.count,
            dropped_frames=film.dropped + undated,
            samples=motion.count,
            dropped_samples=motion.dropped,
            gaps=tuple(self._gaps()),
            marks_s=tuple(self._marks_s),
            free_bytes=self._disk.free_bytes(),
            notices=tuple(self._notices),
            is_over=self._ended_alone or self._are_all_over(),
        )
