"""`hapticplayer device`, as a person calls it, on a Falcon on simulated USB."""

import os
import signal

import pytest

from hapticplayer.clock import SystemClock
from tests.e2e.command import hapticplayer, report_of, started
from tests.needed_extras import needs

FALCON = ("--device", "falcon-simulated")


@pytest.fixture
def device(tmp_path):
    def run(*arguments, status=0):
        home = {"XDG_DATA_HOME": str(tmp_path)}
        done = hapticplayer("device", *arguments, env=home)
        assert done.returncode == status, done.stderr
        return done

    return run


def test_the_list_says_what_can_be_chosen_and_what_is_plugged_in(device):
    report = report_of(device("list", "--json"))
    assert {"simulated", "falcon", "none"} <= {d["name"] for d in report["devices"]}
    assert isinstance(report["falcons"], list)


@needs("faults")
def test_info_looks_and_loads_nothing(device):
    report = report_of(device("info", *FALCON, "--json"))
    assert report["firmware"] == "not loaded"
    assert "upload-firmware" in report["kept_firmware"]
    assert report["capabilities"]["axes"] == 3
    assert "homed" not in report
    simulated = report_of(device("info", "--device", "simulated", "--json"))
    assert "firmware" not in simulated


@pytest.mark.realtime
def test_homing_guides_out_then_in_and_ends_homed(device):
    done = device("home", *FALCON)
    lines = [line.split(" (")[0] for line in done.stderr.splitlines()]
    wanted = ["pull the grip out as far as it goes", "push the grip in until it locks"]
    assert [line for line in lines if line in wanted] == wanted
    assert "homed" in done.stdout
    assert device("home", "--device", "simulated", status=2)


@needs("faults")
def test_homing_that_nobody_does_ends(device):
    done = device("home", *FALCON, "--timeout", "0.3", status=1)
    assert "not homed within" in done.stderr


@pytest.mark.parametrize("limit", ["nan", "inf", "-1", "0"])
def test_an_invalid_time_limit_is_refused_first(limit, device):
    done = device("home", *FALCON, f"--timeout={limit}", status=2)
    assert "--timeout" in done.stderr
    assert "firmware" not in done.stderr


def test_firmware_is_kept_only_with_consent_and_if_valid(device, tmp_path):
    from hapticplayer.extras.faults.usb.board import synthetic_image

    file = tmp_path / "image.bin"
    kept = tmp_path / "hapticplayer" / "falcon-firmware.bin"
    upload = ("upload-firmware", file, *FALCON)
    file.write_bytes(b"no firmware at all")
    assert "08AA" in device(*upload, "--yes", status=1).stderr
    file.write_bytes(synthetic_image().data)
    assert "--yes" in device(*upload, status=2).stderr
    assert "known images" in device(*upload, "--yes", status=2).stderr
    assert not kept.exists()
    done = device(*upload, "--yes", "--accept-unknown")
    assert "Novint" in done.stdout  # the note on its licence
    assert kept.read_bytes() == file.read_bytes()
    report = report_of(device("upload-firmware", *FALCON, "--json"))
    assert (report["image"], report["loaded"]) == ("unknown", True)


@pytest.mark.realtime
def test_the_test_asks_and_then_pushes_gently(device):
    test = ("test", "--device", "simulated", "--json")
    assert "up to 1.1 N" in device(*test, status=2).stderr
    for _ in range(5):  # a busy machine lets the force ramp down in between
        report = report_of(device(*test, "--yes"))
        assert report["largest_force_n"] <= 1.125 + 1e-3
        if report["moved_along_the_force"] > 0.9 and report["largest_force_n"] > 1.0:
            break
    assert report["largest_force_n"] > 1.0
    assert report["moved_along_the_force"] > 0.9
    assert all(4.0 < travel < 20.0 for travel in report["travel_mm"])


@pytest.mark.realtime
def test_ctrl_c_ends_the_test_and_leaves_nothing_running():
    clock = SystemClock()
    process = started("device", "test", *FALCON, "--yes", start_new_session=True)
    try:
        clock.sleep_until(clock.now_s() + 2.0)
        process.send_signal(signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
        with pytest.raises(ProcessLookupError):
            os.killpg(process.pid, 0)
    finally:
        if process.poll() is None:
            process.kill()
    assert process.returncode == 128 + signal.SIGINT
    assert "interrupted" in complaint


@pytest.mark.parametrize("action", ["info", "home", "upload-firmware"])
def test_a_falcon_that_is_not_there_is_one_sentence(device, action):
    # nobody has a Falcon of that number
    done = device(action, "--device", "falcon:NOWHERE0", status=1)
    complaint = [x for x in done.stderr.splitlines() if x.startswith("hapticplayer:")]
    assert len(complaint) == 1
    assert "Falcon" in complaint[0]
