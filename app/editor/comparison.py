"""What the effects change in a few numbers: RMS, peak, reach, time at the limit."""

from PySide6.QtCore import QCoreApplication

from app.bridge.jobs import Job, in_child
from app.widgets import theme
from app.widgets.layout import ElidedLabel
from app.widgets.texts import local
from hapticplayer.errors import Progress
from hapticplayer.model import ForceTrack
from hapticplayer.sequence.events import figures_of
from hapticplayer.sequence.figures import ForceFigures

translate = QCoreApplication.translate

SETTLE_POLLS = 15
_HAND = "relaxed"  # moves furthest


class Comparison(ElidedLabel):
    """A line that says what the force is like without and with the effects.

    The excursion of a hand takes a moment: it is predicted in a process of its own once
    no edit has come for a while.
    """

    def __init__(self) -> None:
        super().__init__(colour=theme.DIM)
        self.before: ForceFigures | None = None
        self.after: ForceFigures | None = None
        self._tracks: list[ForceTrack] = []
        self._clip = (0.0, 0.0)  # duration, force limit
        self._wait = 0
        self._job: Job[list[ForceFigures]] | None = None

    def set_clip(self, duration_s: float, force_limit_n: float) -> None:
        """Say what the tracks belong to."""
        self._clip = duration_s, force_limit_n

    def compare(self, before: ForceTrack, after: ForceTrack) -> None:
        self._tracks = [after] if self.before else [before, after]
        self._wait = SETTLE_POLLS

    def poll(self) -> None:
        """Begin, and show what is found."""
        job = self._job
        if job is not None and job.is_done:
            self._job = None
            if job.result is not None:
                self.before = self.before or job.result[0]
                self.after = job.result[-1]
                self.show_figures(self.before, self.after)
        self._wait = max(0, self._wait - 1)
        if self._wait == 0 and self._job is None and self._tracks:
            tracks, clip, self._tracks = self._tracks, self._clip, []

            def work(progress: Progress) -> list[ForceFigures]:
                return in_child(figures_of, tracks, *clip, progress=progress)

            self._job = Job("", work)
            self._job.start()

    def close_jobs(self) -> None:
        """End what is being predicted."""
        self._tracks = []
        if self._job is not None:
            self._job.cancel()
            self._job.join()
            self._job = None

    def show_figures(self, before: ForceFigures, after: ForceFigures) -> None:
        """Show both."""
        text = translate(
            "Comparison",
            "Without \u2192 with effects: RMS {rms}, peak {peak}, at the limit {limit}, "
            "reach of a relaxed hand {reach}",
        ).format(
            rms=_both(before.rms_n, after.rms_n, "{:.2f}", "N"),
            peak=_both(before.peak_n, after.peak_n, "{:.2f}", "N"),
            limit=_both(
                100.0 * before.saturated_share,
                100.0 * after.saturated_share,
                "{:.1f}",
                "%",
            ),
            reach=_both(
                100.0 * before.reaches[_HAND],
                100.0 * after.reaches[_HAND],
                "{:.0f}",
                "%",
            ),
        )
        colour = theme.DIM
        if after.trips:
            text += " \u2013 " + translate("Comparison", "the force would be stopped")
            colour = theme.BAD
        self.set_text(text, colour)
        self.setAccessibleName(text)
        self.setToolTip(text)


def _both(before: float, after: float, form: str, unit: str) -> str:
    return local(f"{form.format(before)} \u2192 {form.format(after)} {unit}")
