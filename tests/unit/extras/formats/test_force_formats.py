"""Every format of the registry: there and back within the error that it states."""

import tracemalloc
import zlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import InputError, UsageError, from_json
from hapticplayer.extras.formats import thinning
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.sequence import force_formats as force_formats_module
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    format_of,
    loss_line,
    read_force,
    read_formats,
    written_formats,
)

BOTH_WAYS = [
    name for name in written_formats() if name in read_formats() and name != "funscript"
]
"""Those that keep newtons."""

TOLERANCE_N = 0.01
ROUNDING_N = 2e-5
"""Of float32 and of decimals, for forces up to 20 N."""

FORCES = st.floats(-20.0, 20.0, width=32) | st.sampled_from([0.0, 1e-45, -1e-40, 4.5])


@st.composite
def tracks(draw):
    steps = draw(st.lists(st.floats(1e-4, 0.7), min_size=0, max_size=25))
    start = draw(st.sampled_from([0.0, 0.003, 0.0312345, 2.5]))
    times = np.cumsum([start, *steps])
    rows = st.lists(
        st.tuples(FORCES, FORCES, FORCES),
        min_size=len(times),
        max_size=len(times),
    )
    return ForceTrack(times, draw(rows), draw(st.sampled_from(Reconstruction)))


def differ_n(track, back, until_s):
    at_s = np.arange(int(until_s * 1000.0) + 2) / 1000.0
    at_s = at_s[at_s < until_s]
    return float(np.linalg.norm(track.at(at_s) - back.at(at_s), axis=1).max())


def there_and_back(name, track, folder, duration_s):
    path = folder / f"track{force_formats()[name].suffix}"
    choices = WriteChoices(duration_s, TOLERANCE_N)
    report = export_track(track, path, force_formats()[name], choices)
    return report, read_force(path, ReadChoices(), name).track


@pytest.mark.parametrize("name", BOTH_WAYS)
@settings(max_examples=40)
@given(track=tracks())
def test_a_track_comes_back_within_the_tolerance(name, track, tmp_path_factory):
    folder = tmp_path_factory.mktemp("there")
    duration_s = float(track.time_s[-1]) + 0.05
    report, back = there_and_back(name, track, folder, duration_s)
    found_n = differ_n(track, back, duration_s)
    assert found_n <= TOLERANCE_N + ROUNDING_N
    assert report["error_max_n"] <= TOLERANCE_N + ROUNDING_N


@settings(max_examples=40)
@given(track=tracks())
def test_the_size_of_a_track_is_within_the_tolerance(track, tmp_path_factory):
    path = tmp_path_factory.mktemp("there") / "a.ahap"
    choices = WriteChoices(float(track.time_s[-1]) + 0.05, TOLERANCE_N)
    report = export_track(track, path, force_formats()["ahap"], choices)
    assert report["error_max_n"] <= TOLERANCE_N + ROUNDING_N


@pytest.mark.parametrize("name", BOTH_WAYS)
@pytest.mark.parametrize("kind", Reconstruction)
@pytest.mark.parametrize("end_s", [0.003 + 0.085, 0.001 + 0.085, 0.08 + 1e-9, 0.29])
def test_the_last_millisecond_belongs_to_the_track(name, kind, end_s, tmp_path):
    track = ForceTrack([0.0, end_s], [[1, 2, 3], [3, 2, 1]], kind)
    last_ms = [k for k in range(1000) if k / 1000.0 < end_s][-1]
    report, back = there_and_back(name, track, tmp_path, end_s)
    at_s = np.arange(last_ms + 1) / 1000.0
    error_n = np.linalg.norm(track.at(at_s) - back.at(at_s), axis=1).max()
    assert report["error_max_n"] == pytest.approx(error_n, abs=1e-12)
    assert error_n <= TOLERANCE_N + ROUNDING_N


LIMITS = {"wav": "MAX_SAMPLES", "mpegv": "MAX_BYTES"}
SPECIAL = {
    "step": ForceTrack([0.0, 0.5], [[0, 4.5, 0], [0, 0, 0]], Reconstruction.HOLD),
    "impulse": ForceTrack(
        [0.0, 0.5, 0.501, 1.0], [[0, 0, 0], [4, -4, 4], [0, 0, 0], [0, 0, 0]]
    ),
    "one row": ForceTrack([0.25], [[1, 2, 3]]),
    "nothing": ForceTrack([0.0, 1.0], np.zeros((2, 3))),
    "denormal": ForceTrack([0.0, 1.0], np.full((2, 3), 1e-42)),
    "faster than the loop": ForceTrack(
        np.arange(4000) / 8000.0, np.sin(np.arange(12000).reshape(-1, 3))
    ),
    "three hours": ForceTrack(
        np.arange(0, 10801, 60.0), np.tile([[0, 0, 0], [0, 2, 0]], (91, 1))[:181]
    ),
}


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        *(
            (name, kind)
            for name in BOTH_WAYS
            for kind in SPECIAL
            if kind != "three hours"
        ),
        ("hjif", "three hours"),
    ],
)
def test_tracks_of_every_kind_come_back(name, kind, tmp_path):
    track = SPECIAL[kind]
    until_s = float(track.time_s[-1]) + 0.002
    report, back = there_and_back(name, track, tmp_path, until_s)
    first_s = max(0.0, until_s - 130.0)  # the end of three hours is enough
    at_s = np.arange(int(first_s * 1000.0), int(until_s * 1000.0)) / 1000.0
    error_n = np.linalg.norm(track.at(at_s) - back.at(at_s), axis=1).max()
    assert error_n <= TOLERANCE_N + ROUNDING_N
    assert report["error_max_n"] <= TOLERANCE_N + ROUNDING_N


@pytest.mark.parametrize("kind", list(SPECIAL)[:-1])
@pytest.mark.parametrize("name", ["funscript", "ahap"])
def test_tracks_of_every_kind_are_written(name, kind, tmp_path):
    track = SPECIAL[kind]
    path = tmp_path / f"track{force_formats()[name].suffix}"
    report = export_track(track, path, force_formats()[name], WriteChoices())
    if name == "ahap":
        assert report["error_max_n"] <= TOLERANCE_N + ROUNDING_N
    else:
        reach_n = 40.0 * 0.04  # of the spring, at the edge of the workspace
        assert np.abs(read_force(path).track.force_n).max() <= reach_n + ROUNDING_N


@pytest.mark.parametrize("name", ["wav", "mpegv"])
def test_a_track_that_would_not_be_read_is_not_written(name, tmp_path, monkeypatch):
    monkeypatch.setattr(f"hapticplayer.extras.formats.{name}.{LIMITS[name]}", 100)
    with pytest.raises(InputError, match="too long for this format"):
        there_and_back(name, SPECIAL["impulse"], tmp_path, 1.0)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", BOTH_WAYS)
def test_the_error_that_is_told_is_the_one_that_is_there(name, tmp_path, rng):
    track = ForceTrack(np.arange(400) / 199.0, rng.normal(0, 1, (400, 3)))
    report, back = there_and_back(name, track, tmp_path, 2.0)
    at_s = np.arange(2000) / 1000.0
    size = np.linalg.norm(track.at(at_s) - back.at(at_s), axis=1)
    assert report["error_max_n"] == pytest.approx(size.max(), abs=1e-9)
    assert report["error_rms_n"] == pytest.approx(np.sqrt(np.mean(size**2)), abs=1e-9)
    path = tmp_path / f"track{force_formats()[name].suffix}"
    assert report["kbit_s"] == pytest.approx(path.stat().st_size * 8 / 2.0 / 1000.0)
    assert report["track_kbit_s"] == pytest.approx(400 * 20 * 8 / 2.0 / 1000.0)


@pytest.mark.parametrize("name", written_formats())
def test_a_file_that_exists_is_kept_unless_it_is_ours(name, tmp_path):
    track, form = SPECIAL["step"], written_formats()[name]
    path = tmp_path / f"there{form.suffix}"
    path.write_bytes(b"something else")
    for choices in (WriteChoices(), WriteChoices(overwrite=True)):
        with pytest.raises(InputError):
            export_track(track, path, form, choices)
    assert path.read_bytes() == b"something else"
    path.unlink()
    export_track(track, path, form, WriteChoices())
    export_track(track, path, form, WriteChoices(overwrite=True))


@pytest.mark.parametrize("name", ["hjif", "ahap"])
def test_a_track_of_too_many_corners_is_refused(name, tmp_path, monkeypatch):
    monkeypatch.setattr(thinning, "MAX_CORNERS", 1)
    with pytest.raises(InputError, match="keyframes"):
        there_and_back(name, SPECIAL["impulse"], tmp_path, 1.0)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", BOTH_WAYS)
def test_forces_beyond_any_device_are_refused(name, tmp_path):
    track = ForceTrack([0.0, 1.0], [[0, 1e6, 0], [0, 0, 0]])
    with pytest.raises(InputError, match="beyond any device"):
        there_and_back(name, track, tmp_path, 1.0)
    assert not list(tmp_path.iterdir())


LEFT_OUT = {
    "funscript": ["the force in newtons"],
    "ahap": [
        "the direction of the force",
        "changes of the frequency within a second",
    ],
}


@pytest.mark.parametrize("name", written_formats())
def test_every_export_says_what_it_leaves_out(name, tmp_path):
    rows = [[0, 0, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0], [0, 0, 0]]
    track = ForceTrack([-1.0, -0.5, 0.5, 0.5005, 2.0], rows)
    path = tmp_path / f"track{force_formats()[name].suffix}"
    report = export_track(track, path, force_formats()[name], WriteChoices(1.0))
    always = ["the force before 0 s", "the force after the end of the clip (1.000 s)"]
    always.append("what changes within a millisecond")
    said = [str(from_json(one)) for one in report["left_out"]]
    assert said == always + LEFT_OUT.get(name, [])
    line = str(loss_line(report))
    assert f"left out: {', '.join(said)}" in line
    assert str(force_formats()[name].keeps) in line


@pytest.mark.parametrize("name", BOTH_WAYS)
def test_an_export_of_all_leaves_nothing_out(name, tmp_path):
    track = ForceTrack([0.0, 0.5, 1.0], [[0, 0, 0], [1, 2, 3], [0, 0, 0]])
    path = tmp_path / f"track{force_formats()[name].suffix}"
    report = export_track(track, path, force_formats()[name], WriteChoices(1.0))
    assert report["left_out"] == []
    assert str(loss_line(report)).endswith("left out: nothing")


def test_a_jump_between_milliseconds_leaves_nothing_out(tmp_path):
    times, rows = [0.0, 0.001, 0.002 - 1e-6, 0.002, 0.003], [[0, 1, 0]] * 2
    track = ForceTrack(times, [*rows, *rows, [0, 0, 0]])
    path = tmp_path / "a.csv"
    report = export_track(track, path, force_formats()["csv"], WriteChoices())
    assert report["left_out"] == []


@pytest.mark.parametrize(("rate", "is_said"), [(1000, True), (8000, False)])
def test_a_faster_wav_keeps_what_is_within_a_millisecond(tmp_path, rate, is_said):
    track, form = SPECIAL["faster than the loop"], force_formats()["wav"]
    choices = WriteChoices(sample_rate_hz=rate)
    report = export_track(track, tmp_path / "a.wav", form, choices)
    assert bool(report["left_out"]) is is_said


def test_a_long_file_is_compressed_in_parts(tmp_path, monkeypatch):
    monkeypatch.setattr(force_formats_module, "_CHUNK_BYTES", 1 << 12)
    time_s = np.arange(12_000) / 200.0
    track = ForceTrack(time_s, np.sin(np.outer(time_s, [7.0, 11.0, 13.0])))
    report = export_track(
        track, tmp_path / "a.csv", force_formats()["csv"], WriteChoices()
    )
    whole = len(zlib.compress((tmp_path / "a.csv").read_bytes(), 9))
    found = report["kbit_s_compressed"] / report["kbit_s"] * report["bytes"]
    assert found == pytest.approx(whole, rel=0.2)


def test_a_long_table_takes_no_more_memory_than_a_short_one(tmp_path, monkeypatch):
    monkeypatch.setattr("hapticplayer.sequence.force_csv.CHUNK_BYTES", 1 << 17)
    monkeypatch.setattr("hapticplayer.sequence.force_as_csv._PIECE_MS", 5_000)
    monkeypatch.setattr("hapticplayer.sequence.milliseconds._COMPARED_MS", 5_000)
    peaks = []
    for seconds in (60, 240):
        time_s = np.arange(200 * seconds) / 200.0
        track = ForceTrack(time_s, np.sin(np.outer(time_s, [7.0, 11.0, 13.0])))
        path = tmp_path / f"{seconds}.csv"
        tracemalloc.start()
        try:
            report = export_track(track, path, force_formats()["csv"], WriteChoices())
            peaks.append(tracemalloc.get_traced_memory()[1])
        finally:
            tracemalloc.stop()
        assert report["error_max_n"] < 1e-6
        assert path.stat().st_size > 30_000 * seconds
    assert peaks[1] < peaks[0] + 3_000_000  # four times the rows: 6 MB of text more


def test_a_format_is_known_by_its_suffix_or_its_name(tmp_path):
    assert format_of(tmp_path / "a.HJIF").name == "hjif"
    assert format_of(tmp_path / "a.txt", "csv").name == "csv"
    with pytest.raises(UsageError, match=r"'a\.doc' is unknown"):
        format_of(tmp_path / "a.doc")


@pytest.mark.parametrize("feedback", ["realistic", "estimated"])
def test_a_table_says_whether_its_force_was_measured(feedback, tmp_path):
    rows = [[0, 1, 2], [1, 0, 0]]
    track = ForceTrack([0.0, 0.5], rows, provenance={"feedback": feedback})
    _, back = there_and_back("csv", track, tmp_path, 0.6)
    assert back.is_estimated is (feedback == "estimated")
    assert differ_n(track, back, 0.6) <= ROUNDING_N
    header = (tmp_path / "track.csv").read_text().splitlines()[0]
    assert ("is_estimated" in header) is (feedback == "estimated")
    again = WriteChoices(0.6, TOLERANCE_N, overwrite=True)
    export_track(track, tmp_path / "track.csv", force_formats()["csv"], again)


@pytest.mark.parametrize("name", written_formats())
def test_an_export_holds_no_names_dates_and_numbers(name, tmp_path):
    private = {"video": "Anna at home.mp4", "sensor": "C3441324", "date": "2024-05-01"}
    track = ForceTrack([0.0, 1.0], [[0, 1, 0], [0, 0, 0]], provenance=private)
    path = tmp_path / f"Anna{force_formats()[name].suffix}"
    export_track(track, path, force_formats()[name], WriteChoices(1.0))
    content = path.read_bytes()
    today = utc_now_iso()[:10]
    told = [*private.values(), today, today.replace("-", ""), "Anna", str(tmp_path)]
    assert not [one for one in told if one.encode() in content]


def test_force_before_the_clip_is_said_to_be_left_out(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("time_s,fx_n,fy_n,fz_n\n-1,0,1,0\n1,0,0,0\n")
    (note,) = read_force(path).unread
    assert str(note) == "what lies before 0 s was left out"
    path.write_text("time_s,fx_n,fy_n,fz_n\n-1,0,0,0\n0,0,1,0\n1,0,0,0\n")
    assert read_force(path).notes == ()
