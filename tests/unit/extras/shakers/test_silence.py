"""A process that has died is cut off from its sound server or card by its guard."""

import contextlib
import fcntl
import os
import socket

import pytest

from hapticplayer.extras.shakers import silence
from hapticplayer.extras.shakers.silence import (
    hand_over_sound,
    open_files,
)


@pytest.fixture
def line():
    loop, guard = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with loop, guard:
        yield loop.fileno(), guard.fileno()


@pytest.fixture
def server(tmp_path):
    path = str(tmp_path / "native")
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(path)
        made.listen()
        yield made, path


def test_the_server_sees_the_end_of_an_open_client(line, server):
    listening, path = server
    before = open_files()
    with contextlib.ExitStack() as stack:
        for end in socket.socketpair():  # what a client has for itself
            stack.enter_context(end)
        client = stack.enter_context(socket.socket(socket.AF_UNIX))
        client.connect(path)
        served = stack.enter_context(listening.accept()[0])
        hand_over_sound(line[0], before | {served.fileno()})
        cut = silence.silence(line[1])
        client.send(b"sound")
        assert served.recv(10) == b"sound"
        assert cut()
        assert served.recv(10) == b""
        assert not cut()  # there is none left


def test_a_connection_from_before_stays_with_its_owner(line, server):
    _, path = server
    with socket.socket(socket.AF_UNIX) as client:
        client.connect(path)
        before = open_files()
        a, b = socket.socketpair()
        with a, b:
            hand_over_sound(line[0], before)
        assert not silence.silence(line[1])()
        client.send(b"still open")


def test_a_card_without_a_server_is_told_to_drop(line, tmp_path, monkeypatch):
    card, asked = tmp_path / "pcmC0D0p", []
    card.touch()
    monkeypatch.setattr(silence, "CARD", str(card))
    monkeypatch.setattr(fcntl, "ioctl", lambda file, what: asked.append((file, what)))
    before = open_files()
    with card.open() as file:
        hand_over_sound(line[0], before)
        assert silence.silence(line[1])()
        ((taken, request),) = asked
        assert taken != file.fileno()
    assert request == ord("A") << 8 | 0x43  # _IO('A', 0x43) of sound/asound.h
    with pytest.raises(OSError, match="Bad file"):
        os.fstat(taken)


def test_a_sound_card_that_refuses_is_left_alone(line, tmp_path, monkeypatch):
    card = tmp_path / "pcmC0D0p"
    card.touch()
    monkeypatch.setattr(silence, "CARD", str(card))
    before = open_files()
    with card.open():
        hand_over_sound(line[0], before)
    assert not silence.silence(line[1])()  # a plain file knows no such request
    assert not silence.silence(-1)()
    hand_over_sound(-1, before)
