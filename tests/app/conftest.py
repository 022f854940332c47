"""Fixtures for the front end: a real window, a short clip, and nothing of the user's."""

import gc
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

from app.bridge import languages
from app.bridge.settings import Settings
from app.player.application import make_application
from app.player.remake import apply_appearance
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.widgets import theme
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from tests.material.shaken import write_shaken_sequence

sys.path.insert(0, str(Path(__file__).parent))  # helpers beside these tests
from children import real_children, threads_for_children  # noqa: F401 - fixtures
from private_bus import address, bus, bus_daemon  # noqa: F401 - fixtures
from sitting import make_study, sit  # noqa: F401 - fixtures

RATE_HZ, CLIP_S, WIDTH, HEIGHT = 25, 2, 160, 90
LONG_S = 120
LONG_TITLE = "A ride whose title is as long as titles can be. " * 8
PATIENCE_MS = 60_000  # for a busy machine; nothing waits that long where all is well

MOST_OBJECTS = 30_000

MakeWindow = Callable[..., PlayerWindow]


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol() -> Iterator[bool]:
    """Free closed windows and garbage after each test, in this thread.

    Garbage that is collected in the thread of a job ends objects of Qt where they must
    not be; widgets that are left are styled again by each test of a look.
    """
    gc.disable()
    done = yield
    for widget in QApplication.topLevelWidgets():
        if isinstance(widget, PlayerWindow):
            widget.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    with warnings.catch_warnings():
        # processes that another test let go of would fail the next one, whatever it is
        warnings.simplefilter("ignore", ResourceWarning)
        gc.collect()
    if len(gc.get_objects()) > MOST_OBJECTS:  # modules that were loaded
        gc.freeze()
    gc.enable()
    return done


@pytest.fixture(scope="session")
def clip(tmp_path_factory) -> Path:
    """Two seconds that go from dark to bright, without sound."""
    path = tmp_path_factory.mktemp("clip") / "clip.mp4"
    levels = np.linspace(20, 235, CLIP_S * RATE_HZ).astype(np.uint8)
    pictures = (np.full((HEIGHT, WIDTH, 3), level, np.uint8) for level in levels)
    write_clip(path, pictures, frame_rate_hz=RATE_HZ)
    return path


@pytest.fixture(scope="session")
def sequence(clip, tmp_path_factory) -> Path:
    """The clip with a gentle shake up and down."""
    target = tmp_path_factory.mktemp("sequences") / "shake"
    return write_shaken_sequence(clip, target, title=LONG_TITLE)


@pytest.fixture
def source(sequence):
    return open_source(sequence)


@pytest.fixture(scope="session")
def long_clip(tmp_path_factory) -> Path:
    """Two minutes, which nothing here comes to the end of."""
    path = tmp_path_factory.mktemp("clip") / "long.mp4"
    pictures = (np.full((36, 64, 3), 90, np.uint8) for _ in range(10 * LONG_S))
    write_clip(path, pictures, frame_rate_hz=10, is_quick=True)
    return path


@pytest.fixture
def long_source(long_clip) -> Source:
    """The long clip with a small force: a device is ready before it ends."""
    push_n = {"realistic": 0.2, "none": 0.0}
    tracks = {
        name: ForceTrack([0.0, LONG_S], [[0.0, up_n, 0.0]] * 2)
        for name, up_n in push_n.items()
    }
    return Source("long", long_clip, probe(long_clip), tracks, None, "realistic")


@pytest.fixture(scope="session")
def cache(tmp_path_factory) -> Path:
    """Holds what the program makes once: the clip of the demonstration takes 3 s."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def _own_places(tmp_path, cache, monkeypatch) -> None:
    """Keep settings, caches and data away from the user's."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(cache))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))


@pytest.fixture
def application(qapp) -> QApplication:
    """The application as the program sets it up."""
    return make_application()


@pytest.fixture
def settings(tmp_path) -> Settings:
    return Settings(tmp_path / "window.json")


@pytest.fixture
def dressed(application, settings):
    """Set look and language; English and dark again afterwards."""

    def set_to(**values) -> None:
        for name, value in values.items():
            settings.keep(name, value)
        apply_appearance(application, settings)

    yield set_to
    set_to(language=languages.ENGLISH, look=theme.DARK)


@pytest.fixture
def spoken(application) -> Iterator[Callable[[str], None]]:
    """Set the language; English again afterwards."""
    yield lambda code: languages.install(application, code)
    languages.install(application, languages.ENGLISH)


@pytest.fixture
def make_window(application, qtbot, settings) -> Iterator[MakeWindow]:
    """Make a shown window with a player of its own; closed after the test."""
    made = []

    def make(*outputs: str, **more) -> PlayerWindow:
        surface = VideoSurface()
        clock = SystemClock()
        player = Player(
            clock, SurfaceSink(surface), outputs=outputs, audio=None, **more
        )
        window = PlayerWindow(player, surface, clock, settings)
        made.append(window)
        window.show()
        qtbot.waitExposed(window)
        return window

    before = set(threading.enumerate())
    yield make
    for window in filter(isValid, made):  # another look's window may be in its place
        window.close()
        window.deleteLater()
    for thread in threading.enumerate():
        if thread.name in {
            "dialogs",
            "plots",
        }:  # loads modules for the process, not for a window
            thread.join(PATIENCE_MS / 1000.0)
    left = [t.name for t in threading.enumerate() if t not in before and t.is_alive()]
    assert not left, f"threads were left behind: {left}"


@pytest.fixture
def window(make_window) -> PlayerWindow:
    return make_window()


@pytest.fixture
def wait_for(qtbot) -> Callable[[Callable[[], bool]], None]:
    """Let the event loop run until something is true."""
    return lambda condition: qtbot.waitUntil(condition, timeout=PATIENCE_MS)


@pytest.fixture
def feel(wait_for) -> Callable[..., None]:
    """Let a window's clip play until its force is there, also on a busy machine."""

    def until_felt(window: PlayerWindow, look: Callable[[], None] | None = None):
        player = window.player

        def is_felt() -> bool:
            if look is not None:
                look()
            if window.session.is_stopped:  # a busy machine has tripped it
                window.session.rearm()
            if not player.snapshot().is_playing:
                player.play()
            return player.snapshot().leading.mode is Mode.FOLLOWING

        wait_for(is_felt)

    return until_felt


@pytest.fixture
def playing(window, source, wait_for) -> PlayerWindow:
    """A window in which the clip plays, without a device."""
    window.session.show_source(source)
    window.player.play()
    wait_for(lambda: window.player.snapshot().media_s > 0.1)
    return window
