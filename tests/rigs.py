"""A player's side of the haptic loop: in one thread, and of the real process."""

import os
import socket

import numpy as np

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.loop import Loop
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.haptics.shared import BLOCK_BYTES, TICK, SharedBlock
from hapticplayer.haptics.track import map_track, to_shared_memory
from hapticplayer.linux import anonymous_memory
from hapticplayer.model import ForceTrack, PlaybackClock

PATIENCE_S = 60.0


def loaded(track):
    """Return a track as the loop reads it."""
    descriptor = to_shared_memory(track)
    try:
        return map_track(descriptor)
    finally:
        os.close(descriptor)


class LoopRig:
    """Both ends of a loop in one thread; `more` are further arguments of `Loop`."""

    def __init__(self, clock, device, *more):
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        descriptor = anonymous_memory("test", BLOCK_BYTES)
        self.block = SharedBlock(descriptor)
        os.close(descriptor)
        self.player, self.line = MessageSocket(ours), MessageSocket(theirs)
        self.clock, self.device = clock, device
        self.loop = Loop(clock, self.block, self.line, device, *more)

    def give_track(self, track, track_id=1):
        descriptor = to_shared_memory(track)
        self.player.send(MessageKind.TRACK, str(track_id), descriptor)
        os.close(descriptor)

    def close(self):
        self.player.close()
        self.line.close()


class FeedingPlayer:
    """Plays a constant force towards the user for ever; keeps all ticks."""

    def __init__(self, process, force_n):
        self.clock, self.process = SystemClock(), process
        self.start_s, self.ticks = self.clock.now_s(), np.empty(0, TICK)
        process.wait_ready()
        process.load({"track": ForceTrack([0.0, 1e4], [[0, 0, force_n]] * 2)})

    def play_until(self, condition):
        """Play until a condition on all ticks so far holds; return the ticks."""
        end_s = self.clock.now_s() + PATIENCE_S
        while (now_s := self.clock.now_s()) < end_s:
            self.process.beat()
            clock = PlaybackClock(1, self.start_s, 0.0, 1.0, now_s + 0.15)
            self.process.publish(clock, "track")
            self.ticks = np.concatenate([self.ticks, self.process.read_ticks()[0]])
            self.process.poll()
            if len(self.ticks) and condition(self.ticks):
                return self.ticks
            self.clock.sleep_until(now_s + 0.005)
        raise AssertionError("it did not happen")
