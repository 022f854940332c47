"""Records on a damaged disk: what is intact comes back, what is not is named."""

import json
import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.errors import StudyError
from hapticplayer.study import journal as journals
from hapticplayer.study.journal import Journal, decode, encode, read_journal

json_values = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**53), 2**53) | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=8,
)


def lines(count: int) -> list[bytes]:
    texts = ["fine", 'a "quote"', "zwölf\nLinien", ',"crc":"00000000"}', '{"record":9,']
    return [
        encode(n, "2026-01-01T00:00:00+00:00", 10.0 + n, "answers", {"text": text})
        for n, text in zip(range(1, count + 1), texts * count, strict=False)
    ]


@given(st.dictionaries(st.text().map("x_{}".format), json_values, max_size=4))
@settings(max_examples=60)
def test_whatever_is_written_is_read(content):
    line = encode(1, "now", 1.5, "note", content)
    assert line.count(b"\n") == 1
    found = decode(line)
    assert not found.damaged
    assert found.intact[0].content == content


def test_a_record_is_plain_json():
    read = json.loads(lines(1)[0])
    assert read["record"] == 1
    assert read["kind"] == "answers"


def test_names_of_the_record_itself_and_nan_are_refused():
    for content in ({"crc": 1}, {"record": 2}, {"x": float("nan")}):
        with pytest.raises(ValueError):  # noqa: PT011 - either message
            encode(1, "now", 1.0, "note", content)


def test_an_answer_may_be_called_as_the_checksum_is():
    content = {"answers": {"a": 1, "crc": "89abcdef"}, "more": {"record": 1}}
    line = encode(3, "2026-01-01T00:00:00Z", 1.0, "answers", content)
    read = decode(line + encode(4, "2026-01-01T00:00:01Z", 2.0, "end", {}))
    assert [record.number for record in read.intact] == [3, 4]
    assert read.intact[0].content == content
    assert not read.damaged


def test_cut_off_at_every_byte_the_whole_records_come_back():
    written = lines(6)
    data = b"".join(written)
    ends = np.cumsum([len(line) for line in written])
    for cut in range(len(data) + 1):
        found = decode(data[:cut])
        # the line break alone may be missing
        whole = int(np.searchsorted(ends - 1, cut, side="right"))
        assert [r.number for r in found.intact] == list(range(1, whole + 1)), cut
        left = cut - (ends[whole - 1] if whole else 0)
        assert bool(found.damaged) == (left > 0), cut
        assert len(found.damaged) <= 1


def test_a_thousand_flipped_bytes_lose_only_the_record_they_hit():
    written = lines(25)
    data = b"".join(written)
    ends = np.cumsum([len(line) for line in written])
    rng = np.random.default_rng(9)
    for _ in range(1000):
        at = int(rng.integers(len(data)))
        spoilt = bytearray(data)
        spoilt[at] ^= 1 << int(rng.integers(8))
        hit = int(np.searchsorted(ends, at, side="right")) + 1
        is_break = at == ends[hit - 1] - 1
        found = decode(bytes(spoilt))
        numbers = [record.number for record in found.intact]
        wanted = [n for n in range(1, 26) if n != hit or is_break]
        assert numbers == wanted, at
        assert len(found.damaged) == 1
        begin = found.damaged[0].split()[1]
        assert int(begin) <= at


def test_many_flips_at_once_never_change_a_record_silently():
    written = lines(25)
    data = b"".join(written)
    truth = {r.number: r for r in decode(data).intact}
    rng = np.random.default_rng(10)
    for _ in range(200):
        spoilt = bytearray(data)
        for at in rng.integers(len(data), size=8):
            spoilt[at] ^= int(rng.integers(1, 256))
        for record in decode(bytes(spoilt)).intact:
            assert record == truth[record.number]


@pytest.fixture
def path(tmp_path):
    made = tmp_path / "answers.jsonl"
    made.write_bytes(b"")
    return made


def test_a_record_counts_as_kept_only_once_it_is_synced(
    path, manual_clock, monkeypatch
):
    calls = []
    real_write, real_sync = os.write, os.fsync

    def write(descriptor, data):
        calls.append("write")
        return real_write(descriptor, data)

    def fsync(descriptor):
        calls.append("fsync")
        real_sync(descriptor)

    monkeypatch.setattr(journals.os, "write", write)
    monkeypatch.setattr(journals.os, "fsync", fsync)
    journal = Journal(path, manual_clock)
    journal.append("answers", values={"a": 1})
    calls.append("returned")
    journal.close()
    assert calls == ["write", "fsync", "returned"]


def refuse(*_args):
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize("call", ["write", "fsync"])
def test_a_full_disk_is_reported_and_can_be_tried_again(
    path, manual_clock, monkeypatch, call
):
    journal = Journal(path, manual_clock)
    journal.append("answers", values={"a": 1})
    with monkeypatch.context() as patch:
        patch.setattr(journals.os, call, refuse)
        with pytest.raises(StudyError, match=r"the disk at .* is full"):
            journal.append("answers", values={"a": 2})
    journal.append("answers", values={"a": 2})
    journal.close()
    found = read_journal(path)
    assert found.intact[-1].content == {"values": {"a": 2}}
    assert not found.damaged


def test_half_a_line_of_a_full_disk_is_left_alone(path, manual_clock, monkeypatch):
    journal = Journal(path, manual_clock)
    real = os.write
    with monkeypatch.context() as patch:
        patch.setattr(journals.os, "write", lambda d, data: real(d, data[:40]))
        with pytest.raises(StudyError):
            journal.append("answers", values={"a": 1})
    journal.append("answers", values={"a": 1})
    journal.close()
    found = read_journal(path)
    assert [r.content for r in found.intact] == [{"values": {"a": 1}}]
    assert len(found.damaged) == 1


def test_a_folder_that_vanishes_is_noticed(tmp_path, manual_clock):
    folder = tmp_path / "session"
    folder.mkdir()
    (folder / "answers.jsonl").write_bytes(b"")
    journal = Journal(folder / "answers.jsonl", manual_clock)
    journal.append("answers", values={})
    folder.rename(tmp_path / "elsewhere")
    with pytest.raises(StudyError, match="could not be saved"):
        journal.append("answers", values={})
    journal.close()


def test_a_second_window_is_refused(path, manual_clock):
    first = Journal(path, manual_clock)
    with pytest.raises(StudyError, match="another window"):
        Journal(path, manual_clock)
    first.close()
    Journal(path, manual_clock).close()


def test_a_torn_line_stays_and_the_next_record_follows(path, manual_clock):
    path.write_bytes(b"".join(lines(2)) + lines(3)[2][:30])
    journal = Journal(path, manual_clock)
    assert journal.append("resume").number == 4
    journal.close()
    found = read_journal(path)
    assert [r.number for r in found.intact] == [1, 2, 4]
    assert len(found.damaged) == 1


def test_records_of_a_newer_program_are_refused(path, monkeypatch):
    with monkeypatch.context() as newer:
        newer.setattr("hapticplayer.study.journal.VERSION", 2)
        path.write_bytes(b"".join(lines(2)))
    with pytest.raises(StudyError, match="version 2"):
        read_journal(path)
