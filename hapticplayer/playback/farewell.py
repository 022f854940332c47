"""Letting go of a device beside whoever asked for it: it takes 0.1 to 0.2 s."""

import threading

from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.playback.haptic_link import HapticLink


class Farewells:
    """Ends links in threads of their own; the hand comes to rest meanwhile."""

    def __init__(self) -> None:
        self._leaving: list[tuple[HapticLink, threading.Thread]] = []

    def begin(self, link: HapticLink) -> None:
        """End a link; returns at once."""
        if link.device == NO_DEVICE:
            link.close()
            return
        thread = threading.Thread(target=link.close, name="farewell")
        self._leaving = [row for row in self._leaving if row[1].is_alive()]
        self._leaving.append((link, thread))
        thread.start()

    def wait(self, *, hardware_only: bool = False) -> None:
        """Return when all have ended, or all that hold something to plug in."""
        for link, thread in self._leaving:
            if not hardware_only or is_hardware(link.device):
                thread.join()


def is_hardware(device: str) -> bool:
    """Whether only one process can have the device at a time."""
    return device != NO_DEVICE and not find_device(device).server
