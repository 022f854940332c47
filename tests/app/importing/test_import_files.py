"""The page that recognises the files of an import, asks, and offers an estimate."""

import numpy as np
import pytest

from app.experimenter import import_suggestion, import_wizard
from app.experimenter.import_reading import ReadingPage
from app.experimenter.import_wizard import FILES, MOUNTING, REPORT
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.errors import Message
from hapticplayer.sequence import open_sequence
from tests.needed_extras import needs


@needs("loggers")
def test_a_doubtful_log_asks_and_takes_the_answer(wizard, ride, wait_for, tmp_path):
    folder, made = ride
    imu = made.imu
    g = np.column_stack(
        [imu.time_s, imu.specific_force_mps2 / 9.80665, imu.angular_rate_radps]
    )
    log = tmp_path / "other logger.csv"
    np.savetxt(log, g, delimiter=";", header="t;a;b;c;d;e;f", fmt="%.6f")
    wizard.take([folder / "ride.mp4", log])
    question = wizard.files.question
    wait_for(question.isVisible)
    assert not wizard.next.isEnabled()
    assert wizard.findChild(ReadingPage).isVisible()  # its columns are unknown
    wizard.findChild(ReadingPage).reject()
    assert not question.take.isVisible()  # there is no answer to choose
    columns = "columns=time,ax,ay,az,gx,gy,gz"
    question.answered.emit([columns, "accel-unit=rubbish", "rate-unit=rad/s"])
    wait_for(lambda: not wizard.jobs.is_busy and question.isVisible())
    question.answered.emit([columns, "accel-unit=g", "rate-unit=rad/s"])
    wait_for(lambda: "units" in question.text.text())
    question.answers.buttons()[0].click()
    question.take.click()
    wait_for(wizard.next.isEnabled)
    assert "in g" in wizard.files.notes.text()
    assert wizard.files.keep.isVisible()


def test_a_chosen_answer_goes_into_the_form(wizard):
    question = wizard.files.question
    answers = (Message("accel-sign=-, or correct it"), Message("record it again"))
    question.ask(LogQuestion(Message("is doubtful"), answers, "/x/log.csv"))
    (radio,) = question.answers.buttons()
    assert not question.take.isEnabled()
    radio.click()
    assert question.take.isEnabled()
    wanted = []
    question.form_wanted.connect(wanted.append)
    question.form.click()
    assert wanted == [{"accel-sign": "-"}]


@needs("loggers")
def test_a_log_in_two_files_is_read_as_one(wizard, ride, wait_for, tmp_path):
    folder, made = ride
    imu = made.imu
    logs = [tmp_path / "acc.csv", tmp_path / "gyr.csv"]
    for log, values in zip(
        logs, (imu.specific_force_mps2, imu.angular_rate_radps), strict=True
    ):
        np.savetxt(
            log, np.column_stack([imu.time_s, values]), fmt="%.6f", delimiter=","
        )
    wizard.take([folder / "ride.mp4", *logs])
    question = wizard.files.question
    wait_for(question.isVisible)
    assert "2 tables" in question.text.text()
    wizard.findChild(ReadingPage).reject()
    words = "columns=time,ax,ay,az/time,gx,gy,gz time-unit=s accel-unit=m/s2"
    question.answered.emit([*words.split(), "rate-unit=rad/s"])
    wait_for(wizard.next.isEnabled)
    assert "200 Hz" in wizard.files.facts.text()
    assert wizard.files.chosen() == (folder / "ride.mp4", tuple(logs))


def test_problems_are_told_on_the_page(wizard, ride, wait_for, tmp_path):
    wizard.take([ride[0] / "ride.mp4"])  # a clip without motion
    wait_for(wizard.files.suggestion.isVisible)
    assert "no motion" in wizard.files.suggestion.reason.text()
    assert not wizard.next.isEnabled()
    wizard.files.log.setText(str(tmp_path / "missing.csv"))
    wizard.files.log.editingFinished.emit()
    wait_for(lambda: "missing.csv" in wizard.files.problem.text())


@pytest.fixture
def plain(ride, tmp_path):
    """A video that has neither telemetry nor a log."""
    path = tmp_path / "plain.mp4"
    path.write_bytes((ride[0] / "ride.mp4").read_bytes())
    return path


def test_a_plain_video_gets_an_estimate_if_a_person_wants_it(
    wizard, ride, plain, wait_for, monkeypatch
):
    from hapticplayer.extras.frames import estimate
    from tests.unit.extras.frames.made_up import stepping, steps, suggested, turning

    def here(work, *arguments, progress, **options):
        return work(*arguments, progress=progress, **options)

    def seen(_clip, *, gain, progress):
        progress(0.5, "following")
        return suggested(steps(turn_radps=turning, sinking=stepping), gain=gain)

    monkeypatch.setattr(import_wizard, "in_child", here)
    monkeypatch.setattr(estimate, "suggest_motion", seen)
    box = wizard.files.suggestion
    wizard.take([plain])
    wait_for(box.isVisible)
    assert "plain.mp4: contains no motion data" in box.reason.text()
    assert "Nothing measures this motion" in box.expect.text()
    assert not wizard.files.problem.isVisible()
    assert not wizard.next.isEnabled()

    box.choice.click()
    wizard.next.click()
    assert wizard.stack.currentIndex() == MOUNTING
    assert not wizard.mounting.mounting.isVisible()
    assert not wizard.mounting.triad.isVisible()
    assert not wizard.mounting.rendering.lever_arm.isVisible()
    wizard.back.click()
    assert wizard.stack.currentIndex() == FILES
    wizard.next.click()
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    assert "estimated" in open_sequence(wizard.made).tracks
    assert "estimated from the picture, nothing measured it" in (
        wizard.report.toPlainText()
    )

    wizard.another.click()
    wizard.take([ride[0] / "ride.mp4", ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    assert not box.isVisible()
    wizard.next.click()
    wizard.next.click()
    assert wizard.mounting.mounting.isVisible()


def test_without_opencv_the_estimate_cannot_be_chosen(
    wizard, plain, wait_for, monkeypatch
):
    monkeypatch.setattr(import_suggestion, "is_exact", lambda: False)
    wizard.take([plain])
    wait_for(wizard.files.suggestion.isVisible)
    assert not wizard.files.suggestion.choice.isEnabled()
    assert "System check" in wizard.files.suggestion.missing.text()
    assert wizard.files.suggestion.missing.isVisible()
