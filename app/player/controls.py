"""Speed, loop, single frames, volume and output: what the keys do with the player."""

from functools import partial

from PySide6.QtCore import QObject, Signal

from app.bridge.jobs import BackgroundLookup, in_child
from app.bridge.settings import Settings
from app.widgets.texts import local, time_text
from hapticplayer.errors import Progress
from hapticplayer.playback.player import FASTEST, SLOWEST, Player
from hapticplayer.playback.sound_device import sound_outputs
from hapticplayer.playback.sound_process import SoundProcess

VOLUME, MUTED, OUTPUT = "volume", "muted", "sound_output"
"""Names in the settings."""

VOLUME_STEP, WHOLE = 5, 100
SPEED_STEP = 1.1  # as in mpv


def kept_volume(settings: Settings) -> float:
    """Return the loudness that was kept, from 0 to 1; 0 while muted."""
    percent = settings.number(VOLUME, WHOLE)
    is_muted = settings.flag(MUTED, default=False)
    return 0.0 if is_muted else min(max(percent, 0.0), WHOLE) / WHOLE


class Controls(QObject):
    """Drives the player for the person at the window, and says what has changed."""

    message = Signal(str)
    changed = Signal()

    def __init__(self, player: Player, settings: Settings) -> None:
        super().__init__()
        self._player = player
        self._settings = settings
        self._loop_from_s: float | None = None
        self.output = settings.text(OUTPUT)
        self.present = BackgroundLookup(_sound_outputs, self)
        self.apply_settings()

    def apply_settings(self) -> None:
        """Do as the settings say."""
        volume = self._settings.number(VOLUME, WHOLE)
        self.volume_percent = round(min(max(volume, 0.0), WHOLE))
        self.is_muted = self._settings.flag(MUTED, default=False)
        if self._settings.text(OUTPUT) != self.output:
            self.choose_output(self._settings.text(OUTPUT))
        self._apply_volume()

    # --- sound ---------------------------------------------------------------

    def set_volume(self, percent: int) -> None:
        """Set the volume; making it louder ends the silence."""
        self.volume_percent = min(max(percent, 0), WHOLE)
        self.is_muted = False
        self._apply_volume()

    def turn(self, steps: int) -> None:
        """Make it louder (+) or quieter (-)."""
        self.set_volume(self.volume_percent + steps * VOLUME_STEP)
        self.message.emit(self.tr("Volume {n} %").format(n=self.volume_percent))

    def begin_muted(self) -> None:
        """Be silent this time; the next start is as the settings say."""
        was_muted = self.is_muted
        self.mute(is_wanted=True)
        self._settings.keep(MUTED, was_muted)

    def mute(self, *, is_wanted: bool) -> None:
        """Silence, or the sound as it was."""
        self.is_muted = is_wanted
        self._apply_volume()
        text = self.tr("Muted") if is_wanted else self.tr("Sound on")
        self.message.emit(text)

    def _apply_volume(self) -> None:
        percent = 0 if self.is_muted else self.volume_percent
        self._player.set_volume(percent / WHOLE)
        self._settings.keep(VOLUME, self.volume_percent)
        self._settings.keep(MUTED, self.is_muted)
        self.changed.emit()

    def outputs(self) -> list[str]:
        """Return the outputs found last, and the chosen one if it is away."""
        names = self.present.found
        is_away = self.output and self.output not in names
        return [*names, self.output] if is_away else names

    def choose_output(self, name: str) -> None:
        """Play through another output; "" for the default one."""
        self.output = name
        self._settings.keep(OUTPUT, name)
        self._player.set_sound_output(partial(SoundProcess, device=name))

    # --- time ----------------------------------------------------------------

    def change_speed(self, steps: int) -> None:
        """Play faster (+) or slower (-), in steps of a tenth; 0 for normal speed."""
        now = self._player.snapshot().speed
        speed = now * SPEED_STEP**steps if steps else 1.0
        self.set_speed(1.0 if abs(speed - 1.0) < 0.01 else speed)

    def set_speed(self, speed: float) -> None:
        """Play at a speed, within what the player can do."""
        self._player.set_speed(min(max(speed, SLOWEST), FASTEST))
        speed = self._player.snapshot().speed
        self.message.emit(local(self.tr("Speed {x:.2f}").format(x=speed)))
        self.changed.emit()

    def loop(self) -> None:
        """Begin a loop here, end it here, or play on: one after the other."""
        player, now = self._player, self._player.snapshot()
        here_s = now.media_s
        if now.loop_s is not None:
            player.set_loop(None)
            self._loop_from_s = None
            self.message.emit(self.tr("Loop off"))
        elif self._loop_from_s is None or here_s <= self._loop_from_s:
            self._loop_from_s = here_s
            text = self.tr("Loop from {a}")
            self.message.emit(text.format(a=time_text(here_s)))
        else:
            player.set_loop((self._loop_from_s, here_s))
            text = self.tr("Loop from {a} to {b}")
            a, b = time_text(self._loop_from_s), time_text(here_s)
            self.message.emit(text.format(a=a, b=b))
        self.changed.emit()

    def forget_loop(self) -> None:
        """Another clip has no loop yet."""
        self._loop_from_s = None
        self.changed.emit()

    @property
    def marks_s(self) -> tuple[float, ...]:
        """Where the loop begins and ends, as far as that is known."""
        loop_s = self._player.snapshot().loop_s
        if loop_s is not None:
            return loop_s
        return () if self._loop_from_s is None else (self._loop_from_s,)

    def step(self, frames: int) -> None:
        """Show the next (+1) or previous (-1) frame, paused."""
        self._player.step(frames)
        self.message.emit(time_text(self._player.snapshot().media_s, digits=3))


def _sound_outputs(progress: Progress) -> list[str]:
    """Return them; PortAudio takes up to half a second, and knows what was then."""
    return in_child(_listed, progress=progress)


def _listed(*, progress: Progress) -> list[str]:
    progress(0.0, "")
    return sound_outputs()
