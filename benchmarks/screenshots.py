"""A picture of every page in every language, in every look, without a screen.

    python -m benchmarks.screenshots -o FOLDER [--languages en de] [--looks dark light]
        [--scale 2]

The clip stands at one moment and nothing moves, so that two runs are alike.
"""

import argparse
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from app.bridge import languages
from app.bridge.settings import Settings
from app.experimenter.import_wizard import ImportWizard
from app.experimenter.library_page import LibraryPage
from app.player.application import make_application
from app.player.fault_panel import FaultPanel
from app.player.help import about_dialog
from app.player.keys_dialog import KeysDialog
from app.player.look_menus import LANGUAGE, LOOK
from app.player.plugged import Plugged
from app.player.remake import dress
from app.player.setup_page import SetupPage
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.widgets import theme
from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.firmware import find_image
from hapticplayer.devices.falcon.homing import Advice, Guidance
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.setting_up import Progress, Step
from hapticplayer.devices.falcon.transport import FalconGoneError, Transport
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.sequence.demo import demo_folder

WIDTH_PX, HEIGHT_PX = 1280, 800
AT_S = 4.0  # of the demo: both plots have something to show
SETTLE_MS = 900  # decoding one picture, starting the simulated device, plots


def main() -> int:
    """Make the pictures that are asked for, and print their names."""
    options = _options()
    options.output.mkdir(parents=True, exist_ok=True)
    os.environ["QT_SCALE_FACTOR"] = str(options.scale)
    application = make_application()
    source = open_source(demo_folder(progress=lambda _share, _step: None))
    for language in options.languages:
        for look in options.looks:
            settings = Settings(None)
            settings.keep(LANGUAGE, language)
            settings.keep(LOOK, look)
            dress(application, settings)
            for name, widget in _pages(application, settings, source):
                path = options.output / f"{name}-{language}-{look}.png"
                widget.grab().save(str(path))
                print(path)
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, required=True)
    spoken, looks = list(languages.NAMES), list(theme.LOOKS)
    parser.add_argument("--languages", nargs="+", choices=spoken, default=spoken)
    parser.add_argument("--looks", nargs="+", choices=looks, default=looks)
    parser.add_argument("--scale", type=float, default=1.0, help="1 to 3")
    return parser.parse_args()


def _pages(
    application: QApplication, settings: Settings, source: Source
) -> Iterator[tuple[str, QWidget]]:
    """Yield (name, widget) of each page; each is closed before the next."""
    surface = VideoSurface()
    player = Player(SystemClock(), SurfaceSink(surface), device="simulated", audio=None)
    window = PlayerWindow(player, surface, SystemClock(), settings)
    window.resize(WIDTH_PX, HEIGHT_PX)
    window.show()
    _wait(application)
    yield "welcome", window
    window.session.show_source(source)
    player.seek(AT_S)
    _wait(application)
    yield "player", window
    window.extras.statistics.setVisible(True)
    window.show_message(str(FileNotFoundError(2, "No such file", "ride.mp4")))
    _wait(application)
    yield "statistics-and-message", window
    window.extras.statistics.hide()
    window.messages.hide()
    for name, make in _dialogs(window, settings):
        dialog = make()
        dialog.show()
        _wait(application, 50)
        yield name, dialog
        dialog.close()
    for name in ("file", "playback", "view", "help"):
        menu = window.commands.menus[name]
        menu.popup(window.pos())
        _wait(application, 50)
        yield f"menu-{name}", menu
        menu.close()
    window.close()


def _dialogs(
    window: PlayerWindow, settings: Settings
) -> list[tuple[str, Callable[[], QWidget]]]:
    return [
        ("import", lambda: ImportWizard("", Path(), window)),
        ("library", lambda: LibraryPage(demo_folder().parent, window)),
        ("keyboard", lambda: KeysDialog(settings, window)),
        ("about", lambda: about_dialog(window)),
        ("set-up", lambda: _homing(window)),
        ("faults", lambda: FaultPanel(SystemClock(), window.session, window)),
    ]


def _homing(window: PlayerWindow) -> SetupPage:
    """Return the page of the device while a grip is being pushed in."""
    plugged = Plugged(lambda: ["12PZ657E"], window)
    page = SetupPage(SystemClock(), "falcon", plugged, window, _nowhere)
    guidance = Guidance(Advice.PUSH, (True, False, False), 500.0, (600, 500, 400))
    page.freeze(Progress(Step.HOMING, 1.0, guidance))
    return page


def _nowhere(_name: str) -> Reach:
    def refuse() -> Transport:
        raise FalconGoneError("nothing is plugged in")

    return Reach(refuse, find_image)


def _wait(application: QApplication, for_ms: int = SETTLE_MS) -> None:
    loop = QEventLoop()
    QTimer.singleShot(for_ms, loop.quit)
    loop.exec()
    application.processEvents()


if __name__ == "__main__":
    sys.exit(main())
