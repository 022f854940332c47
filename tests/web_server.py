"""A web server for tests that does wrong what real ones do wrong."""

import ssl
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from hapticplayer.clock import SystemClock

PIECE_BYTES = 16 << 10


def wait_for(condition):
    """Wait until something holds."""
    clock = SystemClock()
    end_s = clock.now_s() + 30.0
    while not condition():
        assert clock.now_s() < end_s, "it did not happen"
        clock.sleep_until(clock.now_s() + 0.002)


class WebServer(ThreadingHTTPServer):
    """Serves contents by path within a `with` block.

    Attributes:
        asked: path and range of each request.
        gate: answers wait while it is not set.
        gives_ranges: else each answer is the whole file.
        most_bytes: of an answer before the connection breaks.
        lies: headers by name in place of the true ones; None leaves one out.
        statuses: of the next answers, in place of theirs.
        moved: by path, where to.
        round_trip_s: by which each answer is later.
    """

    daemon_threads = True

    def __init__(self, contents, context: ssl.SSLContext | None = None):
        super().__init__(("127.0.0.1", 0), _Handler)
        self.contents, self.clock = contents, SystemClock()
        self.asked, self.statuses, self.moved, self.lies = [], [], {}, {}
        self.gate = threading.Event()
        self.gate.set()
        self.gives_ranges, self.most_bytes, self.round_trip_s = True, None, 0.0
        self._thread = threading.Thread(target=self.serve_forever, args=(0.01,))
        self._scheme = "http"
        if context is not None:
            self._scheme = "https"
            self.socket = context.wrap_socket(self.socket, server_side=True)

    def url(self, path="/ride.mkv", host="127.0.0.1"):
        return f"{self._scheme}://{host}:{self.server_address[1]}{path}"

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self.gate.set()
        self.shutdown()
        self._thread.join()
        self.server_close()

    def handle_error(self, request, client_address):
        """Say nothing of viewers who hang up."""


class _Handler(BaseHTTPRequestHandler):
    server: WebServer
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True

    def do_GET(self):
        server, path = self.server, self.path.partition("?")[0]
        server.asked.append((self.path, self.headers.get("Range", "")))
        server.clock.sleep_until(server.clock.now_s() + server.round_trip_s)
        server.gate.wait()
        content = server.contents.get(path)
        if path in server.moved:
            self._send(302, b"", {"Location": server.moved[path]})
        elif server.statuses:
            self._send(server.statuses.pop(0), b"", {})
        elif content is None:
            self._send(404, b"", {})
        else:
            self._send_part(content)

    def _send_part(self, content):
        wanted = self.headers.get("Range", "") if self.server.gives_ranges else ""
        begin, _, last = wanted.removeprefix("bytes=").partition("-")
        begin, end = int(begin or 0), min(int(last or len(content)) + 1, len(content))
        headers = {"ETag": f'"{len(content)}"'}
        if wanted:
            headers["Content-Range"] = f"bytes {begin}-{end - 1}/{len(content)}"
        self._send(206 if wanted else 200, content[begin:end], headers)

    def _send(self, status, body, headers):
        headers = {"Content-Length": str(len(body)), **headers, **self.server.lies}
        self.send_response(status)
        for name, value in headers.items():
            if value is not None:
                self.send_header(name, value)
        self.end_headers()
        for at in range(0, len(body), PIECE_BYTES):
            self.server.gate.wait()
            if self.server.most_bytes is not None and at >= self.server.most_bytes:
                self.close_connection = True
                return
            self.wfile.write(body[at : at + PIECE_BYTES])

    def log_message(self, *_):
        """Log nothing."""
