"""Entry: `python -m hapticplayer.extras.inverse3.simulated`, the service as a process."""

import gc
import os
import select
import socket
import sys
import threading

from websockets.exceptions import ConnectionClosed
from websockets.sync.server import Server, ServerConnection, serve

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.dynamics import HANDS
from hapticplayer.extras.inverse3.simulated.service import Service, simulation_of
from hapticplayer.haptics.lifeline import outlive_the_player
from hapticplayer.simulation.falcon.packets import (
    MAX_BYTES,
    Control,
    ForceCommand,
    ScriptedEvent,
    unpack,
)
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.process import PlantRecorder, device_parser

_LONGEST_S = 0.005


class Process:
    """The service behind a WebSocket, and the line to those that started it."""

    def __init__(
        self,
        service: Service,
        ends: list[socket.socket],
        recorder: PlantRecorder | None,
    ) -> None:
        self._service, self._ends, self._recorder = service, ends, recorder
        self._clock: Clock = SystemClock()
        self._lock = threading.Lock()
        self._deaf_until_s = 0.0
        self._server: Server = serve(
            self._talk, "127.0.0.1", 0, compression=None, ping_interval=None
        )

    def run(self) -> None:
        """Serve until everybody has left the line."""
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        while True:
            ready, _, _ = select.select(self._ends, [], [], _LONGEST_S)
            for end in ready:
                data = _received(end)
                if not data and end is self._ends[0]:
                    return
                if not data:
                    self._ends.remove(end)
                elif self._is_over(data):
                    return
            with self._lock:  # the force of a client that has gone ends in time
                self._pass(self._clock.now_s())

    def _talk(self, connection: ServerConnection) -> None:
        try:
            with self._lock:
                first = self._service.inventory(self._clock.now_s())
            connection.send(first)
            while True:
                text = connection.recv()
                self._wait_while_deaf()
                with self._lock:
                    now_s = self._clock.now_s()
                    answer = self._service.answer(text, now_s)
                    self._pass(now_s)
                connection.send(answer)
        except ConnectionClosed:
            return

    def _wait_while_deaf(self) -> None:
        until_s = self._deaf_until_s
        if self._clock.now_s() < until_s:
            self._clock.sleep_until(until_s)

    def _is_over(self, data: bytes) -> bool:
        """Do what the line says; return whether the device is unplugged."""
        packet, now_s = unpack(data), self._clock.now_s()
        with self._lock:
            if isinstance(packet, ForceCommand):  # a guard's zero
                self._service.simulation.command(packet.force_n, now_s)
                self._pass(now_s)
            elif isinstance(packet, Control):
                return self._acts(packet, now_s)
        return False

    def _acts(self, control: Control, now_s: float) -> bool:
        if control.event is ScriptedEvent.HELLO:
            port = self._server.socket.getsockname()[1]
            self._ends[0].send(str(port).encode())
        elif control.event is ScriptedEvent.STALL:
            self._deaf_until_s = now_s + control.value
        elif control.event is ScriptedEvent.CORRUPT:
            self._service.corrupt = int(control.value)
        else:
            self._service.simulation.advance(now_s)
            self._service.simulation.act(control)
        return control.event is ScriptedEvent.UNPLUG

    def _pass(self, now_s: float) -> None:
        self._service.simulation.advance(now_s)
        if self._recorder is not None:
            self._recorder.write(now_s, self._service.simulation)


def _received(end: socket.socket) -> bytes:
    try:
        return end.recv(MAX_BYTES)
    except OSError:
        return b""


def main(argv: list[str] | None = None) -> int:
    """Be an Inverse3 with its service until all others have closed their line."""
    options = device_parser("hapticplayer.extras.inverse3.simulated").parse_args(argv)
    outlive_the_player()
    simulation = simulation_of(
        HANDS[options.hand], Electronics(options.hold_s, options.delay_s)
    )
    numbers = [n for n in (options.line, options.control) if n is not None]
    recorder = None if options.record is None else PlantRecorder(options.record)
    process = Process(
        Service(simulation), [socket.socket(fileno=n) for n in numbers], recorder
    )
    gc.freeze()
    process.run()
    os._exit(0)  # do not wait for threads whose peer has gone


if __name__ == "__main__":
    sys.exit(main())
