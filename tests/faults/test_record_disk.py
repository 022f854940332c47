"""A disk that is full: what was recorded is kept, and it is told."""

import pytest

pytestmark = pytest.mark.realtime


def test_a_film_ends_whole_before_the_disk_is_full(on_its_own_disk):
    found = on_its_own_disk("record_disk.py", "low")
    assert found["is_finished"]
    assert found["film_s"] > 0.2
    assert found["motion_s"] > found["film_s"] + 1.0
    assert found["gaps"] == ["camera"]
    warned, ended = found["notices"]
    assert "of the disk are free, enough for 0 min" in warned
    assert "camera: ends here, the disk at" in ended


def test_a_disk_that_others_fill_is_told_and_what_fitted_is_kept(on_its_own_disk):
    found = on_its_own_disk("record_disk.py", "full")
    assert found["film_s"] > 0.5
    assert found["motion_s"] > 0.5
    assert any("is full" in one for one in found["told"])
    assert not any("was removed" in one for one in found["told"])
    assert len(found["told"]) <= 5
