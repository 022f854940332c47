"""The line between player and loop: messages, their order, and the end."""

import socket

import pytest

from hapticplayer.errors import Message
from hapticplayer.haptics.messages import MessageKind, MessageSocket


@pytest.fixture
def ends():
    """The player's line and the loop's."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    player, loop = MessageSocket(ours), MessageSocket(theirs)
    yield player, loop
    player.close()
    loop.close()


def test_messages_that_come_together_are_received_one_by_one(ends):
    player, loop = ends
    for number in range(9):
        player.send(MessageKind.FORGET, str(number))
    received = [loop.receive() for _ in range(9)]
    assert [message.text for message in received] == [str(n) for n in range(9)]
    assert loop.receive() is None
    assert loop.is_open


def test_a_sentence_keeps_its_template_and_values(ends):
    player, loop = ends
    loop.send(MessageKind.LOST, Message("{device} is gone", device="falcon"))
    text = player.receive().text
    assert (text, text.template) == ("falcon is gone", "{device} is gone")


def test_a_hung_up_line_is_noticed_at_the_next_call(ends):
    player, loop = ends
    player.close()
    assert loop.receive() is None
    assert not loop.is_open
    assert not loop.send(MessageKind.READY, "fifo")


def test_last_words_are_read_after_a_send_that_failed(ends):
    player, loop = ends
    loop.send(MessageKind.FAILED, Message("no Falcon is plugged in"))
    loop.close()
    assert not player.send(MessageKind.TRACK, "1")
    assert player.receive().text == "no Falcon is plugged in"
    assert player.receive() is None
    assert not player.is_open


def fill(player):
    count = 0
    while player.send(MessageKind.FORGET, "1"):
        count += 1
    return count


def test_a_stop_waits_while_the_line_is_full_and_is_sent(ends):
    player, loop = ends
    count = fill(player)
    player.insist(MessageKind.STOP)
    for _ in range(count):
        assert loop.receive().word is MessageKind.FORGET
    assert loop.receive() is None
    player.receive()
    assert loop.receive().word is MessageKind.STOP
    player.receive()
    assert loop.receive() is None  # sent once


def test_of_a_stop_and_a_rearm_that_wait_the_newer_is_sent(ends):
    player, loop = ends
    count = fill(player)
    player.insist(MessageKind.REARM)
    player.insist(MessageKind.STOP)
    for _ in range(count):
        loop.receive()
    player.receive()
    assert loop.receive().word is MessageKind.STOP
    assert loop.receive() is None
