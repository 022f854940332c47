"""The dialogs about devices; each may have the device while it is open."""

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, TypeAlias

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.bridge.settings import Settings, enter_latency, keep_outputs
from app.player.choices import PluggedFalcons
from app.player.controls import OUTPUT
from app.player.session import Session
from app.player.video_surface import SurfaceSink
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_process import SoundProcess

if TYPE_CHECKING:
    from app.editor.page import EditorPage
    from app.experimenter.import_queue import QueuePage
    from app.experimenter.import_wizard import ImportWizard
    from app.experimenter.library_page import LibraryPage
    from app.experimenter.record_page import RecordPage
    from app.experimenter.rendering_page import RenderingPage
    from app.player.outputs_page import OutputsPage
    from app.player.setup_page import SetupPage
    from app.player.share_page import SharePage

    Working: TypeAlias = (
        EditorPage
        | ImportWizard
        | LibraryPage
        | QueuePage
        | OutputsPage
        | RecordPage
        | RenderingPage
        | SetupPage
        | SharePage
    )


class DeviceDialogs(QObject):
    """Sets devices up, tries them out, and chooses several."""

    settings_taken = Signal()

    def __init__(self, window: QWidget, session: Session, settings: Settings) -> None:
        super().__init__(window)
        self._working: list[Working] = []
        self._window = window
        self._session = session
        self._settings = settings
        self.plugged = PluggedFalcons(parent=self)

    def set_up(self, clock: Clock, output: str = "") -> None:
        """Choose a device in the place of an output, and bring it to where it can be used.

        Of the leading one where none is named.
        """
        from app.player.setup_page import SetupPage

        names = self._session.player.output_names
        place = names.index(output) if output in names else 0
        before = names[place] if names else NO_DEVICE
        self._lend()
        player = self._session.player
        page = SetupPage(
            *(clock, before, self.plugged, self._settings, self._window),
            is_free=lambda: player.are_outputs_free,
            with_gain=self._with_gain,
            latch=player.latch,
        )
        wanted, shown, others = list[str](), list[str](), list[bool]()
        page.wanted.connect(wanted.append)
        page.demonstration_wanted.connect(shown.append)
        page.latency_changed.connect(self.settings_taken)
        page.others_wanted.connect(lambda: others.append(True))

        def resume(_result: int) -> None:
            if page in self._working:
                self._working.remove(page)
            for chosen in wanted + shown:
                rest = [name for name in names if name not in (before, chosen)]
                self.choose([*rest[:place], chosen, *rest[place:]])
            if shown:
                self.get_to_know(clock, shown[0])
            elif others or output:
                self.outputs(clock)
            self._take_back()

        page.finished.connect(resume)
        self._working.append(page)
        page.open()

    def choose(self, names: Sequence[str]) -> None:
        """Play on these from now on, and remember them."""
        self._session.choose_outputs(names)
        keep_outputs(self._settings, self._session.player.snapshot().outputs)

    def get_to_know(self, clock: Clock, device: str = "") -> None:
        """Demonstrate the forces of a device, the leading one where none is named."""
        device = device or self._session.player.snapshot().leading.name
        if device == NO_DEVICE:
            problem = self.tr("Choose a device first, then try out its forces")
            self._session.report_outputs(HapticPlayerError(problem))
            return
        from app.player.device_page import DevicePage

        self._lend()
        latch = self._session.player.latch
        dialog = DevicePage(clock, self._with_gain(device), self._window, latch)
        dialog.finished.connect(lambda _: self._take_back())
        dialog.homing_wanted.connect(lambda: self.set_up(clock))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def outputs(self, clock: Clock) -> None:
        """Show all that plays."""
        from app.player.outputs_page import OutputsPage

        session, page = self._session, self._window.findChild(OutputsPage)
        if page is None:
            page = OutputsPage(clock, session, self._window)
            page.changed.connect(
                lambda: keep_outputs(self._settings, session.player.snapshot().outputs)
            )
            page.latency_entered.connect(self._enter_latency)
            page.set_up_wanted.connect(lambda name: self.set_up(clock, name))
            self._working.append(page)
            page.finished.connect(lambda _result: self._forget(page))
        page.show()

    def _enter_latency(self, name: str, latency_ms: float) -> None:
        enter_latency(self._settings, name, latency_ms)
        self._settings.save()
        self.settings_taken.emit()

    def latencies(self, clock: Clock) -> None:
        """Measure how late video, sound and force reach the person."""
        from app.player.latency_page import LatencyPage

        device = self._session.player.snapshot().leading.name
        self._lend()
        latch = self._session.player.latch
        page = LatencyPage(
            *(clock, device, self._settings, self.own_player), latch, self._window
        )
        page.measured.connect(self.settings_taken)
        page.finished.connect(lambda _: self._take_back())
        page.finished.connect(page.deleteLater)
        page.open()

    def own_player(self, clock: Clock, sink: SurfaceSink, device: str) -> Player:
        sound = partial(SoundProcess, device=self._settings.text(OUTPUT))
        latch = self._session.player.latch
        outputs = [self._with_gain(device)]
        return Player(clock, sink, outputs=outputs, audio=sound, latch=latch)

    def _with_gain(self, device: str) -> str:
        """A device as it plays here, for another that opens it."""
        now = self._session.player.snapshot()
        return next((one.device for one in now.outputs if one.name == device), device)

    def _lend(self) -> None:
        """Pause, and let go of all devices, so that a dialog can have them."""
        player = self._session.player
        player.pause()
        player.lend_outputs()
        player.wait_released()

    def _take_back(self) -> None:
        """Play on what is chosen again."""
        try:
            self._session.player.take_back_outputs()
        except HapticPlayerError as problem:
            self._session.report_outputs(problem)
        self._session.changed.emit()

    def _open_working(self, dialog: "Working") -> None:
        self._working.append(dialog)
        dialog.finished.connect(lambda _result: self._forget(dialog))
        dialog.open()

    def _forget(self, dialog: "Working") -> None:
        if dialog in self._working:
            self._working.remove(dialog)
        dialog.deleteLater()
