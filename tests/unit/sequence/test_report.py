"""The quality report marks what is wrong, and only that."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.model import ClockMap, ForceTrack
from hapticplayer.rendering.washout import washed_out
from hapticplayer.sequence.description import Description, TrackEntry
from hapticplayer.sequence.presets import preset_named, washout_of
from hapticplayer.sequence.processing import Processing, process_motion
from hapticplayer.sequence.report import (
    Mark,
    marked,
    needs_recording,
    notes_on_force,
    notes_on_sequence,
    quality_report,
    worst,
)
from hapticplayer.sequence.synchronizing import uncertainty
from hapticplayer.structures import convert

MAPPING = {
    "axes": [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    "gain_n_per_mps2": 0.4,
    "force_limit_n": 4.5,
    "soft_knee_n": None,
    "lever_arm_m": [0, 0, 0],
}
EMPTY = {
    "title": "ride",
    "clip": {"file": "clip.mp4", "duration_s": 10.0},
    "mapping": MAPPING,
    "feedbacks": {},
    "files": {},
}
STILL = {"far": 0.6, "rms_10s_n": 0.0}


def described(**changed):
    made_of = {
        "synchronisation": {
            "method": "pats",
            "drift_ppm": 40.0,
            "drift_is_fitted": True,
        },
        "imu_rate_hz": 200.0,
        "gaps": 0,
        "longest_gap_s": 0.0,
        "uncovered_share": 0.0,
        "motion_summary": {
            "leak_at_rest_mps2": 0.01,
            "saturated_share": 0.0,
            "invalid_share": 0.0,
        },
    }
    hands = {
        "relaxed": {"reach": 0.4, "trip": None},
        "firm": {"reach": 0.1, "trip": None},
    }
    description = {
        **EMPTY,
        "clock_map": {"residual_s": 0.002, "confidence": 0.9},
        "provenance": made_of,
        "feedbacks": {
            "realistic": {
                "peak_n": 3.0,
                "saturated_share": 0.0,
                "excursion": {**STILL, "hands": hands, "thermal_share": 0.3},
            }
        },
    }
    for path, value in changed.items():
        *parents, last = path.split("__")
        at = description
        for name in parents:
            at = at[name]
        at[last] = value
    return convert(description, Description, "test")


def marks(**changed) -> dict[str, Mark]:
    return {one.name: one.mark for one in quality_report(described(**changed))}


def test_a_good_recording_has_nothing_marked():
    found = quality_report(described())
    assert worst(found) is Mark.GOOD
    assert [one.name for one in found] == [
        "sync", "drift", "rate", "leak", "sensor", "gaps", "cover", "force",
        "workspace", "heat",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("path", "value", "name", "mark"),
    [
        ("clock_map__confidence", 0.3, "sync", Mark.DOUBTFUL),
        ("clock_map__confidence", 0.0, "sync", Mark.BAD),
        ("clock_map__residual_s", 0.06, "sync", Mark.BAD),
        ("provenance__synchronisation__method", "offset", "sync", Mark.DOUBTFUL),
        ("provenance__synchronisation__drift_ppm", -200.0, "drift", Mark.DOUBTFUL),
        ("provenance__imu_rate_hz", 30.0, "rate", Mark.DOUBTFUL),
        ("provenance__imu_rate_hz", 20.0, "rate", Mark.BAD),
        ("provenance__motion_summary__leak_at_rest_mps2", 0.1, "leak", Mark.DOUBTFUL),
        ("provenance__motion_summary__leak_at_rest_mps2", None, "leak", Mark.DOUBTFUL),
        ("provenance__motion_summary__saturated_share", 0.001, "sensor", Mark.DOUBTFUL),
        ("provenance__longest_gap_s", 0.5, "gaps", Mark.DOUBTFUL),
        ("provenance__uncovered_share", 0.5, "cover", Mark.BAD),
        ("feedbacks__realistic__saturated_share", 0.1, "force", Mark.BAD),
        ("feedbacks__realistic__excursion__thermal_share", 0.9, "heat", Mark.DOUBTFUL),
    ],
)
def test_one_flaw_marks_one_line(path, value, name, mark):
    found = marks(**{path: value})
    assert found[name] is mark
    assert all(m is Mark.GOOD for other, m in found.items() if other != name)


def test_a_result_that_a_person_checked_is_not_doubted():
    for confidence, method in ((0.0, "offset"), (0.3, "pats"), (1.0, "offset")):
        checked = {"method": method, "seen_by_person": True}
        found = marks(
            clock_map__confidence=confidence, provenance__synchronisation=checked
        )
        assert found["sync"] is Mark.GOOD


@pytest.mark.parametrize(
    ("method", "confidence", "is_seen", "is_confirmed"),
    [
        ("frames", 0.0, True, True),
        ("offset", 1.0, True, True),
        ("frames", 0.9, True, False),  # its own confidence says it
        ("frames", 0.0, False, False),
    ],
)
def test_a_person_counts_as_proof_where_nothing_else_is(
    method, confidence, is_seen, is_confirmed
):
    found = quality_report(
        described(
            clock_map__confidence=confidence,
            provenance__synchronisation={"method": method, "seen_by_person": is_seen},
        )
    )
    sync = next(one for one in found if one.name == "sync")
    assert sync.more["is_confirmed"] is is_confirmed


def test_a_bad_rendering_asks_for_no_other_recording():
    share = {"feedbacks__realistic__saturated_share": 0.1}
    assert not needs_recording(quality_report(described(**share)))
    missing = {"provenance__uncovered_share": 0.5}
    assert needs_recording(quality_report(described(**missing)))


@pytest.mark.parametrize(
    ("synchronisation", "contradictions"),
    [
        ({"method": "offset"}, ("not synchronised", "--offset")),
        ({"method": "pats"}, ("not synchronised", "--offset", "three times")),
        (None, ()),
    ],
)
def test_notes_of_an_import_do_not_contradict_it(
    tiny_clip, recording, swing, synchronisation, contradictions
):
    known = {} if synchronisation is None else {"synchronisation": synchronisation}
    unsure = dataclasses.replace(
        recording, clock_map=ClockMap(1.5, confidence=0.0), provenance=known
    )
    track = process_motion(swing[0], Processing()).track
    notes = notes_on_sequence(unsure, track, tiny_clip)
    for words in contradictions:
        assert not any(words in note for note in notes)
    if synchronisation is None:
        assert any("not synchronised" in note for note in notes)


def test_time_at_the_limit_is_that_of_the_washed_out_force():
    time_s = np.arange(0.0, 20.0, 0.02)
    wave = np.zeros((len(time_s), 3))
    wave[:, 0] = 4.5 * np.sign(np.sin(2.0 * np.pi * 0.4 * time_s))
    made = {"force_limit_n": 4.5, "saturated_share": 1.0}
    track = ForceTrack(time_s, wave.astype(np.float32), provenance=made)
    done = washed_out(track, washout_of(preset_named("balanced"), 4.5))
    share = done.provenance["saturated_share"]
    at_limit = np.linalg.norm(done.force_n, axis=1) >= 0.99 * 4.5
    assert share == pytest.approx(at_limit.mean())
    assert share < 0.5


def test_a_force_that_would_stop_is_bad():
    hands = {"normal": {"reach": 0.5, "trip": "runaway"}}
    found = marks(feedbacks__realistic__excursion__hands=hands)
    assert found["workspace"] is Mark.BAD


def test_entries_that_a_sequence_lacks_are_left_out():
    assert quality_report(convert(EMPTY, Description, "test")) == []
    assert worst([]) is Mark.DOUBTFUL
    known = {**EMPTY, "provenance": {"imu_rate_hz": 50}}
    names = [one.name for one in quality_report(convert(known, Description, "test"))]
    assert names == ["rate"]


def test_more_hertz_are_better():
    assert marked("rate_hz", 100.0, is_low_bad=True) is Mark.GOOD


def test_a_method_that_compares_no_taps_says_nothing_of_taps():
    found = Synchronisation(ClockMap(confidence=0.0), "variance")
    said = uncertainty(found, "clip.mp4")
    assert "the first sudden rise of sound and motion is uncertain" in said
    assert "taps" not in said


@pytest.mark.parametrize(("share", "said"), [(0.0002, "0.02 %"), (0.25, "25 %")])
def test_a_force_limit_that_is_reached_is_never_zero_percent(share, said):
    (note,) = notes_on_force(TrackEntry(saturated_share=share))
    assert str(note).startswith(f"{said} of the time")
