"""The page that measures latencies finds those that were put in, and is gentle."""

import json
import math
from functools import partial

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.bridge.settings import (
    DEVICE,
    DISPLAY,
    SOUND,
    Settings,
    is_known,
    keep_latency,
    latencies_of,
    screen_name,
)
from app.player.extras import warning
from app.player.latency_page import TOGETHER, LatencyPage
from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.playback.beats import (
    COUNT,
    FIRST_S,
    LENGTH_S,
    PULSE_N,
    TapMeter,
    beat_source,
    beat_times_s,
    beat_track,
    relative_latencies_s,
)
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.latency import Latency
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Snapshot

SCREEN_S, SPREAD_S = 0.070, 0.015
HUMAN_S = -0.030  # people tap before the beat


def player_of(clock, sink, device, audio=None, latch=None):
    return Player(clock, sink, outputs=[device], audio=audio, latch=latch)


@pytest.fixture
def make_page(application, qtbot, settings):
    made, latch = [], StopLatch()

    def make(clock, device="none"):
        page = LatencyPage(
            *(clock, device, settings, partial(player_of, latch=latch)), latch
        )
        qtbot.addWidget(page)
        made.append(page)
        page.show()
        qtbot.waitExposed(page)
        return page

    yield make
    for page in made:
        page.reject()


def tap_along(page, clock, rng, late_s, taps):
    """Press the space bar so much after each beat, as a person does."""
    player = page.player
    for beat_s in beat_times_s()[5 : 5 + taps]:
        at_s = beat_s + late_s + rng.normal(0.0, SPREAD_S)
        clock.advance(at_s - player.snapshot().media_s)
        QTest.keyClick(page.focusWidget() or page, Qt.Key.Key_Space)


def test_taps_to_frame_and_force_give_the_latency_between(make_page, wait_for):
    clock = ManualClock(100.0)
    page, rng = make_page(clock), np.random.default_rng(7)
    page.begin()
    wait_for(
        lambda: (
            page.player is not None and page.player.snapshot().phase is Phase.PLAYING
        )
    )
    page.pump.stop()  # from here on time stands still but for `tap_along`
    taps = 24
    for mode, late_s in ((DISPLAY, SCREEN_S), (SOUND, 0.0), (DEVICE, 0.110)):
        page.player.seek(0.0)
        page.choose(mode)
        page.rows[DISPLAY].choice.setFocus()  # as after a click of the mouse
        while page.player.snapshot().phase is not Phase.PLAYING:
            page.player.poll()
            QTest.qWait(1)
        tap_along(page, clock, rng, late_s + HUMAN_S, taps)
        assert page.meters[mode].count == taps
        assert f"{taps} taps" in page.rows[mode].status.text()
    found = {part: row.number.value() for part, row in page.rows.items()}
    # the picture comes 70 ms after the sound: that is what is left of the three
    assert found[SOUND] == 0.0
    assert found[DISPLAY] == pytest.approx(70.0, abs=8.0)
    assert found[DEVICE] == pytest.approx(110.0, abs=8.0)


def test_the_median_of_many_taps_is_within_a_few_milliseconds():
    rng, meter = np.random.default_rng(3), TapMeter()
    taps_s = beat_times_s()[:40] + 0.212 + rng.normal(0.0, SPREAD_S, 40)
    taps_s[7] += 0.3  # slept
    for at_s in taps_s:
        meter.tap(float(at_s))
    assert meter.count == TapMeter.MOST
    assert meter.median_s == pytest.approx(0.212, abs=0.005)
    # half of the middle half of a normal distribution: 0.674 of its deviation
    assert meter.spread_s == pytest.approx(0.674 * SPREAD_S, rel=0.4)
    assert TapMeter().median_s is None
    assert meter.tap(FIRST_S + 0.69) == pytest.approx(0.69)
    assert meter.tap(FIRST_S + 0.75) == pytest.approx(-0.25)


def test_differences_are_put_where_none_is_negative():
    found = relative_latencies_s(0.0, {"a": 0.05, "b": 0.02, "c": 0.3})
    assert found == pytest.approx({"a": 0.03, "b": 0.0, "c": 0.28})
    found = relative_latencies_s(0.04, {"a": 0.05, "b": 0.02})
    assert found == pytest.approx({"a": 0.04, "b": 0.01})


def test_the_beats_are_at_their_times_and_below_a_newton():
    source, track = beat_source(), beat_track()
    assert source.clip.duration_s == pytest.approx(COUNT, abs=0.03)
    assert track.peak_n() == pytest.approx(PULSE_N)
    assert track.peak_n() < 1.0
    at_s = FIRST_S + 3.0
    time_s, force = track.time_s, track.force_n[:, 1]
    inside = np.interp([at_s, at_s + 0.9 * LENGTH_S], time_s, force)
    around = np.interp([at_s - 0.002, at_s + LENGTH_S + 0.002], time_s, force)
    assert inside == pytest.approx(PULSE_N, abs=1e-6)
    assert around == pytest.approx(0.0, abs=1e-6)


@pytest.mark.realtime
def test_on_a_device_the_force_is_gentle_and_escape_ends_it(make_page, wait_for):
    page = make_page(SystemClock(), "simulated")
    page.begin()

    def felt():
        if page.player is None:
            return np.zeros(1)
        ticks = page.player.ticks_since(-math.inf)
        return np.linalg.norm(ticks["force_n"], axis=1) if len(ticks) else np.zeros(1)

    wait_for(lambda: felt().max() > 0.7 * PULSE_N)
    wait_for(lambda: page.player.snapshot().media_s > 2.7)
    assert felt().max() < 1.0
    player = page.player
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert page.player is None
    assert not page.isVisible()
    last = player.snapshot()  # of the closed player
    assert last.leading.mode is Mode.TRIPPED
    assert last.leading.tick["force_n"].tolist() == [0.0, 0.0, 0.0]


def test_a_used_latency_is_kept_for_its_output_and_played_with(
    window, qtbot, settings, wait_for
):
    page = LatencyPage(
        *(SystemClock(), "none", settings, partial(player_of)), StopLatch()
    )
    qtbot.addWidget(page)
    page.measured.connect(window.dialogs.settings_taken)
    page.rows[DISPLAY].number.setValue(45.0)
    page.accept()
    screen = screen_name(window)
    assert latencies_of(settings, screen).display_s == pytest.approx(0.045)
    assert latencies_of(settings, "another screen").display_s == 0.0
    assert window.player.snapshot().latency == Latency(display_s=0.045)
    window.commands.statistics.setChecked(True)
    assert "video 45 " in window.extras.statistics.text()


def test_cancel_changes_nothing(make_page, settings):
    page = make_page(SystemClock())
    page.choose(TOGETHER)
    page.rows[DISPLAY].number.setValue(45.0)
    page.reject()
    assert settings.table("latencies") == {}


def test_each_output_has_its_latency_and_bad_files_are_ignored(tmp_path):
    path = tmp_path / "window.json"
    settings = Settings(path)
    keep_latency(settings, SOUND, "headphones", 180.0)
    keep_latency(settings, SOUND, "speakers", 20.0)
    keep_latency(settings, DEVICE, "falcon:A", 3.0)
    settings.save()
    again = latencies_of(Settings(path), "any")
    assert again.of("headphones", "falcon:A") == Latency(0.0, 0.18, 0.003)
    assert again.of("speakers", "falcon") == Latency(0.0, 0.02, 0.001)
    assert is_known(settings, SOUND, "speakers")
    assert not is_known(settings, SOUND, "television")
    shared = tmp_path / "exported.json"
    settings.export(shared)
    assert "latencies" not in json.loads(shared.read_text())  # of this machine
    nonsense = {"sound": {"a": -1, "b": "x", "c": 1e9, "d": True, "e": 5}, "display": 3}
    path.write_text(json.dumps({"version": 1, "latencies": nonsense}))
    assert dict(latencies_of(Settings(path), "x").sound_s) == {"e": 0.005}


@pytest.mark.parametrize(
    ("name", "reported_s", "is_reported"),
    [
        ("pulse (bluez_output.AC)", 0.10, True),
        ("speakers", 0.21, True),
        ("speakers", 0.141, False),  # PulseAudio, without any device behind it
        ("", 0.0, False),
    ],
)
def test_a_late_output_is_warned_of_once(
    window, settings, monkeypatch, name, reported_s, is_reported
):
    watch, reported = window.extras.latency_monitor, []
    monkeypatch.setattr(
        window.session.gateway, "report", lambda one, _over=None: reported.append(one)
    )
    window.pump.stop()
    late = Snapshot(sound_output=name, reported_latency_s=reported_s)
    monkeypatch.setattr(window.player, "snapshot", lambda: late)
    for now_s in (1e6, 1e6 + 10.0):
        watch.look(now_s)
    assert [str(problem) for problem in reported] == [
        warning(name, reported_s)
    ] * is_reported
    assert all("Measure latencies" in str(problem) for problem in reported)
