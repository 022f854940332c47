"""The dialogs about devices; each may have the device while it is open."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.bridge.settings import Settings, keep_outlets
from app.player.choices import PluggedFalcons
from app.player.controls import OUTPUT
from app.player.session import Session
from app.player.video_surface import SurfaceSink
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, takes_motion
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_process import SoundProcess

if TYPE_CHECKING:
    from app.editor.page import EditorPage
    from app.experimenter.import_wizard import ImportWizard
    from app.experimenter.library_page import LibraryPage
    from app.experimenter.rendering_page import RenderingPage
    from app.player.outlets_page import OutletsPage
    from app.player.setup_page import SetupPage
    from app.player.share_page import SharePage

    Working = (
        EditorPage
        | ImportWizard
        | LibraryPage
        | OutletsPage
        | RenderingPage
        | SetupPage
        | SharePage
    )


class DeviceDialogs(QObject):
    """Sets devices up, tries them out, and chooses several.

    `device_wanted` names a device that was set up and is to be used.
    """

    settings_taken = Signal()
    device_wanted = Signal(str)

    def __init__(self, window: QWidget, session: Session, settings: Settings) -> None:
        super().__init__(window)
        self._working: list[Working] = []
        self._window = window
        self._session = session
        self._settings = settings
        self.plugged = PluggedFalcons(parent=self)

    def set_up(self, clock: Clock, outlet: str = "") -> None:
        """Choose a device, and bring it to where it can be used.

        Of an outlet its own page is shown, and another choice takes its place.
        """
        from app.player.setup_page import SetupPage

        before = self._session.player.snapshot().device
        self._release()
        self._lend()
        page = SetupPage(
            *(clock, outlet or before, self.plugged, self._settings, self._window),
            is_free=self._are_lent_free,
            latch=self._session.player.latch,
        )
        wanted, shown, others = list[str](), list[str](), list[bool]()
        page.wanted.connect(wanted.append)
        page.demonstration_wanted.connect(shown.append)
        page.latency_changed.connect(self.settings_taken)
        page.others_wanted.connect(lambda: others.append(True))

        def go_on(_result: int) -> None:
            if page in self._working:
                self._working.remove(page)
            chosen = next(iter(wanted + shown), "")
            is_beside = bool(outlet) or takes_motion(chosen)
            if chosen and is_beside:
                self._use_beside(chosen, outlet)
            if not shown:
                self._take_back()
            self.device_wanted.emit(before if is_beside else chosen or before)
            if shown:
                self.get_to_know(clock, chosen)
            elif others or is_beside:
                self.outlets(clock)

        page.finished.connect(go_on)
        self._working.append(page)
        page.open()

    def _use_beside(self, name: str, before: str) -> None:
        """Play on an outlet as well, in the place of one from before, if any."""
        player = self._session.player
        muted = {one.name: one.is_muted for one in player.snapshot().outlets}
        names = [one for one in muted if one not in (before, name)]
        try:
            player.set_outlets([*names, name])
        except HapticPlayerError as problem:
            self._session.gateway.report(problem)
        else:
            kept = {one: muted[one] for one in names}
            keep_outlets(self._settings, {**kept, name: muted.get(name, False)})

    def get_to_know(self, clock: Clock, device: str = "") -> None:
        """Demonstrate the forces of the chosen device; nothing plays meanwhile."""
        before = self._session.player.snapshot().device
        device = device or before
        if device == NO_DEVICE:
            problem = self.tr("Choose a device first, then try out its forces")
            self._session.gateway.report(HapticPlayerError(problem))
            return
        from app.player.device_page import DevicePage

        self._release()
        self._lend()
        latch = self._session.player.latch
        dialog = DevicePage(clock, device, self._window, latch)
        dialog.finished.connect(lambda _: self._take_back())
        dialog.finished.connect(lambda _: self._session.choose_device(before))
        dialog.homing_wanted.connect(lambda: self.set_up(clock))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def outlets(self, clock: Clock) -> None:
        """Show what plays beside the device."""
        from app.player.outlets_page import OutletsPage

        session, page = self._session, self._window.findChild(OutletsPage)
        if page is None:
            page = OutletsPage(clock, session, self._window)
            page.changed.connect(lambda kept: keep_outlets(self._settings, kept))
            page.set_up_wanted.connect(lambda name: self.set_up(clock, name))
            self._working.append(page)
            page.finished.connect(lambda _result: self._forget(page))
        page.show()

    def faults(self, clock: Clock) -> None:
        """Show the panel that makes faults happen to the simulated device."""
        from app.player.fault_panel import FaultPanel

        shown = self._window.findChild(FaultPanel)
        panel = shown or FaultPanel(clock, self._session, self._window)
        panel.show()

    def latencies(self, clock: Clock) -> None:
        """Measure how late video, sound and force reach the person."""
        from app.player.latency_page import LatencyPage

        device = self._session.player.snapshot().device
        self._release()
        latch = self._session.player.latch
        page = LatencyPage(
            *(clock, device, self._settings, self._own_player), latch, self._window
        )
        page.measured.connect(self.settings_taken)
        page.finished.connect(lambda _: self._session.choose_device(device))
        page.finished.connect(page.deleteLater)
        page.open()

    def _own_player(self, clock: Clock, sink: SurfaceSink, device: str) -> Player:
        sound = partial(SoundProcess, device=self._settings.text(OUTPUT))
        latch = self._session.player.latch
        return Player(clock, sink, device=device, audio=sound, latch=latch)

    def _release(self) -> None:
        """Let go of the device, so that a dialog can have it."""
        self._session.player.pause()
        self._session.choose_device(NO_DEVICE)
        self._session.player.wait_released()

    def _lend(self) -> None:
        """Let go of what plays beside the device, too."""
        for one in self._session.player.snapshot().outlets:
            self._session.player.lend_outlet(one.name)

    def _are_lent_free(self) -> bool:
        player = self._session.player
        return all(player.is_outlet_free(one.name) for one in player.snapshot().outlets)

    def _take_back(self) -> None:
        """Play on it again."""
        player = self._session.player
        for one in player.snapshot().outlets:
            try:
                player.take_back_outlet(one.name)
            except HapticPlayerError as problem:
                self._session.gateway.report(problem)

    def _open_working(self, dialog: "Working") -> None:
        self._working.append(dialog)
        dialog.finished.connect(lambda _result: self._forget(dialog))
        dialog.open()

    def _forget(self, dialog: "Working") -> None:
        if dialog in self._working:
            self._working.remove(dialog)
        dialog.deleteLater()
