"""Folders and zips: what is read, what is passed over, what is refused."""

import io
import os
import tracemalloc
import zipfile

import numpy as np
import pytest

from hapticplayer.capture import csv_table, read_recording, source
from hapticplayer.capture.csv_table import Numbers, Shape, read_numbers
from hapticplayer.capture.source import LogSource, open_source
from hapticplayer.errors import InputError
from tests.faults.import_formats import FORMATS, put, zipped
from tests.faults.import_signal import sample
from tests.needed_extras import needs


@needs("loggers")
def test_a_zip_and_its_folder_are_the_same_recording(tmp_path):
    files = FORMATS["OpenCamera Sensors"].write(sample(apart=True))
    folder = read_recording(put(files, tmp_path / "a")).imu
    zip_ = read_recording(put(files, tmp_path / "b", as_zip=True)).imu
    np.testing.assert_array_equal(folder.time_s, zip_.time_s)
    np.testing.assert_array_equal(folder.specific_force_mps2, zip_.specific_force_mps2)


def appended(path):
    with path.open("ab") as out:
        out.write(b"\n")


def replaced(path):
    content = path.read_bytes()
    path.unlink()
    path.write_bytes(content)


@pytest.mark.parametrize("change", [appended, replaced, os.utime])
@pytest.mark.parametrize("kind", ["folder", "files", "zip", "file"])
@needs("loggers")
def test_a_recording_that_changes_meanwhile_is_refused(
    tmp_path, monkeypatch, change, kind
):
    name = "MARS" if kind == "file" else "OpenCamera Sensors"
    files = FORMATS[name].write(sample(apart=FORMATS[name].apart))
    log = put(files, tmp_path / "in", as_zip=kind == "zip")
    changing = log if log.is_file() else next(log.iterdir())
    log = list(log.iterdir()) if kind == "files" else log
    begun, read = [], LogSource.opened

    def opened(self, member):
        if not begun:
            begun.append(member)
            change(changing)
        return read(self, member)

    monkeypatch.setattr(LogSource, "opened", opened)
    with pytest.raises(InputError, match="changed or replaced while it was read"):
        read_recording(log)


@needs("loggers")
def test_folder_inside_the_zip_does_not_matter(tmp_path):
    files = FORMATS["Sensor Logger Android"].write(sample(apart=True))
    inside = {f"2026-01-01_ride/{name}": content for name, content in files.items()}
    inside["__MACOSX/._TotalAcceleration.csv"] = b"\0\1\2"
    path = put(inside, tmp_path / "in", as_zip=True)
    assert read_recording(path).camera == "Sensor Logger (Android)"


@pytest.mark.parametrize(
    "name", ["../evil.csv", "/etc/evil.csv", "a/../../evil.csv", "..\\evil.csv", "C:\\e.csv"]
)  # fmt: skip
def test_names_that_point_out_of_a_zip_are_refused(tmp_path, name):
    path = tmp_path / "evil.zip"
    path.write_bytes(zipped({"gyro_accel.csv": b"x", name: b"x"}))
    with pytest.raises(InputError, match="outside the zip"):
        read_recording(path)
    assert [file.name for file in tmp_path.iterdir()] == ["evil.zip"]


@needs("loggers")
def test_a_zip_that_swells_is_refused_before_it_fills_the_memory(tmp_path, monkeypatch):
    """Whatever size it claims; here the claim itself is honest and too large."""
    monkeypatch.setattr(source, "MAX_CSV_BYTES", 1 << 20)
    files = FORMATS["MARS"].write(sample())
    files["gyro_accel.csv"] += b"0" * (1 << 20)
    path = put(files, tmp_path / "in", as_zip=True)
    assert path.stat().st_size < 200_000
    with pytest.raises(InputError, match="larger than the limit"):
        read_recording(path)


def test_a_zip_of_false_size_ends_at_the_limit(tmp_path, monkeypatch):
    monkeypatch.setattr(source, "MAX_CSV_BYTES", 1000)
    path = tmp_path / "log.csv"
    path.write_bytes(b"1\n" * 499)
    held = open_source(path)
    with held.opened("log.csv") as stream:
        path.write_bytes(b"1\n" * 5000)  # grows while it is read
        with pytest.raises(InputError, match="larger than the limit"):
            stream.read()


def test_too_many_members_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(source, "MAX_MEMBERS", 5)
    files = {f"{number}.csv": b"x" for number in range(6)}
    for as_zip in (True, False):
        path = put(files, tmp_path / str(as_zip), as_zip=as_zip)
        with pytest.raises(InputError, match="more than 5 files"):
            read_recording(path)


@needs("loggers")
def test_links_and_pipes_in_a_folder_are_passed_over(tmp_path):
    outside = tmp_path / "outside.csv"
    outside.write_text("x")
    folder = put(FORMATS["MARS"].write(sample()), tmp_path / "in")
    (folder / "link.csv").symlink_to(outside)
    os.mkfifo(folder / "pipe.csv")
    assert open_source(folder).names == ("frame_timestamps.txt", "gyro_accel.csv")
    assert len(read_recording(folder).imu) == 1200


def test_encrypted_and_broken_zips_are_refused(tmp_path):
    content = bytearray(zipped(FORMATS["MARS"].write(sample())))
    for at in range(len(content) - 4):  # the bit that says encrypted
        if content[at : at + 4] == b"PK\x01\x02":
            content[at + 8] |= 1
        if content[at : at + 4] == b"PK\x03\x04":
            content[at + 6] |= 1
    for name, data in (("locked", bytes(content)), ("cut", bytes(content[:900]))):
        path = tmp_path / f"{name}.zip"
        path.write_bytes(data)
        with pytest.raises(InputError) as caught:
            read_recording(path)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "files", [{}, {"readme.txt": b"hello"}, {"a.jpg": b"\xff\xd8"}]
)
def test_a_folder_without_a_log_is_rejected(tmp_path, files):
    folder = tmp_path / "in"
    folder.mkdir()
    for name, content in {**files, "other.md": b"# notes"}.items():
        (folder / name).write_bytes(content)
    with pytest.raises(InputError, match="no log of a known format"):
        read_recording(folder)


def test_a_zip_in_a_zip_is_not_opened(tmp_path):
    inner = zipped(FORMATS["MARS"].write(sample()))
    path = tmp_path / "outer.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("inner.zip", inner)
    with pytest.raises(InputError, match="no log of a known format"):
        read_recording(path)


def rows(text: bytes, **shape: object) -> Numbers:
    wanted = Shape(**{"width": 3, "columns": (0, 1, 2), **shape})  # type: ignore[arg-type]
    return read_numbers(io.BytesIO(text), wanted, "log")


@pytest.mark.parametrize("end", [b"\n", b"\r\n", b"\n\r"])
def test_line_ends_of_all_kinds_are_read(end):
    held = rows(end.join([b"1,2,3", b"4,5,6", b"7,8,9", b""]))
    np.testing.assert_array_equal(held.values, [[1, 2, 3], [4, 5, 6], [7, 8, 9]])
    assert held.damaged == ()


def test_chunks_join_without_losing_a_line(monkeypatch):
    monkeypatch.setattr(csv_table, "CHUNK_BYTES", 7)
    text = b"".join(b"%d,%d,%d\n" % (k, 2 * k, -k) for k in range(200))
    held = rows(text)
    expected = np.outer(np.arange(200), [1.0, 2.0, -1.0])
    np.testing.assert_array_equal(held.values, expected)


def test_empty_cells_are_nan_and_damaged_lines_are_counted():
    good = b"1,2,3\n" * 60
    held = rows(good + b"1,,3\n" + b"1,x,3\n" + b"1,2\n" + b"1,1_0,2\n" + good)
    assert len(held.values) == 121
    assert np.isnan(held.values[60, 1])
    assert held.damaged == (62, 63, 64)
    assert "first: line 62" in held.notes[0]


def test_rows_of_wrong_length_do_not_shift_into_each_other():
    """Together they have the right number of cells."""
    good = b"1,2,3\n" * 60
    held = rows(good + b"1,2,3,4\n1,2\n" + good)
    np.testing.assert_array_equal(held.values, np.tile([1.0, 2, 3], (120, 1)))
    assert held.damaged == (61, 62)


def test_decimal_commas_and_exponents_are_numbers():
    held = rows(b"1,5E0;-2,5e-1;3\n4;5;6\n", separator=";", decimal=",")
    np.testing.assert_array_equal(held.values, [[1.5, -0.25, 3], [4, 5, 6]])


def test_integers_beyond_float64_are_subtracted_exactly():
    base = 1_700_000_000_123_456_789
    text = b"".join(b"%d,1,2\n" % (base + k) for k in range(100))
    held = rows(text, integer=0)
    assert held.origin == base
    np.testing.assert_array_equal(held.values[:, 0], np.arange(100.0))
    damaged = text + b"oops\n" + b"%d,1,2\n" % (base + 100)
    np.testing.assert_array_equal(
        rows(damaged, integer=0).values[:, 0], np.arange(101.0)
    )


@pytest.mark.parametrize(
    ("text", "sentence"),
    [(b"", "0 rows"), (b"1,2,3\n", "1 rows"), (b"x\n" * 50, "50 damaged lines"),
     (b"1,2,3\n" * 50 + b"oops\n" * 9, "9 damaged lines"),
     (b"7" * 5_000_000, "line 1: is longer than 4096 characters")],
)  # fmt: skip
def test_text_that_is_not_a_table_is_refused(text, sentence):
    with pytest.raises(InputError, match=sentence):
        rows(text)


def test_an_endless_line_is_refused_before_more_of_it_is_read():
    text = io.BytesIO(b"1,2,3\n1,2,3\n" + b"7" * 30_000_000)
    with pytest.raises(InputError, match="line 3: is longer than 4096 characters"):
        read_numbers(text, Shape(3, (0, 1, 2)), "log")
    assert text.tell() < 10_000_000


@pytest.mark.parametrize("blank", [b"\n", b"\r", b"\r\n"])
def test_blank_lines_take_no_memory_of_their_own(blank, monkeypatch):
    monkeypatch.setattr(csv_table, "CHUNK_BYTES", 1 << 16)
    text = b"1,2,3\n" + blank * 200_000 + b"4,5,6\n"
    tracemalloc.start()
    try:
        held = rows(text)
        peak_bytes = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    np.testing.assert_array_equal(held.values, [[1, 2, 3], [4, 5, 6]])
    assert peak_bytes < 400_000  # a list of the lines of a chunk takes 500 kB more


def test_more_rows_than_the_limit_are_refused(monkeypatch):
    monkeypatch.setattr(csv_table, "MAX_CSV_ROWS", 100)
    assert len(rows(b"1,2,3\n" * 100).values) == 100
    with pytest.raises(InputError, match="more than 100 rows"):
        rows(b"1,2,3\n" * 101)
