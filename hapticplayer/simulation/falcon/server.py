"""The simulated Falcon as a process of its own: it outlives the loop that drives it."""

import select
import socket

from hapticplayer.clock import Clock
from hapticplayer.simulation.falcon.packets import (
    MAX_BYTES,
    Control,
    ForceCommand,
    ScriptedEvent,
    pack_reply,
    unpack,
)
from hapticplayer.simulation.falcon.plant import ZERO
from hapticplayer.simulation.falcon.process import PlantRecorder
from hapticplayer.simulation.falcon.simulation import Simulation

COMMAND_AGE_S = 0.020
_RECORD_PERIOD_S = 0.020
_LONGEST_SLEEP_S = 0.5


class Server:
    """Answers at one end of a SOCK_SEQPACKET pair until the other end is closed.

    `turn` is public so that tests drive it on a virtual clock. `control` is a second
    end, for acts only; its other side may close at any time.
    """

    def __init__(
        self,
        clock: Clock,
        line: socket.socket,
        simulation: Simulation,
        recorder: PlantRecorder | None = None,
        control: socket.socket | None = None,
    ) -> None:
        self.is_over = self._is_up_to_date = False
        self._clock = clock
        self._simulation = simulation
        self._recorder = recorder
        self._line = line
        self._ends = [line] if control is None else [line, control]
        for end in self._ends:
            end.setblocking(False)
        self._deaf_until_s: float | None = None
        self._poll = self._watching()
        self._corrupt = 0
        now_s = clock.now_s()
        simulation.advance(now_s)
        self._reply(0, now_s)  # a greeting: whoever opens the device waits for it

    def run(self) -> None:
        """Serve until the end."""
        while not self.is_over:
            self._wait()
            self.turn()

    def turn(self) -> None:
        """Take all that has come, let the time pass, and write it down."""
        self._is_up_to_date = False
        if self._deaf_until_s is None or self._hears(self._clock.now_s()):
            for end in tuple(self._ends):
                self._drain(end)
        if self._is_up_to_date:  # a command was the last to come, and is on record
            return
        now_s = self._clock.now_s()
        self._simulation.advance(now_s)
        self._write_down(now_s)

    def _wait(self) -> None:
        now_s = self._clock.now_s()
        longest_s = _RECORD_PERIOD_S if self._recorder else _LONGEST_SLEEP_S
        wake_s = min(now_s + longest_s, self._simulation.next_change_s)
        if self._deaf_until_s is not None:
            wake_s = min(wake_s, self._deaf_until_s)
        events = self._poll.poll(max(0.0, 1e3 * (wake_s - now_s)))
        if self._deaf_until_s is not None:
            line_events = dict(events).get(self._line.fileno(), 0)
            self.is_over = bool(line_events & select.POLLHUP)

    def _hears(self, now_s: float) -> bool:
        if self._deaf_until_s is not None and now_s >= self._deaf_until_s:
            self._deaf_until_s = None
            self._poll = self._watching()
        return self._deaf_until_s is None

    def _watching(self) -> select.poll:
        """The wake-up sources; while it is deaf only the departure of all."""
        poll = select.poll()
        if self._deaf_until_s is not None:
            poll.register(self._line, 0)
            return poll
        for end in self._ends:
            poll.register(end, select.POLLIN)
        return poll

    def _drain(self, end: socket.socket) -> None:
        while not self.is_over and self._deaf_until_s is None:
            try:
                data = end.recv(MAX_BYTES)
            except BlockingIOError:
                return
            except ConnectionResetError:
                continue  # they left without reading our replies; packets may follow
            if not data:
                self._hang_up(end)
                return
            self._take(data)
            if not self._poll.poll(0.0):  # a third of what a refused call costs
                return

    def _hang_up(self, end: socket.socket) -> None:
        if end is self._line:
            self.is_over = True
        else:
            self._ends.remove(end)
            self._poll = self._watching()

    def _take(self, data: bytes) -> None:
        self._is_up_to_date = False
        packet, now_s = unpack(data), self._clock.now_s()
        if isinstance(packet, ForceCommand):
            self._obey(packet, now_s)
        elif isinstance(packet, Control):
            self._act(packet, now_s)
        else:
            self._simulation.refused += 1

    def _obey(self, command: ForceCommand, now_s: float) -> None:
        is_timely = abs(now_s - command.stamp_s) <= COMMAND_AGE_S
        if not (is_timely or command.force_n == ZERO):  # a zero never comes too late
            self._simulation.refused += 1
            return
        self._simulation.command(command.force_n, now_s)
        self._write_down(now_s)
        self._is_up_to_date = True
        self._reply(command.serial, now_s)

    def _act(self, control: Control, now_s: float) -> None:
        self._simulation.advance(now_s)
        if control.event is ScriptedEvent.HELLO:
            self._reply(0, now_s)
        elif control.event is ScriptedEvent.UNPLUG:
            self.is_over = True
            self._line.close()
        elif control.event is ScriptedEvent.STALL:
            self._deaf_until_s = now_s + control.value
            self._poll = self._watching()
        elif control.event is ScriptedEvent.CORRUPT:
            self._corrupt = int(control.value)
        else:
            self._simulation.act(control)

    def _reply(self, serial: int, now_s: float) -> None:
        data = pack_reply(serial, self._simulation.reading(now_s))
        if self._corrupt > 0:
            self._corrupt -= 1
            middle = len(data) // 2
            data = data[:middle] + bytes([data[middle] ^ 0x10]) + data[middle + 1 :]
        try:
            self._line.send(data)
        except OSError:  # the queue is full, or the peer has gone
            return

    def _write_down(self, now_s: float) -> None:
        if self._recorder is not None:
            self._recorder.write(now_s, self._simulation)
