"""Entry of the haptics process: `python -m hapticplayer.haptics`."""

import argparse
import os
import socket
import sys
from typing import Any

from hapticplayer.clock import SystemClock
from hapticplayer.devices import FAULTS, HapticDevice, find_device
from hapticplayer.errors import DeviceError, message_of
from hapticplayer.extension import load
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.centring import centring_of
from hapticplayer.haptics.lifeline import hold, map_lifeline, outlive_the_player
from hapticplayer.haptics.limiter import limits_of
from hapticplayer.haptics.loop import Loop
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.linux import (
    FIFO_PRIORITY,
    OWN_LOOP_PRIORITY,
    CpuLatencyRequest,
    Scheduling,
    acquire,
)


def main(argv: list[str] | None = None) -> int:
    """Open the device, say READY, and run the loop until the player is gone."""
    parser = argparse.ArgumentParser(prog="hapticplayer.haptics")
    for name in ("block", "line", "lifeline", "held", "alarm", "handle"):
        parser.add_argument(f"--{name}", type=int, required=True, help="descriptor")
    parser.add_argument("--device", required=True)
    parser.add_argument("--faults", action="store_true", help="take faults")
    parser.add_argument("--scheduling", choices=[s.value for s in Scheduling])
    options = parser.parse_args(argv)
    if options.faults and not find_device(options.device).server:
        parser.error("a real device does not accept injected faults")

    # Ctrl-C and a hang-up reach the whole group: the player decides, its alarm reports
    # them at once, and if it dies of them, the closed line does.
    outlive_the_player()
    os.set_inheritable(options.held, False)  # the guard takes its closing for our end
    block = LoopBlock(options.block)
    end = socket.socket(fileno=options.line)
    line = MessageSocket(end, options.alarm)
    entry = find_device(options.device)
    try:
        device = entry.make(options.handle)
        device.open()
    except DeviceError as problem:
        line.send(MessageKind.FAILED, message_of(problem))
        return 1
    try:
        wanted = Scheduling(options.scheduling) if options.scheduling else None
        hold(block.lifeline)  # until the end, which the guard sees
        loop = _loop(options, block, line, device)
        priority = OWN_LOOP_PRIORITY if entry.loop else FIFO_PRIORITY
        line.send(MessageKind.READY, acquire(wanted, priority).value)
        loop.run()
    finally:
        device.close()
    return 0


def _loop(
    options: argparse.Namespace,
    block: LoopBlock,
    line: MessageSocket,
    device: HapticDevice,
) -> Any:
    entry, lifeline = find_device(options.device), map_lifeline(options.lifeline)
    if entry.loop:
        return load(entry.loop)(SystemClock(), block, line, device, lifeline)
    limits = limits_of(device.capabilities)
    return _kind(options)(
        SystemClock(),
        block,
        line,
        device,
        limits,
        centring_of(limits),
        cpu_latency=CpuLatencyRequest(),
        lifeline=lifeline,
    )


def _kind(options: argparse.Namespace) -> type[Loop]:
    if not options.faults:
        return Loop
    kind: type[Loop] = load(f"{FAULTS}.loop:FaultyLoop")
    return kind


if __name__ == "__main__":
    sys.exit(main())
