"""Several clips are imported one after the other, and none holds the others up."""

import shutil

import pytest

from app.experimenter import import_queue
from app.experimenter.import_queue import QueuePage, State
from app.experimenter.import_wizard import MOUNTING, REPORT, ImportWizard
from hapticplayer.errors import InputError
from hapticplayer.sequence import open_sequence
from tests.needed_extras import needs


@pytest.fixture
def queue(application, qtbot, tmp_path):
    made = QueuePage([], tmp_path / "library")
    qtbot.addWidget(made)
    made.show()
    yield made
    made.close_jobs()


@pytest.fixture
def clips(ride, clip, tmp_path):
    """A folder with a camera's clip, one with its log, a plain and a damaged one."""
    folder = tmp_path / "rides"
    (folder / "day 2").mkdir(parents=True)
    shutil.copy(ride[0] / "gopro.mp4", folder / "a camera.mp4")
    (folder / "b damaged.mp4").write_bytes(b"no video" * 50)
    shutil.copy(clip, folder / "c plain.mp4")
    shutil.copy(ride[0] / "ride.mp4", folder / "day 2" / "d ride.mp4")
    shutil.copy(ride[0] / "log.csv", folder / "day 2" / "d ride.csv")
    return folder


def states(queue):
    return [row.state for row in queue.rows]


def shown(queue):
    return [queue.table.item(at, 2).text() for at in range(queue.table.rowCount())]


def test_a_folder_becomes_a_queue_with_one_report(queue, clips, wait_for, qtbot):
    queue.add([clips])
    assert [row.item.video.name[0] for row in queue.rows] == ["a", "b", "c", "d"]
    assert queue.table.item(3, 1).text() == "d ride.csv"
    queue.start.click()
    assert not queue.start.isEnabled()
    wait_for(lambda: not queue.jobs.is_busy and State.WAITING not in states(queue))
    assert states(queue) == [State.DONE, State.FAILED, State.ASKS, State.DONE]
    said = queue.report.text()
    assert "Clips: 4; imported: 2; need an answer: 1; not imported: 1" in said
    assert queue.table.currentRow() == 2  # what is asked is selected
    assert "no motion" in queue.detail.text()
    assert "needs an answer" in shown(queue)[2]
    made = [row.folder for row in queue.rows if row.folder]
    assert [open_sequence(folder).title for folder in made] == ["a camera", "d ride"]
    assert all(folder.parent == queue.library for folder in made)
    with qtbot.waitSignal(queue.wizard_wanted) as wanted:
        queue.answer.click()
    assert wanted.args == [[clips / "c plain.mp4"]]


def test_clips_that_are_there_are_only_tested(queue, clips, wait_for):
    queue.add([clips / "a camera.mp4"])
    queue.run()
    wait_for(lambda: states(queue) == [State.DONE])
    made = queue.rows[0].folder
    again = QueuePage([clips / "a camera.mp4"], queue.library)
    again.run()
    wait_for(lambda: states(again) == [State.THERE])
    assert again.rows[0].folder == made
    assert "was there, intact" in shown(again)[0]
    imu = made / "imu.npz"
    imu.write_bytes(imu.read_bytes()[:-8] + b"damaged!")
    third = QueuePage([clips / "a camera.mp4"], queue.library)
    third.run()
    wait_for(lambda: states(third) == [State.FAILED])
    assert "imu.npz" in third.detail.text()
    for page in (again, third):
        page.close_jobs()


def test_a_queue_that_is_stopped_goes_on_later(queue, clips, wait_for, monkeypatch):
    really = import_queue.in_child
    stopped = []

    def held(*arguments, progress, **options):
        if not stopped:
            stopped.append(True)
            queue.progress.stop.click()
        return really(*arguments, progress=progress, **options)

    queue.add([clips])
    monkeypatch.setattr(import_queue, "in_child", held)
    queue.run()
    wait_for(lambda: not queue.jobs.is_busy and State.RUNNING not in states(queue))
    assert states(queue) == [State.STOPPED] * 4
    assert not queue.library.exists()
    assert "stopped: 4" in queue.report.text()
    queue.start.click()
    wait_for(lambda: not queue.jobs.is_busy and State.WAITING not in states(queue))
    assert states(queue).count(State.DONE) == 2


def test_a_fault_of_the_program_stops_no_other_clip(
    queue, clips, wait_for, monkeypatch, qtbot
):
    def broken(*_arguments, progress):
        raise ZeroDivisionError("a fault")

    queue.add([clips])
    monkeypatch.setattr(import_queue, "in_child", broken)
    with qtbot.captureExceptions() as caught:
        queue.run()
        wait_for(lambda: states(queue) == [State.FAILED] * 4)
    assert len(caught) == 4  # each is told to who looks after the program
    assert "a fault" in shown(queue)[0]


@needs("loggers")
def test_an_unknown_log_waits_for_its_columns(queue, clips, case, wait_for, tmp_path):
    log = clips / "day 2" / "d ride.csv"
    log.write_bytes(case("number-spellings/blanks.txt").read_bytes())
    queue.add([clips / "day 2"])
    queue.run()
    wait_for(lambda: states(queue) == [State.ASKS])
    assert "without a description" in queue.detail.text()


def test_dropped_clips_open_the_wizard_for_an_answer(
    window, clips, wait_for, settings, tmp_path
):
    settings.keep("library", str(tmp_path / "library"))
    window.dropping.take([clips])
    queue = window.findChild(QueuePage)
    assert len(queue.rows) == 4
    queue.table.selectRow(3)
    queue.answer.click()
    wizard = window.findChild(ImportWizard)
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    wizard.next.click()
    assert wizard.stack.currentIndex() == MOUNTING
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    wizard.reject()
    assert queue.rows[3].state is State.DONE
    assert queue.rows[3].folder == wizard.made
    assert queue.isVisible()
    queue.reject()


def test_several_clips_lead_from_the_wizard_to_a_queue(window, clips):
    wizard = window.dialogs.import_recording([])
    wizard.files.take(sorted(clips.glob("*.mp4")))
    assert not wizard.isVisible()
    queue = window.findChild(QueuePage)
    assert [row.item.video.name[0] for row in queue.rows] == ["a", "b", "c"]
    queue.add([clips / "a camera.mp4"])  # it is in the list
    assert len(queue.rows) == 3
    queue.reject()


def test_a_clip_whose_report_cannot_be_read_is_told(queue, clips, monkeypatch):
    def damaged(_folder):
        raise InputError("is damaged", where="x", remedy="import it again")

    monkeypatch.setattr(import_queue, "read_description", damaged)
    queue.add([clips / "a camera.mp4"])
    queue.note([clips / "a camera.mp4"], clips)
    assert "is damaged" in queue.detail.text()
