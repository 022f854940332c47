"""A clip on a server, read like a file: a few seconds ahead of what decoders ask for."""

import io
import itertools
import os
from collections import OrderedDict
from typing import Any, BinaryIO

from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError, MediaError, Message, message_of
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.streaming.client import Aborted, StreamAddress, Unreachable
from hapticplayer.streaming.fetch_thread import FetchThread
from hapticplayer.streaming.manifest import Manifest
from hapticplayer.untrusted import MAX_BYTES_AT_ONCE, MAX_BYTES_KEPT, PATIENCE_S

BLOCK_BYTES = 128 << 10
FIRST_BLOCKS = 2
"""Of the first answer; the others are as large as the network is fast."""
MOST_BLOCKS = MAX_BYTES_AT_ONCE // BLOCK_BYTES
"""Of one answer."""
KEPT_BLOCKS = MAX_BYTES_KEPT // BLOCK_BYTES
"""In memory."""
AHEAD_BLOCKS = 2 * MOST_BLOCKS
"""8 MB ahead of each decoder: 8 s of 8 Mbit/s."""

_FAST_S, _SLOW_S = 0.6, 1.2
"""Answers that take less are asked for twice as large, those that take more for half."""

_RETRY_S = 0.2


class RemoteClip(FetchThread, ClipBytes):
    """Fetches blocks in a thread of its own and keeps the latest 64 MB; `close` ends it."""

    def __init__(
        self, address: StreamAddress, manifest: Manifest, clock: Clock
    ) -> None:
        ClipBytes.__init__(self, manifest.clip_name, manifest.clip_bytes)
        FetchThread.__init__(self, address, clock, "clip-fetch")
        self._clock = clock
        self._blocks: OrderedDict[int, bytes] = OrderedDict()
        self._count = -(-self.size_bytes // BLOCK_BYTES)
        self._wanted: dict[int, int] = {}  # block by reader, the latest last
        self._readers = itertools.count()
        self._waiting: dict[int, int] = {}
        self._under_way = range(0)
        self._at_once = FIRST_BLOCKS
        self._problem: HapticPlayerError | None = None
        self._thread.start()

    def open(self) -> BinaryIO:
        """Return a reader from the beginning, for one thread; it raises MediaError."""
        return io.BufferedReader(_ClipReader(self, next(self._readers)))

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

    def _wait_for(self, reader: int, number: int) -> None:
        """Wait for a block, ahead of what nobody waits for."""
        self._waiting[reader] = number
        is_coming = any(block in self._under_way for block in self._waiting.values())
        if self._under_way and not is_coming:
            self._client.abort()
        until_s = self._clock.now_s() + PATIENCE_S
        try:
            while number not in self._blocks:
                left_s = until_s - self._clock.now_s()
                if self._is_closed or self._problem or left_s <= 0.0:
                    raise self._failure()
                self._news.wait(left_s)
        finally:
            del self._waiting[reader]

    def is_ahead(self, count_bytes: float) -> bool:
        """Whether so much of what decoders will read next is there, or nothing comes."""
        blocks = min(int(count_bytes / BLOCK_BYTES) + 1, AHEAD_BLOCKS // 2)
        with self._news:
            if self._problem or self._is_closed:
                return True
            return not any(self._missing(k, blocks) for k in self._wanted.values())

    def forget(self, reader: int) -> None:
        """Fetch nothing for a reader any more."""
        with self._news:
            self._wanted.pop(reader, None)

    def _failure(self) -> MediaError:
        why = Message("the server has not answered for {s:g} s", s=PATIENCE_S)
        if self._problem:
            why = message_of(self._problem)
        return MediaError(
            "cannot be fetched ({reason})",
            where=self.name,
            remedy="check the network, then start again",
            reason=why,
        )

    def _run(self) -> None:
        while (span := self._next()) is not None:
            begun_s = self._clock.now_s()
            first, end = span
            at, size = first * BLOCK_BYTES, self.size_bytes
            until = min(end * BLOCK_BYTES, size)
            try:
                content = self._client.get("clip", until - at, (at, until, size))
            except Aborted:
                continue
            except Unreachable:
                self._at_once = max(self._at_once // 2, 1)
                self._wait(_RETRY_S)
            except HapticPlayerError as problem:
                with self._news:
                    self._problem = problem
                    self._news.notify_all()
                return
            else:
                self._keep(first, content)
                self._adapt(self._clock.now_s() - begun_s, end - first)

    def _next(self) -> tuple[int, int] | None:
        """Return the next blocks to fetch, None at the end."""
        with self._news:
            while not self._is_closed:
                # who asked last waits most probably; then what lies ahead of each
                for ahead in (1, AHEAD_BLOCKS):
                    for wanted in reversed(self._wanted.values()):
                        if span := self._missing(wanted, ahead):
                            self._under_way = range(*span)
                            return span
                self._under_way = range(0)
                self._news.wait()
            return None

    def _missing(self, wanted: int, ahead: int) -> tuple[int, int] | None:
        """Return the first run of blocks that are not there."""
        end = min(wanted + ahead, self._count)
        first = next((k for k in range(wanted, end) if k not in self._blocks), None)
        if first is None:
            return None
        most = min(first + self._at_once, self._count)
        rest = range(first + 1, most)
        return first, next((k for k in rest if k in self._blocks), most)

    def _keep(self, first: int, content: bytes) -> None:
        with self._news:
            for at in range(0, len(content), BLOCK_BYTES):
                number = first + at // BLOCK_BYTES
                self._blocks[number] = content[at : at + BLOCK_BYTES]
            while len(self._blocks) > KEPT_BLOCKS:
                self._blocks.popitem(last=False)
            self._news.notify_all()

    def _adapt(self, took_s: float, blocks: int) -> None:
        if took_s < _FAST_S:
            self._at_once = min(2 * max(blocks, self._at_once), MOST_BLOCKS)
        elif took_s > _SLOW_S:
            self._at_once = max(blocks // 2, 1)


class _ClipReader(io.RawIOBase):
    """Reads a clip from one place after the other."""

    def __init__(self, clip: RemoteClip, number: int) -> None:
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
