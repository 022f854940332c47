"""Opens the address of a stream as a source that can be played."""

from pathlib import Path

from hapticplayer.clock import Clock
from hapticplayer.errors import Message, NetworkError
from hapticplayer.media.clip_info import probe
from hapticplayer.playback.source import Source, no_feedback_for
from hapticplayer.streaming.client import StreamAddress, StreamClient, Unreachable
from hapticplayer.streaming.force_fetch import ForceFetch
from hapticplayer.streaming.manifest import MANIFEST, Manifest, read_manifest
from hapticplayer.streaming.remote_clip import RemoteClip
from hapticplayer.untrusted import MAX_MANIFEST_BYTES

SCHEMES = ("http://", "https://")


class Stream:
    """The clip and the force of a stream while it is played; see `ForceStream`."""

    def __init__(
        self, address: StreamAddress, manifest: Manifest, clock: Clock
    ) -> None:
        self.force = ForceFetch(address, manifest, clock)
        self.clip = RemoteClip(address, manifest, clock)
        self.tracks = self.force.tracks

    @property
    def problem(self) -> Message | None:
        """Why no force comes any more, None while it does."""
        problem = self.force.problem
        return problem.args[0] if problem else None

    def follow(self, feedback: str, media_s: float) -> bool:
        """Fetch what is felt from a position on; return whether it is there."""
        self.force.follow(feedback, media_s)
        return self.force.has(feedback, media_s)

    def is_ahead(self, seconds: float, duration_s: float) -> bool:
        """Whether the clip may play for so long, as far as its bytes tell."""
        return self.clip.is_ahead(seconds * self.clip.size_bytes / duration_s)

    def close(self) -> None:
        """Ask for nothing any more."""
        self.clip.close()
        self.force.close()


def is_address(text: str) -> bool:
    """Whether a text names something on a network, not a file."""
    return text.lower().startswith(SCHEMES)


def open_stream(url: str, clock: Clock) -> Source:
    """Return what is served at an address; the player that opens it closes its stream.

    Raises:
        NetworkError: when it cannot be reached, or is not a stream.
        MediaError: when its clip cannot be shown.
    """
    address = StreamAddress.of(url)
    stream = Stream(address, manifest := _manifest(address, clock), clock)
    try:
        clip = probe(stream.clip)
    except BaseException:
        stream.close()
        raise
    return Source(
        manifest.title,
        Path(manifest.clip_name),
        clip,
        dict.fromkeys(manifest.tracks, no_feedback_for(clip)),
        None,
        manifest.feedback,
        stream=stream,
    )


def _manifest(address: StreamAddress, clock: Clock) -> Manifest:
    client = StreamClient(address, clock)
    try:
        content = client.get(MANIFEST, MAX_MANIFEST_BYTES)
    except Unreachable as problem:
        raise NetworkError(
            "cannot be reached ({reason})",
            where=str(address),
            remedy="check the address, and that `hapticplayer serve` runs there",
            reason=str(problem),
        ) from problem
    finally:
        client.drop()
    return read_manifest(content, f"{address}: {MANIFEST}")
