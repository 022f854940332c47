"""The Inverse3's own driver, connected to the simulated service at the end of a line."""

import os
import select

from hapticplayer.devices.websocket import Connection
from hapticplayer.errors import DeviceError
from hapticplayer.extras.inverse3.driver import (
    TITLE,
    Inverse3Driver,
    ServiceConnection,
)
from hapticplayer.simulation.falcon.packets import Control, ScriptedEvent, pack_control

PATIENCE_S = 10.0
_MOST_BYTES = 64


def make(descriptor: int) -> Inverse3Driver:
    """Return the driver; the descriptor belongs to it from now on."""
    return Inverse3Driver(_Connecting(descriptor))


class _Connecting:
    """Asks the process at the end of the line for its port, and connects to it."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        os.set_blocking(descriptor, False)

    def __call__(self) -> ServiceConnection:
        try:
            os.write(self._descriptor, pack_control(Control(ScriptedEvent.HELLO)))
            while select.select([self._descriptor], [], [], PATIENCE_S)[0]:
                answer = os.read(self._descriptor, _MOST_BYTES)
                if answer.isdigit():
                    return Connection(f"ws://127.0.0.1:{int(answer)}", TITLE)
                if not answer:
                    break
        except OSError as problem:
            raise _ended() from problem
        raise _ended()


def _ended() -> DeviceError:
    return DeviceError(
        "the simulated service has ended; choose the device again to start a new one"
    )
