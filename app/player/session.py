"""What the window does with the player: open, choose, stop."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.bridge.errors import Attempts, ErrorGateway, IsOver, Show
from app.bridge.jobs import Jobs
from hapticplayer.errors import HapticPlayerError, Progress, UsageError, message_of
from hapticplayer.haptics.contract import Cause
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.latch import STOPPED
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.replay import with_log
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.source import Source, open_source
from hapticplayer.playback.video_check import Verdict, VideoCheck
from hapticplayer.rendering import ChosenFeedback
from hapticplayer.shipped import DEMO


class Session(QObject):
    """Runs the player for the window; everything on the window's thread.

    Signals:
        opening: another source is about to be loaded; sizes can be prepared.
        opened: another source is loaded.
        chosen: a person opened it; it is about to play.
        stopped: a person took the force away.
        changed: the phase, the stop, the device or the feedback is another.
        ended: the clip has come to its end.
        another_video: the clip is not the one that its force was made for.
    """

    opening = Signal(object)
    opened = Signal()
    chosen = Signal(object)
    stopped = Signal()
    changed = Signal()
    ended = Signal()
    another_video = Signal(object)

    def __init__(self, player: Player, show: Show) -> None:
        super().__init__()
        self.player = player
        self.gateway = ErrorGateway(show, self.halt, has_report=True)
        self._opening = Attempts()
        self._is_opening_over: IsOver = self._opening.begin()
        self.jobs = Jobs(lambda problem: self.report(problem, self._is_opening_over))
        self.last_problem = ""
        self._state: tuple[object, ...] = ()
        self._warned_of: VideoCheck | None = None

    def report(self, problem: BaseException, is_over: IsOver | None = None) -> None:
        """Show a problem until it is over."""
        if isinstance(problem, UsageError) and message_of(problem) == STOPPED:
            is_over = lambda: not self.is_stopped  # noqa: E731
        self.gateway.report(problem, is_over)

    # --- opening -------------------------------------------------------------

    def open_path(self, path: Path) -> None:
        """Open a sequence or a video and play it."""
        self._run(
            self.tr("Opening {name}").format(name=path.name),
            lambda _progress: open_source(path),
        )

    def open_log(self, path: Path) -> None:
        """Play what a log says was sent, with the clip that is open."""
        source = self.player.snapshot().source
        if source is not None:
            self._run(
                self.tr("Opening {name}").format(name=path.name),
                lambda _progress: with_log(source, path),
            )

    def make_feedback(self, chosen: ChosenFeedback) -> None:
        """Make a force of the clip that is open, and play it from the beginning."""
        source = self.player.snapshot().source
        if source is None:
            return

        def work(_progress: Progress) -> Source:
            made, name = with_feedback(source, chosen.text)
            return replace(made, feedback=name)

        self._run(self.tr("Making the force"), work)

    def open_demo(self) -> None:
        """Open the demo that comes with the program."""
        self.open_path(DEMO)

    def _run(self, title: str, work: Callable[[Progress], Source]) -> None:
        if self.jobs.is_busy:
            problem = self.tr("Another task is running; wait for it or cancel it")
            self.report(HapticPlayerError(problem), lambda: not self.jobs.is_busy)
            return
        self._is_opening_over = self._opening.begin()
        self.jobs.run(title, work, self._play_source)
        # also for work that ends before the next call of `watch`
        self._state = (*self._state[:-1], self.jobs.is_busy)
        self.changed.emit()

    def _play_source(self, source: Source) -> None:
        self.show_source(source)
        self.chosen.emit(source)
        self.player.play()

    def show_source(self, source: Source, feedback: str | None = None) -> None:
        """Load another source, paused at its beginning."""
        self.last_problem = ""
        self.opening.emit(source)
        self.player.open(source, feedback)
        self.opened.emit()
        self._report_notices()

    def _report_notices(self) -> None:
        for text in self._notices():
            self.report(HapticPlayerError(text), partial(self._has_not, text))

    def _has_not(self, notice: str) -> bool:
        return notice not in self._notices()

    def _notices(self) -> list[str]:
        """What a person should know of the clip and the force that is chosen."""
        from hapticplayer.sequence.excursion import stored_texts

        now = self.player.snapshot()
        if (source := now.source) is None:
            return []
        known = (source.coverage_notice(now.feedback), source.notice)
        return [*filter(None, known), *stored_texts(source.description, now.feedback)]

    # --- controls ------------------------------------------------------------

    @property
    def is_stopped(self) -> bool:
        """Whether the force was stopped and waits for a person."""
        return self.player.snapshot().is_stopped

    def stop_or_rearm(self) -> None:
        """Press the big button."""
        if self.is_stopped:
            self.rearm()
        else:
            self.stop()

    def stop(self) -> None:
        """Take the force away at once and pause."""
        self.player.stop_force()
        self.stopped.emit()

    def rearm(self) -> None:
        """Let the force come back after a stop; the grip has to be near the middle."""
        if not self.is_stopped:
            return
        try:
            self.player.rearm()
        except UsageError as problem:
            self.report(problem, lambda: not self.is_stopped)

    def skip(self, by_s: float) -> None:
        """Go some seconds forwards or backwards."""
        self.player.seek(self.player.snapshot().media_s + by_s)

    def go_to_end(self) -> None:
        """Go to the last frame."""
        self.player.seek(self.player.snapshot().duration_s)

    def choose_outputs(self, names: Sequence[str]) -> None:
        """Play on these devices, the leading one first."""
        self.last_problem = ""
        try:
            self.player.set_outputs(names)
        except HapticPlayerError as problem:
            self.report_outputs(problem)
        self.changed.emit()

    def report_outputs(self, problem: HapticPlayerError) -> None:
        """Show why a device cannot be opened, until others are chosen or it can."""
        before = self._health()
        self.report(problem, lambda: self._health() != before)

    def _health(self) -> list[tuple[str, Health]]:
        return [(one.name, one.health) for one in self.player.snapshot().outputs]

    def choose_leading(self, name: str) -> None:
        others = [one for one in self.player.output_names[1:] if one != name]
        self.choose_outputs([name, *others])

    def choose_feedback(self, name: str) -> None:
        """Play another force track."""
        self.player.set_feedback(name)
        self._report_notices()
        self.changed.emit()

    def halt(self) -> None:
        """Stop force and clip whatever else is broken."""
        for action in (self.player.stop_force, self.player.pause):
            try:
                action()
            except Exception as problem:  # noqa: BLE001 - the gateway's last resort
                self.gateway.note(problem)

    # --- what happens by itself ----------------------------------------------

    def watch(self) -> None:
        """Report what has changed since the last call."""
        self.gateway.poll()
        self.jobs.poll()
        now, phase_before = self.player.snapshot(), self._state[:1]
        self._report_problem(now)
        self._watch_video(now)
        state = (
            now.phase,
            now.is_stopped,
            self._health(),
            now.feedback,
            self.jobs.is_busy,
        )
        if state != self._state:
            self._state = state
            self.changed.emit()
            if now.phase is Phase.ENDED and phase_before != (Phase.ENDED,):
                self._on_ended()

    def _on_ended(self) -> None:
        """Tell; the next time the clip plays to its own end."""
        self.player.set_end(self.player.snapshot().duration_s)
        self.ended.emit()

    def _watch_video(self, now: Snapshot) -> None:
        """Tell once that a clip is not the one that its force was made for."""
        check = now.source.check if now.source else None
        if check is not self._warned_of and check and check.verdict is Verdict.ANOTHER:
            self._warned_of = check
            self.another_video.emit(now.source)

    def _report_problem(self, now: Snapshot) -> None:
        """Report once what the player or the device complains about."""
        text = next(iter(_problems(now)), "")
        if text and text != self.last_problem:
            self.report(
                HapticPlayerError(text),
                lambda: text not in _problems(self.player.snapshot()),
            )
        self.last_problem = text or self.last_problem

    def close(self) -> None:
        """Stop what runs, bring the hand to rest and finish the log."""
        self.jobs.close()
        self.player.close()


def _problems(now: Snapshot) -> list[str]:
    """What is wrong; the health line says why the leading output has stopped."""
    lead = now.leading
    is_said = now.is_stopped or lead.cause is Cause.NOT_HOMED
    faults = (one.fault for one in now.outputs if one is not lead or not is_said)
    problems = (one.problem for one in now.outputs)
    return [*filter(None, (now.problem, *problems, *faults))]
