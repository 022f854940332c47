"""Damaged files of force; `benchmarks.distribution damage` has all of them."""

import pytest

from tests.faults.force_cases import KINDS, clean_file, judge


@pytest.mark.parametrize("name", KINDS)
def test_damaged_files_are_read_or_refused_in_a_sentence(name, tmp_path):
    clean = clean_file(name)
    found = [judge(name, clean, number, tmp_path) for number in range(60)]
    assert {"read", "refused"} == set(found)
