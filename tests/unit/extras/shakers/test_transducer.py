"""Shakers: the right channels at the right time, in their band, and silent at a stop."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.clock import ManualClock
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.extras.shakers.driver import ShakerDriver
from hapticplayer.extras.shakers.meter import LevelMeter
from hapticplayer.extras.shakers.settings import shaker_settings
from hapticplayer.extras.shakers.signal import FULL_N, SAMPLE_HZ, limited
from hapticplayer.model.device import ChannelLevel
from tests.unit.extras.shakers.fake_card import FakeCard

ZERO = (0.0, 0.0, 0.0)


class Bench:
    def __init__(self, text=""):
        self.clock = ManualClock(100.0)
        self.card = FakeCard(self.clock)
        settings = shaker_settings(text)
        self.device = ShakerDriver(settings, self.clock, self.card.stream)
        self.device.open()

    def play(self, force_of_t, seconds):
        begin_s = self.clock.now_s()
        for _ in range(round(1000 * seconds)):
            now_s = self.clock.now_s()
            self.device.exchange(force_of_t(now_s - begin_s), now_s)
            self.clock.advance(0.001)
            self.card.play()

    def levels(self):
        return self.device.exchange(ZERO, self.clock.now_s()).levels


def steady(_t):
    return (0.0, 2.25, 0.0)


def test_only_the_chosen_channels_sound():
    bench = Bench("pulse,channels=3+4")
    bench.play(steady, 1.0)
    peaks = np.abs(bench.card.heard(0.5)).max(axis=0)
    assert peaks[:2].tolist() == [0.0, 0.0]
    assert peaks[2:] == pytest.approx([0.25, 0.25], rel=0.02)  # half of half
    levels = bench.levels()
    assert [one.channel for one in levels] == [3, 4]
    assert [one.peak for one in levels] == pytest.approx([0.25, 0.25], rel=0.02)
    assert not any(one.is_limited for one in levels)


def test_a_steady_force_is_its_carrier_and_nothing_below():
    bench = Bench("band=20-80-40")
    bench.play(steady, 2.0)
    heard = bench.card.heard(1.0)[:, 0]
    power = np.abs(np.fft.rfft(heard * np.hanning(len(heard)))) ** 2
    hertz = np.fft.rfftfreq(len(heard), 1.0 / SAMPLE_HZ)
    assert hertz[power.argmax()] == pytest.approx(40.0, abs=1.0)
    assert power[hertz < 20.0].sum() < 1e-4 * power.sum()
    assert power[hertz > 100.0].sum() < 1e-4 * power.sum()


@pytest.mark.parametrize(("hertz", "least", "most"), [(5, 0.0, 0.25), (40, 0.45, 1.0)])
def test_a_force_inside_the_band_is_played_unchanged(hertz, least, most):
    """The axis alone, with no carrier's help: the direct part against its force."""
    bench = Bench("band=15-120,axis=z")

    def force(t):
        return (0.0, 0.0, 2.0 * math.sin(2 * math.pi * hertz * t))

    bench.play(force, 2.0)
    direct = 0.5 * 2.0 / FULL_N
    t = np.arange(SAMPLE_HZ) / SAMPLE_HZ
    heard = bench.card.heard(1.0)[-SAMPLE_HZ:, 0]
    at = 2.0 * abs(np.mean(heard * np.exp(-2j * math.pi * hertz * t[: len(heard)])))
    assert least * direct <= at <= most * direct


@pytest.mark.parametrize("latency_ms", [60, 120])
def test_a_force_sounds_at_its_stated_latency(latency_ms):
    """The onset in the card's time, whatever it asks ahead."""
    bench = Bench(f"latency_ms={latency_ms},band=50-200-100")
    bench.play(lambda _t: ZERO, 0.2)
    begun_s = bench.clock.now_s()
    bench.play(lambda t: (0.0, 4.0 * math.sin(2 * math.pi * 100 * t), 0.0), 0.4)
    heard = bench.card.heard(0.4)
    first = np.flatnonzero(np.abs(heard[:, 0]) > 0.02)[0]
    onset_s = bench.clock.now_s() - (len(heard) - first) / SAMPLE_HZ - begun_s
    assert onset_s == pytest.approx(latency_ms / 1000.0, abs=0.005)


def test_a_stop_is_silent_at_once_and_a_ramp_is_played_out():
    bench = Bench()
    bench.play(steady, 0.5)
    assert np.abs(bench.card.heard(0.05)).max() > 0.1
    bench.play(lambda _t: (0.0, 0.01, 0.0), 0.03)  # quiet now, and loud for 50 ms more
    assert np.abs(bench.card.heard(0.02)).max() > 0.1
    bench.device.forget()
    bench.play(lambda _t: ZERO, 0.1)
    assert not bench.card.heard(0.095).any()
    bench.play(steady, 0.5)
    bench.play(lambda t: (0.0, max(0.0, 2.25 * (1.0 - 50.0 * t)), 0.0), 0.05)
    assert np.abs(bench.card.heard(0.02)).max() > 0.1  # what comes before the ramp


def test_a_push_that_ends_at_once_is_heard_whole():
    bench = Bench("latency_ms=80,band=50-200-100")
    bench.play(lambda _t: ZERO, 0.2)
    bench.play(lambda t: (0.0, 4.0 * (t < 0.010), 0.0), 0.12)
    heard = np.abs(bench.card.heard(0.12)).max(axis=1)
    loud = np.flatnonzero(heard > 0.1)
    begin_s, end_s = (loud[[0, -1]] - len(heard)) / SAMPLE_HZ + 0.12
    assert begin_s == pytest.approx(0.080, abs=0.005)
    assert end_s == pytest.approx(0.090, abs=0.010)


def test_a_loop_that_stands_still_fades_in_the_streams_own_time():
    bench = Bench("latency_ms=60")
    bench.play(steady, 0.5)
    for _ in range(100):
        bench.clock.advance(0.001)
        bench.card.play()
    assert not bench.card.heard(0.020).any()
    steps = np.abs(np.diff(bench.card.heard(0.2)[:, 0]))
    assert steps.max() < 0.02  # no click


@given(
    st.lists(
        st.tuples(*3 * [st.floats(allow_nan=True, allow_infinity=True)]),
        min_size=1,
        max_size=30,
    )
)
def test_whatever_it_is_told_samples_stay_within_one(forces):
    bench = Bench()
    planned = iter(forces)
    bench.play(lambda _t: next(planned), len(forces) / 1000.0)
    bench.play(steady, 0.15)
    heard = bench.card.heard(1.0)
    assert np.isfinite(heard).all()
    assert np.abs(heard).max(initial=0.0) <= 1.0


def test_the_limiter_has_no_corner_and_keeps_the_order():
    values = np.linspace(-5.0, 5.0, 10_001)
    bent = limited(values)
    assert np.abs(bent).max() <= 1.0
    assert (np.diff(bent) >= 0.0).all()
    inside = np.abs(values) <= 0.8
    assert (bent[inside] == values[inside]).all()
    slopes = np.diff(bent) / np.diff(values)
    assert np.abs(np.diff(slopes)).max() < 0.01


def test_a_level_falls_by_20_db_in_1_7_s():
    """As a peak meter of IEC 60268-10, type I."""
    meter = LevelMeter((3, 4))
    meter.note(3, 0.5, 10.0, is_limited=False)
    meter.note(4, 0.4, 10.0, is_limited=True)
    meter.note(4, 0.35, 10.1, is_limited=False)  # the first has fallen to 0.349
    meter.note(4, 0.1, 10.2, is_limited=False)  # it is still louder
    left, right = meter.levels(11.7)
    assert left == ChannelLevel(3, pytest.approx(0.05), False)
    assert right == ChannelLevel(4, pytest.approx(0.35 * 10 ** (-16 / 17)), False)
    assert meter.levels(10.99)[1].is_limited
    assert meter.levels(9.9)[0].peak == 0.5  # what sounds only in a moment
    assert [one.peak for one in meter.levels(17.0)] == [0.0, 0.0]


def test_the_limiter_is_shown_on_its_channel():
    bench = Bench("channels=1+2,band=15-80+15-400-45,axis=y")
    pushed = 2.0 * math.pi * 150.0  # Hz: only the second band has that
    bench.play(lambda t: (0.0, 6.75 * math.sin(pushed * t), 0.0), 0.4)
    assert [one.is_limited for one in bench.levels()] == [False, True]
    heard = np.abs(bench.card.heard(0.3)).max(axis=0)
    assert heard[0] < 0.8 < heard[1]


def test_a_card_that_asks_for_nothing_is_late_and_then_gone():
    bench = Bench()
    bench.play(steady, 0.3)
    bench.card.is_asking = False
    bench.play(steady, 0.5)
    now_s = bench.clock.now_s()
    assert now_s - bench.device.exchange(steady(0), now_s).replied_s > 0.4
    with pytest.raises(
        DeviceError, match=r"no longer accepts sound \(it asks for none\); connect"
    ):
        bench.play(steady, 1.0)


def test_a_card_that_does_not_start_says_why():
    bench = Bench()
    bench.card.problem = "Device unavailable"
    with pytest.raises(DeviceError, match=r"\(Device unavailable\); connect"):
        bench.play(steady, 0.1)


@pytest.mark.parametrize(
    "text",
    [
        "channels=0",
        "channels=1+1",
        "band=80-15",
        "band=15-80+20-60+5-10",
        "axis=w",
        "x=1",
        "latency_ms=5",
        "gain=nan",
        "card,other",
        "band=15-80-100",
        "channels=a",
    ],
)
def test_settings_that_cannot_be_are_told(text):
    with pytest.raises(DeviceError, match=r"shaker"):
        find_device(f"shaker:{text}")


def test_settings_are_what_was_written():
    text = "pulse,channels=3+4,band=15-80+20-60-30,axis=x,gain=0.5"
    found = find_device(f"shaker:{text}").settings
    assert (found.address, found.channels, found.width) == ("pulse", (3, 4), 4)
    assert [(b.low_hz, b.high_hz) for b in found.bands] == [(15, 80), (20, 60)]
    assert found.bands[1].carrier_hz == 30.0
    assert (found.axis, found.gain, found.latency_s) == (0, 0.5, 0.080)


def test_a_channel_alone_keeps_its_band_and_all_else():
    text = "pulse,channels=3+4,band=15-80+20-60-30,axis=x,gain=0.5,latency_ms=60"
    both = find_device(f"shaker:{text}").settings
    alone = find_device(both.alone(4)).settings
    assert (alone.channels, alone.bands) == ((4,), both.bands[1:])
    assert (alone.address, alone.axis, alone.gain) == ("pulse", 0, 0.5)
    assert alone.latency_s == pytest.approx(0.060)
