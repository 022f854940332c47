"""Arrays at the border: copied unless nobody can write to them any more."""

import numpy as np
import pytest

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


def test_every_other_row_becomes_contiguous():
    mine = np.arange(12.0).reshape(4, 3)
    mine.setflags(write=False)
    assert frozen(mine[::2], (None, 3), "it").flags.c_contiguous
