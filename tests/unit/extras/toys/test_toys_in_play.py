"""`play` on a toy: its own pace, and each fault said with the status 1."""

import json
import math

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from tests.e2e.command import hapticplayer
from tests.unit.extras.toys.fake_intiface import FakeIntiface

pytestmark = pytest.mark.realtime
SECONDS = 3.0


@pytest.fixture(scope="module")
def clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "clip.mp4"
    frame = np.zeros((36, 64, 3), np.uint8)
    write_clip(path, [frame] * round(10 * SECONDS + 10), frame_rate_hz=10)
    return path


@pytest.fixture
def force(tmp_path):
    rows = ["time_s,fx_n,fy_n,fz_n"]
    rows += [f"{k / 50},0,{2 + math.sin(k / 5):.3f},0" for k in range(200)]
    path = tmp_path / "force.csv"
    path.write_text("\n".join(rows))
    return path


def played(clip, force, server, tmp_path, *more):
    log = tmp_path / "log.jsonl"
    words = ["play", clip, "--force", force, "--headless", "--mute", "--json"]
    words += ["--duration", SECONDS, "--log", log, *more]
    done = hapticplayer(*words, "--device", f"buttplug:{server.where}")
    events = [json.loads(line) for line in log.read_text().splitlines()]
    return done, [one for one in events if one["kind"] == "event"]


def commands(server):
    return [name for name, _ in server.heard if name in ("OutputCmd", "ScalarCmd")]


@pytest.mark.parametrize(("version", "more"), [(4, ()), (3, ("--device", "simulated"))])
def test_a_toy_with_a_gap_of_100_ms_plays_all_the_time(
    clip, force, tmp_path, version, more
):
    server = FakeIntiface(version=version, gap_ms=100)
    done, events = played(clip, force, server, tmp_path, *more)
    server.close()
    assert done.returncode == 0, done.stderr
    assert "trip" not in [
        one["name"] for one in events if one.get("cause") != "stopped"
    ]
    rate_hz = len(commands(server)) / 2 / SECONDS  # two motors
    assert 7.0 < rate_hz < 11.0


@pytest.mark.parametrize("fault", ["errors", "hang up"])
def test_a_toy_that_reports_errors_or_goes_makes_the_status_1(
    clip, force, tmp_path, fault
):
    server = FakeIntiface(gap_ms=50)
    server.errors, server.hangs_up = (10**6, False) if fault == "errors" else (0, True)
    done, events = played(clip, force, server, tmp_path)
    server.close()
    assert done.returncode == 1
    said = "reports an error" if fault == "errors" else "has closed the connection"
    assert said in done.stderr
    assert "Traceback" not in done.stderr
    (lost,) = [one for one in events if one["name"] == "device_lost"]
    assert said in lost["problem"]
    assert said in json.loads(done.stdout)["fault"]


ONLY_STOPS = {"unanswered": ("OutputCmd",)}
STOP_FAILS = {"refuses": {"StopCmd": (4, "toy busy")}, "late_s": {"StopCmd": 0.15}}
LATE_ERROR = {"refuses": {"OutputCmd": (4, "toy busy")}, "late_s": {"OutputCmd": 0.2}}
ONE_BAD = {"more": {"1": {"DeviceIndex": 1, "DeviceFeatures": None}}}


@pytest.mark.parametrize(
    ("faults", "says"),
    [
        (ONLY_STOPS, "stopped: device not responding"),
        (STOP_FAILS, "reports an error (toy busy)"),
        (LATE_ERROR, "reports an error (toy busy)"),
        (ONE_BAD, "a device is left out: Intiface at"),
        ({"refuses": {"Ping": (2, "late ping")}}, "reports an error (late ping)"),
        ({"late_s": {"OutputCmd": 5.0}}, "stopped: device not responding"),
    ],
    ids=["only stops", "stop fails", "late error", "one bad", "ping", "gap of 5 s"],
)
def test_a_fault_of_a_server_is_said_also_at_the_end(
    clip, force, tmp_path, faults, says
):
    server = FakeIntiface(gap_ms=50, max_ping_ms=600)
    for name, value in faults.items():
        setattr(server, name, value)
    done, events = played(clip, force, server, tmp_path)
    server.close()
    assert done.returncode == 1
    assert says in done.stderr
    assert "Traceback" not in done.stderr
    assert says in json.loads(done.stdout)["fault"]
    assert {"trip", "device_lost", "device_notice"} & {one["name"] for one in events}


def test_a_toy_that_does_not_answer_trips_and_is_said(clip, force, tmp_path):
    server = FakeIntiface(gap_ms=50)
    server.falls_silent = True
    done, events = played(clip, force, server, tmp_path)
    server.close()
    assert done.returncode == 1
    assert "stopped: device not responding; check its cable" in done.stderr
    assert ("trip", "reply_lost") in [(one["name"], one.get("cause")) for one in events]
