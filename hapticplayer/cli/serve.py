"""The command `serve`: a felt video for others on this machine or a local network."""

import argparse
import json
import sys
from pathlib import Path

from hapticplayer.cli.common import (
    add_accept_changed,
    add_number,
    interruptible,
    say,
    say_aside,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import NetworkError
from hapticplayer.model import ranges
from hapticplayer.playback.source import Source, open_source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.streaming.offer import Offer
from hapticplayer.streaming.server import LOOPBACK, StreamServer


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "source", metavar="FILE", help="a file that was packed, or a sequence"
    )
    command.add_argument(
        "--bind",
        metavar="ADDRESS",
        default=LOOPBACK,
        help="address of this machine to listen on, 0.0.0.0 for all of them: then "
        "whoever has the URL can watch from the network, and nothing is encrypted "
        f"(default: {LOOPBACK}, only this machine)",
    )
    add_number(
        command,
        "--port",
        ranges.PORT,
        default=0,
        metavar="N",
        help="port to listen on (default: any that is free)",
    )
    add_accept_changed(command)
    command.add_argument("--json", action="store_true", help="print the URL as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Serve until Ctrl-C."""
    source = open_source(Path(options.source))
    _refuse_another(source, is_accepted=options.accept_changed_video)
    with (
        StreamServer(
            Offer(source), SystemClock(), options.bind, int(options.port)
        ) as server,
        interruptible(),
    ):
        try:
            _announce(server, source, options)
            server.serve_forever(poll_interval=0.2)
        except KeyboardInterrupt:
            say_aside("stopped")
    return 0


def _refuse_another(source: Source, *, is_accepted: bool) -> None:
    if source.check and not is_accepted and source.check.wait() is Verdict.ANOTHER:
        raise NetworkError(
            "is not the video that its force was made for (its checksum differs)",
            where=str(source.path),
            remedy="ask for the file again, or agree with --accept-changed-video",
        )


def _announce(
    server: StreamServer, source: Source, options: argparse.Namespace
) -> None:
    if source.clip.has_telemetry:
        say_aside(
            "the clip holds the camera's own motion track, which may name places; "
            "`pack` leaves it out"
        )
    if not options.bind.startswith("127.") and options.bind not in ("::1", "localhost"):
        say_aside(
            "whoever on the network has this URL can watch and feel the clip; nothing "
            "is encrypted"
        )
    if options.json:
        say(json.dumps({"title": source.title, "url": server.url}))
    else:
        say(f"{source.title} is served until Ctrl-C; to play it:")
        say(f"  hapticplayer play --allow-network {server.url}")
    sys.stdout.flush()  # it may be a pipe, and nothing follows
