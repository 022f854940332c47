"""Raw arrays with holes, against closed forms of what was there."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling
from hapticplayer.motion.repair import repair_samples
from hapticplayer.motion.repair import samples as repair
from hapticplayer.motion.repair.timestamps import RepairKind

COUNT = 600
T = np.arange(COUNT) / 100.0


@pytest.fixture
def arrays():
    """Sensors whose values are straight lines in time: any line fill is exact."""
    force = line([0.0, 0.5, STANDARD_GRAVITY_MPS2], [0.1, -0.2, 0.05])
    rate = line([0.02, 0.0, 0.04], [0.005, 0.01, -0.005])
    field = line([0.0, 20.0, -45.0], [1.0, -1.0, 0.5])
    return [T.copy(), force, rate, field]


def line(start, slope):
    return np.array(start) + np.outer(T, slope)


def kinds(repaired):
    return {one.kind: one.count for one in repaired.repairs}


def test_a_clean_recording_comes_through_as_it_is(arrays):
    repaired = repair_samples(*arrays, sampling=Sampling.AVERAGED, source="walk.csv")
    imu = repaired.imu
    assert repaired.repairs == ()
    assert imu.valid is None
    assert imu.sampling is Sampling.AVERAGED
    assert imu.source == "walk.csv"
    given = (imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps)
    for got, want in zip(given, arrays, strict=False):
        assert np.array_equal(got, want)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e6, 1e300])
@pytest.mark.parametrize(
    ("sensor", "kind"), [(1, RepairKind.FORCE_FILLED), (2, RepairKind.RATE_FILLED)]
)
def test_a_sample_that_no_sensor_gives_is_filled_and_marked(
    arrays, sensor, kind, value
):
    want = arrays[sensor].copy()
    arrays[sensor][[7, 300, 301], [0, 2, 1]] = value
    repaired = repair_samples(*arrays)
    imu = repaired.imu
    got = (imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps)[sensor]
    assert np.allclose(got, want, atol=1e-12)
    assert np.flatnonzero(~imu.valid).tolist() == [7, 300, 301]
    assert kinds(repaired) == {kind: 3}
    assert repaired.repairs[0].first_row == 7
    assert "3 of 600 samples" in repaired.repairs[0].text


def test_a_long_gap_is_filled_between_the_means_of_its_sides(arrays):
    arrays[1][200:400] = np.nan
    # one odd sample beside the gap must not set the course of two seconds
    arrays[1][199] += 2.5
    filled = repair_samples(*arrays).imu.specific_force_mps2[200:400]
    before, after = arrays[1][175:200].mean(axis=0), arrays[1][400:425].mean(axis=0)
    part = (np.arange(1, 201) / 201.0)[:, None]
    assert np.allclose(filled, before + part * (after - before), atol=1e-9)


def test_a_gap_at_an_end_holds_the_nearest_sample(arrays):
    arrays[2][:50] = np.nan
    arrays[2][-50:] = np.nan
    imu = repair_samples(*arrays).imu
    assert np.array_equal(imu.angular_rate_radps[:50], np.tile(arrays[2][50], (50, 1)))
    assert np.array_equal(imu.angular_rate_radps[-1], arrays[2][549])
    assert int((~imu.valid).sum()) == 100


def test_holes_of_the_magnetometer_leave_the_motion_valid(arrays):
    want = arrays[3].copy()
    arrays[3][100:103] = np.nan
    arrays[3][400] = 0.0
    repaired = repair_samples(*arrays)
    assert repaired.imu.valid is None
    assert np.allclose(repaired.imu.magnetic_field_ut, want, atol=1e-12)
    assert kinds(repaired) == {RepairKind.FIELD_FILLED: 4}


@pytest.mark.parametrize("value", [0.0, np.nan])
def test_an_empty_magnetometer_is_left_out(arrays, value):
    arrays[3][: COUNT // 2 + 1] = value
    repaired = repair_samples(*arrays)
    assert repaired.imu.magnetic_field_ut is None
    assert RepairKind.FIELD_DROPPED in kinds(repaired)


def test_zeros_in_the_midst_of_real_forces_are_placeholders(arrays):
    want = arrays[1].copy()
    arrays[1][[0, 250, 251]] = 0.0
    imu = repair_samples(*arrays).imu
    assert np.flatnonzero(~imu.valid).tolist() == [0, 250, 251]
    assert np.allclose(imu.specific_force_mps2[1:], want[1:], atol=1e-12)


def test_zeros_in_a_fall_that_begins_gently_are_real(arrays):
    fade = np.clip(np.abs(np.arange(COUNT) - 300) / 50.0 - 1.0, 0.0, 1.0)
    arrays[1] *= fade[:, None]
    assert not arrays[1][300].any()
    repaired = repair_samples(*arrays)
    assert repaired.imu.valid is None
    assert np.array_equal(repaired.imu.specific_force_mps2, arrays[1])


def test_rows_that_share_a_time_are_averaged(arrays):
    arrays = [np.insert(a, 200, a[200], axis=0) for a in arrays]
    arrays[1][200] += [0.2, 0.0, 0.0]
    imu = repair_samples(*arrays).imu
    assert np.array_equal(imu.time_s, T)
    middle = arrays[1][201] + [0.1, 0.0, 0.0]
    assert np.allclose(imu.specific_force_mps2[200], middle, atol=1e-12)


def test_the_arrays_of_the_caller_stay_as_they_are(arrays):
    arrays[0][5] = np.nan
    arrays[1][50] = np.nan
    before = [a.copy() for a in arrays]
    repair_samples(*arrays)
    for now, then in zip(arrays, before, strict=True):
        assert np.array_equal(now, then, equal_nan=True)


@pytest.mark.parametrize(
    "convert",
    [
        np.ndarray.tolist,
        np.asfortranarray,
        np.float32,
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a.astype(">f8"),
        lambda a: a.astype(object),
    ],
)
def test_any_kind_of_array_of_numbers_will_do(arrays, convert):
    want = repair_samples(*arrays).imu
    got = repair_samples(arrays[0], *map(convert, arrays[1:])).imu
    assert got.specific_force_mps2.dtype == np.float64
    assert got.specific_force_mps2.flags.c_contiguous
    assert np.allclose(got.specific_force_mps2, want.specific_force_mps2, rtol=1e-6)
    assert np.allclose(got.angular_rate_radps, want.angular_rate_radps, rtol=1e-6)


def test_masked_and_empty_cells_are_missing_samples(arrays):
    masked = np.ma.MaskedArray(arrays[1], mask=np.zeros((COUNT, 3)))
    masked[40] = np.ma.masked
    rate = arrays[2].astype(object)
    rate[41, 1] = None
    imu = repair_samples(arrays[0], masked, rate).imu
    assert np.flatnonzero(~imu.valid).tolist() == [40, 41]


@pytest.mark.parametrize(
    ("index", "value", "says"),
    [
        (0, np.zeros((COUNT, 2)), "time_s has 2 axes"),
        (1, np.zeros((COUNT, 2)), "specific_force_mps2 has the shape 600 x 2"),
        (2, np.zeros((5, 3)), "angular_rate_radps has the shape 5 x 3"),
        (3, [["a", "b", "c"]] * COUNT, "magnetic_field_ut does not hold numbers"),
        (2, [[1, 2], [3]], "angular_rate_radps does not hold numbers"),
        (1, np.ones((COUNT, 3)) * 1j, "specific_force_mps2 does not hold numbers"),
    ],
)
def test_other_shapes_and_things_are_refused_by_name(arrays, index, value, says):
    arrays[index] = value
    with pytest.raises(InputError, match=f"walk.csv: {says}"):
        repair_samples(*arrays, source="walk.csv")


def test_more_samples_than_the_limit_are_refused(arrays, monkeypatch):
    monkeypatch.setattr(repair, "MAX_SAMPLES", COUNT - 1)
    with pytest.raises(InputError, match=r"600; 2 to 599 can be used.*cut it"):
        repair_samples(*arrays)


def test_a_gyroscope_that_says_nothing_is_mentioned(arrays):
    arrays[2][:] = 0.0
    assert kinds(repair_samples(*arrays)) == {RepairKind.NO_ROTATION: COUNT}
