"""What reaches the person later is begun earlier, by exactly that much."""

import json

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import DeviceError, UsageError
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.latency import MOST_S, Latencies, Latency, is_wireless
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.sound_ring import AudioRing
from tests.material.sound_output import SilentOutput
from tests.needed_extras import needs

STEP_S = 0.004  # of the virtual time
OUTPUT, DEVICE = SilentOutput.name, "none"


class Notes:
    """What went out when: pictures, sound at the DAC, and the clock of the force."""

    def __init__(self, theatre):
        self.theatre, self.sound = theatre, {}
        self.first = len(theatre.published)

    @property
    def force(self):
        return [
            (now_s, clock.media_s(now_s), clock.epoch)
            for now_s, clock, _ in self.theatre.published[self.first :]
            if clock.is_running(now_s)
        ]

    def run(self, seconds):
        for _ in range(round(seconds / STEP_S)):
            self.theatre.run(STEP_S)
            if self.theatre.out is not None:
                heard = self.theatre.out.block.last_heard()
                if heard.monotonic_s:
                    self.sound[heard.monotonic_s] = heard.media_s

    def offset_s(self, rows):
        """Return (the least, the greatest) media time minus monotonic time."""
        gaps = [media_s - monotonic_s for monotonic_s, media_s in rows]
        return min(gaps), max(gaps)

    def pictures(self):
        first = next(k for k, (_, pts) in enumerate(self.theatre.sink.shown) if pts > 0)
        return self.theatre.sink.shown[first:]


def played(theatre, seconds=1.5, **latencies):
    theatre.player.set_latencies(Latencies(**latencies))
    notes = Notes(theatre)
    theatre.player.play()
    notes.run(seconds)
    return notes


@pytest.mark.parametrize(
    ("display_s", "sound_s", "device_s"),
    [(0, 0, 0), (0.08, 0, 0), (0, 0.2, 0), (0, 0, 0.03), (0.05, 0.3, 0.01)],
)
def test_picture_sound_and_force_of_a_moment_meet_at_the_person(
    theatre, display_s, sound_s, device_s
):
    notes = played(
        theatre, display_s=display_s, sound_s={OUTPUT: sound_s},
        device_s={DEVICE: device_s},
    )  # fmt: skip
    # media time at a monotonic time, each as it reaches the person
    sound = notes.offset_s([(t + sound_s, m) for t, m in notes.sound.items()])
    force = notes.offset_s([(t + device_s, m) for t, m, _ in notes.force])
    picture = notes.offset_s([(t + display_s, m) for t, m in notes.pictures()])
    assert len(notes.force) > 200
    assert len(notes.pictures()) > 15
    assert sound[1] - sound[0] < 1e-6
    assert force[0] == pytest.approx(sound[0], abs=2e-4)
    assert force[1] == pytest.approx(sound[1], abs=2e-4)
    # a picture comes at the step after its time: up to 4 ms late, never early
    # by more than the millisecond that it is aimed to be early
    assert picture[0] - sound[0] > -STEP_S - 5e-4
    assert picture[1] - sound[1] < 1.5e-3
    assert theatre.player.snapshot().frames_dropped == 0


def test_a_late_display_delays_sound_and_force_equally(theatre):
    """At the wire: the picture is painted so much before the force is sent."""
    notes = played(theatre, display_s=0.08)
    painted = {pts: t for t, pts in notes.pictures()}
    times, media, _ = np.array(notes.force).T
    sent = {pts: float(np.interp(pts, media, times)) for pts in painted}
    gaps = [sent[pts] - painted[pts] for pts in painted if media[0] < pts < media[-1]]
    assert np.median(gaps) == pytest.approx(0.08, abs=STEP_S)


def test_a_late_device_is_told_earlier(silent_theatre):
    notes = played(silent_theatre, device_s={DEVICE: 0.04})
    painted = {pts: t for t, pts in notes.pictures()}
    times, media, _ = np.array(notes.force).T
    gaps = [painted[p] - np.interp(p, media, times) for p in painted if p < media[-1]]
    assert np.median(gaps) == pytest.approx(0.04, abs=STEP_S)
    assert media[0] < 0.02  # nothing of the beginning was left out
    assert silent_theatre.player.snapshot().frames_dropped == 0


def test_another_latency_while_playing_begins_a_new_epoch(theatre):
    """The force fades instead of leaping."""
    notes = played(theatre, 0.6)
    before = notes.force[-1]
    theatre.player.set_latencies(Latencies(device_s={DEVICE: 0.05}))
    notes.run(0.6)
    assert notes.force[-1][2] > before[2]
    assert notes.force[-1][1] > before[1]
    epoch = theatre.player.snapshot().epoch
    theatre.player.set_latencies(Latencies(device_s={DEVICE: 0.05, "falcon": 0.1}))
    assert theatre.player.snapshot().epoch == epoch  # of another device: nothing to do


def test_latencies_belong_to_outputs():
    known = Latencies(0.01, {"speakers": 0.02, "headphones": 0.2}, {"falcon:A": 0.003})
    assert known.of("headphones", "falcon:A") == Latency(0.01, 0.2, 0.003)
    assert known.of("speakers", "falcon:B") == Latency(0.01, 0.02, 0.001)
    assert known.of("", "none") == Latency(0.01, 0.0, 0.0)


@pytest.mark.parametrize("bad", [-0.001, MOST_S + 0.001, float("nan"), float("inf")])
def test_a_latency_out_of_range_is_refused(bad):
    with pytest.raises(UsageError, match="between 0 and 1 s"):
        Latency(display_s=bad)


def test_the_delay_that_the_output_reports_is_known(theatre):
    assert theatre.player.snapshot().reported_latency_s == 0.0
    played(theatre, 1.0, sound_s={OUTPUT: 0.3})
    reported_s = theatre.player.snapshot().reported_latency_s
    assert reported_s == pytest.approx(
        0.12, abs=1.5 * STEP_S
    )  # its own, not what we know


def test_sound_that_joins_a_running_clock_is_heard_on_it():
    ring = AudioRing(48_000)
    ring.latency_s = 0.2
    generation = ring.load(1, 5.0)
    ring.write(generation, 5.0, np.zeros((48_000, 2), np.float32))
    out = SilentOutput(ring, ManualClock(100.0), latency_s=0.1)
    clock = PlaybackClock(1, 99.5, 5.0, 1.0, 101.0)
    ring.join(clock)
    out.advance(480)
    (report,) = ring.reports()
    assert report.monotonic_s == pytest.approx(100.3)  # now, its delay, and ours
    assert report.media_s == pytest.approx(clock.media_s(100.3), abs=1.1 / 48_000)
    ring.close()


def test_the_meters_compare_what_the_person_meets(theatre):
    noted = {"video": [], "audio": []}
    force = theatre.player._outputs.leading
    force.video.event = lambda *event: noted["video"].append(event)
    force.audio.event = lambda *event: noted["audio"].append(event)
    notes = played(theatre, 1.0, display_s=0.05, device_s={DEVICE: 0.02})
    times, media, _ = np.array(notes.force).T
    for commanded_s, media_s in noted["video"] + noted["audio"]:
        if times[0] < commanded_s < times[-1]:
            off_s = media_s - np.interp(commanded_s, times, media)
            assert -1.5e-3 - STEP_S < off_s < 1.5e-3


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("bluez_output.AC_BF_71.1", True),
        ("Headphones (Bluetooth)", True),
        ("Jo's AirPods Pro", True),
        ("pulse", False),
        ("HDA Intel PCH: ALC3232 Analog (hw:0,0)", False),
    ],
)
def test_outputs_without_a_wire_are_told_by_their_name(name, expected):
    assert is_wireless(name) is expected


def test_the_log_has_the_latencies_and_perceived_times(theatre, tmp_path):
    path = tmp_path / "log.jsonl"
    player = theatre.player
    player.attach_log(PlaybackLog(path, {}))
    notes = played(theatre, 0.8, display_s=0.06, sound_s={OUTPUT: 0.1})
    player.close()
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    latencies = [line for line in lines if line.get("name") == "latency"]
    parts = ("display_s", "sound_s", "device_s")
    assert [latencies[-1][part] for part in parts] == [0.06, 0.1, 0.0]
    seen = {
        line["media_s"]: line["monotonic_s"]
        for line in lines
        if line["kind"] == "frame"
    }
    painted = {pts: t for t, pts in notes.pictures()}
    assert len(painted) > 8
    for pts, t in painted.items():
        assert seen[pts] == pytest.approx(t + 0.06)
    said = [line for line in lines if line["kind"] == "audio"]
    heard = [(line["monotonic_s"], line["media_s"]) for line in said]
    at_dac = list(notes.sound.items())
    assert notes.offset_s(heard)[1] == pytest.approx(notes.offset_s(at_dac)[1] - 0.1)


@needs("toys")
def test_the_best_that_is_known_of_a_device_is_compensated():
    def known(name, **more):
        latency_s, source = Latencies(**more).of_device(name)
        return round(latency_s, 6), source.value

    assert known("buttplug") == (0.05, "assumed")
    assert known("buttplug", entered_s={"buttplug": 0.07}) == (0.07, "entered")
    both = {"device_s": {"buttplug": 0.06}, "entered_s": {"buttplug": 0.07}}
    assert known("buttplug", **both) == (0.06, "measured")
    assert known("shaker") == (0.08, "kept")  # by the clock of its card
    assert known("shaker:pulse,latency_ms=40") == (0.04, "kept")
    assert known("shaker", device_s={"shaker": 0.095}) == (0.095, "measured")
    rig = "rig:outsim,latency_ms=40"
    assert known(rig) == known(rig, device_s={rig: 0.1}) == (0.04, "settings")
    assert known("rig:outsim", device_s={"rig:outsim": 0.1}) == (0.1, "measured")
    assert known("rig:outsim") == (0.0, "assumed")
    assert known("none") == (0.0, "assumed")
    assert known("buttplug", device_s={"buttplug": 0.0}) == (0.0, "measured")
    with pytest.raises(DeviceError, match="no driver"):
        known("teleporter")
