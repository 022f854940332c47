"""The log is readable line by line; the meters find differences that were put in."""

import json
import math

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.meters import HISTORY_TICKS, SyncMeter, TickHistory


def ticks(count, start_s=100.0, media0_s=5.0, mode=Mode.FOLLOWING):
    made = np.zeros(count, dtype=TICK)
    made["monotonic_s"] = start_s + 0.001 * np.arange(count)
    made["media_s"] = media0_s + 0.001 * np.arange(count)
    made["force_n"] = np.arange(3 * count).reshape(count, 3) / 100.0
    made["lateness_s"] = 20e-6
    made["mode"] = mode
    return made


def test_every_line_is_json_and_the_summary_is_last(tmp_path):
    path = tmp_path / "log.jsonl"
    log = PlaybackLog(path, {"clip": "ä.mp4"})
    log.line("frame", monotonic_s=1.0, media_s=0.5)
    log.ticks(ticks(3))
    log.line("event", name="pause", monotonic_s=2.0)
    log.close({"missed": 0})
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert [line["kind"] for line in lines] == [
        "header", "frame", "force", "force", "force", "event", "summary",
    ]  # fmt: skip
    assert lines[3]["force_n"] == [0.03, 0.04, 0.05]
    assert lines[3]["monotonic_s"] == 100.001
    assert lines[0]["clip"] == "ä.mp4"


def test_a_log_that_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(InputError, match="cannot be written"):
        PlaybackLog(tmp_path / "no" / "log.jsonl", {})


def test_bytes_of_a_name_that_are_no_text_are_escaped(tmp_path):
    path = tmp_path / "log.jsonl"
    PlaybackLog(path, {"clip": "ä\udcff.mp4"}).close({})
    assert b'"\xc3\xa4\\udcff.mp4"' in path.read_bytes()
    assert json.loads(path.read_text().splitlines()[0])["clip"] == "ä\udcff.mp4"


def test_a_line_that_cannot_be_written_is_told_at_the_end(tmp_path):
    log = PlaybackLog(tmp_path / "log.jsonl", {})
    log.line("event", value=float("nan"))
    log.ticks(ticks(3))
    log.close({})
    assert log.problem.startswith("the log is incomplete (")


@pytest.mark.parametrize("late_ms", [-15.0, 0.0, 3.0, 50.0])
def test_a_known_difference_is_found(late_ms):
    meter = SyncMeter()
    for k in range(50):
        # shown at t while the loop, which is `late_ms` behind, plays an earlier time
        t = 100.01 + 0.011 * k
        meter.event(t, 5.0 + (t - 100.0) + late_ms / 1e3)
    meter.compare(ticks(1000))
    stats = meter.total()
    assert stats.count == 50
    assert stats.p50_ms == pytest.approx(late_ms, abs=1e-6)


def test_events_wait_for_the_ticks_that_belong_to_them():
    meter = SyncMeter()
    meter.event(100.5, 5.5)
    meter.compare(ticks(100))
    assert meter.total() is None
    meter.compare(ticks(600))
    assert meter.total().count == 1


def test_while_nothing_is_played_nothing_is_compared():
    meter = SyncMeter()
    meter.event(100.05, 5.05)
    meter.compare(ticks(100, mode=Mode.IDLE))
    assert meter.total() is None


def test_the_history_is_bounded_and_the_totals_are_not():
    history = TickHistory()
    for k in range(40):
        chunk = ticks(1000, start_s=100.0 + k)
        chunk["missed"][0] = 1
        history.add(chunk, lost=0)
    assert len(history.since(-math.inf)) == HISTORY_TICKS
    assert np.all(np.diff(history.since(-math.inf)["monotonic_s"]) > 0)
    total = history.total_stats()
    assert (total.ticks, total.missed) == (40_000, 40)
    assert total.lateness_p99_us == pytest.approx(20.0, rel=1e-4)


@pytest.mark.parametrize("most", [40, 5000, 20_000])
def test_the_history_has_the_last_ticks_whatever_is_read_at_once(most, rng):
    whole = ticks(80_000)
    whole["lateness_s"] = rng.uniform(0.0, 1e-3, len(whole))
    whole["missed"] = rng.integers(0, 3, len(whole))
    history, end = TickHistory(), 0
    assert history.latest() is None
    assert history.recent_stats() is None
    while end < len(whole) - most:
        begin, end = end, end + int(rng.integers(0, most))
        history.add(whole[begin:end].copy(), lost=1)
        last = whole[max(0, end - HISTORY_TICKS) : end]
        if not end or rng.random() > 20.0 * most / len(whole):
            continue  # most are only added
        assert np.array_equal(history.since(-math.inf), last)
        assert history.latest() == whole[end - 1]
        for at_s in (99.0, float(last["monotonic_s"][len(last) // 2]), 1e9):
            newer = last[last["monotonic_s"] > at_s]
            assert np.array_equal(history.since(at_s), newer)
        stats, stats_shown = last[-10_000:], history.recent_stats()
        assert stats_shown.missed == stats["missed"].sum()
        assert stats_shown.lateness_p50_us == pytest.approx(
            1e6 * np.median(stats["lateness_s"]), rel=1e-5
        )
    total = history.total_stats()
    assert (total.ticks, total.missed) == (end, whole["missed"][:end].sum())


def test_ticks_read_from_the_history_stay_as_they_were():
    history = TickHistory()
    history.add(ticks(10_000), lost=0)
    kept = (history.since(-math.inf), history.since(105.0), history.latest())
    before = [part.copy() for part in kept]
    history.add(ticks(30_000, start_s=110.0), lost=0)
    assert all(map(np.array_equal, kept, before))
