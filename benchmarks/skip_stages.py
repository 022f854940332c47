"""The stages of skips.py: what one picture, one second of sound, one tick costs."""

import os
import socket
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

import numpy as np
from common import HEIGHT, WIDTH
from skip_cases import TICKS, Stage, decoded, loaded, shown_surface

from hapticplayer.clock import ManualClock
from hapticplayer.devices.falcon.kinematics import Kinematics, motor_words
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.haptics.contract import Situation, State, Supervision
from hapticplayer.haptics.guard import Guard
from hapticplayer.haptics.hand import observe
from hapticplayer.haptics.limiter import PERIOD_S, Limits
from hapticplayer.haptics.loop import Loop
from hapticplayer.haptics.messages import Line, Word
from hapticplayer.haptics.recorder import Recorder
from hapticplayer.haptics.records import RecordWriter, open_record
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.step import step
from hapticplayer.haptics.track import anonymous_memory, to_shared_memory
from hapticplayer.media.audio import AudioBlock, AudioDecoder
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.opening import open_media, read_only
from hapticplayer.media.tempo import TempoFilter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ForceTrack, PlaybackClock
from hapticplayer.model.device import DeviceReading, Vector

SPEED, SOUND_HZ = 1.5, 48_000
TICKS_READ = 50
FORCE: Vector = (1.0, -2.0, 0.5)


def all_stages(folder: Path, clip: Path, stack: ExitStack) -> list[Stage]:
    """Return every stage, on the way from the file to the hand."""
    return [*picture_stages(clip, stack), *sound_stages(clip), *tick_stages(folder)]


def picture_stages(clip: Path, stack: ExitStack) -> list[Stage]:
    """From the file to the screen, 1280 x 720."""
    frames, surface = decoded(clip), shown_surface()
    stack.callback(surface.close)

    def demux() -> int:
        with open_media(clip) as container:
            video = container.streams.video[0]
            read_only(container, video)
            return sum(1 for _ in container.demux(video))

    def decode() -> int:
        with VideoDecoder(clip) as decoder:
            return sum(1 for _ in decoder.frames())

    def convert() -> int:
        converter = FrameConverter()
        for frame in frames:
            converter.convert(frame, WIDTH, HEIGHT)
        return len(frames)

    def paint() -> int:
        for frame in frames:
            surface.present(frame)
        return len(frames)

    return [
        Stage("demux", "packet", demux),
        Stage("decode (H.264, its demux included)", "picture", decode),
        Stage(f"convert to BGRA, {WIDTH} x {HEIGHT}", "picture", convert),
        Stage("convert and paint", "picture", paint),
    ]


def sound_stages(clip: Path) -> list[Stage]:
    """From the file to the ring, AAC in stereo at 48 kHz."""
    with AudioDecoder(clip) as decoder:
        blocks: list[AudioBlock] = list(iter(decoder.next_block, None))
    seconds = round(sum(len(b.samples) for b in blocks) / SOUND_HZ)

    def decode() -> int:
        with AudioDecoder(clip) as decoder:
            while decoder.next_block() is not None:
                pass
        return seconds

    def stretch() -> int:
        tempo = TempoFilter(SPEED, SOUND_HZ)
        for block in [*blocks, None]:
            tempo.push(block)
        return seconds

    return [
        Stage("sound decode", "second", decode),
        Stage(f"another speed, {SPEED:g}x", "second", stretch),
    ]


class Still:
    """A device that answers at once, so that the loop's own work is measured."""

    def __init__(self) -> None:
        self.grip: Vector = (0.001, 0.002, -0.001)

    def exchange(self, _force_n: Vector, now_s: float) -> DeviceReading:
        """Answer."""
        return DeviceReading(self.grip, 0, is_homed=True, replied_s=now_s)


def waves() -> ForceTrack:
    """Return a minute of force without a pause."""
    time_s = np.arange(0.0, 60.0, 0.005)
    waves = [1.5 + np.sin(2.0 * np.pi * f * time_s) for f in (0.7, 1.1, 1.9)]
    return ForceTrack(time_s, np.stack(waves, axis=1))


def tick_stages(folder: Path) -> list[Stage]:
    """From the track to the wire, and beside it."""
    track, kinematics = loaded(waves()), Kinematics()
    counts = [(40 + k % 2, -25, 10) for k in range(TICKS)]
    near_m = kinematics.pose(kinematics.angles(counts[0])).position_m
    jacobian = kinematics.pose(kinematics.angles(counts[0])).jacobian

    def interpolate() -> int:
        for number in range(TICKS):
            track.force_at(1e-3 * number)
        return TICKS

    def pose() -> int:
        for one in counts:
            kinematics.pose(kinematics.angles(one), near_m)
        return TICKS

    def torques() -> int:
        for _ in counts:
            motor_words(jacobian, FORCE)
        return TICKS

    def encode() -> int:
        for one in counts:
            encode_command(one)
        return TICKS

    return [
        Stage("interpolation", "tick", interpolate),
        Stage("step: rules, interpolation, limits", "tick", steps(track)),
        Stage("tick: step, listening, clock, record; no device", "tick", ticks()),
        Stage("Falcon's kinematics: pose", "tick", pose),
        Stage("Falcon's kinematics: torques", "tick", torques),
        Stage("Falcon's encoding", "tick", encode),
        Stage("guard, every 19 ms", "look", guard()),
        Stage("recorder", "tick", recorder(folder)),
    ]


def steps(track: object) -> Callable[[], int]:
    """Return what runs the pure step while the force acts."""
    limits, grip = Limits(), Still().grip

    def run() -> int:
        state, now_s = State(), 1000.0
        clock = PlaybackClock(1, now_s, 1.0, 1.0, 1e9)
        for _ in range(TICKS):
            now_s += PERIOD_S
            reading = DeviceReading(grip, 0, is_homed=True, replied_s=now_s)
            hand, told = observe(state.hand, reading, limits), Supervision(now_s)
            state = step(Situation(now_s, clock, track, state, hand, told, limits))  # type: ignore[arg-type]
        return TICKS

    return run


def ticks() -> Callable[[], int]:
    """Return what runs the loop on a virtual clock."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    clock, block = ManualClock(), shared_block()
    player = Line(ours, outbox=block.outbox)
    line = Line(theirs, inbox=block.outbox)
    loop = Loop(clock, block, line, Still())  # type: ignore[arg-type]
    descriptor = to_shared_memory(waves())
    player.send(Word.TRACK, "1", descriptor)
    os.close(descriptor)

    def run() -> int:
        assert player.is_open
        now_s = clock.now_s()
        block.write_clock(PlaybackClock(1, now_s, 0.0, 1.0, now_s + 1e6), 1)
        for _ in range(TICKS):
            clock.advance(PERIOD_S)
            block.beat(clock.now_s())
            loop.tick(clock.now_s())
        return TICKS

    return run


def shared_block() -> SharedBlock:
    """Return the memory between loop and player."""
    descriptor = anonymous_memory("benchmark", BLOCK_BYTES)
    block = SharedBlock(descriptor)
    os.close(descriptor)
    return block


def guard() -> Callable[[], int]:
    """Return what looks at a loop that is well."""
    clock, block = ManualClock(), shared_block()
    watching = Guard(clock, block, lambda: True)

    def run() -> int:
        for _ in range(TICKS):
            watching.look()
        return TICKS

    return run


def recorder(folder: Path) -> Callable[[], int]:
    """Return what writes ticks into a file, 50 at a time as in a run."""
    clock, block = ManualClock(), shared_block()
    writer = RecordWriter(open_record(folder / "benchmark.record"))
    writer.begin({})
    recording = Recorder(clock, block, writer)
    written = [0]

    def run() -> int:
        for number in range(TICKS):
            fields = [0.0] * 18
            block.write_tick(written[0], clock.now_s(), 0.0, *fields, 0, 0, 0, 0)
            written[0] += 1
            if number % TICKS_READ == TICKS_READ - 1:
                recording.collect()
                clock.advance(TICKS_READ * PERIOD_S)
        return TICKS

    return run
