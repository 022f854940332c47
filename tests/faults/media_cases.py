"""Clips in five containers, one of them with force, eight ways to damage them, and a
child that plays one.

A child has 512 MB more than the process it was forked from, and five seconds.
"""

import contextlib
import json
import os
import resource
import select
import signal
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import av
import numpy as np

from hapticplayer.clock import SystemClock
from hapticplayer.errors import InputError
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.remux import video_payload
from hapticplayer.media.video import VideoDecoder
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import read_packed
from tests.material.shaken import write_shaken_sequence

EXTREMES = (b"\xff\xff\xff\xff", b"\x7f\xff\xff\xff", b"\0\0\0\0")
LONGEST_S = 5.0
EXTRA_BYTES = 512 * 1024**2
PICTURES, RATE_HZ, SIZE_PX = 30, 15, (128, 96)
SOUND_HZ = 48_000
# container: how many mutations are asked for, picture codec, sound codec
CONTAINERS = {
    "mp4": (1000, "libx264", "aac"),
    "mkv": (200, "libx264", "aac"),
    "webm": (200, "libvpx", "libopus"),
    "mov": (200, "libx264", "aac"),
    "avi": (200, "mpeg4", "pcm_s16le"),
    "packed": (2000, "", ""),
}


@dataclass(frozen=True, slots=True)
class Outcome:
    """What playing a file from beginning to end came to.

    Attributes:
        kind: "played", "refused" (with a sentence), "crashed" or "hung".
        text: the sentence, or how it crashed.
        pictures: how many were decoded.
        is_marked: whether a notice says that the file is damaged.
        extra_bytes: memory beyond that of the parent.
        seconds: how long it took.
    """

    kind: str
    text: str
    pictures: int
    is_marked: bool
    extra_bytes: int
    seconds: float


def make_clip(folder: Path, container: str) -> Path:
    """Write 2 s of pictures that do not compress, so that damage meets them."""
    if container == "packed":
        return _packed(folder)
    _, picture_codec, sound_codec = CONTAINERS[container]
    path = folder / f"clip.{container}"
    rng = np.random.default_rng(8)
    with av.open(str(path), "w") as file:
        video = file.add_stream(picture_codec, rate=RATE_HZ)
        video.width, video.height = SIZE_PX
        video.pix_fmt, video.bit_rate = "yuv420p", 2_000_000
        video.codec_context.gop_size = RATE_HZ
        audio = file.add_stream(sound_codec, rate=SOUND_HZ)
        audio.layout = "stereo"
        for number in range(PICTURES):
            noise = rng.integers(0, 256, (SIZE_PX[1], SIZE_PX[0], 3)).astype(np.uint8)
            picture = av.VideoFrame.from_ndarray(noise, format="rgb24")
            picture.pts, picture.time_base = number, Fraction(1, RATE_HZ)
            file.mux(video.encode(picture))
            file.mux(audio.encode(_tone(number)))
        for stream in (video, audio):
            file.mux(stream.encode(None))
    return path


def _packed(folder: Path) -> Path:
    """Write a clip with its force attached."""
    clip = make_clip(folder, "mp4")
    sequence = write_shaken_sequence(clip, folder / "sequence", title="Shaken")
    pack(sequence, folder / "packed.mkv", with_motion=True)
    return folder / "packed.mkv"


def _tone(number: int) -> av.AudioFrame:
    count = SOUND_HZ // RATE_HZ
    t = (number * count + np.arange(count)) / SOUND_HZ
    wave = (8000 * np.sin(2.0 * np.pi * 440.0 * t)).astype(np.int16)
    frame = av.AudioFrame.from_ndarray(
        np.repeat(wave, 2)[None, :], format="s16", layout="stereo"
    )
    frame.sample_rate, frame.pts = SOUND_HZ, number * count
    frame.time_base = Fraction(1, SOUND_HZ)
    return frame


def mutated(content: bytes, rng: np.random.Generator) -> bytes:
    """Damage a file in one of eight ways."""
    damaged, kind = bytearray(content), int(rng.integers(8))
    at, length = int(rng.integers(len(damaged))), int(rng.integers(1, 2000))
    header = max(0, damaged.find(b"moov"))
    reach = min(4000, len(damaged) - header - 4)
    if kind < 3:
        for _ in range((1, 20, 300)[kind]):
            damaged[int(rng.integers(len(damaged)))] ^= 1 << int(rng.integers(8))
    elif kind == 3:
        del damaged[at:]
    elif kind == 4:
        damaged[at : at + length] = bytes(len(damaged[at : at + length]))
    elif kind == 5:
        damaged[at:at] = damaged[at : at + length]
    else:
        for _ in range(3):
            spot = header + int(rng.integers(reach))
            damaged[spot : spot + 4] = EXTREMES[int(rng.integers(3))]
    return bytes(damaged)


def mutation(content: bytes, container: str, number: int, seed: int = 0) -> bytes:
    """Return the mutation of that number; the same for ever.

    Rules are tuned on what they are tried on, so another seed gives other damage.
    """
    own = [seed] if seed else []
    return mutated(content, np.random.default_rng([*own, number, *container.encode()]))


def play(path: Path) -> tuple[int, bool]:
    """Play pictures and sound to the end and seek back, as the player does.

    Before that, force in the file is read, and the checksum of its video taken.

    Returns:
        How many pictures came, and whether the file is marked as damaged.

    Raises:
        InputError: with the sentence for people.
    """
    if (packed := read_packed(path)) is not None:
        assert set(packed.sequence.tracks) == {"realistic", "none", "random"}
        video_payload(path)
    pictures, info = 0, probe(path)
    with VideoDecoder(path) as video:
        for frame in video.frames():
            FrameConverter().convert(frame, 64, 48)
            pictures += 1
        is_marked = video.damaged > 0
        video.seek(0.5 * info.duration_s)
        video.next_frame()
    if info.has_audio:
        with AudioDecoder(path) as audio:
            while audio.next_block() is not None:
                pass
    return pictures, is_marked


def play_in_child(path: Path) -> Outcome:
    """Play in a process with limits."""
    reader, writer = os.pipe()
    baseline_bytes = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begin_s = SystemClock().now_s()
    pid = os.fork()
    if pid == 0:
        os.close(reader)
        _be_the_child(path, writer)
    os.close(writer)
    with os.fdopen(reader) as answer:
        is_in_time = bool(select.select([answer], [], [], LONGEST_S)[0])
        if not is_in_time:
            os.kill(pid, signal.SIGKILL)
        said = answer.read()
    _, status, usage = os.wait4(pid, 0)
    seconds = SystemClock().now_s() - begin_s
    extra_bytes = max(0, 1024 * usage.ru_maxrss - baseline_bytes)
    if not is_in_time:
        return Outcome("hung", "", 0, False, extra_bytes, seconds)
    if not said:
        text = f"status {os.waitstatus_to_exitcode(status)}"
        return Outcome("crashed", text, 0, False, extra_bytes, seconds)
    return Outcome(**json.loads(said), extra_bytes=extra_bytes, seconds=seconds)


def _be_the_child(path: Path, writer: int) -> None:
    """Play, tell, and end without whatever the parent would do at its end."""
    status = 1
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        # address space, not memory: threads of a decoder reserve stacks and arenas
        most = pages * resource.getpagesize() + 4 * EXTRA_BYTES
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        try:
            pictures, is_marked = play(path)
            said = ("played", "", pictures, is_marked)
        except InputError as problem:
            said = ("refused", str(problem), 0, True)
        except BaseException as problem:  # noqa: BLE001 - what must never happen
            said = ("crashed", repr(problem), 0, False)
        names = ("kind", "text", "pictures", "is_marked")
        content = json.dumps(dict(zip(names, said, strict=True)))
        with contextlib.suppress(OSError):
            os.write(writer, content.encode())
            status = 0
    finally:
        os._exit(status)
