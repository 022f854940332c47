"""The alarm for touch that people feel to be early or late."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.playback.meters import LEAST_EVENTS, SyncAlarm


def fed(*differences_ms):
    alarm = SyncAlarm("video")
    for difference_ms in differences_ms:
        alarm.add([difference_ms] * LEAST_EVENTS)
    return alarm


@pytest.mark.parametrize(
    ("difference_ms", "is_on"),
    [(-14.9, False), (-15.1, True), (0.0, False), (49.9, False), (50.1, True)],
)
def test_a_sync_alarm_begins_where_people_notice(difference_ms, is_on):
    assert fed(difference_ms).is_on is is_on


def test_a_sync_alarm_ends_only_well_inside():
    assert fed(60.0, 48.0).is_on
    assert not fed(60.0, 44.0).is_on


def test_a_few_outliers_are_no_alarm():
    alarm = SyncAlarm("video")
    for k in range(200):
        assert not alarm.add([80.0 if k % 3 == 0 else 1.0])
    assert not alarm.is_on


def test_a_sync_alarm_says_by_how_much_and_where():
    assert fed(-20.0).sentence().startswith("the force is 20 ms ahead of the video")
    assert fed(70.0).sentence().startswith("the force is 70 ms behind the video")


@given(st.lists(st.floats(-300.0, 300.0), max_size=60))
def test_a_sync_alarm_reports_each_change_once(differences_ms):
    alarm, state = SyncAlarm("sound"), False
    for difference_ms in differences_ms:
        changed = alarm.add([difference_ms])
        assert changed is (alarm.is_on is not state)
        state = alarm.is_on
