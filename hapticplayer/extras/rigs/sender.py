"""Sends packets to one receiver by UDP."""

import contextlib
import socket

from hapticplayer.devices.options import host_and_port
from hapticplayer.errors import DeviceError
from hapticplayer.extras.rigs.extension import RIG
from hapticplayer.extras.rigs.settings import RigSettings
from hapticplayer.model.rig import RigMotion


class RigSender:
    """One rig; never waits."""

    name, capabilities = "rig", RIG

    def __init__(self, settings: RigSettings) -> None:
        self.settings = settings
        self._end: socket.socket | None = None

    def open(self) -> None:
        """Find the receiver's address; raises DeviceError with what to do."""
        self.close()
        host, port = host_and_port(self.settings.address)
        try:
            family, kind, _, _, address = socket.getaddrinfo(
                host, port, type=socket.SOCK_DGRAM
            )[0]
            self._end = socket.socket(family, kind)
            self._end.connect(address)
            self._end.setblocking(False)
        except OSError as problem:
            self.close()
            raise self._problem(problem) from problem

    def send(self, motion: RigMotion, time_s: float) -> bool:
        """Send one packet; return False while nobody listens there.

        Raises:
            DeviceError: when the network refuses it; the next one may get through.
        """
        if self._end is None:
            raise DeviceError("the rig is not open; choose the device again")
        packet = self.settings.format.encode(motion, time_s, self.settings)
        try:
            self._end.send(packet)
        except ConnectionRefusedError:  # of the packet before
            with contextlib.suppress(OSError):
                self._end.send(packet)
            return False
        except BlockingIOError:  # the next one is newer
            return True
        except OSError as problem:
            raise self._problem(problem) from problem
        return True

    def close(self) -> None:
        """Let go of the socket; may be called again."""
        if self._end is not None:
            self._end.close()
            self._end = None

    def _problem(self, reason: OSError) -> DeviceError:
        return DeviceError(
            "the rig at {address} cannot be reached ({reason}); check address and "
            "network, and choose the device again",
            address=self.settings.address,
            reason=reason,
        )


def make(_line: int, settings: RigSettings) -> RigSender:
    return RigSender(settings)
