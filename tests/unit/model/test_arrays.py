"""Arrays at the border: copied unless nobody can write to them any more."""

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import frozen


def test_an_array_that_can_be_written_to_is_copied():
    mine = np.arange(6.0).reshape(2, 3)
    kept = frozen(mine, (None, 3), "it")
    mine[0, 0] = 9.0
    assert kept[0, 0] == 0.0


def test_a_read_only_view_of_something_writable_is_copied():
    mine = np.arange(6.0).reshape(2, 3)
    view = mine[:]
    view.setflags(write=False)
    kept = frozen(view, (None, 3), "it")
    mine[0, 0] = 9.0
    assert kept[0, 0] == 0.0


def test_a_frozen_array_and_its_views_stay_as_they_are():
    mine = np.arange(6.0)
    mine.setflags(write=False)
    assert np.shares_memory(frozen(mine.reshape(2, 3), (None, 3), "it"), mine)


@pytest.mark.parametrize("other", [np.float32, np.int64])
def test_another_type_is_converted(other):
    mine = np.arange(6).astype(other)
    mine.setflags(write=False)
    assert frozen(mine, (None,), "it").dtype == np.float64


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "values",
    [
        np.ones((2, 3), dtype=complex),
        np.ones((2, 3), dtype=np.complex64),
        np.full((2, 3), "1"),
        np.full((2, 3), b"1"),
        np.full((2, 3), np.datetime64("2026-11-27")),
        np.full((2, 3), np.timedelta64(1, "s")),
        np.zeros((2, 3), dtype=[("x", "f8")]),
        np.full((2, 3), None),
        [[1j, 0, 0]],
        [["x", 0, 0]],
        [[1, 2], [3]],
        [[None, 0, 0]],
        [[10**400, 0, 0]],
    ],
)
def test_values_that_are_no_real_numbers_are_refused(values):
    with pytest.raises(InputError, match=r"it must hold real numbers|not finite"):
        frozen(values, (None, 3), "it")


@pytest.mark.filterwarnings("error")
def test_a_number_that_does_not_fit_is_refused():
    with pytest.raises(InputError, match="not finite in row 1"):
        frozen(np.array([1.0, 1e300]), (None,), "it", np.float32)


def test_every_other_row_becomes_contiguous():
    mine = np.arange(12.0).reshape(4, 3)
    mine.setflags(write=False)
    assert frozen(mine[::2], (None, 3), "it").flags.c_contiguous
