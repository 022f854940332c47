"""What a server gives, and to whom."""

import json
import os
import socket

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import NetworkError
from hapticplayer.playback.source import open_source
from hapticplayer.streaming.offer import Offer, wanted_bytes
from hapticplayer.streaming.packets import PACKET_BYTES, decoded
from hapticplayer.untrusted import (
    CONNECTION_S,
    MAX_CONNECTIONS_OF_ONE,
    MAX_PACKETS_AT_ONCE,
)
from tests.unit.streaming.conftest import served, wait_for


def test_the_manifest_names_clip_and_force(ask, packed):
    response, content = ask("manifest.json")
    assert response.status == 200
    found = json.loads(content)
    assert found["clip"] == {"name": "ride.mkv", "size_bytes": packed.stat().st_size}
    assert found["force"]["tracks"] == ["realistic", "none", "random"]
    assert found["force"]["samples"] == 2001


def test_the_clip_comes_whole_and_in_parts(ask, packed):
    whole = packed.read_bytes()
    assert ask("clip")[1] == whole
    response, content = ask("clip", Range="bytes=100-299")
    assert (response.status, content) == (206, whole[100:300])
    assert response.getheader("Content-Range") == f"bytes 100-299/{len(whole)}"
    assert ask("clip", Range="bytes=-7")[1] == whole[-7:]
    response, content = ask("clip", Range=f"bytes={len(whole)}-")
    assert (response.status, content) == (416, b"")


@pytest.mark.parametrize(
    ("header", "wanted"),
    [
        (None, (0, 50)),
        ("bytes=0-", (0, 50)),
        ("bytes=49-80", (49, 50)),
        ("bytes=-80", (0, 50)),
        ("bytes=50-", None),
        ("bytes=9-8", None),
        ("bytes=-0", None),
        ("bytes=-", (0, 50)),
        ("bytes=0-1,3-4", (0, 50)),
        ("lines=1-2", (0, 50)),
    ],
)
def test_a_range_is_met_or_ignored(header, wanted):
    assert wanted_bytes(header, 50) == wanted


def test_force_comes_in_packets(ask, packed):
    _, content = ask("force/0/3-4")
    first, second = decoded(content, 0, 16)
    assert (first.number, second.number) == (3, 4)
    times = np.arange(3 * 128, 4 * 128) / 1000.0
    expected = open_source(packed).tracks["realistic"].at(times)
    assert np.abs(first.force_n - expected).max() < 1e-6


def test_one_answer_holds_a_limited_number_of_packets(sequence_folder):
    offer = Offer(open_source(sequence_folder))
    assert len(offer.answer("force/0/0-99999999", None).content) == 16 * PACKET_BYTES
    object.__setattr__(offer.manifest, "samples", 10_000_000)
    limited = len(offer.answer("force/0/0-99999999", None).content)
    assert limited == MAX_PACKETS_AT_ONCE * PACKET_BYTES


@pytest.mark.parametrize("token", ["", "x", "%", "A" * 22, "."])
def test_a_wrong_token_gets_nothing(ask, token):
    response, content = ask("clip", token)
    assert (response.status, content) == (403, b"")


def test_a_token_that_is_not_ascii_gets_nothing(server):
    with connected(server) as rude:
        rude.sendall("GET /\xff\xe9/clip HTTP/1.1\r\n\r\n".encode("latin-1"))
        assert rude.recv(100).startswith(b"HTTP/1.1 403")


@pytest.mark.parametrize(
    "resource",
    [
        "clip/",
        "../clip",
        "clip/../../../etc/passwd",
        "/etc/passwd",
        "force/9/0-1",
        "force/0/5-4",
        "force/0/900-901",
        "force/0/-1-2",
        "force/a/0-1",
        "sequence.json",
        "%2e%2e/clip",
    ],
)
def test_nothing_but_what_is_offered_is_found(ask, resource):
    response, content = ask(resource)
    assert (response.status, content) == (404, b"")


def test_only_reading_is_possible(ask):
    response, content = ask("clip", method="HEAD")
    assert (response.status, content) == (200, b"")
    assert ask("clip", method="PUT")[0].status == 501


def test_a_clip_that_changes_is_not_given_any_more(ask, packed):
    packed.write_bytes(b"another")
    assert ask("clip")[0].status == 410


def test_it_listens_on_this_machine_alone_unless_told(server):
    assert server.server_address[0] == "127.0.0.1"
    assert server.url.startswith(f"http://127.0.0.1:{server.server_address[1]}/")
    assert len(server.token) == 22  # 128 bits


def test_a_port_in_use_is_refused_in_one_sentence(server, packed):
    offer = Offer(open_source(packed))
    with pytest.raises(NetworkError, match=r"^127.0.0.1: cannot listen on port"):
        served(offer, port=server.server_address[1])


def test_a_clip_without_force_is_refused(tiny_clip):
    with pytest.raises(NetworkError, match="holds no force"):
        Offer(open_source(tiny_clip.path))


def connected(server):
    return socket.create_connection(server.server_address[:2], timeout=10)


@pytest.mark.parametrize("said", [b"", b"GET /", b"GET / HTTP/1.1\r\nA: b\r\n"])
def test_who_never_finishes_a_request_is_hung_up_on(packed, said):
    clock = ManualClock()
    with served(Offer(open_source(packed)), clock) as server, connected(server) as slow:
        slow.sendall(said)
        wait_for(lambda: server.connections)
        clock.advance(0.5 * CONNECTION_S)
        assert server.connections
        # its thread may have begun only now
        wait_for(lambda: clock.advance(CONNECTION_S) or not server.connections)
        assert slow.recv(100) == b""


def test_one_address_cannot_take_all_connections(server, ask):
    crowd = [connected(server) for _ in range(MAX_CONNECTIONS_OF_ONE)]
    with connected(server) as one_more:
        assert one_more.recv(100) == b""
    for one in crowd:
        one.close()
    wait_for(lambda: not server.connections)
    assert ask("manifest.json")[0].status == 200


def test_ending_hangs_up_on_everybody(packed):
    with served(Offer(open_source(packed))) as server:
        viewer = connected(server)
        wait_for(lambda: server.connections)
    assert viewer.recv(100) == b""
    viewer.close()


def test_who_takes_no_bytes_is_hung_up_on(packed, monkeypatch):
    source = open_source(packed)
    os.truncate(packed, 64 << 20)  # more than any buffer on the way
    with served(Offer(source)) as server, monkeypatch.context() as patch:
        patch.setattr(server.RequestHandlerClass, "timeout", 0.3)
        lazy = connected(server)
        lazy.sendall(f"GET /{server.token}/clip HTTP/1.1\r\n\r\n".encode())
        assert lazy.recv(15) == b"HTTP/1.1 200 OK"
        wait_for(lambda: not server.connections)
        lazy.close()


def test_noise_in_place_of_requests_does_no_harm(server, ask, rng):
    for _ in range(100):
        with connected(server) as rude:
            rude.sendall(rng.bytes(int(rng.integers(1, 300))) + b"\r\n\r\n")
            rude.shutdown(socket.SHUT_WR)
            while rude.recv(1 << 16):
                pass
    assert ask("manifest.json")[0].status == 200
