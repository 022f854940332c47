"""A clip on a web server, read like a file: some seconds ahead of what decoders ask for."""

import io
import itertools
import os
import threading
from collections import OrderedDict
from typing import Any, BinaryIO, Self
from urllib.parse import quote, urljoin

from hapticplayer.clock import Clock
from hapticplayer.errors import MediaError, Message, message_of
from hapticplayer.extras.web.http_range import (
    Aborted,
    NetworkError,
    NotOfferedError,
    RangeClient,
    Unreachable,
)
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.untrusted import PATIENCE_S

BLOCK_BYTES = 128 << 10
FEW_BLOCKS = 2
"""Fetched first; and where so little is to come still, no answer is given up."""
KEPT_BLOCKS = (64 << 20) // BLOCK_BYTES  # of a clip in memory
AHEAD_BLOCKS = 64
"""8 MB ahead of each decoder: 8 s of 8 Mbit/s; so much is asked for at once, and each
block is read as soon as it is there."""

_RETRY_S, _SLOWEST_RETRY_S = 0.1, 2.0
_NOTICED_S = 1.0  # a wait that is shorter needs no words


class HttpClip(ClipBytes):
    """Fetches blocks in a thread of its own and keeps the latest 64 MB; `close` ends it.

    What does not come is asked for again until it does. `waiting` says why meanwhile.

    Args:
        url: of the file.
        clock: of the machine.

    Raises:
        NetworkError: when the server cannot be reached, or does not offer its parts.
    """

    def __init__(self, url: str, clock: Clock) -> None:
        self._client, self._clock = RangeClient(url), clock
        self._blocks: OrderedDict[int, bytes] = OrderedDict()
        self._news = threading.Condition()
        self._wanted: dict[int, int] = {}  # block by reader, the latest last
        self._readers = itertools.count()
        self._waits: dict[int, int] = {}  # block by reader that waits for it
        self._under_way, self._heard_s = range(0), 0.0
        self._failure: Message | None = None
        self._is_closed = False
        try:
            self._fetch(range(FEW_BLOCKS))
        except Unreachable as problem:
            raise NetworkError(
                "cannot be reached ({reason})",
                where=self._client.where,
                remedy="check the address and the network",
                reason=problem.args[0],
            ) from problem
        assert self._client.version is not None
        super().__init__(self._client.name, self._client.version.size_bytes)
        self._count = -(-self.size_bytes // BLOCK_BYTES)
        threading.Thread(target=self._run, name="clip-fetch", daemon=True).start()

    def open(self) -> BinaryIO:
        """Return a reader from the beginning, for one thread; it raises MediaError."""
        return io.BufferedReader(_ClipReader(self, next(self._readers)))

    def beside(self, name: str) -> Self | None:
        """Return the file of a name in the same folder of the server, None without one."""
        url = self._client.url
        query = url.partition("?")[2]
        there = urljoin(url, quote(name)) + (f"?{query}" if query else "")
        try:
            return type(self)(there, self._clock)
        except NotOfferedError:
            return None

    def is_ahead(self, share: float) -> bool:
        """Whether such a share of the clip can be read next without waiting."""
        blocks = min(int(share * self.size_bytes / BLOCK_BYTES) + 1, AHEAD_BLOCKS // 2)
        with self._news:
            if self._is_closed:
                return True
            return not any(self._missing(k, blocks) for k in self._wanted.values())

    @property
    def waiting(self) -> Message | None:
        """Why the next bytes do not come, None while they do."""
        with self._news:
            quiet_s = self._clock.now_s() - self._heard_s
            if self._failure or not self._under_way or quiet_s < _NOTICED_S:
                return self._failure
        return Message("{where}: waiting for the server", where=self._client.where)

    def close(self) -> None:
        """Ask for nothing any more; readers fail from now on."""
        with self._news:
            self._is_closed = True
            self._news.notify_all()
        self._client.close()

    # --- for readers ------------------------------------------------------------

    def block(self, reader: int, number: int) -> bytes:
        """Return a block, once it is there.

        Raises:
            MediaError: when it does not come.
        """
        with self._news:
            self._wanted.pop(reader, None)
            self._wanted[reader] = number
            self._news.notify_all()
            if number not in self._blocks:
                self._wait_for(reader, number)
            self._blocks.move_to_end(number)
            return self._blocks[number]

    def forget(self, reader: int) -> None:
        """Fetch nothing for a reader any more."""
        with self._news:
            self._wanted.pop(reader, None)

    def _wait_for(self, reader: int, number: int) -> None:
        """Wait for a block, ahead of what nobody waits for."""
        begun_s = self._clock.now_s()
        self._waits[reader] = number
        is_coming = any(block in self._under_way for block in self._waits.values())
        if len(self._under_way) > FEW_BLOCKS and not is_coming:
            self._client.abort()
        try:
            while number not in self._blocks:
                left_s = begun_s + self.patience_s - self._clock.now_s()
                if self._is_closed or left_s <= 0.0:
                    raise MediaError(
                        "cannot be fetched ({reason})",
                        where=self.name,
                        remedy="check the network, then open it again",
                        reason=self._failure or Message("the server does not answer"),
                    )
                self._news.wait(min(left_s, PATIENCE_S))
        finally:
            del self._waits[reader]

    # --- the thread that fetches ------------------------------------------------

    def _run(self) -> None:
        failures = 0
        while (blocks := self._next()) is not None:
            try:
                self._fetch(blocks)
            except Aborted:
                continue
            except (Unreachable, NetworkError) as problem:
                failures += 1
                self._pause(problem, min(_RETRY_S * 2.0**failures, _SLOWEST_RETRY_S))
            else:
                failures = 0
        self._client.drop()

    def _pause(self, problem: Exception, duration_s: float) -> None:
        """Note why nothing comes, and wait until it is worth asking again."""
        why = message_of(problem)
        if isinstance(problem, Unreachable):
            why = Message("{where}: {reason}", where=self._client.where, reason=why)
        with self._news:
            self._failure = why
            self._news.wait_for(lambda: self._is_closed, duration_s)

    def _next(self) -> range | None:
        """Return the next blocks to fetch, None at the end."""
        with self._news:
            while not self._is_closed:
                # who asked last waits most probably; then what lies ahead of each
                for ahead in (1, AHEAD_BLOCKS):
                    for wanted in reversed(self._wanted.values()):
                        if blocks := self._missing(wanted, ahead):
                            return blocks
                self._news.wait()
            return None

    def _missing(self, wanted: int, ahead: int) -> range | None:
        """Return the first run of blocks that are not there."""
        end = min(wanted + ahead, self._count)
        first = next((k for k in range(wanted, end) if k not in self._blocks), None)
        if first is None:
            return None
        most = min(wanted + AHEAD_BLOCKS, self._count)
        rest = range(first + 1, most)
        return range(first, next((k for k in rest if k in self._blocks), most))

    def _fetch(self, blocks: range) -> None:
        with self._news:
            self._under_way, self._heard_s = blocks, self._clock.now_s()
        try:
            for number, content in enumerate(
                self._client.part(
                    blocks.start * BLOCK_BYTES, blocks.stop * BLOCK_BYTES, BLOCK_BYTES
                ),
                blocks.start,
            ):
                self._keep(number, content)
        finally:
            with self._news:
                self._under_way = range(0)

    def _keep(self, number: int, content: bytes) -> None:
        with self._news:
            self._blocks[number] = content
            self._under_way = range(number + 1, self._under_way.stop)
            self._failure, self._heard_s = None, self._clock.now_s()
            while len(self._blocks) > KEPT_BLOCKS:
                self._blocks.popitem(last=False)
            self._news.notify_all()


class _ClipReader(io.RawIOBase):
    """Reads a clip from one place after the other."""

    def __init__(self, clip: HttpClip, number: int) -> None:
        super().__init__()
        self._clip, self._number, self._at = clip, number, 0

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._at

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        begin = {
            os.SEEK_SET: 0,
            os.SEEK_CUR: self._at,
            os.SEEK_END: self._clip.size_bytes,
        }[whence]
        self._at = max(0, begin + offset)
        return self._at

    def readinto(self, buffer: Any) -> int:
        target = memoryview(buffer)
        if self._at >= self._clip.size_bytes or not target:
            return 0
        number, at = divmod(self._at, BLOCK_BYTES)
        part = self._clip.block(self._number, number)[at : at + len(target)]
        target[: len(part)] = part
        self._at += len(part)
        return len(part)

    def close(self) -> None:
        if not self.closed:
            self._clip.forget(self._number)
        super().close()
