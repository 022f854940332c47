from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.si_csv import READER, write_imu_csv
from hapticplayer.capture.source import open_file
from hapticplayer.errors import InputError
from hapticplayer.model import ImuLog, Sampling


def read_imu(path: Path) -> ImuLog:
    """Read as such a log, whatever it is recognised as."""
    return READER.read(open_file(path), LogChoices()).imu


HEADER = "time_s,ax,ay,az,gx,gy,gz"
ROW = "{},0.1,0.2,9.8,0,0,0.01"


def log_lines(count: int = 20) -> list[str]:
    return [HEADER, *(ROW.format(number / 100) for number in range(count))]


def write(path: Path, lines: list[str], newline: str = "\n") -> Path:
    path.write_bytes((newline.join(lines) + newline).encode())
    return path


def test_plain_log_is_read(tmp_path):
    imu = read_imu(write(tmp_path / "log.csv", log_lines()))
    assert imu.time_s == pytest.approx(np.arange(20) / 100)
    np.testing.assert_array_equal(imu.specific_force_mps2[3], [0.1, 0.2, 9.8])
    np.testing.assert_array_equal(imu.angular_rate_radps[3], [0.0, 0.0, 0.01])
    assert imu.magnetic_field_ut is None
    assert imu.sampling is Sampling.INSTANT
    assert imu.source.endswith("log.csv")


def test_the_one_log_of_a_folder_is_read(tmp_path):
    write(tmp_path / "log.csv", log_lines())
    (tmp_path / "truth.npz").write_bytes(bytes(range(256)))
    found = read_recording(tmp_path)
    assert len(found.imu) == 20
    assert found.imu.source.endswith("log.csv")


def test_field_columns_are_read(tmp_path):
    lines = [
        HEADER + ",mx,my,mz",
        *(f"0.0{t},0,0,9.8,0,0,0,20,-3,40" for t in range(3)),
    ]
    imu = read_imu(write(tmp_path / "log.csv", lines))
    assert imu.magnetic_field_ut is not None
    np.testing.assert_array_equal(imu.magnetic_field_ut[1], [20.0, -3.0, 40.0])


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\n\n"])
@pytest.mark.parametrize("start", ["", "\ufeff"])
def test_spaces_marks_and_line_ends_are_tolerated(tmp_path, newline, start):
    lines = [line.replace(",", " , ") for line in log_lines()]
    lines[0] = start + lines[0]
    imu = read_imu(write(tmp_path / "log.csv", [*lines, "", "  "], newline))
    assert len(imu) == 20


def test_write_and_read_agree_to_nine_digits(tmp_path):
    rng = np.random.default_rng(3)
    imu = ImuLog(
        time_s=np.cumsum(rng.uniform(0.004, 0.006, 500)) - 1.0,
        specific_force_mps2=rng.normal((0.0, 0.0, 9.8), 1.0, (500, 3)),
        angular_rate_radps=rng.normal(0.0, 1.0, (500, 3)),
        magnetic_field_ut=rng.normal(0.0, 30.0, (500, 3)),
    )
    path = tmp_path / "log.csv"
    write_imu_csv(path, imu)
    again = read_imu(path)
    np.testing.assert_allclose(again.time_s, imu.time_s, atol=6e-10)
    for name in ("specific_force_mps2", "angular_rate_radps", "magnetic_field_ut"):
        np.testing.assert_allclose(getattr(again, name), getattr(imu, name), rtol=1e-8)
    assert [entry.name for entry in tmp_path.iterdir()] == ["log.csv"]


def test_folder_that_cannot_be_written_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    imu = read_imu(write(tmp_path / "log.csv", log_lines()))
    with pytest.raises(InputError, match="cannot be written"):
        write_imu_csv(tmp_path / "file" / "log.csv", imu)


def changed(number: int, line: str) -> list[str]:
    lines = log_lines()
    lines[number - 1] = line
    return lines


def noisy_lines(
    count: int = 200, *, scale: float = 1.0, step_s: float = 0.01
) -> list[str]:
    """A log at rest; its specific force times a factor, with other time steps."""
    noise = 0.02 * np.random.default_rng(4).standard_normal((count, 6))
    rows = noise + np.array([0.1, 0.2, 9.8, 0.0, 0.0, 0.0])
    rows[:, :3] *= scale
    cells = (
        f"{k * step_s:.6g}," + ",".join(f"{v:.6f}" for v in rows[k])
        for k in range(count)
    )
    return [HEADER, *cells]


FAULTS = {
    "word": (changed(9, "0.07,0,0,9.8,0,zero,0"), "line 9, column gy: 'zero'"),
    "word beside an empty cell": (
        changed(9, "0.07,0,,9.8,0,zero,0"),
        "line 9, column gy: 'zero' is not a number",
    ),
    "underscore": (changed(9, "0.07,0,0,1_0,0,0,0"), "line 9, column az: '1_0'"),
    "decimal comma": (changed(9, "0,07,0,0,9,8,0,0,0"), "line 9: has 9 columns"),
    "short": (changed(12, "0.1,0,0,9.8"), "line 12: has 4 columns, the header has 7"),
    "long": (changed(12, "0.1,0,0,9.8,0,0,0,1"), "line 12: has 8 columns"),
    "clock set back": (
        [*log_lines(), *log_lines()[1:]],
        "time_s jumps back by 0.19 s at line 22; cut the recording there",
    ),
    "mostly empty": (
        [
            HEADER,
            *(ROW.format(t / 9) if t < 9 else f"{t / 9},,,,0,0,{t}" for t in range(20)),
        ],
        "specific_force_mps2 is zero, not finite .* in 11 of 20 rows, first in line 11",
    ),
    "stuck": (log_lines(60), "sensor was stuck"),
    "endless": (changed(12, "0.1" + ",0" * 9000), "line 12: is longer than 4096"),
    "no rows": ([HEADER], "has 0 rows"),
    "one row": (log_lines(1), "has 1 rows"),
    "no header": (log_lines()[1:], "line 1: there is no header"),
    "names": (["time,ax,ay,az,gx,gy,gz", *log_lines()[1:]], "the header is 'time,ax"),
    "a column too few": (
        [HEADER + ",mx", *log_lines()[1:]],
        "line 2: has 7 columns, the header has 8",
    ),
    "a column twice": (
        [HEADER + ",ax", *(f"{line},0" for line in log_lines()[1:])],
        "the header is",
    ),
    "in g": (noisy_lines(scale=1 / 9.80665), "decide with --read-as accel-unit=g"),
    "in milli-g": (
        noisy_lines(scale=1000 / 9.80665),
        "decide with --read-as accel-unit=mg",
    ),
    "without gravity": (noisy_lines(scale=1e-3), "gravity seems to be removed"),
    "in counts": (noisy_lines(scale=26.0), "give the specific force in m/s"),
    "in milliseconds": (noisy_lines(step_s=10.0), "divide time_s by 1000"),
    "one huge value": (
        changed(9, "0.07,0,0,1e30,0,0,0"),
        "acceleration of 1e\\+30 m/s2, beyond any sensor",
    ),
    "one enormous value": (
        changed(9, "0.07,1e308,0,-1e308,0,0,0"),
        "acceleration of 1e\\+308 m/s2, beyond any sensor",
    ),
    "enormous throughout": (
        [HEADER, *(f"0.{k:02},1e308,0,1e308,0,0,0" for k in range(99))],
        "beyond any sensor in 99 of 99 rows",
    ),
    "in degrees": (
        changed(9, "0.07,0,0,9.8,0,0,250"),
        "decide with --read-as rate-unit=deg/s",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_fault_is_named_with_its_place_and_a_remedy(tmp_path, name):
    lines, sentence = FAULTS[name]
    path = write(tmp_path / "log.csv", lines)
    with pytest.raises((InputError, LogQuestion), match=sentence) as caught:
        read_imu(path)
    assert "log.csv" in str(caught.value)
    assert "; " in str(caught.value)
    assert "\n" not in str(caught.value)


def with_cell(line: str, column: int, cell: str) -> str:
    cells = line.split(",")
    cells[column] = cell
    return ",".join(cells)


@pytest.mark.parametrize("cell", ["", "  ", "nan", "NaN", "inf", "-inf"])
@pytest.mark.parametrize("column", [1, 3, 6])
def test_a_missing_value_is_filled_marked_and_noted(tmp_path, cell, column):
    lines = noisy_lines()
    clean = read_imu(write(tmp_path / "clean.csv", lines))
    lines[60] = with_cell(lines[60], column, cell)
    lines.insert(20, "")
    log = read_recording(write(tmp_path / "log.csv", lines))
    assert log.imu.valid is not None
    assert np.flatnonzero(~log.imu.valid).tolist() == [59]
    kept = np.arange(200) != 59
    force = log.imu.specific_force_mps2
    np.testing.assert_array_equal(force[kept], clean.specific_force_mps2[kept])
    assert np.abs(force[59] - clean.specific_force_mps2[59]).max() < 0.1
    name = "specific_force_mps2" if column < 4 else "angular_rate_radps"
    assert len(log.notes) == 1
    assert f"1 of 200 samples of {name} were missing" in log.notes[0]
    assert "first in line 62" in log.notes[0]  # the header and an empty line before it


def test_a_clean_log_has_nothing_to_say(tmp_path):
    log = read_recording(write(tmp_path / "log.csv", noisy_lines()))
    assert log.notes == ()
    assert log.imu.valid is None


def test_a_missing_time_is_interpolated(tmp_path):
    lines = noisy_lines()
    lines[60] = with_cell(lines[60], 0, "")
    log = read_recording(write(tmp_path / "log.csv", lines))
    np.testing.assert_allclose(log.imu.time_s, np.arange(200) / 100, atol=1e-12)
    assert log.notes == (
        "1 missing or implausible times were interpolated (first in line 61)",
    )


def test_swapped_and_repeated_rows_are_put_in_order(tmp_path):
    lines = noisy_lines()
    clean = read_imu(write(tmp_path / "clean.csv", lines))
    lines[30], lines[31] = lines[31], lines[30]
    lines.insert(100, lines[100])
    log = read_recording(write(tmp_path / "log.csv", lines))
    np.testing.assert_array_equal(log.imu.time_s, clean.time_s)
    np.testing.assert_array_equal(
        log.imu.specific_force_mps2, clean.specific_force_mps2
    )
    assert log.imu.valid is None
    assert [note.split(" ", 1)[1] for note in log.notes] == [
        "pairs of rows were swapped in time and put in order (first in line 31)",
        "of 201 rows repeat the one before and were left out (first in line 102)",
    ]


def test_a_gap_stays_a_gap(tmp_path):
    lines = noisy_lines()
    del lines[101:151]
    log = read_recording(write(tmp_path / "log.csv", lines))
    assert len(log.imu) == 150
    assert np.diff(log.imu.time_s).max() == pytest.approx(0.51)
    assert "about 50 samples were never recorded" in log.notes[1]


def test_a_log_without_noise_is_read_with_a_note(tmp_path):
    log = read_recording(write(tmp_path / "log.csv", log_lines()))
    assert log.notes == ("all samples are the same: was the sensor stuck?",)


def test_fault_is_found_behind_empty_lines(tmp_path):
    lines = log_lines()
    lines[5:5] = ["", "", ""]
    lines[12] = "x"
    with pytest.raises(InputError, match="line 13"):
        read_imu(write(tmp_path / "log.csv", lines))


@pytest.mark.parametrize(
    "content",
    [b"\xff\xfe\x00\x01", b"\x00" * 5000, b"time_s,ax\x00", b"\x89PNG\r\n\x1a\n\x00"],
)
def test_binary_content_is_refused(tmp_path, content):
    path = tmp_path / "log.csv"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"line 1|not a text file"):
        read_imu(path)


def test_letters_behind_the_header_that_are_not_utf8_are_refused(tmp_path):
    path = tmp_path / "log.csv"
    path.write_bytes("\n".join(log_lines()).encode() + b"\n\xff\xff")
    with pytest.raises(InputError, match="not a text file in UTF-8"):
        read_imu(path)


@pytest.mark.parametrize(
    ("limit", "value", "sentence"),
    [
        ("source.MAX_CSV_BYTES", 99, "larger than the limit"),
        ("csv_table.MAX_CSV_ROWS", 19, "has more than 19 rows"),
    ],
)
def test_limits_refuse_just_above(tmp_path, monkeypatch, limit, value, sentence):
    path = write(tmp_path / "log.csv", log_lines())
    monkeypatch.setattr(f"hapticplayer.capture.{limit}", value)
    with pytest.raises(InputError, match=sentence):
        read_imu(path)
    room = path.stat().st_size if "BYTES" in limit else 20
    monkeypatch.setattr(f"hapticplayer.capture.{limit}", room)
    assert len(read_imu(path)) == 20


def test_missing_file_and_folder_are_refused(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_imu(tmp_path / "none.csv")
    with pytest.raises(InputError, match="is a folder"):
        read_imu(tmp_path)


def test_rough_ride_passes_the_unit_check(tmp_path):
    """GoPro in sport: peaks of 55 m/s2 and 11 rad/s are no unit error."""
    rng = np.random.default_rng(2)
    force = rng.normal((0.0, 0.0, 9.8), 12.0, (400, 3)).clip(-55, 55)
    rate = rng.normal(0.0, 4.0, (400, 3))
    path = tmp_path / "log.csv"
    write_imu_csv(path, ImuLog(np.arange(400) / 200, force, rate))
    assert len(read_imu(path)) == 400
