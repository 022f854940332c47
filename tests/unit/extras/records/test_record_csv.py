"""The CSV of a record: the same numbers, with units, whatever they are."""

import csv
import io
import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.extras.records.record_csv import columns_of, head_line, lines
from hapticplayer.haptics.shared import TICK

HEADER = {
    "modes": {"2": "following", "4": "tripped"},
    "causes": {"0": "none", "7": "player_gone"},
}
NAMES = (
    "tick,monotonic_s,media_s,"
    "planned_fx_n,planned_fy_n,planned_fz_n,force_fx_n,force_fy_n,force_fz_n,"
    "position_x_m,position_y_m,position_z_m,"
    "velocity_x_mps,velocity_y_mps,velocity_z_mps,"
    "centring_fx_n,centring_fy_n,centring_fz_n,"
    "lateness_us,reply_age_us,heat_n,missed,mode,cause,buttons\n"
)


def table(ticks, first=0, header=HEADER):
    """The CSV, read by the standard library."""
    columns = columns_of(ticks.dtype, header)
    text = (head_line(columns) + lines(first, ticks, columns)).decode()
    return list(csv.DictReader(io.StringIO(text)))


def column_of(kind, values):
    """The texts of one column `value_s` with nine decimals."""
    ticks = np.zeros(len(values), dtype=[("value_s", kind)])
    ticks["value_s"] = values
    return [row["value_s"] for row in table(ticks)]


def test_the_columns_carry_their_units():
    assert head_line(columns_of(TICK, HEADER)).decode() == NAMES


def test_numbers_and_names_are_where_they_belong():
    ticks = np.zeros(2, dtype=TICK)
    ticks["monotonic_s"] = [12345.678901234, 12345.679901]
    ticks["force_n"] = [[1, -2, 3.5], [0, 0, -0.000002]]
    ticks["position_m"] = [[0.0401, 0, -0.02], [1e-9, 0, 0]]
    ticks["lateness_s"] = [12.5e-6, 0]
    ticks["missed"], ticks["buttons"] = [0, 3], [0, 65535]
    ticks["mode"], ticks["cause"] = [2, 4], [0, 7]
    one, two = table(ticks, first=99)
    assert (one["tick"], two["tick"]) == ("99", "100")
    assert one["monotonic_s"] == "12345.678901234"
    assert [one[f"force_f{a}_n"] for a in "xyz"] == [
        "1.000000",
        "-2.000000",
        "3.500000",
    ]
    assert two["force_fz_n"] == "-0.000002"
    assert float(one["position_x_m"]) == pytest.approx(0.0401, abs=2e-9)
    assert two["position_x_m"] == "0.000000001"
    assert one["lateness_us"] == "12.500"
    assert (two["missed"], two["buttons"]) == ("3", "65535")
    assert (one["mode"], one["cause"]) == ("following", "none")
    assert (two["mode"], two["cause"]) == ("tripped", "player_gone")


@pytest.mark.parametrize(
    "header",
    [
        {},
        {"modes": [1], "causes": "none"},
        {"modes": {"x": "y", "٢": "following", "2": 3}, "causes": {"0": "=cmd()"}},
        {"modes": {"2": "a,b"}, "causes": {"0": 'a"\n'}},
        {"modes": {"2": ""}, "causes": {"0": "n" * 1000}},
    ],
)
def test_names_that_could_break_a_table_are_left_as_numbers(header):
    ticks = np.zeros(1, dtype=TICK)
    ticks["mode"] = 2
    (row,) = table(ticks, header=header)
    assert (row["mode"], row["cause"]) == ("2", "0")


@given(st.lists(st.floats(width=64), min_size=1, max_size=20))
def test_any_double_is_itself_to_nine_decimals(values):
    for value, text in zip(values, column_of("<f8", values), strict=True):
        if abs(value) * 1e9 < 1 << 62:
            assert re.fullmatch(r"-?(0|[1-9]\d*)\.\d{9}", text)
            tolerance = 0.5e-9 + 2.0 * math.ulp(value)  # of scaling and of reading
            assert abs(float(text) - value) <= tolerance
            assert not (text.startswith("-") and float(text) == 0.0)
        elif math.isnan(value):
            assert text == "nan"
        else:
            assert float(text) == value


@given(st.lists(st.floats(width=32), min_size=1, max_size=20))
def test_any_float_is_itself_to_nine_decimals(values):
    for value, text in zip(values, column_of("<f4", values), strict=True):
        if math.isnan(value):
            assert text == "nan"
        else:
            # 17 digits where it is too large for decimals, exact but for the scaling
            assert float(text) == pytest.approx(value, abs=0.51e-9, rel=1e-15)


@pytest.mark.parametrize(
    "kind", ["|u1", "<u2", "<u4", "<u8", "|i1", "<i2", "<i4", "<i8"]
)
def test_whole_numbers_are_exact_to_their_limits(kind):
    limits = np.iinfo(kind)
    values = sorted({0, 1, 9, 10, 99, 100, limits.max, limits.max - 1, limits.min})
    assert column_of(kind, values) == [str(value) for value in values]


def test_a_number_reads_the_same_whatever_stands_beside_it(rng):
    values = rng.standard_normal(1000).astype("<f4")
    alone = [column_of("<f4", [value])[0] for value in values]
    beside = np.concatenate([values, [np.nan, np.inf, -np.inf, 1e38]])
    assert column_of("<f4", beside)[:1000] == alone
    assert column_of("<f4", beside)[1000:1003] == ["nan", "inf", "-inf"]


def test_fields_that_this_version_does_not_know_are_columns_too():
    dtype = np.dtype([("grip_n", "<f4", (2,)), ("quality", "<f8"), ("flags", "<u2")])
    ticks = np.zeros(1, dtype=dtype)
    ticks["grip_n"], ticks["quality"], ticks["flags"] = [1.5, -2], 0.1, 7
    (row,) = table(ticks)
    assert row == {
        "tick": "0",
        "grip_f0_n": "1.500000",
        "grip_f1_n": "-2.000000",
        "quality": "0.10000000000000001",
        "flags": "7",
    }
