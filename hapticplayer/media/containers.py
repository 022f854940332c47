"""The containers that are read, and the common ones that are not, with what to do."""

from pathlib import Path
from typing import NamedTuple

from hapticplayer.errors import MediaError, Message, shell_line
from hapticplayer.media.clip_bytes import AnyClip, ClipBytes, open_clip
from hapticplayer.media.mp4 import TOP


class Container(NamedTuple):
    """One that is read.

    Attributes:
        name: for people.
        demuxers: of FFmpeg.
        endings: of files.
    """

    name: str
    demuxers: tuple[str, ...]
    endings: tuple[str, ...]


CONTAINERS = (
    Container("MP4, MOV", ("mov",), (".mp4", ".mov")),
    Container("Matroska", ("matroska",), (".mkv",)),
    Container("WebM", ("webm",), (".webm",)),
    Container("AVI", ("avi",), (".avi",)),
    Container("WAV", ("wav",), (".wav",)),
)


class OtherContainer(NamedTuple):
    """One that is not read: FFmpeg seeks in it by guessing, or follows what it names.

    Attributes:
        name: for people.
        endings: of files, for documents.
        options: of ffmpeg, which make an MP4 of it.
        magic: what it begins with.
        every: the magic comes again after so many bytes, wherever the file was cut.
    """

    name: str
    endings: tuple[str, ...]
    options: tuple[str, ...]
    magic: bytes
    every: int = 0


_COPY, _ENCODE = ("-c", "copy"), ("-c:v", "libx264", "-c:a", "aac")
_TRANSPORT = ("MPEG-TS", (".ts", ".mts", ".m2ts"))
_VIDEO_COPY = ("-c:v", "copy", "-c:a", "aac")  # MP4 takes no PCM of Blu-ray
OTHERS = (
    OtherContainer(*_TRANSPORT, _VIDEO_COPY, b"G", every=192),
    OtherContainer(*_TRANSPORT, _COPY, b"G", every=188),
    OtherContainer("MPEG-PS", (".mpg", ".vob"), _COPY, b"\0\0\1\xba"),
    OtherContainer("MPEG video", (".m2v",), _COPY, b"\0\0\1\xb3"),
    OtherContainer("raw H.264 or H.265", (".h264", ".h265"), _COPY, b"\0\0\0\1"),
    OtherContainer("MXF", (".mxf",), _VIDEO_COPY, b"\6\x0e\x2b\x34"),
    OtherContainer("FLV", (".flv",), _ENCODE, b"FLV\1"),
    OtherContainer("Windows Media", (".wmv", ".asf"), _ENCODE, b"\x30\x26\xb2\x75\x8e\x66"),
    OtherContainer("Ogg", (".ogv", ".ogg"), _ENCODE, b"OggS"),
    OtherContainer("RealMedia", (".rm", ".rmvb"), _ENCODE, b".RMF"),
    OtherContainer("IVF", (".ivf",), _COPY, b"DKIF"),
    OtherContainer("HLS", (".m3u8",), _COPY, b"#EXTM3U"),
    OtherContainer("NUT", (".nut",), _COPY, b"nut/multimedia container"),
    OtherContainer("Dahua", (".dav",), _COPY, b"DHAV"),
    OtherContainer("Dahua", (".dav",), _COPY, b"DAHUA"),
    OtherContainer("Windows recorded TV", (".wtv",), _ENCODE, b"\xb7\xd8\x00\x20\x37\x49"),
    OtherContainer("Y4M", (".y4m",), _ENCODE, b"YUV4MPEG2"),
    OtherContainer("GIF", (".gif",), _ENCODE, b"GIF8"),
)  # fmt: skip

_HEAD_BYTES, _LEAST_PACKETS = 4096, 5


def refuse_others(clip: AnyClip) -> None:
    """Reject a container that is known and not read.

    Raises:
        MediaError: with the command that makes an MP4 of it.
    """
    with open_clip(clip) as stream:
        head = stream.read(_HEAD_BYTES)
    if head[4:8] in TOP:
        return
    found = next((one for one in OTHERS if _is(one, head)), None)
    if found is None:
        return
    path = Path(clip.name if isinstance(clip, ClipBytes) else clip)
    raise MediaError(
        "it is {container}, which is not read",
        where=str(path),
        remedy=Message(
            "make an MP4 of it with: {command}", command=command(path, found)
        ),
        container=found.name,
    )


def command(path: Path, container: OtherContainer) -> str:
    """What makes an MP4 beside a file, to be pasted; no file is in its way."""
    names = (f"{path.stem}{number}.mp4" for number in ("", *range(2, 1000)))
    target = next(one for one in map(path.with_name, names) if not one.exists())
    words = ("-fflags", "+genpts", "-i", path, *container.options, target)
    return shell_line("ffmpeg", *words)


def _is(one: OtherContainer, head: bytes) -> bool:
    if not one.every:
        return head.startswith(one.magic)
    places = (head[first :: one.every] for first in range(one.every))
    return any(
        len(found) >= _LEAST_PACKETS and not found.strip(one.magic) for found in places
    )
