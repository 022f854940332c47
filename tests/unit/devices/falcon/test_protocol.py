"""Frames against golden vectors; the parser against noise and any chunking."""

import itertools
import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.devices.falcon.protocol import (
    CommandParser,
    Lights,
    Reply,
    ReplyParser,
    encode_command,
    encode_reply,
)

word = st.integers(-0x8000, 0x7FFF)
replies = st.builds(
    Reply, st.tuples(word, word, word), st.integers(0, 15), st.integers(0, 7)
)


def test_golden_frames_are_exact_both_ways(golden):
    assert len(golden["frames"]) == 7
    for words, light, homing, digits, text in golden["frames"]:
        frame = encode_command(tuple(words), light | homing)
        assert frame.hex() == digits
        assert frame == text.encode()
        assert CommandParser().feed(frame) == [(tuple(words), light | homing)]


def test_golden_replies_are_exact_both_ways(golden):
    assert len(golden["replies"]) == 4
    for counts, homed, buttons, digits in golden["replies"]:
        (reply,) = ReplyParser().feed(bytes.fromhex(digits))
        assert reply == (tuple(counts), buttons, homed)
        assert reply.is_homed == (homed == 7)
        assert encode_reply(reply).hex() == digits


def test_a_word_is_its_nibbles_from_the_least_significant():
    """By hand: -1447 = 0xFA59 gives 9, 5, A, F."""
    (reply,) = ReplyParser().feed(b"<JFKPHKFAPPPP\xb1A>")
    assert reply.counts == (-1447, 1447, -1)
    assert encode_command((0x1234, 0, 0))[1:5] == b"EDCB"


def test_lights_and_buttons_have_their_bits():
    frame = encode_command((0, 0, 0), Lights.HOMING | Lights.BLUE)
    assert frame == b"<AAAAAAAAAAAAFA>"
    assert ReplyParser().feed(b"<AAAAAAAAAAAAEA>") == [Reply((0, 0, 0), 4, 0)]


@given(replies)
def test_replies_come_back_as_they_were(reply):
    assert ReplyParser().feed(encode_reply(reply)) == [reply]


@given(st.tuples(word, word, word), st.integers(0, 15))
def test_commands_come_back_as_they_were(words, lights):
    frame = encode_command(words, lights)
    assert CommandParser().feed(frame) == [(words, lights)]
    assert len(frame) == 16
    assert frame.count(b"<") == frame.count(b">") == 1


@pytest.mark.parametrize("words", [(0x8000, 0, 0), (0, -0x8001, 0), (0, 0, 70_000)])
def test_words_that_do_not_fit_never_wrap_round(words):
    with pytest.raises(ValueError, match="16 bits"):
        encode_command(words)
    with pytest.raises(ValueError, match="16 bits"):
        encode_reply(Reply(words, 0, 7))


def test_flags_that_do_not_exist_are_refused():
    for lights in (-1, 16):
        with pytest.raises(ValueError, match="lights"):
            encode_command((0, 0, 0), lights)
    for reply in (Reply((0, 0, 0), 16, 0), Reply((0, 0, 0), 0, 8)):
        with pytest.raises(ValueError, match="cannot be sent"):
            encode_reply(reply)


@pytest.mark.parametrize(
    "frame",
    [
        b"",
        b"<AAAAAAAAAAAAAA",
        b">AAAAAAAAAAAAAA<",
        b"<AAAAAAAAAAAQAA>",
        b"<AAAAAAAAAAA@AA>",
        b"<AAAAAAAAAAAA@A>",
        b"<AAAAAAAAAAAA\xc1A>",
    ],
)
def test_bytes_that_are_not_a_frame_are_skipped(frame):
    assert ReplyParser().feed(frame) == CommandParser().feed(frame) == []


def chunked(stream, cuts):
    places = [0, *sorted(cut % (len(stream) + 1) for cut in cuts), len(stream)]
    return [stream[a:b] for a, b in itertools.pairwise(places)]


@given(
    st.lists(st.one_of(replies.map(encode_reply), st.binary(max_size=40)), max_size=12),
    st.lists(st.integers(0, 1000), max_size=30),
)
def test_any_chunking_gives_the_same_frames_and_the_same_count(parts, cuts):
    stream = b"".join(parts)
    whole, pieces = ReplyParser(), ReplyParser()
    expected = whole.feed(stream)
    found = [reply for chunk in chunked(stream, cuts) for reply in pieces.feed(chunk)]
    assert found == expected
    assert pieces.malformed == whole.malformed


def test_a_million_random_bytes_make_no_frame():
    """Frames go in whole, or cut short; exactly the whole ones come out."""
    chance = random.Random(20)
    stream, expected, noise = bytearray(), [], 0
    while noise < 1_000_000:
        junk = chance.randbytes(chance.randrange(400))
        noise += len(junk)
        reply = Reply(
            tuple(chance.randrange(-0x8000, 0x8000) for _ in range(3)),
            chance.randrange(16),
            chance.randrange(8),
        )
        frame = encode_reply(reply)
        stream += junk
        if chance.random() < 0.2:
            stream += frame[: chance.randrange(1, 16)]  # and the next one follows
        else:
            stream += frame
            expected.append(reply)
    parser, found, at = ReplyParser(), [], 0
    while at < len(stream):
        size = chance.randrange(1, 63)
        found += parser.feed(bytes(stream[at : at + size]))
        at += size
    assert found == expected
    assert len(found) > 3000


def test_bytes_that_only_look_like_frames_are_noise():
    """Of the letters of frames alone, the hardest noise there is."""
    chance = random.Random(21)
    stream = bytes(chance.choices(b"<>ABCP@Q\xb1", k=200_000))
    found = ReplyParser().feed(stream)
    assert all(encode_reply(reply)[:14] in stream for reply in found)
    parser = ReplyParser()
    good = encode_reply(Reply((1, 2, 3), 0, 7))
    for length in range(1, 16):  # a torn frame directly before a good one
        assert parser.feed(good[:length] + good) == [Reply((1, 2, 3), 0, 7)]
        assert parser.feed(good[length:] + good) == [Reply((1, 2, 3), 0, 7)]


def test_malformed_answers_in_a_row_are_counted():
    parser = ReplyParser()
    good, bad = b"<AAAAAAAAAAAAAA>", b"<AAAA!AAAAAAAAA>"
    assert parser.malformed == 0
    for count in range(1, 25):
        assert parser.feed(bad) == []
        assert parser.malformed == count
    parser.feed(good[:9])
    parser.feed(good[9:])
    assert parser.malformed == 0
    parser.feed(b"\x00" + good)  # a glitch before a good one is forgiven
    assert parser.malformed == 0


def test_the_parser_keeps_less_than_a_frame():
    parser = CommandParser()
    for size in (1, 5, 15, 16, 17, 1000):
        for _ in range(100):
            parser.feed(b"<AAAA" * size)
        assert len(repr(vars(parser))) < 100


def test_the_simulators_side_hears_commands():
    parser = CommandParser()
    stream = (
        b"\xff" + encode_command((5, -6, 4096), 9) + b"<AA" + encode_command((1, 1, 1))
    )
    assert parser.feed(stream) == [((5, -6, 4096), 9), ((1, 1, 1), 0)]
