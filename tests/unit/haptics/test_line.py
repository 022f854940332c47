"""The line between player and loop: what is heard when, and how often it is asked for."""

import os
import socket

import pytest

from hapticplayer.haptics.messages import RESTS, Line, Word


class Ends:
    """A player's line, a loop's, and how often the loop's asks the kernel."""

    def __init__(self):
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.raw, self.memory = ours, memoryview(bytearray(8)).cast("Q")
        self.player = Line(ours, outbox=self.memory)
        self.loop = Line(theirs, inbox=self.memory)
        self.asked, real = 0, self.loop._poll

        class Poll:
            """The line's, counted."""

            @staticmethod
            def poll(timeout_ms):
                self.asked += 1
                return real.poll(timeout_ms)

        self.loop._poll = Poll

    def close(self):
        self.player.close()
        self.loop.close()


@pytest.fixture
def ends():
    made = Ends()
    yield made
    made.close()


def test_an_idle_line_asks_the_kernel_at_every_fourth_call(ends):
    for _ in range(400):
        assert ends.loop.receive() is None
    assert ends.asked == 400 / (RESTS + 1)


@pytest.mark.parametrize("phase", range(RESTS + 1))
def test_a_message_is_heard_at_the_next_call(ends, phase):
    for _ in range(phase):
        ends.loop.receive()
    ends.player.send(Word.STOP)
    message = ends.loop.receive()
    assert message is not None
    assert message.word is Word.STOP


def test_messages_that_come_together_are_heard_in_a_row(ends):
    for number in range(9):
        ends.player.send(Word.FORGET, str(number))
    heard = [ends.loop.receive() for _ in range(9)]
    assert [message.text for message in heard] == [str(n) for n in range(9)]
    assert ends.loop.receive() is None


def test_a_message_on_its_way_before_it_is_counted_is_not_lost(ends):
    ends.loop.receive()
    ends.raw.send(Word.STOP.value)  # sent, and the player is killed before it counts
    heard = [ends.loop.receive() for _ in range(RESTS + 1)]
    assert [m.word for m in heard if m is not None] == [Word.STOP]


@pytest.mark.parametrize("phase", range(RESTS + 1))
def test_a_hung_up_line_is_noticed_at_the_next_call(ends, phase):
    for _ in range(phase):
        ends.loop.receive()
    ends.player.close()
    ends.loop.receive()
    assert not ends.loop.is_open


@pytest.mark.parametrize("phase", range(RESTS + 1))
def test_the_end_of_a_dead_player_is_noticed_at_the_fourth_call(ends, phase):
    for _ in range(phase):
        ends.loop.receive()
    os.close(ends.raw.detach())  # what the kernel does; nobody counts
    for _ in range(RESTS + 1):
        ends.loop.receive()
    assert not ends.loop.is_open


def test_a_line_without_an_inbox_asks_at_each_call():
    first, second = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    plain, other = Line(first), Line(second)
    other.send(Word.QUIT)
    message = plain.receive()
    assert message is not None
    assert message.word is Word.QUIT
    other.close()
    plain.receive()
    assert not plain.is_open
    plain.close()
