"""Conditioning and gravity removal: order, report and notes."""

import dataclasses

import numpy as np
import pytest

from hapticplayer import motion
from hapticplayer.capture.recording import Recording
from hapticplayer.clock import ManualClock
from hapticplayer.errors import InputError, UsageError
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.motion import DEFAULT_METHOD, conditioning
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.process_report import compare_methods, describe_quality
from hapticplayer.sequence.processing import (
    Processing,
    describe_motion,
    process_motion,
)
from hapticplayer.sequence.report import notes_on_motion


def test_processing_by_default_is_gravity_removal_alone(swing):
    imu, _ = swing
    done = process_motion(imu, Processing())
    expected = motion.remove_gravity(imu)
    assert done.imu is imu
    assert np.array_equal(done.track.acceleration_mps2, expected.acceleration_mps2)
    assert done.conditioning == ()
    assert done.summary["method"] == DEFAULT_METHOD


def spiked(imu: ImuLog) -> ImuLog:
    force = np.array(imu.specific_force_mps2)
    force[3000, 1] += 60.0
    return dataclasses.replace(imu, specific_force_mps2=force)


def test_conditioning_comes_in_the_order_that_loses_least(swing):
    imu = spiked(swing[0])
    done = process_motion(
        imu,
        Processing(
            remove_spikes=True, repair_clipping=True, average_hz=50.0, lowpass_hz=5.0
        ),
    )
    clean, _ = conditioning.remove_spikes(imu)
    clean, _ = conditioning.repair_clipping(clean)
    log = conditioning.average(clean, 50.0)
    expected = conditioning.lowpass_motion(motion.remove_gravity(log), 5.0)
    assert done.imu.sampling is Sampling.AVERAGED
    assert np.array_equal(done.track.acceleration_mps2, expected.acceleration_mps2)
    assert [step.split()[0] for step in done.conditioning] == [
        "spikes",
        "clipped",
        "averaged",
        "motion",
    ]
    assert "removed from 1 accelerometer" in done.conditioning[0]


def test_a_time_constant_reaches_the_smoother(swing):
    imu, _ = swing
    done = process_motion(imu, Processing(time_constant_s=12.0))
    assert done.summary["time_constant_s"] == pytest.approx([12.0, 12.0], rel=0.01)
    assert done.summary["time_constant_from"] == "chosen by a person"


def test_a_time_constant_of_another_method_is_wrong_usage():
    with pytest.raises(UsageError, match="is for the method smoother"):
        Processing("vqf", time_constant_s=12.0)


def test_unknown_or_unfit_processing_is_refused(swing):
    imu, _ = swing
    with pytest.raises(UsageError, match="choose one of smoother"):
        process_motion(imu, Processing("magic"))
    with pytest.raises(InputError):
        process_motion(imu, Processing(average_hz=1000.0))
    with pytest.raises(InputError, match="cutoff"):
        process_motion(imu, Processing(lowpass_hz=150.0))


# --- the quality report -----------------------------------------------------


def as_recording(imu):
    return Recording(imu, ClockMap(), "test camera", ("a note",))


def test_the_report_counts_what_was_recorded(still_log):
    keep = np.r_[0:500, 700:2000]
    log = ImuLog(
        still_log.time_s[keep],
        still_log.specific_force_mps2[keep],
        still_log.angular_rate_radps[keep],
        source="folder/still.csv",
    )
    report = describe_quality(as_recording(log), process_motion(log, Processing()))
    read = report["recording"]
    assert read["source"] == "still.csv"
    assert read["samples"] == 1800
    assert read["duration_s"] == pytest.approx(1999 / 200)
    assert read["rate_hz"] == pytest.approx(200.0)
    assert read["gaps"] == 1
    assert read["longest_gap_s"] == pytest.approx(201 / 200)
    assert read["notes"] == ["a note"]
    found = report["gravity_removal"]
    assert found["accelerometer_gain"] == pytest.approx(1 / 1.03, abs=1e-3)
    assert found["leak_at_rest_mps2"] < 0.05
    assert found["invalid_share"] == pytest.approx(2 / 1800)


def test_rms_and_peak_are_those_of_the_valid_samples(swing):
    track = motion.remove_gravity(swing[0])
    p = np.zeros((len(track), 3))
    p[100:200] = [3.0, 0.0, 4.0]
    p[150] = [0.0, -12.0, 5.0]
    p[170] = 1e3
    valid = np.ones(len(track), dtype=bool)
    valid[170] = False
    track = dataclasses.replace(track, acceleration_mps2=p, valid=valid)
    found = describe_motion(track)
    square = (98 * 25.0 + 169.0) / (len(track) - 1)
    assert found["rms_mps2"] == pytest.approx(np.sqrt(square))
    assert found["peak_mps2"] == pytest.approx(13.0)
    assert found["peak_at_s"] == track.time_s[150]
    nothing = dataclasses.replace(track, valid=np.zeros(len(track), dtype=bool))
    assert describe_motion(nothing)["rms_mps2"] is None


class TickingClock(ManualClock):
    """Moves on by 10 ms whenever it is read."""

    def now_s(self):
        self.advance(0.01)
        return super().now_s()


def test_methods_are_compared_on_the_same_samples(swing):
    imu, truth = swing
    rows = list(compare_methods(imu, Processing(), TickingClock()))
    assert [row.method for row in rows] == list(motion.METHODS)
    assert rows[0].difference_mps2 == 0.0
    default = motion.remove_gravity(imu)
    for row in rows:
        track = motion.remove_gravity(imu, row.method)
        apart = track.acceleration_mps2 - default.acceleration_mps2
        both = track.valid & default.valid
        expected = np.sqrt(np.mean(np.sum(apart[both] ** 2, axis=1)))
        assert row.difference_mps2 == pytest.approx(expected, abs=1e-12)
        p = track.acceleration_mps2[track.valid]
        assert row.rms_mps2 == pytest.approx(np.sqrt(np.mean(np.sum(p**2, axis=1))))
        assert row.us_per_sample == pytest.approx(1e4 / len(imu))
    rms_true = np.sqrt(np.mean(np.sum(truth**2, axis=1)))
    assert rows[0].rms_mps2 == pytest.approx(rms_true, rel=0.02)


# --- notes ------------------------------------------------------------------


def found_in(imu, **changed):
    return {**process_motion(imu, Processing()).summary, **changed}


def test_a_good_recording_needs_no_note(still_log):
    assert notes_on_motion(still_log, found_in(still_log)) == []


@pytest.mark.parametrize(
    ("changed", "sentence"),
    [
        ({"saturated_share": 0.0123}, "1.2 % of the samples are at the sensor's limit"),
        ({"invalid_share": 0.002}, "0.2 % of the motion is not valid"),
        ({"leak_at_rest_mps2": 0.07}, "0.07 m/s2 of gravity remain"),
        ({"clock": "the time stamps jitter by 12 %"}, "jitter by 12 %"),
        ({"calibration_overruled": 1}, "contradicts the calibration"),
    ],
)
def test_flaws_that_harm_the_force_are_noted(still_log, changed, sentence):
    (note,) = notes_on_motion(still_log, found_in(still_log, **changed))
    assert sentence in note


def test_a_rate_that_changes_is_noted(still_log):
    steps_s = np.where(np.arange(2000) < 1000, 0.005, 0.0052)
    drifting = dataclasses.replace(still_log, time_s=np.cumsum(steps_s))
    (note,) = notes_on_motion(drifting, found_in(still_log))
    assert "from 192.3 to 200.0 Hz" in note


# --- importing --------------------------------------------------------------


def test_an_import_records_what_was_done(tmp_path, tiny_clip, swing):
    recording = as_recording(spiked(swing[0]))
    chosen = Processing(
        time_constant_s=15.0, remove_spikes=True, average_hz=100.0, lowpass_hz=10.0
    )
    folder = write_sequence(
        tiny_clip, recording, tmp_path / "ride", choices=Choices(processing=chosen)
    )
    sequence = open_sequence(folder)
    made_of = sequence.description.provenance
    assert made_of["processing"] == dataclasses.asdict(chosen)
    assert made_of["gravity_removal"] == "smoother"
    assert made_of["motion_summary"]["time_constant_from"] == "chosen by a person"
    assert [step.split()[0] for step in made_of["conditioning"]] == [
        "spikes",
        "averaged",
        "motion",
    ]
    expected = process_motion(recording.imu, chosen).track
    assert np.array_equal(sequence.motion.acceleration_mps2, expected.acceleration_mps2)
    with np.load(folder / "imu.npz") as stored:  # as it was recorded
        assert np.array_equal(
            stored["specific_force_mps2"], recording.imu.specific_force_mps2
        )


def test_the_gain_is_estimated_once(tmp_path, tiny_clip, recording, monkeypatch):
    calls, analyse = [], motion.analyse
    monkeypatch.setattr(
        motion, "analyse", lambda *a, **o: calls.append(a) or analyse(*a, **o)
    )
    monkeypatch.setattr(motion, "remove_gravity", None)
    write_sequence(tiny_clip, recording, tmp_path / "ride")
    assert len(calls) == 1
