"""Idle inhibition and MPRIS against services on a private bus."""

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import ClassInfo, QObject, QProcess, Slot
from PySide6.QtDBus import QDBusConnection

from app.bridge import idle
from app.bridge.desktop import NAME, PATH, PLAYER, Mpris
from app.bridge.idle import IdleInhibitor
from hapticplayer.playback.phases import Phase

PROPERTIES = "org.freedesktop.DBus.Properties"
INTROSPECT = "org.freedesktop.DBus.Introspectable.Introspect"
SERVICE, PLACE = "org.freedesktop.ScreenSaver", "/org/freedesktop/ScreenSaver"


@ClassInfo({"D-Bus Interface": SERVICE})
class FakeScreenSaver(QObject):
    """Notes who inhibits it; who has left the bus holds nothing, as with real ones."""

    def __init__(self, bus) -> None:
        super().__init__()
        self._bus, self.reasons = bus, []

    @Slot(str, str, result="uint")
    def Inhibit(self, application: str, reason: str) -> int:  # noqa: N802
        self.reasons.append((application, reason))
        return 7

    @property
    def holders(self) -> set[str]:
        """Whoever else is on this private bus."""
        names = self._bus.interface().registeredServiceNames().value()
        others = {name for name in names if name.startswith(":")}
        return others - {self._bus.baseService()} if self.reasons else set()


@pytest.fixture
def saver(bus):
    made = FakeScreenSaver(bus)
    everything = QDBusConnection.RegisterOption.ExportAllSlots
    assert bus.registerObject(PLACE, made, everything)
    assert bus.registerService(SERVICE)
    return made


def test_the_screen_is_held_awake_as_long_as_it_is_wanted(saver, address, wait_for):
    inhibitor = IdleInhibitor(address)
    inhibitor.set_wanted("playing a clip")
    inhibitor.set_wanted("playing a clip")
    wait_for(lambda: bool(saver.reasons))
    assert saver.reasons == [("hapticplayer", "playing a clip")]
    assert len(saver.holders) == 1
    inhibitor.set_wanted("")
    wait_for(lambda: not saver.holders)


def test_the_window_holds_the_screen_while_it_plays(
    saver, address, make_window, source, wait_for
):
    window = make_window()
    window.desktop.idle = IdleInhibitor(address)
    window.session.show_source(source)
    wait_for(lambda: window.player.snapshot().phase is Phase.PAUSED)
    assert not saver.holders
    window.player.play()
    wait_for(lambda: bool(saver.holders))
    window.player.pause()
    wait_for(lambda: not saver.holders)
    window.player.play()
    wait_for(lambda: bool(saver.holders))
    window.close()
    wait_for(lambda: not saver.holders)


def test_without_a_bus_nothing_happens(qapp):
    inhibitor = IdleInhibitor("unix:path=/nowhere/at/all")
    inhibitor.set_wanted("playing a clip")
    inhibitor.release()


@pytest.fixture
def mpris(address, playing):
    made = Mpris(playing.player, playing.raise_, playing.close, address)
    made.switch(is_on=True)
    assert made.is_on
    yield made
    made.switch(is_on=False)


@pytest.fixture
def ask(address, wait_for):
    """Call a method as another program would, and return what it prints."""
    if shutil.which("dbus-send") is None:
        pytest.skip("dbus-send is not on this machine")

    def call(method, *arguments) -> str:
        process = QProcess()
        process.start(
            "dbus-send",
            [
                f"--bus={address}",
                "--print-reply",
                f"--dest={NAME}",
                PATH,
                method,
                *arguments,
            ],
        )
        wait_for(lambda: process.state() is QProcess.ProcessState.NotRunning)
        said = bytes(process.readAllStandardError().data()).decode()
        assert process.exitCode() == 0, said
        return bytes(process.readAllStandardOutput().data()).decode()

    return call


def test_media_keys_play_and_pause_over_mpris(mpris, playing, ask, wait_for):
    get = ("org.freedesktop.DBus.Properties.Get", f"string:{PLAYER}")
    assert "Playing" in ask(*get, "string:PlaybackStatus")
    ask(f"{PLAYER}.Pause")
    assert playing.player.snapshot().phase is Phase.PAUSED
    assert "Paused" in ask(*get, "string:PlaybackStatus")
    ask(f"{PLAYER}.PlayPause")
    wait_for(lambda: playing.player.snapshot().is_playing)
    ask(f"{PLAYER}.Stop")
    assert playing.player.snapshot().phase is Phase.PAUSED


def test_other_programs_see_what_plays_and_can_seek(mpris, playing, ask):
    playing.player.pause()
    everything = ask("org.freedesktop.DBus.Properties.GetAll", f"string:{PLAYER}")
    assert "A ride whose title" in everything
    assert "int64 2000000\n" in everything  # its length, microseconds
    assert 'object path "/org/hapticplayer/clip"' in everything
    playing.player.seek(0.5)
    ask(f"{PLAYER}.Seek", "int64:250000")
    assert playing.player.snapshot().media_s == pytest.approx(0.75)
    ask(f"{PLAYER}.SetPosition", "objpath:/org/hapticplayer/clip", "int64:1000000")
    assert playing.player.snapshot().media_s == pytest.approx(1.0)
    ask(f"{PLAYER}.SetPosition", "objpath:/org/hapticplayer/clip", "int64:99000000")
    assert playing.player.snapshot().media_s == pytest.approx(1.0)  # beyond: ignored


def test_every_property_of_both_interfaces_can_be_read(mpris, ask):
    get = "org.freedesktop.DBus.Properties.GetAll"
    root = ask(get, "string:org.mpris.MediaPlayer2")
    for name in ("CanQuit", "CanRaise", "HasTrackList", "Identity", "DesktopEntry"):
        assert f'"{name}"' in root
    player = ask(get, f"string:{PLAYER}")
    for name in ("Rate", "MinimumRate", "MaximumRate", "CanControl", "Metadata"):
        assert f'"{name}"' in player


def test_the_player_vanishes_from_the_bus_for_a_study(mpris, bus, wait_for):
    assert bus.interface().isServiceRegistered(NAME).value()
    mpris.switch(is_on=False)
    wait_for(lambda: not bus.interface().isServiceRegistered(NAME).value())


def test_without_a_session_bus_none_is_started(playing, monkeypatch, tmp_path):
    monkeypatch.delenv("DBUS_SESSION_BUS_ADDRESS", raising=False)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setattr(idle, "open_dbus_connection", None)  # nobody connects
    IdleInhibitor().set_wanted("playing a clip")
    made = Mpris(playing.player, playing.raise_, playing.close)
    made.switch(is_on=True)
    made.publish()
    assert not made.is_on


def test_the_session_bus_is_found_by_its_socket(monkeypatch, address, saver, wait_for):
    monkeypatch.delenv("DBUS_SESSION_BUS_ADDRESS", raising=False)
    socket = address.partition("path=")[2].partition(",")[0]
    folder = Path(socket).parent
    (folder / "bus").symlink_to(socket)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(folder))
    inhibitor = IdleInhibitor()
    inhibitor.set_wanted("playing a clip")
    wait_for(lambda: bool(saver.holders))
    inhibitor.release()


def test_a_bus_that_ends_is_left(mpris, bus_daemon, wait_for):
    bus_daemon.kill()
    wait_for(lambda: not mpris.is_on)
    mpris.publish()


def test_calls_that_are_wrong_get_an_error(mpris, ask):
    for method, arguments, error in (
        (f"{PLAYER}.Fly", (), "UnknownMethod"),
        (f"{PLAYER}.Seek", ("string:far",), "InvalidArgs"),
        (f"{PROPERTIES}.Get", (f"string:{PLAYER}", "string:Weight"), "UnknownProperty"),
    ):
        with pytest.raises(AssertionError, match=error):
            ask(method, *arguments)
    assert '<arg type="x" direction="in" />' in ask(INTROSPECT)
