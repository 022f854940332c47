"""What kept an output from playing is counted, and said in one sentence."""

import numpy as np
import pytest

from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import RULES, Cause, Mode, Reaction
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.faults import CAUSE_TEXTS, HARMLESS, OutputFaults, trip_text


def ticks(mode, cause=Cause.NONE, count=1000, flags=0):
    made = np.zeros(count, TICK)
    made["mode"], made["cause"], made["buttons"] = mode, cause, flags
    return made


def faults_of(*parts, is_wanted=True, is_rig=False):
    made = OutputFaults()
    for part in parts:
        made.add(part, is_wanted=is_wanted, is_rig=is_rig)
    return made


def test_an_output_that_played_has_no_fault():
    start = ticks(Mode.IDLE, Cause.NO_TRACK, 90)
    assert faults_of(start, ticks(Mode.FOLLOWING)).sentence == ""
    paused = ticks(Mode.IDLE, Cause.PAUSED, 9000)
    assert faults_of(paused, ticks(Mode.FOLLOWING, count=1)).sentence == ""


def test_an_output_that_nobody_wanted_has_no_fault():
    idle = ticks(Mode.IDLE, Cause.NO_TRACK)
    assert faults_of(idle, is_wanted=False).sentence == ""


def test_an_output_that_never_played_says_why():
    said = faults_of(ticks(Mode.IDLE, Cause.NOT_HOMED)).sentence
    assert said == "nothing was played: not homed; set the device up first"


def test_an_output_that_played_half_of_the_time_says_why():
    late = ticks(Mode.RAMPING, Cause.REPLY_LATE)
    said = faults_of(ticks(Mode.FOLLOWING), late).sentence
    assert said.startswith("at times nothing was played: device not responding")
    assert "; " in said


def test_a_trip_is_said_until_a_person_re_arms():
    faults = faults_of(ticks(Mode.FOLLOWING))
    assert faults.note_mode(Mode.TRIPPED, Cause.REPLY_LOST)
    assert faults.sentence.startswith("stopped: device not responding; ")
    faults.note_mode(Mode.RAMPING, Cause.PAUSED)
    assert faults.sentence == ""


@pytest.mark.parametrize("cause", [Cause.STOPPED, Cause.UNPLUGGED])
def test_a_stop_by_a_person_and_a_lost_device_are_no_trip(cause):
    faults = faults_of(ticks(Mode.FOLLOWING), ticks(Mode.TRIPPED, cause))
    assert not faults.note_mode(Mode.TRIPPED, cause)
    assert faults.sentence == ""


def test_a_report_of_a_device_is_said_last():
    faults = faults_of(ticks(Mode.FOLLOWING))
    faults.notice = "low battery; charge it"
    assert faults.sentence == "low battery; charge it"
    faults.note_mode(Mode.TRIPPED, Cause.MALFORMED)
    assert faults.sentence.startswith("stopped: malformed replies from the device; ")
    assert faults.sentence.endswith("; low battery; charge it")


@pytest.mark.parametrize(("refused", "is_unheard"), [(300, False), (700, True)])
def test_a_rig_that_most_packets_did_not_reach_is_unheard(refused, is_unheard):
    heard = ticks(Mode.FOLLOWING, count=1000 - refused, flags=SENT)
    lost = ticks(Mode.FOLLOWING, count=refused, flags=SENT | REFUSED)
    assert faults_of(lost, heard, is_rig=True).is_unheard is is_unheard


def test_each_cause_that_keeps_a_force_away_has_words():
    own = {Cause.STOPPED, *HARMLESS}
    assert {rule.cause for rule in RULES} - own <= set(CAUSE_TEXTS)
    for cause, reaction, _ in RULES:
        if reaction is Reaction.TRIP and cause is not Cause.STOPPED:
            assert "; " in trip_text(cause)
            assert "_" not in trip_text(cause)
