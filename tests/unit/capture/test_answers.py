"""Each answer to a question about a log is applied, or refused in a sentence."""

from functools import cache

import msgspec
import numpy as np
import pytest

from hapticplayer.capture import formats, read_recording
from hapticplayer.capture.choices import KEYS, LogChoices, parse_choices
from hapticplayer.capture.reading import find_format
from hapticplayer.capture.recorded import LOG, RECORDING, SourceClockLine, Take
from hapticplayer.capture.source import open_source
from hapticplayer.errors import HapticPlayerError
from tests.faults.import_cases import check_sentence
from tests.faults.import_formats import FORMATS as LOGGED
from tests.faults.import_formats import Written, own_csv, put
from tests.faults.import_signal import sample
from tests.needed_extras import needs
from tests.unit.capture.conftest import DATA

pytestmark = needs("loggers")


def recorded_here(made):
    """A folder of the recorder without its clip."""
    clock = SourceClockLine(0.2, 1.0, 0.002)
    take = Take(began="2026-11-27T15:00:00+00:00", is_finished=True, clock=clock)
    (log,) = own_csv(made).values()
    return {LOG: log, RECORDING: msgspec.json.encode(take)}


FORMATS = {**LOGGED, "recorded here": Written("recorded here", recorded_here)}
ANSWERS = {  # none of which leaves any of these logs as it is
    "columns": "time,ay,ax,az,gx,gy,gz",
    "time-unit": "ms",
    "accel-unit": "9.9",
    "rate-unit": "1.1",
    "field-unit": "mT",
    "axes": "y,-x,z",
    "accel-sign": "-",
    "accel-axes": "y,-x,z",
    "rate-axes": "y,-x,z",
    "rate-delay": "0.3",
    "swapped": "accel,rate",
    "rate-hz": "140",
    "sampling": "averaged",
}
WITHOUT_A_LIBRARY = {"camera"}
"""Read by telemetry-parser, then assembled like the others."""


@cache
def read_as(path, *words):
    return read_recording(path, parse_choices(words))


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Writes a recording of a format; its path, the same in every test."""
    place = tmp_path_factory.mktemp("logs")

    @cache
    def write(key):
        one = FORMATS[key]
        return put(one.write(sample(8.0, apart=one.apart)), place / key)

    return write


def differ(one, other):
    pairs = [
        (one.imu.time_s, other.imu.time_s),
        (one.imu.specific_force_mps2, other.imu.specific_force_mps2),
        (one.imu.angular_rate_radps, other.imu.angular_rate_radps),
        (one.imu.magnetic_field_ut, other.imu.magnetic_field_ut),
        (one.imu.sampling, other.imu.sampling),
    ]
    return any(not np.array_equal(a, b) for a, b in pairs)


def test_every_format_and_every_answer_is_tried(written):
    tried = {
        find_format(open_source(written(key)), parse_choices(one.choices)).name
        for key, one in FORMATS.items()
    }
    rows = {one.name for one in formats.recording_formats()}
    assert tried == rows - WITHOUT_A_LIBRARY
    assert {*ANSWERS, "format", "stuck"} == set(KEYS)


@pytest.mark.parametrize("answer", ANSWERS)
@pytest.mark.parametrize("key", FORMATS)
def test_an_answer_changes_the_log_or_is_refused(written, key, answer):
    path, plain = written(key), FORMATS[key].choices
    before, word = read_as(path, *plain), f"{answer}={ANSWERS[answer]}"
    others = [w for w in plain if not w.startswith(f"{answer}=")]
    try:
        after = read_as(path, *others, word)
    except HapticPlayerError as refusal:
        check_sentence(str(refusal))
        return
    assert after.provenance["answers"][answer] == ANSWERS[answer]
    assert word in after.notes[-1]
    assert differ(before, after)


@pytest.mark.parametrize("key", FORMATS)
def test_a_format_that_was_chosen_is_in_the_provenance(written, key):
    path, plain = written(key), FORMATS[key].choices
    name = find_format(open_source(path), parse_choices(plain)).name
    found = read_as(path, *plain, f"format={name}")
    assert found.provenance["answers"]["format"] == name
    with pytest.raises(HapticPlayerError, match=f"format={name}-mars"):
        read_as(path, *plain, f"format={name}-mars")


def test_answers_stay_the_same_however_often_they_are_used(written):
    choices = parse_choices(["axes=y,-x,z"])
    first, second = (read_recording(written("own CSV"), choices) for _ in range(2))
    assert not differ(first, second)
    assert choices == LogChoices(axes="y,-x,z")
    assert not choices.taken


def test_axes_of_a_phone_apply_to_our_own_csv():
    path = DATA.parent / "cases" / "si-csv-answers" / "phone.csv"
    if not path.is_file():
        pytest.skip("needs ../shared/data/cases/si-csv-answers")
    plain, turned = read_as(path), read_as(path, "axes=y,-x,z")
    force = plain.imu.specific_force_mps2
    expected = np.stack([force[:, 1], -force[:, 0], force[:, 2]], axis=1)
    np.testing.assert_allclose(turned.imu.specific_force_mps2, expected, atol=1e-9)
