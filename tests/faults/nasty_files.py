"""Files that real disks hold and players fall over, each made by code.

Every maker takes an empty folder and a good clip, and returns what is to be opened.
"""

import contextlib
import os
import socket
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import av
import numpy as np

PICTURES = 12
RATE_HZ = 12
ALL = -1
Make = Callable[[Path, bytes], Path]


class Nasty(NamedTuple):
    """One file.

    Attributes:
        make: makes it.
        pictures: how many it must show; 0 where it must be refused.
        says: what the sentence of a refusal holds, a regular expression.
    """

    make: Make
    pictures: int = 0
    says: str = ""


def encoded(
    path: Path,
    times: Iterable[int],
    *,
    size: tuple[int, int] = (128, 96),
    pixels: str = "yuv420p",
    codec: str = "libx264",
    base: Fraction = Fraction(1, RATE_HZ),
    options: dict[str, str] | None = None,
    turn_deg: int = 0,
) -> Path:
    """Write pictures without compressible content at the times given, in `base`."""
    rng = np.random.default_rng(5)
    order = {"bf": "0"} if codec == "libx264" else {}
    with av.open(str(path), "w", options=options or {}) as file:
        stream = file.add_stream(codec, rate=RATE_HZ, options=order)
        stream.width, stream.height = size
        stream.pix_fmt = pixels
        stream.codec_context.time_base = stream.time_base = base
        stream.codec_context.gop_size = 4
        if turn_deg:
            stream.set_display_rotation(turn_deg)
        for at in times:
            noise = rng.integers(0, 256, (size[1], size[0], 3)).astype(np.uint8)
            picture = av.VideoFrame.from_ndarray(noise, format="rgb24")
            picture = picture.reformat(format=pixels)
            picture.pts, picture.time_base = at, base
            file.mux(stream.encode(picture))
        file.mux(stream.encode(None))
    return path


def _bytes(content: bytes, name: str = "clip.mp4") -> Make:
    def make(folder: Path, _clip: bytes) -> Path:
        (folder / name).write_bytes(content)
        return folder / name

    return make


def _named(name: str) -> Make:
    def make(folder: Path, clip: bytes) -> Path:
        (folder / name).write_bytes(clip)
        return folder / name

    return make


def _link(target: str) -> Make:
    def make(folder: Path, _clip: bytes) -> Path:
        (folder / "link.mp4").symlink_to(target)
        return folder / "link.mp4"

    return make


def _with(**how: object) -> Make:
    def make(folder: Path, _clip: bytes) -> Path:
        name = str(how.get("name", "clip.mp4"))
        times = how.get("times", range(PICTURES))
        more = {key: how[key] for key in how.keys() - {"name", "times"}}
        return encoded(folder / name, times, **more)  # type: ignore[arg-type]

    return make


def _fifo(folder: Path, _clip: bytes) -> Path:
    os.mkfifo(folder / "pipe.mp4")
    return folder / "pipe.mp4"


def _folder(folder: Path, _clip: bytes) -> Path:
    (folder / "folder.mp4").mkdir()
    return folder / "folder.mp4"


def _socket(folder: Path, _clip: bytes) -> Path:
    with socket.socket(socket.AF_UNIX) as made, contextlib.chdir(folder):
        made.bind("s.mp4")
    return folder / "s.mp4"


def _only_sound(folder: Path, _clip: bytes) -> Path:
    path = folder / "sound.mp4"
    with av.open(str(path), "w") as file:
        stream = file.add_stream("aac", rate=48_000, layout="stereo")
        for number in range(20):
            block = np.zeros((2, 1024), np.float32)
            frame = av.AudioFrame.from_ndarray(block, format="fltp", layout="stereo")
            frame.sample_rate, frame.pts = 48_000, 1024 * number
            file.mux(stream.encode(frame))
        file.mux(stream.encode(None))
    return path


def _no_stream(folder: Path, clip: bytes) -> Path:
    """Keep the boxes of a film, without any track in it."""
    path = folder / "empty.mp4"
    at = clip.index(b"ftyp") - 4
    length = int.from_bytes(clip[at : at + 4], "big")
    movie_header = bytes(4) + bytes(8) + (1000).to_bytes(4, "big") + bytes(84)
    header = (8 + len(movie_header)).to_bytes(4, "big") + b"mvhd" + movie_header
    movie = (8 + len(header)).to_bytes(4, "big") + b"moov" + header
    path.write_bytes(clip[at : at + length] + movie)
    return path


def _huge(folder: Path, _clip: bytes) -> Path:
    """A picture that would take 700 MB to show, in a file of a few kilobytes."""
    path = folder / "huge.mkv"
    with av.open(str(path), "w") as file:
        stream = file.add_stream("libx264", rate=1, options={"preset": "ultrafast"})
        stream.width = stream.height = 8192
        stream.pix_fmt = "yuv420p"
        black = av.VideoFrame(8192, 8192, "yuv420p")
        for plane, level in zip(black.planes, (16, 128, 128), strict=True):
            plane.update(bytes([level]) * plane.buffer_size)
        black.pts, black.time_base = 0, Fraction(1)
        file.mux(stream.encode(black))
        file.mux(stream.encode(None))
    return path


def _times_before_zero(folder: Path, _clip: bytes) -> Path:
    """Begin half a second early; FFmpeg gives such pictures no time at all."""
    times = range(-6, PICTURES - 6)
    options = {"avoid_negative_ts": "disabled"}
    return encoded(folder / "before.mkv", times, options=options)


def _times_backwards(folder: Path, _clip: bytes) -> Path:
    """Let every other packet come a quarter of a second late in the container."""
    whole, path = encoded(folder / "whole.mkv", range(PICTURES)), folder / "back.mkv"
    with av.open(str(whole)) as source, av.open(str(path), "w") as file:
        stream = file.add_stream_from_template(source.streams.video[0])
        for number, packet in enumerate(source.demux(video=0)):
            if packet.pts is not None:
                packet.pts += 250 * (number % 2)
                packet.stream = stream
                file.mux(packet)
    whole.unlink()
    return path


def _unknown_codec(folder: Path, clip: bytes) -> Path:
    path = folder / "unknown.mp4"
    path.write_bytes(clip.replace(b"avc1", b"zzz9").replace(b"mp4a", b"zzz8"))
    return path


def _growing(folder: Path, _clip: bytes) -> Path:
    """A recording that is still being written: no length, the last packet cut."""
    whole = encoded(folder / "whole.mkv", range(PICTURES), options={"live": "1"})
    content = whole.read_bytes()
    whole.unlink()
    (folder / "growing.mkv").write_bytes(content[: len(content) * 2 // 3])
    return folder / "growing.mkv"


def _traps_beside(folder: Path, clip: bytes) -> Path:
    """Pipes with the names that players look for: reading one hangs for ever."""
    path = _named("clip.mp4")(folder, clip)
    for suffix in ("srt", "ass", "cue", "json", "csv", "gcsv", "jpg", "mp4.json"):
        os.mkfifo(folder / f"clip.{suffix}")
    return path


NASTY = {
    "nothing in it": Nasty(_bytes(b""), says="is empty"),
    "one byte": Nasty(_bytes(b"\0"), says="cannot be|can be read|no video"),
    "a text": Nasty(_bytes(b"time_s,ax\n0,1\n" * 50), says="can be read"),
    "a pipe": Nasty(_fifo, says="is a pipe"),
    "a folder": Nasty(_folder, says="is a folder"),
    "a socket": Nasty(_socket, says="is a socket"),
    "a device": Nasty(lambda _folder, _clip: Path("/dev/null"), says="is a device"),
    "a link to a device": Nasty(_link("/dev/zero"), says="is a device"),
    "a link to itself": Nasty(_link("link.mp4"), says="cannot be reached"),
    "a link to nothing": Nasty(_link("gone.mp4"), says="no such file"),
    "no stream": Nasty(_no_stream, says="0 streams|can be read|no video"),
    "only sound": Nasty(_only_sound, says="no video"),
    "a huge picture": Nasty(_huge, says="8192 x 8192 pixels are too large"),
    "a codec that nobody knows": Nasty(_unknown_codec, says="decoded|no video|read"),
    "a playlist": Nasty(_bytes(b"#EXTM3U\n#EXTINF:5,\nhttp://127.0.0.1:9/a.ts\n")),
    "a list of files": Nasty(_bytes(b"ffconcat version 1.0\nfile /etc/passwd\n")),
    "an archive": Nasty(_bytes(b"PK\x03\x04" + bytes(500))),
    "a picture": Nasty(_bytes(b"\x89PNG\r\n\x1a\n" + bytes(500))),
    "no sound": Nasty(_with(), PICTURES),
    "one picture": Nasty(_with(times=range(1)), 1),
    "times before zero": Nasty(_times_before_zero, PICTURES),
    "times that run backwards": Nasty(_times_backwards, PICTURES),
    "a variable rate": Nasty(
        _with(times=[0, 1, 2, 9, 10, 30, 31, 32, 50, 51, 52, 90]), PICTURES
    ),
    "ten bits": Nasty(_with(pixels="yuv420p10le"), PICTURES),
    "full colour": Nasty(_with(pixels="yuv444p"), PICTURES),
    "turned": Nasty(_with(turn_deg=90), PICTURES),
    "an odd size": Nasty(_with(size=(127, 95), pixels="yuv444p"), PICTURES),
    "two pixels": Nasty(_with(size=(2, 2), codec="mpeg4", name="dot.avi"), PICTURES),
    "a long and narrow one": Nasty(_with(size=(4096, 16)), PICTURES),
    "a name of 255 bytes": Nasty(_named("é" * 125 + "x.mp4"), ALL),
    "a name in many scripts": Nasty(_named("über:cañón %d \n日本 🎢.mp4"), ALL),
    "a name like an option": Nasty(_named("-i.mp4"), ALL),
    "still being written": Nasty(_growing, says="its duration"),
    "traps beside it": Nasty(_traps_beside, ALL),
}
"""Instead of a number: as many pictures as the good clip has."""
