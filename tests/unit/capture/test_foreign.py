"""What spreadsheets and other programs make of a log is read, asked about or refused."""

import gzip
import zipfile
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import parse_choices
from hapticplayer.errors import InputError, UsageError
from tests.faults.import_formats import zipped
from tests.needed_extras import needs

OWN = "time_s,ax,ay,az,gx,gy,gz"
COUNT = 400
RNG = np.random.default_rng(4)
FORCE = np.array([0.0, 0.0, 9.81]) + 0.1 * RNG.standard_normal((COUNT, 3))
RATE = 0.2 * RNG.standard_normal((COUNT, 3))
CHOICES = parse_choices(
    [
        "columns=time,ax,ay,az,gx,gy,gz",
        "time-unit=s",
        "accel-unit=m/s2",
        "rate-unit=rad/s",
    ]
)


def log(
    head: str = OWN, *, separator: str = ",", decimal: str = ".", quote: str = ""
) -> str:
    rows = np.column_stack([np.arange(COUNT) / 100.0, FORCE, RATE])
    lines = [[quote + name + quote for name in head.split(",")]]
    for row in rows:
        cells = [f"{number:.6f}".replace(".", decimal) for number in row]
        lines.append([quote + cell + quote for cell in cells])
    return "".join(separator.join(line) + "\n" for line in lines)


def check(path: Path, choices=None) -> None:
    imu = read_recording(path, choices).imu
    np.testing.assert_allclose(imu.time_s, np.arange(COUNT) / 100.0, atol=1e-9)
    np.testing.assert_allclose(imu.specific_force_mps2, FORCE, atol=1e-5)
    np.testing.assert_allclose(imu.angular_rate_radps, RATE, atol=1e-5)


def test_our_own_log_may_be_quoted(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(log(quote='"'))
    check(path)


def test_empty_cells_between_quotes_are_holes(tmp_path):
    path = tmp_path / "log.csv"
    lines = log(quote='"').splitlines()
    cells = lines[50].split(",")
    lines[50] = ",".join([cells[0], '""', *cells[2:]])
    path.write_text("\n".join(lines))
    imu = read_recording(path).imu
    assert imu.valid is not None
    assert np.flatnonzero(~imu.valid).tolist() == [49]


@needs("loggers")
@pytest.mark.parametrize(
    ("separator", "decimal", "quote"),
    [
        (",", ".", '"'),
        (",", ",", '"'),
        (";", ",", '"'),
        ("\t", ",", ""),
        (";", ".", ""),
        ("  ", ".", ""),
        (" \t", ",", ""),
    ],
)
def test_another_table_may_be_quoted(tmp_path, separator, decimal, quote):
    path = tmp_path / "log.csv"
    head = "t,accX,accY,accZ,gyrX,gyrY,gyrZ"
    path.write_text(log(head, separator=separator, decimal=decimal, quote=quote))
    with pytest.raises(UsageError, match="table of 7 columns"):
        read_recording(path)
    check(path, CHOICES)


@needs("loggers")
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_empty_last_cells_are_holes(tmp_path, separator):
    path = tmp_path / "log.csv"
    lines = log("t,a,b,c,d,e,f", separator=separator).splitlines()
    lines[50] = separator.join([*lines[50].split(separator)[:-1], ""])
    path.write_text("\n".join(lines))
    imu = read_recording(path, CHOICES).imu
    assert imu.valid is not None
    assert np.flatnonzero(~imu.valid).tolist() == [49]


@needs("loggers")
def test_commas_that_are_decimal_and_separate_are_not_guessed_at(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(log("t,a,b,c,d,e,f", decimal=","))
    with pytest.raises((InputError, UsageError)):
        read_recording(path, CHOICES)


@needs("loggers")
def test_columns_that_a_person_gives_win_over_our_own_header(tmp_path):
    path = tmp_path / "log.csv"
    lines = log().splitlines()
    path.write_text("\n".join([lines[0] + ",temp", *(f"{x},25" for x in lines[1:])]))
    assert "not read: the columns temp" in read_recording(path).notes
    columns = ["columns=time,ax,ay,az,gx,gy,gz,-", "time-unit=s", "accel-unit=m/s2"]
    check(path, parse_choices([*columns, "rate-unit=rad/s"]))


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("mark", ["\ufeff", ""])
def test_text_in_utf_16_is_named(tmp_path, encoding, mark):
    path = tmp_path / "log.csv"
    path.write_bytes((mark * (encoding != "utf-16") + log()).encode(encoding))
    with pytest.raises(InputError, match="UTF-16"):
        read_recording(path)


BLACKBOX = b"H Product:Blackbox flight data recorder by Nicholas Sherlock\n"
ZIP = zipped({"log.csv": log().encode()})


@pytest.mark.parametrize(
    ("content", "what", "remedy"),
    [
        (b"\x0e\x20\x56\x08\x88\x13\0\0.FIT" + RNG.bytes(5000), "a FIT file", "CSV"),
        (BLACKBOX + RNG.bytes(5000), "a blackbox log", "blackbox_decode"),
        (BLACKBOX + b"H x:1\n" * 900 + RNG.bytes(5000), "a blackbox log", "to CSV"),
        (gzip.compress(log().encode()), "compressed with gzip", "unpack it"),
        (b"7z\xbc\xaf\x27\x1c" + RNG.bytes(5000), "not a zip", "unpack it"),
        (bytes(5000), "begins with 5000 NUL bytes", "copy it again"),
        (b"garbage\n" + ZIP, "a zip with other bytes before it", "unpack it"),
        (RNG.bytes(5000) + ZIP, "a zip with other bytes before it", "unpack it"),
        (b'[{"sensor":"Accelerometer","x":"0"}]\n', "is JSON", "as CSV"),
        (b'{"t": 0.0, "ax": 0.1}\n' * 90, "is JSON", "as CSV"),
        (b"<?xml version='1.0'?>\n<gpx></gpx>\n", "is XML", "as CSV"),
        (b"<!DOCTYPE html>\n<html></html>\n", "a web page", "as CSV"),
        (ZIP + bytes(100_000), "followed by other bytes", "unpack it"),
    ],
)
def test_files_that_are_no_log_are_named(tmp_path, content, what, remedy):
    path = tmp_path / "ride.log"
    path.write_bytes(content)
    with pytest.raises(InputError, match=what) as caught:
        read_recording(path)
    assert remedy in str(caught.value)
    assert "MP4" not in str(caught.value)


@pytest.mark.parametrize("at", [200, 20_000, None])
@pytest.mark.parametrize("count", [40, 5000])
def test_nul_bytes_are_named(tmp_path, at, count):
    path, text = tmp_path / "log.csv", log().encode()
    at = len(text) if at is None else at
    path.write_bytes(text[:at] + bytes(count) + text[at:])
    with pytest.raises(InputError, match="holds NUL bytes"):
        read_recording(path)


@pytest.mark.parametrize(
    ("head", "place"),
    [(OWN, "line 2, column time_s: "), ("t,a,b,c,d,e,f", "log.csv: "), ("", "")],
)
def test_digits_of_another_script_are_named(tmp_path, head, place):
    """Arabic-Indic ones, as programs write them that follow the language."""
    path, (_, _, rows) = tmp_path / "log.csv", log().partition("\n")
    rows = rows.translate({ord("0") + k: 0x660 + k for k in range(10)})
    if not head:  # a format that skips damaged lines
        head = '"Time (s)",' + ",".join(
            f'"Acceleration {axis} (m/s^2)"' for axis in "xyz"
        )
        rows = "".join(",".join(r.split(",")[:4]) + "\n" for r in rows.splitlines())
    path.write_text(f"{head}\n{rows}")
    with pytest.raises(InputError, match="other digits than 0 to 9") as caught:
        read_recording(path)
    assert "\u0660" in str(caught.value)
    assert place in str(caught.value)


def test_excel_workbooks_are_named(tmp_path):
    old, new = tmp_path / "log.xls", tmp_path / "log.xlsx"
    old.write_bytes(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(4000))
    with zipfile.ZipFile(new, "w") as book:
        book.writestr("[Content_Types].xml", "<Types/>")
        book.writestr("xl/workbook.xml", "<workbook/>")
    for path in (old, new):
        with pytest.raises(InputError, match="Excel workbook"):
            read_recording(path)
