"""Files that would fill the memory are opened, or refused, with at most 300 MB more."""

import subprocess
import sys
import zlib
from pathlib import Path

import pytest

from hapticplayer.media.remux import MATROSKA, remux

MB = 1 << 20
MOST_BYTES = 300 * MB
CLUSTER = b"\x1f\x43\xb6\x75"
SEGMENT, ATTACHMENTS, TAGS = (
    b"\x18\x53\x80\x67",
    b"\x19\x41\xa4\x69",
    b"\x12\x54\xc3\x67",
)
OPEN = """
import re, sys
from pathlib import Path
from hapticplayer.errors import InputError
from hapticplayer.media.clip_bytes import resident_bytes
from hapticplayer.media.clip_info import probe
from hapticplayer.media.remux import video_payload
from hapticplayer.sequence.packed import read_packed
before = resident_bytes()
said = []
for use in (read_packed, probe, video_payload):
    try:
        use(Path(sys.argv[1]))
    except InputError as problem:
        said.append(str(problem))
status = Path("/proc/self/status").read_text()  # ru_maxrss begins with the parent's
print(1024 * int(re.search(r"VmHWM:\\s+(\\d+)", status)[1]) - before)
print(*said)
"""


def element(number, content=b"", more=0):
    """An EBML element; `more` bytes of its content follow elsewhere."""
    size = (len(content) + more | 1 << 56).to_bytes(8, "big")
    return number + size + content


def attachments(size_bytes):
    """All of it but the content, which stays a hole in the file."""
    names = element(b"\x46\x6e", b"x.bin") + element(b"\x46\x60", b"a/b")
    names += element(b"\x46\xae", b"\x07")
    data = element(b"\x46\x5c", b"", size_bytes)
    return element(
        ATTACHMENTS, element(b"\x61\xa7", names + data, size_bytes), size_bytes
    )


def box(kind, content=b""):
    return (8 + len(content)).to_bytes(4, "big") + kind + content


def matroska(clip, path, *parts, before=b""):
    """Write a clip with parts before its own, or before one; a number is a hole."""
    remux(clip, path, MATROSKA)
    content = path.read_bytes()
    at = content.index(SEGMENT) + 4
    own = content[at + 9 - content[at].bit_length() :]
    first = own[: own.index(before)]
    with path.open("wb") as writer:
        writer.write(content[:at] + b"\x01" + b"\xff" * 7 + first)
        for part in parts:
            writer.seek(part, 1) if isinstance(part, int) else writer.write(part)
        writer.write(own[len(first) :])
    return path


def mp4(clip, path, *, more=b"", moov=None):
    """Write a clip whose index stands at its end, with more in it, or is another one."""
    content = bytearray(clip.read_bytes())
    at = content.index(b"moov")
    own = content[at + 4 : at - 4 + int.from_bytes(content[at - 4 : at], "big")]
    content[at : at + 4] = b"free"
    path.write_bytes(content + box(b"moov", moov or bytes(own) + more))
    return path


def four(clip, path):
    return matroska(clip, path, *[attachments(250 * MB), 250 * MB] * 4)


def forty(clip, path):
    return matroska(clip, path, *[attachments(150 * MB), 150 * MB] * 40)


def behind_a_seek_head(clip, path):
    """Where no element begins, but FFmpeg is told that one does."""
    hidden = attachments(250 * MB)
    place = element(b"\x53\xab", ATTACHMENTS) + element(b"\x53\xac", b"\0\0\0\x3b")
    head = element(b"\x11\x4d\x9b\x74", element(b"\x4d\xbb", place))
    assert len(head) + 9 == 0x3B
    return matroska(clip, path, head, element(b"\xec", hidden, 250 * MB), 250 * MB)


def tags(clip, path):
    one = element(b"\x45\xa3", b"K") + element(b"\x44\x87", b"v")
    return matroska(clip, path, element(TAGS, element(b"\x73\x73", one * 500_000)))


def chapters(clip, path):
    atoms = element(b"\x45\xb9", b"\xb6\x80" * 10_000_000)
    return matroska(clip, path, element(b"\x10\x43\xa7\x70", atoms))


def cues(clip, path):
    cue = element(b"\xbb", element(b"\xb3", b"\0"))
    return matroska(clip, path, element(b"\x1c\x53\xbb\x6b", cue * 1_500_000))


def tracks(clip, path):
    return matroska(clip, path, element(b"\x16\x54\xae\x6b", b"\xae\x80" * 1_900_000))


def one_block(clip, path):
    cluster = CLUSTER + b"\x01" + b"\xff" * 7 + element(b"\xe7", b"\0")
    block = element(b"\xa3", b"\x81\0\0\x80", 1 << 30)
    return matroska(clip, path, cluster + block, 1 << 30, before=CLUSTER)


def cover(clip, path):
    art = box(b"covr", box(b"data", bytes((0, 0, 0, 13, 0, 0, 0, 0)) + bytes(80 * MB)))
    handler = box(b"hdlr", bytes(8) + b"mdirappl" + bytes(9))
    meta = box(b"meta", bytes(4) + handler + box(b"ilst", art))
    return mp4(clip, path, more=box(b"udta", meta))


def packed_index(clip, path):
    size = (1000 * MB).to_bytes(4, "big")
    content = box(b"cmvd", size + zlib.compress(bytes(1000 * MB)))
    return mp4(clip, path, moov=box(b"cmov", box(b"dcom", b"zlib") + content))


def samples(clip, path):
    content = bytearray(clip.read_bytes())
    at = content.index(b"stsz") + 8
    content[at : at + 8] = (1).to_bytes(4, "big") + (200_000_000).to_bytes(4, "big")
    path.write_bytes(content)
    with path.open("r+b") as writer:
        writer.seek(0, 2)
        hole = 1 << 30
        writer.write((1).to_bytes(4, "big") + b"free" + (16 + hole).to_bytes(8, "big"))
        writer.truncate(writer.tell() + hole)
    return path


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (four, ""),
        (forty, ""),
        (behind_a_seek_head, ""),
        (tags, "tags or chapters are too large"),
        (chapters, "tags or chapters are too large"),
        (cues, "its index, tags"),
        (tracks, "streams, expected"),
        (one_block, "too large"),
        (cover, "headers are too large"),
        (packed_index, "read"),
        (samples, "its index lists"),
    ],
)
def test_a_heavy_file_takes_little_memory(clip: Path, tmp_path: Path, make, says):
    path = make(clip, tmp_path / ("heavy.mp4" if make in AS_MP4 else "heavy.mkv"))
    done = subprocess.run(
        [sys.executable, "-c", OPEN, str(path)],
        capture_output=True,
        text=True,
        check=True,
    )
    grown, _, said = done.stdout.partition("\n")
    assert int(grown) < MOST_BYTES, said
    assert says in said
    assert bool(said.strip()) is bool(says)


AS_MP4 = (cover, packed_index, samples)
