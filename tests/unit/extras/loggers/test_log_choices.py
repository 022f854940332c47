"""Tables that do not explain themselves: questions, answers, templates."""

import json

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices, parse_choices, write_template
from hapticplayer.errors import InputError, UsageError
from tests.faults.import_formats import FORMATS, GENERIC, generic, put
from tests.faults.import_signal import sample, true_force, true_rate


@pytest.fixture
def table(tmp_path):
    return put(generic(sample()), tmp_path / "in")


def test_an_unknown_table_asks_what_its_columns_are(table):
    with pytest.raises(UsageError, match="table of 8 columns") as caught:
        read_recording(table)
    assert "counter; t_us; Ax; Ay; Az; Gx; Gy; Gz" in str(caught.value)
    assert "--read-as columns=time,ax,ay,az,gx,gy,gz" in str(caught.value)


def test_units_are_asked_for_all_at_once(table):
    with pytest.raises(UsageError) as caught:
        read_recording(table, parse_choices(GENERIC[:1]))
    for key in ("time-unit=s|ms|us|ns", "accel-unit=m/s2|g", "rate-unit=rad/s|deg/s"):
        assert key in str(caught.value)


@pytest.mark.parametrize(
    ("columns", "sentence"),
    [
        ("time,ax,ay,az,gx,gy,gz", "names 7 columns, the table has 8"),
        ("-,time,ax,ay,az,gx,gy,roll", "unknown name 'roll'"),
        ("-,time,ax,ay,az,gx,gy,gy", "names a column twice"),
        ("-,time,ax,ay,az,gx,gy,-", "lacks gz"),
        ("-,-,ax,ay,az,gx,gy,gz", "lacks time"),
        ("time,ax,ay,az,gx,gy,gz,mx", "names a part of mx, my, mz"),
    ],
)
def test_columns_that_do_not_fit_are_explained(table, columns, sentence):
    with pytest.raises(UsageError, match=sentence):
        read_recording(table, parse_choices([f"columns={columns}"]))


def test_a_template_reads_every_log_of_its_logger(table, tmp_path):
    template = tmp_path / "mine.json"
    write_template(template, parse_choices(GENERIC))
    choices = parse_choices([f"template={template}"])
    assert choices == parse_choices(GENERIC)
    imu = read_recording(table, choices).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06
    assert list(tmp_path.glob("*.part")) == []


def test_a_word_beside_a_template_wins(tmp_path):
    template = tmp_path / "mine.json"
    write_template(template, LogChoices(accel_unit="g", axes="x,y,z"))
    choices = parse_choices(["accel-unit=m/s2", f"template={template}"])
    assert choices == LogChoices(accel_unit="m/s2", axes="x,y,z")


@pytest.mark.parametrize(
    "content",
    ["", "[]", "{", '{"accel-unit": 3}', '{"colour": "red"}', "[" * 60_000,
     json.dumps({"axes": "x" * 70_000}), "null"],
)  # fmt: skip
def test_a_file_that_is_not_a_template_is_refused(tmp_path, content):
    template = tmp_path / "mine.json"
    template.write_text(content)
    with pytest.raises(InputError, match=r"not a template|not valid JSON|is too large"):
        parse_choices([f"template={template}"])


def test_a_template_that_cannot_be_written_is_refused(tmp_path):
    (tmp_path / "no").write_text("")
    with pytest.raises(InputError, match="cannot be written"):
        write_template(tmp_path / "no" / "mine.json", LogChoices(axes="x,y,z"))


@pytest.mark.parametrize("word", ["accel-unit", "colour=red", "=", "accel_sign=2"])
def test_words_that_are_no_choice_are_refused(word):
    with pytest.raises(UsageError):
        parse_choices([word])


@pytest.mark.parametrize("second", ["axes=x,y,z", "axes="])
def test_an_answer_that_another_replaces_is_refused(second):
    with pytest.raises(UsageError, match="give one value"):
        parse_choices(["axes=y,-x,z", second])
    assert parse_choices(["axes=y,-x,z", "axes=y,-x,z"]).axes == "y,-x,z"


@pytest.mark.parametrize(
    "word",
    ["accel-unit=stone", "rate-unit=-1", "rate-unit=nan", "field-unit=0",
     "rate-hz=fast", "rate-hz=-5", "accel-sign=x"],
)  # fmt: skip
def test_values_that_make_no_sense_are_refused(tmp_path, word):
    key = "Razor-AHRS" if word.startswith("rate-hz") else "Ultimate IMU"
    path = put(FORMATS[key].write(sample()), tmp_path / "in")
    with pytest.raises(UsageError):
        read_recording(path, parse_choices([word]))


def test_a_factor_is_a_unit(table):
    words = [*GENERIC[:2], "accel-unit=9.80665", "rate-unit=0.0174532925"]
    imu = read_recording(table, parse_choices(words)).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_sign_of_the_accelerometer_can_be_negated(tmp_path):
    """As MARS of iOS writes it: -1 g upwards; no rotation of axes could mend it."""
    clean = sample()
    clean.force[:] *= -1.0
    path = put(FORMATS["MARS"].write(clean), tmp_path / "in")
    with pytest.raises(UsageError, match="accel-sign=-"):
        read_recording(path)
    imu = read_recording(path, parse_choices(["accel-sign=-"])).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_a_rate_stands_in_for_times(tmp_path):
    clean = sample()
    rows = np.concatenate([clean.force, clean.rate], axis=1)
    path = tmp_path / "rows.csv"
    np.savetxt(path, rows, fmt="%.7f", delimiter="\t")
    words = ["columns=ax,ay,az,gx,gy,gz", "rate-hz=100", "accel-unit=m/s2",
             "rate-unit=rad/s"]  # fmt: skip
    imu = read_recording(path, parse_choices(words)).imu
    assert imu.rate_hz == pytest.approx(100.0)
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_rows_of_one_sensor_each_are_streams_of_their_own(tmp_path):
    """Interleaved rows with empty cells: by their own times, not row by row."""
    clean = sample(apart=True)
    rows = [
        *((t, *f, None, None, None) for t, f in zip(clean.force_s, clean.force, strict=True)),
        *((t, None, None, None, *r) for t, r in zip(clean.rate_s, clean.rate, strict=True)),
    ]  # fmt: skip
    rows.sort(key=lambda row: row[0])
    lines = [",".join("" if v is None else f"{v:.7f}" for v in row) for row in rows]
    path = tmp_path / "merged.csv"
    path.write_text("t,ax,ay,az,gx,gy,gz\n" + "\n".join(lines) + "\n")
    words = ["columns=time,ax,ay,az,gx,gy,gz", "time-unit=s", "accel-unit=m/s2",
             "rate-unit=rad/s"]  # fmt: skip
    imu = read_recording(path, parse_choices(words)).imu
    assert imu.rate_hz == pytest.approx(100.0, rel=1e-3)
    assert imu.valid is None
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def write_two(folder, unit_s=1e-6, begin=0.0):
    """A table of accelerations and one of rates on the same clock, each at its rate."""
    clean = sample(apart=True)
    paths = []
    for name, t, values in (
        ("acc", clean.force_s, clean.force),
        ("gyr", clean.rate_s, clean.rate),
    ):
        rows = zip(t, values, strict=True)
        lines = [
            ";".join([f"{begin + s / unit_s:.0f}", *(f"{x:.6f}" for x in v)])
            for s, v in rows
        ]
        path = folder / f"{name}.csv"
        path.write_text("t;x;y;z\n" + "\n".join(lines) + "\n")
        paths.append(path)
    return paths


TWO = ("columns=time,ax,ay,az/time,gx,gy,gz", "accel-unit=m/s2", "rate-unit=rad/s")


@pytest.mark.parametrize(
    ("unit", "unit_s", "begin"), [("us", 1e-6, 0.0), ("ns", 1e-9, 1e15)]
)
def test_a_table_for_each_sensor_is_one_log(tmp_path, unit, unit_s, begin):
    paths = write_two(tmp_path, unit_s, begin)
    with pytest.raises(UsageError, match="are 2 tables") as caught:
        read_recording(paths)
    assert "t; x; y; z / t; x; y; z" in str(caught.value)
    assert "columns=time,ax,ay,az/time,gx,gy,gz" in str(caught.value)
    imu = read_recording(paths, parse_choices([*TWO, f"time-unit={unit}"])).imu
    assert imu.source.endswith("acc.csv + gyr.csv")
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06
    # a mean over 10 ms lags by 5 ms: 0.4 * 1.7**2 rad/s2
    assert np.abs(imu.angular_rate_radps - true_rate(imu.time_s)).max() < 0.02


@pytest.mark.parametrize(
    ("columns", "sentence"),
    [
        ("time,ax,ay,az", "describes 1 of 2 tables"),
        ("time,ax,ay,az/-,gx,gy,gz", "lacks time"),
        ("time,ax,ay,az/time,ax,ay,az", "names a column twice"),
        ("time,ax,ay,gz/time,gx,gy,az", "names a part of ax, ay, az"),
    ],
)
def test_columns_of_two_tables_are_checked(tmp_path, columns, sentence):
    paths = write_two(tmp_path)
    with pytest.raises(UsageError, match=sentence):
        read_recording(paths, parse_choices([f"columns={columns}"]))


def test_files_of_one_log_are_given_one_by_one(tmp_path):
    """Also those of an app: they are recognised as in its zip."""
    folder = put(FORMATS["phyphox X Y Z"].write(sample(apart=True)), tmp_path / "in")
    names = ("Accelerometer.csv", "Gyroscope.csv")
    recording = read_recording([folder / name for name in names])
    assert recording.camera == "phyphox"
    assert len(recording.imu) > 1000


def test_files_of_the_same_name_are_told_apart(tmp_path):
    paths = write_two(tmp_path)
    moved = []
    for path in paths:
        folder = tmp_path / path.stem
        folder.mkdir()
        moved.append(path.rename(folder / "data.csv"))
    imu = read_recording(moved, parse_choices([*TWO, "time-unit=us"])).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


@pytest.mark.parametrize("other", ["in", "missing.csv"])
def test_a_part_that_is_not_a_file_is_refused(tmp_path, other):
    (tmp_path / "in").mkdir()
    paths = [write_two(tmp_path)[0], tmp_path / other]
    with pytest.raises(InputError, match=other):
        read_recording(paths)


def test_format_can_be_chosen_but_not_against_the_content(table):
    with pytest.raises(UsageError, match="is not a log of Gyroflow"):
        read_recording(table, parse_choices(["format=gcsv"]))
    with pytest.raises(UsageError, match="format 'xls' not found"):
        read_recording(table, parse_choices(["format=xls"]))
