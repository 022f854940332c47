"""A bad network between a stream's server and its viewers."""

import math
import threading
from collections.abc import Iterable
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPException
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Self

import numpy as np

from hapticplayer.clock import Clock
from hapticplayer.streaming.client import StreamAddress
from hapticplayer.streaming.manifest import MANIFEST
from hapticplayer.streaming.packets import PACKET_BYTES
from hapticplayer.streaming.server import LOOPBACK
from hapticplayer.untrusted import ANSWER_S

_KEPT_HEADERS = ("Content-Type", "Content-Range", "Accept-Ranges")


@dataclass(frozen=True, slots=True)
class NetworkFaults:
    """What goes wrong with answers; the manifest always comes through.

    Attributes:
        lost: share of the packets of force, and of whole answers, that are lost each time.
        gone: share of the packets of force that never come, however often asked for.
        delay_s: by which every answer is later.
        is_reordered: the packets of an answer come in any order.
        damaged: share of the packets of force with one wrong bit.
        bytes_per_s: that come through, of each connection.
    """

    lost: float = 0.0
    gone: float = 0.0
    delay_s: float = 0.0
    is_reordered: bool = False
    damaged: float = 0.0
    bytes_per_s: float = math.inf


class BadNetwork(ThreadingHTTPServer):
    """Passes requests on to a server and does what `faults` say to its answers.

    Args:
        url: of the stream.
        faults: may be replaced while it runs.
        clock: to wait with.
        seed: of what is lost.

    Attributes:
        holds: "clip" or "force": answers with that wait until it is something else.
    """

    daemon_threads = True

    def __init__(
        self, url: str, faults: NetworkFaults, clock: Clock, seed: int = 1
    ) -> None:
        super().__init__((LOOPBACK, 0), _BadNetworkHandler)
        self.address, self.faults, self.clock = StreamAddress.of(url), faults, clock
        self.holds = ""
        self._seed, self._rng = seed, np.random.default_rng(seed)
        self._lock = threading.Lock()  # a generator is for one thread at a time
        self._thread = threading.Thread(target=self.serve_forever, args=(0.02,))

    @property
    def url(self) -> str:
        """Return the address of the stream behind this network."""
        host, port = self.server_address[:2]
        return f"http://{host!s}:{port}/{self.address.token}/{MANIFEST}"

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.holds = ""
        self.shutdown()
        self._thread.join()
        self.server_close()

    def happens(self, share: float) -> bool:
        """Whether something that is that frequent happens now."""
        with self._lock:
            return bool(self._rng.random() < share)

    def force_of(self, content: bytes, first: int) -> bytes:
        """Return what comes through of packets, the first of which has a number."""
        faults = self.faults
        cut = range(0, len(content), PACKET_BYTES)
        packets = [
            self._damaged(content[at : at + PACKET_BYTES])
            for number, at in enumerate(cut, start=first)
            if not self.happens(faults.lost) and not self._is_gone(number)
        ]
        if faults.is_reordered:
            with self._lock:
                self._rng.shuffle(packets)
        return b"".join(packets)

    def _is_gone(self, number: int) -> bool:
        drawn = np.random.default_rng([self._seed, number]).random()
        return bool(drawn < self.faults.gone)

    def _damaged(self, packet: bytes) -> bytes:
        if not self.happens(self.faults.damaged):
            return packet
        with self._lock:
            at = int(self._rng.integers(len(packet)))
        return packet[:at] + bytes([packet[at] ^ 1]) + packet[at + 1 :]

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing of viewers who hang up."""


class _BadNetworkHandler(BaseHTTPRequestHandler):
    server: BadNetwork
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True

    def do_GET(self) -> None:
        network = self.server
        status, headers, content = self._ask()
        kind, *place = self.path.split("/")[2:]
        if kind != MANIFEST:
            self._wait(kind, len(content))
            if network.happens(network.faults.lost):
                self.close_connection = True
                return
        if kind == "force":
            content = network.force_of(content, int(place[1].partition("-")[0]))
        self._send(status, headers, content)

    def _ask(self) -> tuple[int, Iterable[tuple[str, str]], bytes]:
        address = self.server.address
        connection = HTTPConnection(address.host, address.port, timeout=ANSWER_S)
        span = self.headers.get("Range")
        try:
            connection.request(
                "GET", self.path, headers={"Range": span} if span else {}
            )
            with connection.getresponse() as response:
                kept = [(k, v) for k, v in response.getheaders() if k in _KEPT_HEADERS]
                return response.status, kept, response.read()
        except (OSError, HTTPException):
            return 502, (), b""
        finally:
            connection.close()

    def _wait(self, kind: str, size_bytes: int) -> None:
        clock, faults = self.server.clock, self.server.faults
        wait_s = faults.delay_s + size_bytes / faults.bytes_per_s
        clock.sleep_until(clock.now_s() + wait_s)
        while self.server.holds == kind:
            clock.sleep_until(clock.now_s() + 0.02)

    def _send(
        self, status: int, headers: Iterable[tuple[str, str]], content: bytes
    ) -> None:
        self.send_response(status)
        for name, value in (*headers, ("Content-Length", str(len(content)))):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002
        """Log nothing."""
