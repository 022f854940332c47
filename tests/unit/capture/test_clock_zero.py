"""What the offset of a person refers to: each format's clock zero, as documented."""

import re
from dataclasses import replace

import pytest

from hapticplayer.capture import formats, read_recording
from hapticplayer.capture.choices import parse_choices
from tests.faults.import_formats import FORMATS, put
from tests.faults.import_signal import Sampled, sample
from tests.needed_extras import needs

pytestmark = needs("loggers")

LATE_S = 2.5
"""The first sample, on the clock that is written."""

WRITTEN = {  # the format's name: what writes it, and the time of the first sample
    "gopro": ("GoPro, raw", LATE_S),
    "si-csv": ("own CSV", LATE_S),
    "sensor-logger": ("Sensor Logger Android", LATE_S),  # its seconds_elapsed
    "phyphox": ("phyphox tab", LATE_S),
    "gcsv": ("gcsv", LATE_S),
    "euroc": ("EuRoC", 0.0),
    "mars": ("MARS", 0.0),
    "razor": ("Razor-AHRS", 0.0),
    "ultimate-imu": ("Ultimate IMU", LATE_S),
    "razor-m0": ("Razor M0", LATE_S + 5.321),  # since its start
    "opencamera": ("OpenCamera Sensors", 0.0),
    "androsensor": ("AndroSensor", LATE_S),
    "racechrono": ("RaceChrono", 0.0),
    "xsens-dot": ("Xsens DOT", 0.0),
    "xsens-mt": ("Xsens MTw", 0.0),
    "csv": ("generic CSV", LATE_S),
}


def late(apart: bool) -> Sampled:
    clean = sample(apart=apart)
    return replace(
        clean,
        force_s=clean.force_s + LATE_S,
        rate_s=clean.rate_s + LATE_S,
        field_s=clean.field_s + LATE_S,
    )


@pytest.mark.parametrize(
    "name", [one.name for one in formats.FORMATS if one.name != "recorded"]
)
def test_clock_reads_zero_where_the_table_says(tmp_path, name):
    key, first_s = WRITTEN[name]
    one = FORMATS[key]
    path = put(one.write(late(one.apart)), tmp_path / "in")
    recording = read_recording(path, parse_choices(one.choices))
    assert recording.imu.time_s[0] == pytest.approx(first_s, abs=1e-3)


def test_nanoseconds_of_a_table_count_from_its_first_row(tmp_path):
    path = tmp_path / "log.csv"
    rows = (
        f"{1_700_000_000_000_000_000 + k * 10_000_000},0.0{k % 7},0,9.8{k % 3},0,0,0.0{k % 2}"
        for k in range(500)
    )
    path.write_text("t,a,b,c,d,e,f\n" + "\n".join(rows) + "\n")
    words = ["columns=time,ax,ay,az,gx,gy,gz", "time-unit=ns", "accel-unit=m/s2",
             "rate-unit=rad/s"]  # fmt: skip
    assert read_recording(path, parse_choices(words)).imu.time_s[0] == 0.0


@pytest.mark.parametrize("cell", ["", "nan", "1e300", "oops"])
def test_unusable_elapsed_times_leave_the_first_sample(tmp_path, cell):
    files = FORMATS["Sensor Logger Android"].write(sample(apart=True))
    elapsed = re.compile(rb"^(\d+),[^,]+,", re.MULTILINE)
    files = {
        name: elapsed.sub(rb"\1," + cell.encode() + b",", content)
        for name, content in files.items()
    }
    imu = read_recording(put(files, tmp_path / "in")).imu
    assert imu.time_s[0] == pytest.approx(0.0, abs=1e-3)
