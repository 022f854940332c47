"""The process of a simulated Falcon: serves requests until the last peer has gone."""

import errno
import socket
import threading

from hapticplayer.clock import Clock
from hapticplayer.extras.faults.usb.board import Board
from hapticplayer.extras.faults.usb.chip import Chip, UsbFault
from hapticplayer.extras.faults.usb.remote import (
    MAX_BYTES,
    NO_ANSWER,
    UsbAnswer,
    UsbRequest,
    UsbRequestKind,
    pack_answer,
    unpack_request,
)
from hapticplayer.simulation.falcon.packets import Control, ScriptedEvent, unpack
from hapticplayer.simulation.falcon.simulation import Simulation


class UsbServer:
    """Hands requests from line A to a chip in real time, and answers."""

    def __init__(self, chip: Chip, line: socket.socket) -> None:
        self._chip, self._line = chip, line

    def run(self) -> None:
        """Serve line A in this thread and each line B in one of its own."""
        while self._chip.is_plugged:
            try:
                data, descriptors, _, _ = socket.recv_fds(self._line, MAX_BYTES, 1)
            except ConnectionResetError:
                continue  # they left without reading our answers; more may follow
            if not data:
                return
            request = unpack_request(data)
            if request is None:
                continue
            if request.kind is UsbRequestKind.ATTACH:
                for descriptor in descriptors:
                    end = socket.socket(fileno=descriptor)
                    threading.Thread(
                        target=self._feed, args=(end,), daemon=True
                    ).start()
            else:
                self._serve(self._line, request)

    def _feed(self, end: socket.socket) -> None:
        with end:
            while data := _received(end):
                request = unpack_request(data)
                if request is not None:
                    self._serve(end, request)

    def _serve(self, end: socket.socket, request: UsbRequest) -> None:
        answer = self._answer(request)
        if request.serial == NO_ANSWER:
            return
        try:
            end.send(pack_answer(answer))
        except OSError:
            return  # the peer has gone; the next read ends

    def _answer(self, request: UsbRequest) -> UsbAnswer:
        serial, chip = request.serial, self._chip
        try:
            if request.kind is UsbRequestKind.CONTROL:
                chip.control(*request.words)
                return UsbAnswer(serial)
            if request.kind is UsbRequestKind.OUT:
                taken = chip.write(request.data, request.timeout_s)
                return UsbAnswer(serial, taken=taken)
            packet = chip.read(request.timeout_s)
        except UsbFault as fault:
            return UsbAnswer(serial, fault.errno or errno.EIO)
        if packet is None:
            return UsbAnswer(serial, errno.ETIMEDOUT)
        return UsbAnswer(serial, data=packet)


def serve_acts(
    end: socket.socket, chip: Chip, board: Board, simulation: Simulation, clock: Clock
) -> None:
    """Let a test make things happen, until it hangs up."""
    while data := _received(end):
        packet = unpack(data)
        if isinstance(packet, Control):
            act(packet, chip, board, simulation, clock)


def act(
    control: Control, chip: Chip, board: Board, simulation: Simulation, clock: Clock
) -> None:
    """Make one thing happen to the device."""
    with chip.held():
        if control.event is ScriptedEvent.UNPLUG:
            chip.unplug()
        elif control.event is ScriptedEvent.STALL:
            chip.stalled_until_s = clock.now_s() + control.value
        elif control.event is ScriptedEvent.CORRUPT:
            board.faults.corrupt = int(control.value)
        else:
            simulation.advance(clock.now_s())
            simulation.act(control)


def _received(end: socket.socket) -> bytes:
    try:
        return end.recv(MAX_BYTES)
    except OSError:
        return b""
