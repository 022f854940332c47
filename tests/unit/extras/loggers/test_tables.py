"""Tables as programs and people write them are read, or the cell and the cure named."""

import itertools
import re
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import KEYS, LogQuestion, parse_choices
from hapticplayer.errors import HapticPlayerError, InputError, UsageError
from tests.faults.import_formats import FORMATS, put
from tests.faults.import_signal import sample
from tests.unit.capture.conftest import DATA

CASES = DATA.parent / "cases"
COUNT = 400
RNG = np.random.default_rng(4)
FORCE = np.array([0.0, 0.0, 9.81]) + 0.1 * RNG.standard_normal((COUNT, 3))
RATE = 0.2 * RNG.standard_normal((COUNT, 3))
SECONDS = np.arange(COUNT) / 50.0
HEADER = ["time", "ax", "ay", "az", "gx", "gy", "gz"]
COLUMNS = "columns=time,ax,ay,az,gx,gy,gz"
UNITS = ("accel-unit=m/s2", "rate-unit=rad/s")


def table(times, header=HEADER, separator=",", number="{:.5f}".format, end=""):
    """A table with these texts as times."""
    lines = [separator.join(header) + end]
    for time, row in zip(times, np.hstack([FORCE, RATE]), strict=True):
        lines.append(separator.join([time, *map(number, row)]) + end)
    return "\n".join(lines) + "\n"


def read(path, *words):
    return read_recording(path, parse_choices(words))


def check(found, begin_s=None):
    imu = found.imu
    since_s = imu.time_s - (imu.time_s[0] if begin_s is None else begin_s)
    np.testing.assert_allclose(since_s, SECONDS, atol=2e-6)
    np.testing.assert_allclose(imu.specific_force_mps2, FORCE, atol=1e-4)
    np.testing.assert_allclose(imu.angular_rate_radps, RATE, atol=1e-4)


def clock(format_, begin_s=86_395.0):
    """Clock times that pass midnight."""
    for second in begin_s + SECONDS:
        whole, part = divmod(round(1000 * second), 1000)
        hour, minute = whole // 3600 % 24, whole // 60 % 60
        day = 28 + whole // 86_400
        yield format_.format(
            h=hour, h12=(hour - 1) % 12 + 1, m=minute, s=whole % 60, ms=part,
            day=day, half="PM" if hour >= 12 else "AM",
        )  # fmt: skip


CLOCKS = [
    "{h:02}:{m:02}:{s:02}.{ms:03}",
    "{h:02}:{m:02}:{s:02}:{ms:03}",
    "{h12}:{m:02}:{s:02}.{ms:03} {half}",
    "2023-10-{day}T{h:02}:{m:02}:{s:02}.{ms:03}Z",
    "2023-10-{day} {h:02}:{m:02}:{s:02}.{ms:03} +0200",
    '"2023/10/{day} {h:02}:{m:02}:{s:02}.{ms:03}"',
    "{day}.10.2023 {h:02}:{m:02}:{s:02}.{ms:03}",
    '"10/{day}/2023, {h:02}:{m:02}:{s:02}.{ms:03}"',
]


@pytest.mark.parametrize("written", CLOCKS)
def test_clock_times_and_dates_are_times(tmp_path, written):
    path = tmp_path / "log.csv"
    path.write_text(table(clock(written)))
    with pytest.raises(UsageError, match="time-unit=ms"):
        read(path, COLUMNS, *UNITS, "time-unit=ms")
    check(read(path, COLUMNS, *UNITS, "time-unit=s"), 0.0)
    check(read(path, COLUMNS, *UNITS), 0.0)


def test_dates_with_a_decimal_comma_are_times(tmp_path):
    path = tmp_path / "log.csv"
    times = clock("2023-10-{day} {h:02}:{m:02}:{s:02},{ms:03}")
    path.write_text(
        table(times, separator=";", number=lambda x: f"{x:.5f}".replace(".", ","))
    )
    check(read(path, COLUMNS, *UNITS), 0.0)


@pytest.mark.parametrize(
    ("unit", "scale", "begin"),
    [("ms", 1e3, 1_700_000_000_000), ("us", 1e6, 1_700_000_000_000_000),
     ("ns", 1e9, 1_700_000_000_000_000_000), ("us", 1e6, 2**32 - 3_000_000),
     ("ms", 1e3, 2**32 - 3_000), ("us", 1e6, 2**24 - 3_000_000),
     ("ms", 1e3, 2**16 - 3_000), ("us", 1e6, 2**31 - 3_000_000)],
)  # fmt: skip
def test_counters_since_1970_or_that_start_again_are_times(
    tmp_path, unit, scale, begin
):
    counts = [begin + round(scale * second) for second in SECONDS]
    if begin < 2**33:  # as many bits as it begins with; the last one is signed
        turn = 2 ** (begin.bit_length() + (begin < 2**31 < counts[-1]))
        low = -(turn // 2) if begin < 2**31 < counts[-1] else 0
        counts = [(one - low) % turn + low for one in counts]
        assert min(counts) < counts[0]
    path = tmp_path / "log.csv"
    path.write_text(table(map(str, counts)))
    check(read(path, COLUMNS, *UNITS, f"time-unit={unit}"))


NUMBERS = {
    "N/A": lambda k, x: "N/A" if k == 70 else f"{x:.5f}",
    "nan": lambda k, x: "nan" if k == 70 else f"{x:.5f}",
    "null": lambda k, x: "NULL" if k == 70 else f"{x:.5f}",
    "dashes": lambda k, x: " -- " if k == 70 else f"{x:.5f}",
    "empty": lambda k, x: "" if k == 70 else f"{x:.5f}",
    "question marks": lambda k, x: "?" if k == 70 else f"{x:.5f}",
}


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("kind", NUMBERS)
def test_words_for_no_number_are_holes(tmp_path, kind, separator):
    cell, counter = NUMBERS[kind], itertools.count()
    path = tmp_path / "log.csv"
    path.write_text(
        table(
            [f"{t:.3f}" for t in SECONDS],
            separator=separator,
            number=lambda x: cell(next(counter), x),
        )
    )
    found = read(path, COLUMNS, *UNITS, "time-unit=s")
    assert np.flatnonzero(~found.imu.valid).tolist() == [70 // 6]
    assert found.notes[1].startswith("1 of 400 samples")
    assert "damaged" not in " ".join(found.notes)


@pytest.mark.parametrize(
    ("separator", "group", "point", "quote"),
    [(",", ",", ".", '"'), (";", ",", ".", ""), (";", ".", ",", ""),
     ("\t", "\u202f", ",", ""), (";", "\xa0", ",", ""), (",", "'", ".", ""),
     (",", ".", ",", '"')],
)  # fmt: skip
def test_thousands_may_be_grouped(tmp_path, separator, group, point, quote):
    def number(value, digits=5):
        text = f"{value:,.{digits}f}".replace(".", "\0").replace(",", group)
        return quote + text.replace("\0", point) + quote

    path = tmp_path / "log.csv"
    times = [number(1000 * t + 998_000, 1) for t in SECONDS]
    text = table(times, separator=separator, number=number)
    path.write_text(text, encoding="utf-8")
    check(read(path, COLUMNS, *UNITS, "time-unit=ms"), 998.0)


def test_texts_between_the_numbers_are_skipped_or_named(tmp_path):
    path = tmp_path / "log.csv"
    rows = table([f"{t:.3f}" for t in SECONDS]).splitlines()
    lines = ["state,note,", *(f'a_b,"to the ""left"", µ{k}",' for k in range(COUNT))]
    joined = "\n".join(a + b for a, b in zip(lines, rows, strict=True))
    path.write_text(joined, encoding="utf-8")
    check(read(path, COLUMNS.replace("time", "-,-,time"), "time-unit=s", *UNITS))
    with pytest.raises(
        UsageError, match="column 2 for time, but it holds 'to the"
    ) as e:
        read(path, "columns=-,time,ax,ay,az,gx,gy,gz,-", "time-unit=s", *UNITS)
    assert "ignore it with -" in str(e.value)


def test_whole_seconds_are_those_that_rows_follow(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(table([f"{t:.0f}" for t in np.floor(SECONDS)]))
    check(read(path, COLUMNS, "time-unit=s", *UNITS), 0.0)


def test_the_newest_row_may_come_first(tmp_path):
    path = tmp_path / "log.csv"
    head, *rows = table([f"{t:.3f}" for t in SECONDS]).splitlines()
    path.write_text("\n".join([head, *rows[::-1]]))
    found = read(path, COLUMNS, "time-unit=s", *UNITS)
    check(found, 0.0)
    assert "the newest came first" in " ".join(found.notes)


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize(
    ("true", "scale", "given"),
    [("us", 1e6, "ns"), ("us", 1e6, "ms"), ("ms", 1e3, "us"), ("d", 1 / 86_400, "s")],
)
def test_a_wrong_unit_of_time_is_asked_about(tmp_path, true, scale, given, count):
    times = [f"{scale * t:.12f}" for t in SECONDS]
    paths = [tmp_path / f"{k}.csv" for k in range(count)]
    columns = COLUMNS
    for path in paths:
        path.write_text(table(times))
    if count == 2:
        columns = "columns=time,ax,ay,az,-,-,-/time,-,-,-,gx,gy,gz"
    with pytest.raises(LogQuestion, match="samples a second") as asked:
        read(paths, columns, f"time-unit={given}", *UNITS)
    assert asked.value.answers == (f"time-unit={true}",)
    check(read(paths, columns, *UNITS, *asked.value.answers), 0.0)


def with_row_names(rows):
    """As R writes them: the names of the rows have no name."""
    head, *rows = rows
    return [head, *(f'"{k}",{row}' for k, row in enumerate(rows, start=1))]


def behind_clock_times(rows):
    """As the serial monitor of Arduino writes them, without a header."""
    stamps = [f"23:59:{5 * k / 100:06.3f} -> " for k in range(COUNT)]
    return [a + b for a, b in zip(stamps, rows[1:], strict=True)]


@pytest.mark.parametrize(
    ("written", "is_proposed"), [(with_row_names, True), (behind_clock_times, False)]
)
def test_columns_before_the_first_name_are_ignored(tmp_path, written, is_proposed):
    path = tmp_path / "log.csv"
    rows = table([f"{1000 * t:.0f}" for t in SECONDS]).splitlines()
    path.write_text("\n".join(written(rows)))
    columns = COLUMNS.replace("time", "-,time")
    with pytest.raises(LogQuestion, match="8 columns") as asked:
        read(path)
    assert (f"{columns} " in asked.value.answers[0]) == is_proposed
    check(read(path, columns, "time-unit=ms", *UNITS), 0.0)


def test_a_row_for_each_sensor_is_named(tmp_path):
    path = tmp_path / "log.csv"
    lines, files = ["time,sensor,x,y,z"], {"acc": [], "gyr": []}
    for t, force, rate in zip(SECONDS, FORCE, RATE, strict=True):
        for name, row in (("acc", force), ("gyr", rate)):
            files[name].append(f"{t:.3f},{name},{row[0]:.5f},{row[1]:.5f},{row[2]:.5f}")
        lines += [files["acc"][-1], files["gyr"][-1]]
    path.write_text("\n".join(lines))
    with pytest.raises(InputError, match=r"column 2 holds acc, gyr.*give both"):
        read(path)
    parts = []
    for name, rows in files.items():
        parts.append(tmp_path / f"{name}.csv")
        parts[-1].write_text("\n".join(rows))
    columns = "columns=time,-,ax,ay,az/time,-,gx,gy,gz"
    check(read(parts, columns, "time-unit=s", *UNITS), 0.0)


def test_decimal_commas_between_commas_are_named(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(
        table([f"{t:.3f}" for t in SECONDS]).replace(".", ","), encoding="utf-8"
    )
    with pytest.raises(InputError, match="decimal commas between commas"):
        read(path)


@pytest.mark.parametrize("lines", [3, 70, 2000, 20_000])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_header_may_have_any_length(tmp_path, lines, end):
    path = tmp_path / "log.csv"
    head = "".join(f'"parameter_{k}","{k}"\n' for k in range(lines))
    text = head + table([f"{t:.3f}" for t in SECONDS])
    path.write_text(text.replace("\n", end), newline="")
    check(read(path, COLUMNS, "time-unit=s", *UNITS))


@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_our_names_are_read_in_any_order_and_among_others(tmp_path, separator, mark):
    order = [4, 5, 6, 0, 3, 2, 1]
    path = tmp_path / "log.csv"
    lines = []
    for line in table([f"{t:.3f}" for t in SECONDS]).splitlines():
        cells = line.replace("time", "time_s").split(",")
        if separator != ",":
            cells = [cell.replace(".", ",") for cell in cells]
        lines.append(separator.join(["time_s" if not lines else cells[0], *cells[1:]]))
    path.write_text(mark + "\n".join(lines))
    check(read(path))
    shuffled = [
        separator.join([line.split(separator)[0], "7", *line.split(separator)[1:], "x"])
        for line in lines
    ]
    shuffled[0] = separator.join(["time_s", "lap", *HEADER[1:], "remark"])
    path.write_text(mark + "\n".join(shuffled))
    found = read(path)
    check(found)
    assert "not read: the columns lap, remark" in found.notes
    turned = [
        separator.join(["7", *(line.split(separator)[at] for at in order)])
        for line in lines
    ]
    path.write_text("\n".join(["time_s" + turned[0][1:], *turned[1:]]))
    with pytest.raises(HapticPlayerError, match="time_s"):  # a name twice
        read(path)


def test_commas_that_excel_adds_are_no_columns(tmp_path):
    path = tmp_path / "log.csv"
    own = table([f"{t:.3f}" for t in SECONDS], ["time_s", *HEADER[1:]], end=",,")
    path.write_text(own)
    check(read(path))
    path.write_text("My ride,,,,,,,,\n" + own.replace("time_s", "t"))
    check(read(path, COLUMNS, "time-unit=s", *UNITS))
    short = own.splitlines()
    path.write_text("\n".join([short[0], *(one.rstrip(",") for one in short[1:])]))
    with pytest.raises(InputError, match="line 2: has 7 columns, the header has 9"):
        read(path)


def test_a_unit_that_cannot_be_names_its_line(tmp_path):
    path = tmp_path / "log.csv"
    text = table([f"{t:.3f}" for t in SECONDS], ["time_s", *HEADER[1:]], ";")
    path.write_text(text.replace(";9.", ";9.8 g;", 1).replace(";9.8 g;", ";9.8 g", 1))
    with pytest.raises(InputError, match=r"line 2, column az: '9\.8 g"):
        read(path)


GCSV = """GYROFLOW IMU LOG{end}
version,1.1{end}
id,board{end}
orientation,XYZ{end}
tscale,{scale}{end}
gscale,1{end}
ascale,0.101971621{end}
"""


@pytest.mark.parametrize(
    ("names", "end"),
    [
        (["t", "ax", "ay", "az", "gx", "gy", "gz"], ""),
        (["t", "ax", "ay", "az", "rx", "ry", "rz"], ",,,,,,"),
        (["time", "ax", "ay", "az", "gx", "gy", "gz", "temp", "pressure"], ",,"),
    ],
)
def test_gcsv_is_read_by_the_names_of_its_columns(tmp_path, names, end):
    more = ",25,1013" * (len(names) > 7)
    begin = 2**32 - 3_000_000
    times = [str((begin + round(1e6 * t)) % 2**32) for t in SECONDS]
    path = tmp_path / "log.gcsv"
    rows = table(times, names[:7], end=more)
    rows = rows.replace(f"{names[6]}{more}", ",".join(names[6:]), 1)
    path.write_text(GCSV.format(end=end, scale="0.000001") + rows)
    check(read(path))


def test_gcsv_without_a_sensor_names_its_columns(tmp_path):
    path = tmp_path / "log.gcsv"
    names = ["t", "ax", "ay", "az", "p", "q", "r"]
    rows = table([f"{1000 * t:.0f}" for t in SECONDS], names)
    path.write_text(GCSV.format(end="", scale="0.001") + rows)
    with pytest.raises(InputError, match="holds t,ax,ay,az,p,q,r; columns of gyro"):
        read(path)


@pytest.mark.parametrize("stamp", ["1e300", "-1e300", "1e308", "inf", "9" * 400])
@pytest.mark.parametrize("where", [0, 70, 399])
@pytest.mark.parametrize("unit", ["s", "us", "ns"])
@pytest.mark.filterwarnings("error")
def test_enormous_times_are_refused_without_a_warning(tmp_path, stamp, where, unit):
    scale = {"s": 1.0, "us": 1e6, "ns": 1e9}[unit]
    times = [f"{scale * t:.3f}".removesuffix(".000") for t in SECONDS]
    times[where] = stamp
    path = tmp_path / "log.csv"
    for header, words in (
        (["time_s", *HEADER[1:]], ()),
        (HEADER, (COLUMNS, f"time-unit={unit}", *UNITS)),
    ):
        path.write_text(table(times, header))
        try:
            found = read(path, *words).imu
        except InputError:
            continue
        assert np.isfinite(found.time_s).all()


@pytest.mark.parametrize("key", FORMATS)
@pytest.mark.filterwarnings("error")
def test_enormous_cells_of_any_format_are_no_warnings(tmp_path, key):
    one = FORMATS[key]
    # both sensors are compared from 2 s on: a second for each cell, so in one format
    files = one.write(sample(4.0 if key == "Razor $" else 1.8, apart=one.apart))
    if key == "GoPro, raw":
        pytest.skip("holds no text")
    for name, content in files.items():
        lines = content.split(b"\n")
        row = len(lines) // 2
        cells = re.split(rb"([,;\t])", lines[row])
        enormous = itertools.cycle((b"1e300", b"-1e308"))
        for at, cell in zip(range(0, len(cells), 2), enormous, strict=False):
            spoilt = b"".join([*cells[:at], cell, *cells[at + 1 :]])
            damaged = b"\n".join([*lines[:row], spoilt, *lines[row + 1 :]])
            path = put(
                {**files, name: damaged}, tmp_path / f"{name}{at}{cell.decode()}"
            )
            try:
                imu = read(path, *one.choices).imu
            except HapticPlayerError:
                continue
            assert np.isfinite(imu.specific_force_mps2).all()


def followed(path, *given):
    """Read with the answers that the questions print, the first of each."""
    words = list(given)
    for _ in range(6):
        try:
            return read(path, *words)
        except LogQuestion as question:
            text = question.answers[0]
            new = [w.split("|")[0] for w in text.split() if re.match(r"[a-z-]+=", w)]
            assert new, text
            assert all(word.partition("=")[0] in KEYS for word in new)
            words += new
    raise AssertionError("the questions have no end")


def case(*names: str) -> list[Path]:
    paths = [CASES / name for name in names]
    if not all(path.is_file() for path in paths):
        pytest.skip(f"needs ../shared/data/cases/{names[0]}")
    return paths


TEXTS, NUMBERS_AS_WRITTEN = "text-columns", "number-spellings"
G, DPS, COUNTS = "accel-unit=g", "rate-unit=deg/s", "accel-unit=0.00478840332"


@pytest.mark.parametrize(
    ("names", "given"),
    [
        (["blackbox_decode.csv"], ["time-unit=us", DPS, COUNTS]),
        (["blackbox_explorer.csv"], ["time-unit=us", DPS, COUNTS]),
        (["gopro_ACCL.csv", "gopro_GYRO.csv"], ["time-unit=ms", *UNITS]),
        (["metawear_acc.csv", "metawear_gyro.csv"], ["time-unit=ms", G, DPS]),
        (["sensorlog_ios.csv"], [G, UNITS[1], "accel-sign=-"]),
        (["witmotion.txt"], [G, DPS]),
    ],
)
def test_tables_with_texts_are_read_as_the_question_proposes(names, given):
    paths = case(*(f"{TEXTS}/{name}" for name in names))
    imu = followed(paths, *given).imu
    assert imu.rate_hz == pytest.approx(50.0, abs=0.01)
    norm = np.linalg.norm(imu.specific_force_mps2, axis=1)
    assert np.median(norm) == pytest.approx(9.80, abs=0.01)
    assert np.std(imu.specific_force_mps2, axis=0) == pytest.approx(
        [1.03, 1.7, 0.61], abs=0.01
    )


@pytest.mark.parametrize("name", ["blanks.txt", "clock_time.csv", "not_available.csv"])
def test_spellings_of_the_same_log_are_read(name):
    paths = case(f"{NUMBERS_AS_WRITTEN}/{name}")
    words = [COLUMNS, "time-unit=s", G, "rate-unit=rad/s"]
    for imu in (read(paths, *words).imu, followed(paths, G, "rate-unit=rad/s").imu):
        assert imu.rate_hz == pytest.approx(50.0, abs=0.01)
        norm = np.linalg.norm(imu.specific_force_mps2, axis=1)
        assert np.median(norm) == pytest.approx(9.80, abs=0.01)


@pytest.mark.parametrize(
    "name", ["micros_wrap", "mobius_temp", "saved_by_excel", "thumb_rx"]
)
def test_gcsv_of_other_writers_is_the_same_log(name):
    (path,) = case(f"gcsv-header/{name}.gcsv")
    imu = read(path).imu
    assert imu.rate_hz == pytest.approx(50.0, abs=0.01)
    norm = np.linalg.norm(imu.specific_force_mps2, axis=1)
    assert np.median(norm) == pytest.approx(9.80, abs=0.01)
    assert len(imu) == 800
