"""Force tracks as CSV: what is kept, and what is refused with file, line and column."""

import subprocess
import sys
import tracemalloc

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import Reconstruction
from hapticplayer.sequence import force_csv
from hapticplayer.sequence.force_csv import read_force_csv


def write(path, lines):
    path.write_text("\n".join(lines) + "\n")
    return path


def test_force_track_holds_each_value(tmp_path):
    lines = ["time_s,fx_n,fy_n,fz_n", "0.5,1,0,0", "1.5,0,-2,0.25"]
    track = read_force_csv(write(tmp_path / "force.csv", lines))
    assert track.reconstruction is Reconstruction.HOLD
    np.testing.assert_array_equal(
        track.at(np.array([0.4, 0.5, 1.4999, 1.5, 99.0])),
        [[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, -2, 0.25], [0, -2, 0.25]],
    )
    assert track.provenance["source"] == "force.csv"


FORCE_HEADER = "time_s,fx_n,fy_n,fz_n"


def test_a_dense_force_track_keeps_what_the_loop_takes(tmp_path, monkeypatch):
    """Rows every 2.5 us, of a force that rises by 1 N a second."""
    monkeypatch.setattr(force_csv, "CHUNK_BYTES", 1 << 16)
    steps = np.arange(200_000)
    rows = (f"{2.5e-6 * k:.7f},{2.5e-6 * k:.7f},0,0" for k in steps)
    path = write(tmp_path / "force.csv", [FORCE_HEADER, *rows, "900,2,0,0"])
    tracemalloc.start()
    try:
        track = read_force_csv(path, until_s=0.4)
        peak_bytes = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak_bytes < 2_000_000  # all rows take 6.4 MB
    assert len(track.time_s) <= 0.4 * 1e4 + 100  # one more for each piece
    assert (track.time_s[0], track.time_s[-1]) == (0.0, 900.0)
    ticks_s = np.arange(0.0, 0.4, 1e-3)
    np.testing.assert_allclose(track.at(ticks_s)[:, 0], ticks_s, atol=1.1e-4)


@pytest.mark.parametrize(
    ("line", "sentence"),
    [("0.1,1,0,0", "line 3002, column time_s: the time decreases"),
     ("3,nan,0,0", "line 3002, column fx_n"), ("3,x,0,0", "line 3002, column fx_n"),
     ("3,1+2j,0,0", "line 3002, column fx_n"), ("3,1_0,0,0", "line 3002, column fx_n"),
     ("3,1e400,0,0", "line 3002, column fx_n"), ("3,0x10,0,0", "line 3002, column fx_n"),
     ("3,1e9,0,0", "force of 1e\\+09 N")],
)  # fmt: skip
def test_rows_after_the_clip_are_checked(tmp_path, monkeypatch, line, sentence):
    monkeypatch.setattr(force_csv, "CHUNK_BYTES", 1000)
    rows = [f"{1e-3 * k:.3f},1,0,0" for k in range(3000)]
    path = write(tmp_path / "force.csv", [FORCE_HEADER, *rows, line, "4,0,0,0"])
    with pytest.raises(InputError, match=sentence):
        read_force_csv(path, until_s=0.5)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("line", ["-1e300,1,0,0", "1e300,1,0,0", "2e5,1,0,0"])
def test_times_beyond_any_clip_are_refused(tmp_path, line):
    lines = [FORCE_HEADER, "0,1,0,0", "1,0,0,0"]
    lines.insert(1 if line.startswith("-") else 3, line)
    with pytest.raises(InputError, match=r"column time_s: .* later than any clip"):
        read_force_csv(write(tmp_path / "force.csv", lines))


@pytest.mark.parametrize(
    ("head", "rows"),
    [
        ("time_s;fx_n;fy_n;fz_n", ["0;1,5;0;0", "1,25;0;0;0"]),
        ("fx_n,fy_n,time_s,fz_n", ["1.5,0,0,0", "0,0,1.25,0"]),
        ("time_s,fx_n,fy_n,fz_n,,", ["0,1.5,0,0,,", "1.25,0,0,0,,"]),
        ("time_s\tfx_n\tfy_n\tfz_n", ["0\t1.5\t0\t0", "1.25\t0\t0\t0"]),
        ("time_s,fx_n,fy_n,fz_n", ['"0","1.5","0","0"', "1.25,0,0,0,"]),
        ("sep=;\ntime_s;fx_n;fy_n;fz_n", ["0;1,5;0;0", "1,25;0;0;0"]),
        ('"sep=;"\r\n"time_s";"fx_n";"fy_n";"fz_n"', ["0;1,5;0;0", "1,25;0;0;0"]),
        ("# mine\n\n;;;\ntime_s;fx_n;fy_n;fz_n", ["0;1,5;0;0", "1,25;0;0;0"]),
        ("\ufeffTime_s,FX_N,Fy_n,FZ_n", ["0,1.5,0,0", "1.25,0,0,0"]),
        ("time_s|fx_n|fy_n|fz_n", ["0|1.5|0|0", "1.25|0|0|0"]),
        ("time_s  fx_n fy_n   fz_n", ["0   1.5 0 0", " 1.25 0\t0 0"]),
        ("\ufeff% of Octave\ntime_s fx_n fy_n fz_n", ["0 1.5 0 0", "1.25 0 0 0"]),
    ],
)
def test_force_that_a_spreadsheet_wrote_is_read(tmp_path, head, rows):
    track = read_force_csv(write(tmp_path / "force.csv", [head, *rows]))
    assert track.time_s.tolist() == [0.0, 1.25]
    assert track.force_n.tolist() == [[1.5, 0, 0], [0, 0, 0]]


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        (["time_s,fx_n,fy_n,fz_n"], "has no rows"),
        (["time_s,fx,fy,fz", "0,1,0,0"], "begin the file with time_s,fx_n,fy_n,fz_n"),
        (["time_s,fx_n,fy_n,fz_n", "0,1,0,0", "0,1,0,0"], "line 3, column time_s"),
        (["sep=,", FORCE_HEADER, "0,1,0,0", "0,1,0,0"], "line 4, column time_s"),
        (["# a", "#", "time_s,fx,fy,fz"], "line 3: the header is"),
        (["#"] * 200, "the header is"),
        ([""] * 3, "the header is ''"),
        ([f"{FORCE_HEADER},note", "0,1,0,0,a"], "'note' is not of a force; remove"),
        ([f"{FORCE_HEADER}\r0,1,0,0"], "CR alone; save it"),
        (["time_s,fx_n,fy_n,fz_n", "0,1,0,1e5"], "beyond any device"),
        (["time_s,fx_n,fy_n,fz_n", "0,1,0,1e39"], "beyond any device"),
    ],
)
def test_bad_force_track_is_refused(tmp_path, lines, sentence):
    with pytest.raises(InputError, match=sentence):
        read_force_csv(write(tmp_path / "force.csv", lines))


@pytest.mark.parametrize("coding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_force_in_utf_16_is_named_with_the_remedy(tmp_path, coding):
    path, text = tmp_path / "force.csv", f"{FORCE_HEADER}\n0,1,0,0\n1,0,0,0\n"
    path.write_text(text, encoding=coding)
    with pytest.raises(InputError, match="UTF-16; save it as text in UTF-8"):
        read_force_csv(path)
    path.write_text(text, encoding="utf-8")
    assert read_force_csv(path).time_s.tolist() == [0.0, 1.0]


def test_the_player_reads_force_without_the_room_of_recordings(tmp_path):
    path = write(tmp_path / "force.csv", [FORCE_HEADER, "0,1,0,0"])
    program = (
        "import sys, hapticplayer.playback.player as _;"
        "from hapticplayer.sequence.force_csv import read_force_csv;"
        "read_force_csv(sys.argv[1]);"
        "print([m for m in sys.modules if m.startswith('hapticplayer.capture')])"
    )
    told = subprocess.run(
        [sys.executable, "-c", program, path], capture_output=True, check=True
    )
    assert told.stdout.strip() == b"[]"


def test_ten_hours_of_milliseconds_are_no_row_too_many():
    assert force_csv.MAX_SAMPLES >= 10 * 3600 * 1000
