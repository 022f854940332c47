"""The force under the effects as they are now, rendered beside the window."""

from PySide6.QtCore import QObject, Signal

from app.bridge.jobs import Job
from hapticplayer.errors import Progress
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.effects import NO_EFFECTS, EffectList
from hapticplayer.sequence.presets import Rendering


class LiveForce(QObject):
    """Renders in a thread, one list after the other; of several that wait the last counts.

    The first is the force without effects, for which all is computed; after it only what
    an edit changes is (75 s of clip: below 100 ms).
    """

    made = Signal(object, object)
    """A list of effects, and its force track."""

    failed = Signal(object)

    def __init__(self, rendering: Rendering, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._rendering = rendering
        self.plain: ForceTrack | None = None  # without effects
        self._wanted: EffectList | None = NO_EFFECTS
        self._made = self._doing = NO_EFFECTS
        self._job: Job[ForceTrack] | None = None

    @property
    def is_busy(self) -> bool:
        """Whether something is being rendered, or about to be."""
        return self._job is not None or self._wanted is not None

    def want(self, effects: EffectList) -> None:
        """Render these as soon as possible."""
        latest = self._made if self._job is None else self._doing
        is_alike = effects.effects == latest.effects  # markers are not felt
        if self._wanted is None and is_alike and self.plain is not None:
            return
        self._wanted = effects

    def poll(self) -> None:
        """Hand over what is rendered, and begin with what is wanted."""
        job = self._job
        if job is not None and job.is_done:
            self._job = None
            self._take(job)
        if self._job is None and self._wanted is not None:
            # the force without effects comes first
            first = NO_EFFECTS if self.plain is None else self._wanted
            self._wanted = None if first == self._wanted else self._wanted
            self._begin(first)

    def close(self) -> None:
        """Wait for what is being rendered."""
        self._wanted = None
        if self._job is not None:
            self._job.join()
            self._job = None

    def _begin(self, effects: EffectList) -> None:
        def work(_progress: Progress) -> ForceTrack:
            return self._rendering.track(effects)

        self._doing = effects
        self._job = Job("", work)
        self._job.start()

    def _take(self, job: Job[ForceTrack]) -> None:
        if job.problem is not None:
            self._wanted = None
            self.failed.emit(job.problem)
            return
        assert job.result is not None  # as it has no problem
        if self.plain is None:
            self.plain = job.result
        self._made = self._doing
        self.made.emit(self._made, job.result)
