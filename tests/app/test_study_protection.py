"""Nothing of the desktop gets between a participant and the clip, nor tells secrets."""

import json
import os
from types import BuiltinMethodType

import pytest
from PySide6.QtCore import ClassInfo, QObject, Qt, Slot
from PySide6.QtDBus import QDBusConnection
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QProgressDialog, QWidget
from sitting import KEYS, Person

from app.bridge.desktop import NAME, Mpris
from app.bridge.idle import EVERYTHING, IdleInhibitor
from app.experimenter.study_menu import StudyProcess
from app.participant.application import OPENED
from hapticplayer.errors import StudyError
from hapticplayer.haptics.processes import Health
from hapticplayer.playback.output import LENT
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.pages import PageKind

NOTIFICATIONS = "org.freedesktop.Notifications"
SECRETS = (*KEYS, "realistic", "random", "shake", "clip.mp4", "A ride whose", ".json")
MEDIA_KEYS = (
    *(Qt.Key.Key_MediaPlay, Qt.Key.Key_MediaTogglePlayPause, Qt.Key.Key_MediaStop),
    *(Qt.Key.Key_MediaNext, Qt.Key.Key_VolumeUp, Qt.Key.Key_VolumeMute),
)


@ClassInfo({"D-Bus Interface": NOTIFICATIONS})
class FakeNotifications(QObject):
    """Notes who does not want to be notified."""

    def __init__(self) -> None:
        super().__init__()
        self.inhibited: list[tuple[str, str]] = []

    @Slot(str, str, "QVariantMap", result="uint")
    def Inhibit(self, application: str, reason: str, hints: dict) -> int:  # noqa: N802
        self.inhibited.append((application, reason))
        return 3


def test_notifications_are_held_back_during_a_session(
    bus, address, make_study, sit, wait_for, monkeypatch
):
    desktop = FakeNotifications()
    everything = QDBusConnection.RegisterOption.ExportAllSlots
    path = f"/{NOTIFICATIONS.replace('.', '/')}"
    assert bus.registerObject(path, desktop, everything)
    assert bus.registerService(NOTIFICATIONS)
    monkeypatch.setattr(
        "app.participant.application.IdleInhibitor",
        lambda services: IdleInhibitor(address, services),
    )
    session = sit(make_study())
    wait_for(lambda: bool(desktop.inhibited))
    assert desktop.inhibited == [("hapticplayer", "an experiment is running")]
    services = {service.name for service in EVERYTHING}
    assert services > {NOTIFICATIONS, "org.freedesktop.ScreenSaver"}
    session.close()
    others = bus.interface().registeredServiceNames
    mine = bus.baseService()
    wait_for(lambda: {n for n in others().value() if n[0] == ":"} == {mine})


def test_media_keys_find_no_player_while_a_session_runs(
    window, bus, address, tmp_path, monkeypatch, wait_for, make_study
):
    window.desktop.mpris = Mpris(window.player, window.raise_, window.close, address)
    window.desktop.begin()
    is_there = bus.interface().isServiceRegistered
    assert is_there(NAME).value()
    gate, study = tmp_path / "gate", make_study()
    os.mkfifo(gate)
    program = tmp_path / "session"
    program.write_text(f"#!/bin/sh\ncat {gate} >&2\nexit 1\n")
    program.chmod(0o700)
    monkeypatch.setattr("app.experimenter.study_menu.sys.executable", str(program))
    texts = []
    monkeypatch.setattr(
        window.study_menu, "report", lambda one, _over: texts.append(one)
    )
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.study_menu.run()
    assert window.study_menu.process.is_running
    assert not is_there(NAME).value()
    window.study_menu.run()  # one at a time
    gate.write_text("starting\nhapticplayer: the Falcon is not plugged in\n")
    wait_for(lambda: not window.study_menu.process.is_running)
    assert is_there(NAME).value()
    assert [str(problem) for problem in texts] == ["the Falcon is not plugged in"]


def test_the_window_says_that_a_session_opens_until_it_has(
    window, make_study, tmp_path, monkeypatch, wait_for
):
    gate, end, study = tmp_path / "gate", tmp_path / "end", make_study()
    os.mkfifo(gate)
    os.mkfifo(end)
    program = tmp_path / "session"
    program.write_text(f"#!/bin/sh\ncat {gate}\ncat {end}\n")
    program.chmod(0o700)
    monkeypatch.setattr("app.experimenter.study_menu.sys.executable", str(program))
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.study_menu.run()
    (waiting,) = window.findChildren(QProgressDialog)
    assert waiting.isVisible()
    assert "Opening" in waiting.labelText()
    gate.write_text(f"{OPENED}\n")
    wait_for(lambda: not window.findChildren(QProgressDialog))
    assert window.study_menu.process.is_running
    end.write_text("")
    wait_for(lambda: not window.study_menu.process.is_running)


def test_a_session_borrows_the_outputs_of_the_window(
    window, make_study, tmp_path, monkeypatch, wait_for
):
    window.session.choose_leading("simulated")
    study, seen = make_study(), tmp_path / "arguments"
    program = tmp_path / "session"
    program.write_text(f'#!/bin/sh\necho "$@" >> {seen}\n')
    program.chmod(0o700)
    monkeypatch.setattr("app.experimenter.study_menu.sys.executable", str(program))
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.study_menu.run()
    lent = window.player.snapshot().leading
    assert (lent.name, lent.note) == ("simulated", LENT)
    wait_for(lambda: not window.study_menu.process.is_running)
    # not ready: every process of the program is the script meanwhile
    assert window.player.snapshot().leading.health is not Health.NONE
    assert window.player.snapshot().leading.note == ""
    assert window.player.output_names == ["simulated"]
    said = seen.read_text().splitlines()[0].split()
    assert said[:4] == ["-m", "app", "study", "run"]
    assert said[4:] == [str(study.folder), "--device", "simulated"]


def test_the_real_program_is_started_and_its_complaint_is_heard(
    application, qtbot, tmp_path
):
    process = StudyProcess(application)
    for arguments, texts in (
        (["study", "run", str(tmp_path / "gone")], "gone/study.json"),
        (["--version"], ""),
    ):
        with qtbot.waitSignal(process.ended, timeout=60_000) as ended:
            process.start(arguments)
        assert texts in ended.args[0]
        assert bool(texts) == bool(ended.args[0])
        assert not process.is_running


def test_a_study_without_clips_is_refused_before_any_change(
    window, tmp_path, monkeypatch
):
    study, texts = create_study(tmp_path / "empty"), []
    monkeypatch.setattr(
        window.study_menu, "report", lambda one, _over: texts.append(one)
    )
    monkeypatch.setattr(window.study_menu, "ask_folder", lambda: study.folder)
    window.session.choose_leading("simulated")
    window.study_menu.run()
    assert "'bike' has no folder with a sequence" in str(texts[0])
    assert window.player.snapshot().leading.name == "simulated"
    assert not window.study_menu.process.is_running


def test_a_media_key_changes_nothing_on_the_participants_screen(
    make_study, sit, wait_for
):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.begin_trial()
    window, page = session.participant, session.runner.page.number
    for key in MEDIA_KEYS:
        QTest.keyClick(window.windowHandle(), key)
        assert session.player.snapshot().is_playing
        assert session.runner.page.number == page


def test_another_program_in_front_takes_the_force_away(
    make_study, sit, wait_for, application
):
    session = sit(make_study())
    person = Person(session, wait_for)
    person.begin_trial()
    application.applicationStateChanged.emit(Qt.ApplicationState.ApplicationInactive)
    person.wait_page(PageKind.PAUSED)
    assert not session.player.snapshot().is_playing
    assert session.runner.last_trial.reasons[0] == "focus_lost"
    application.applicationStateChanged.emit(Qt.ApplicationState.ApplicationActive)


def every_text(window: QWidget) -> list[str]:
    """Return each text that a widget of a window could show or speak."""
    texts = [window.windowTitle(), window.windowFilePath(), window.windowIconText()]
    for widget in [window, *window.findChildren(QWidget)]:
        texts += [widget.toolTip(), widget.statusTip(), widget.whatsThis()]
        texts += [widget.accessibleName(), widget.accessibleDescription()]
        for name in ("text", "toPlainText", "placeholderText", "title", "prefix"):
            found = getattr(widget, name, "")
            texts.append(str(found() if isinstance(found, BuiltinMethodType) else ""))
    return texts


class Onlooker(Person):
    """Takes part, and writes down whatever could be read or heard on the way."""

    def __init__(self, session, wait_for):
        super().__init__(session, wait_for)
        self.seen: dict[tuple[PageKind, str], list[str]] = {}

    def wait_page(self, kind, step=None):
        super().wait_page(kind, step)
        page, texts = self.runner.page, every_text(self.session.participant)
        self.seen.setdefault((page.kind, page.step), []).extend(texts)


@pytest.mark.parametrize("language", ["en", "fr", "de"])
def test_no_page_of_a_session_tells_a_condition_or_a_file(
    make_study, sit, wait_for, language
):
    study = make_study()
    content = json.loads(study.content)
    content["sequences"] = content["sequences"][:1]
    session = sit(change_definition(study, content), language=language)
    person = Onlooker(session, wait_for)
    person.wait_page(PageKind.CONSENT)
    person.begin_trial()
    session.control.buttons["pause"].click()
    person.wait_page(PageKind.PAUSED)
    session.control.buttons["pause"].click()
    for _ in range(3):
        person.trial()
    person.wait_page(PageKind.QUESTIONS, "post-test")
    wait_for(lambda: not session.participant.guard.isActive())
    person.page.next.click()
    person.wait_page(PageKind.THANKS)
    unseen = {PageKind.PROBLEM, PageKind.STOPPED, PageKind.INTERVAL}
    assert {kind for kind, _ in person.seen} == set(PageKind) - unseen
    question = session.runner.definition.pages[1].questions[0].text[language]
    assert question in person.seen[PageKind.QUESTIONS, "trial-01"]
    code = session.runner.plan.code
    assert any(code in text for text in person.seen.pop((PageKind.THANKS, "end")))
    secrets = (*SECRETS, str(study.folder), code)
    for where, texts in person.seen.items():
        for secret in secrets:
            assert not [t for t in texts if secret.lower() in t.lower()], (
                where,
                secret,
            )


class ClosedRecorder:
    """A stream of another program, which has ended."""

    def begin(self, session):
        self.code = session.code

    def marker(self, text, monotonic_s):
        pass

    def force(self, monotonic_s, force_n):
        pass

    def check(self):
        raise StudyError("LabRecorder was closed")


def test_an_operator_is_told_why_a_trial_does_not_begin(make_study, sit, wait_for):
    recorder = ClosedRecorder()
    session = sit(make_study(), observer=recorder)
    person = Person(session, wait_for)
    person.to_trials()
    person.wait_page(PageKind.READY, "trial-01")
    person.key(Qt.Key.Key_Enter)
    wait_for(lambda: "LabRecorder was closed" in session.control.messages.text())
    assert recorder.code == session.runner.plan.code
    assert session.runner.page.kind is PageKind.READY
    assert "please wait" in person.page.problem.text().lower()
