"""Every importer through the list of faults; `benchmarks.robustness importers` has all of it.

Here: each format with each fault of its samples, truncations, and 4 of the 200
mutations; there: all 200, and logs of ten hours with time and memory.
"""

import functools
from collections.abc import Callable

import numpy as np
import pytest

from tests.faults.import_cases import (
    ASKED,
    READ,
    REFUSED,
    Verdict,
    clean_files,
    judge,
    mutation,
)
from tests.faults.import_formats import FORMATS, put
from tests.faults.import_signal import FAULTS, sample, with_fault

KEYS = list(FORMATS)
TIMED = [key for key, one in FORMATS.items() if one.is_timed]


@pytest.fixture(scope="module")
def with_one(tmp_path_factory) -> Callable[[str, str], Verdict]:
    """Judge a format with one fault; once, although several tests look at it."""

    @functools.cache
    def judged(key: str, fault: str) -> Verdict:
        one = FORMATS[key]
        files = one.write(with_fault(sample(apart=one.apart), fault))
        return judge(put(files, tmp_path_factory.mktemp("fault") / "in"), one)

    return judged


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("fault", FAULTS)
def test_faults_of_the_samples_do_no_harm(key, fault, with_one):
    """`judge` checks what holds always; here no fault is passed over as well."""
    verdict = with_one(key, fault)
    if fault == "wrong rate unit" and verdict.outcome == READ:
        # a given unit is reported
        assert any("rate-unit" in word for word in FORMATS[key].choices)
        assert any("agree with the unit" in note for note in verdict.recording.notes)
    elif fault in {"zero rows", "wrong force unit", "wrong rate unit"}:
        assert verdict.outcome in {REFUSED, ASKED}, verdict


@pytest.mark.parametrize("key", [key for key in TIMED if key != "GoPro, raw"])
def test_a_clock_set_back_is_refused(key, with_one):
    verdict = with_one(key, "backwards")
    assert verdict.outcome == REFUSED
    assert "jumps back by" in verdict.message


@pytest.mark.parametrize("key", TIMED)
def test_a_gap_stays_a_gap_and_nothing_is_made_up_in_it(key, with_one):
    verdict = with_one(key, "gap")
    assert verdict.recording is not None
    steps_s = np.diff(verdict.recording.imu.time_s)
    assert steps_s.max() == pytest.approx(1.51, abs=0.03)
    assert np.count_nonzero(steps_s > 0.1) == 1


@pytest.mark.parametrize("key", [k for k in TIMED if k != "GoPro, raw"])
def test_repeated_times_are_repaired_with_a_note(key, with_one):
    verdict = with_one(key, "duplicate")
    assert verdict.recording is not None
    said = ("share the time", "repeat the one", "carry the time")
    notes = verdict.recording.notes
    assert any(word in note for note in notes for word in said), notes


@pytest.mark.parametrize("key", [k for k in KEYS if k != "Razor $"])
def test_missing_numbers_are_marked_or_left_out(key, with_one):
    verdict = with_one(key, "nan")
    assert verdict.recording is not None, verdict.message
    imu = verdict.recording.imu
    lost = 0 if imu.valid is None else int(np.count_nonzero(~imu.valid))
    assert 15 <= lost <= 80


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("share", [0.0005, 0.02, 0.5, 0.999])
def test_cut_files_are_read_or_refused(key, share, tmp_path):
    one = FORMATS[key]
    files = {
        name: content[: max(1, round(share * len(content)))]
        for name, content in clean_files(key).items()
    }
    verdict = judge(put(files, tmp_path / "in"), one)
    if share < 0.001:
        assert verdict.outcome != READ
    # our own CSV is strict about its last line; a phone's system stands at an end
    if share == 0.5 and key not in {"own CSV", "Sensor Logger iOS"}:
        assert verdict.outcome == READ, verdict.message
        assert verdict.recording is not None
        assert (
            3.0 < verdict.recording.imu.time_s[-1] - 5.321 * (key == "Razor M0") < 5.0
        )


@pytest.mark.parametrize("key", KEYS)
def test_mutations_are_read_or_refused(key, tmp_path):
    outcomes = []
    for number in range(4, 8):
        path = mutation(key, number, tmp_path / str(number))
        outcomes.append(judge(path, FORMATS[key]).outcome)
    # our own CSV names the first line at fault instead of leaving it out
    assert READ in outcomes or key == "own CSV"
