"""What the engine says is shown in the language of the window."""

import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from typing import ClassVar

import pytest
from PySide6.QtCore import QTranslator
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMenu

from app.bridge import languages
from app.bridge.languages import translated
from app.experimenter.import_wizard import ImportWizard
from app.player.remake import apply_appearance
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.errors import DeviceError, InputError, Message, message_of

FOREIGN = [code for code in languages.NAMES if code != languages.ENGLISH]


@pytest.fixture
def german(make_window, settings, application):
    """A window that speaks German."""
    settings.keep("language", "de")
    apply_appearance(application, settings)
    yield make_window()
    settings.keep("language", languages.ENGLISH)
    apply_appearance(application, settings)


def messages(code: str) -> list[tuple[str, str]]:
    """Return all texts that have a translation, and the translations."""
    tree = ET.parse(languages.FOLDER / f"{code}.ts")
    pairs = [
        (m.findtext("source"), m.findtext("translation")) for m in tree.iter("message")
    ]
    assert len(pairs) > 1000
    return [(text, said) for text, said in pairs if said]


@pytest.mark.parametrize("code", FOREIGN)
def test_translations_keep_places_for_values_and_mnemonics(code):
    field, mnemonic = re.compile(r"\{[^{}]*\}"), re.compile(r"&\w")
    for text, said in messages(code):
        assert set(field.findall(said)) == set(field.findall(text)), text
        assert bool(mnemonic.search(said)) == bool(mnemonic.search(text)), text


def test_french_signs_stay_with_their_word():
    texts = [said for _, said in messages("fr")]
    assert [text for text in texts if re.search(r" [;:!?\u00bb]|\u00ab ", text)] == []


class Backwards(QTranslator):
    """Knows some texts, in a language of its own."""

    KNOWN: ClassVar = {
        "{text!r} is odd": "odd is {text!r}",
        "{file}, line {line}": "line {line} of {file}",
        "{where}: {what}": "{what}; {where}",
        "{what}; {remedy}": "{remedy}: {what}",
        "mend it": "it mend",
        "No such file or directory": "no file",
    }

    def translate(self, context, text, *_more):
        return self.KNOWN.get(text) if context == languages.ENGINE else None


def test_values_that_are_messages_are_translated_too(application):
    problem = InputError(
        "{text!r} is odd",
        where=Message("{file}, line {line}", file="/you: {0}", line=3),
        remedy="mend it",
        text="{x}",
    )
    missing = InputError("new: {reason}", reason=FileNotFoundError(2, os.strerror(2)))
    assert translated(message_of(problem)) == str(problem)
    translator = Backwards()
    application.installTranslator(translator)
    try:
        said = translated(message_of(problem))
        assert said == "it mend: odd is '{x}'; line 3 of /you: {0}"
        assert translated(message_of(missing)) == "new: no file"
    finally:
        application.removeTranslator(translator)


@pytest.mark.parametrize("code", FOREIGN)
@pytest.mark.parametrize(
    "text", ["", "{0} {{", "not translated: yet {", "is really odd"]
)
def test_a_text_without_translation_stays_english(spoken, code, text):
    spoken(code)
    assert translated(text) == text
    assert translated(message_of(DeviceError(text))) == text
    assert translated(Message("not yet, {name}", name=text)) == f"not yet, {text}"


# --- in the window -------------------------------------------------------------


@pytest.mark.parametrize("code", languages.NAMES)
def test_no_letter_chooses_two_entries_of_a_menu(make_window, spoken, code):
    spoken(code)
    bar = make_window().menuBar()
    menus = {*bar.findChildren(QMenu), *(one.menu() for one in bar.actions())}
    assert len(menus) > 5
    for actions in (bar.actions(), *(menu.actions() for menu in menus)):
        texts = [one.text().replace("&&", "") for one in actions if one.isVisible()]
        letters = [text[text.index("&") + 1].lower() for text in texts if "&" in text]
        twice = {one for one in letters if letters.count(one) > 1}
        assert not twice, texts


def test_a_missing_file_is_shown_in_german_and_copied_in_both(
    german, wait_for, tmp_path
):
    path = tmp_path / "missing.mp4"
    german.session.open_path(path)
    wait_for(lambda: "missing.mp4" in german.messages.text())
    said = german.messages.text()
    assert (
        said == f"{path}: diese Datei gibt es nicht; pr\u00fcfen Sie Namen und Ordner"
    )
    german.messages.copy.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    english = f"{path}: there is no such file; check the name and the folder"
    assert lines == [said, english]


def test_bytes_in_a_name_that_are_no_text_are_replaced(spoken):
    spoken("de")
    assert translated("ride \udcff.mp4") == "ride ?.mp4"
    assert translated(Message("ride \udcff.mp4")) == "ride ?.mp4"


def test_a_damaged_sequence_is_told_in_german(german, sequence, wait_for, tmp_path):
    broken = tmp_path / "broken"
    shutil.copytree(sequence, broken)
    (broken / "sequence.json").write_text("[]")
    german.session.open_path(broken)
    wait_for(german.messages.isVisible)
    assert german.messages.text() == (
        f"{broken / 'sequence.json'}: muss ein Objekt sein, nicht eine Liste; "
        "importieren Sie es noch einmal"
    )


def test_a_log_that_cannot_be_read_is_told_in_german(
    german, clip, wait_for, qtbot, tmp_path
):
    log = tmp_path / "log.csv"
    rows = "".join(f"{k / 100},0,0,9.8,0,0,zero\n" for k in range(300))
    log.write_text("time_s,ax,ay,az,gx,gy,gz\n" + rows)
    wizard = ImportWizard("", tmp_path, german)
    qtbot.addWidget(wizard)
    wizard.take([clip, log])
    wait_for(lambda: bool(wizard.files.problem.text()))
    said = wizard.files.problem.text()
    wizard.close_jobs()
    assert said == (
        f"{log}, Zeile 2, Spalte gz: 'zero' ist keine Zahl; entfernen Sie die Zeile, "
        "oder berichtigen Sie die Zahl"
    )


def test_a_question_about_a_log_is_asked_in_german(german, qtbot, tmp_path):
    wizard = ImportWizard("", tmp_path, german)
    qtbot.addWidget(wizard)
    question = LogQuestion(
        Message("its units are not known"),
        (Message("accel-unit={fitting:.6g} to scale it to gravity", fitting=9.5),),
        "/x/log.csv",
    )
    wizard.files.show_problem(question)
    asked = wizard.files.question
    assert asked.text.text() == "log.csv: die Einheiten sind nicht bekannt"
    (answer,) = asked.answers.buttons()
    assert answer.text() == (
        "Einheit der Beschleunigung: 9.5, um auf die Schwerkraft zu skalieren"
    )
    answer.click()
    with qtbot.waitSignal(asked.answered) as answered:
        asked.take.click()
    assert answered.args == [["accel-unit=9.5"]]
    wizard.close_jobs()


def test_a_device_that_is_not_there_is_told_in_german(german, wait_for):
    german.session.choose_leading("falcon:NONE")
    wait_for(german.messages.isVisible)
    said = german.messages.text()
    assert re.match(
        r"kein Falcon |libusb fehlt; |der Falcon |Sie d\u00fcrfen ", said
    ), said


SPEAK = """
import json, os, sys
from app.bridge import languages
from app.player.application import make_application
for environment in json.loads(sys.argv[1]):
    if not os.fork():
        os.environ.update(environment)
        make_application()
        print(languages.spoken(), flush=True)
        os._exit(0)
    os.wait()
"""
OF_SYSTEMS = [
    ({"LANG": "de_AT.UTF-8"}, "de"),
    ({"LANG": "fr_FR.UTF-8"}, "fr"),
    ({"LANG": "it_IT.UTF-8"}, "en"),
    ({"LANG": "C.UTF-8"}, "en"),
    ({"LANG": "en_GB.UTF-8", "LC_ALL": "de_DE.UTF-8"}, "de"),
]


def test_without_a_choice_the_window_follows_lang():
    environments, codes = zip(*OF_SYSTEMS, strict=True)
    spoken = ("LANG", "LANGUAGE", "LC_ALL", "LC_MESSAGES")
    kept = {k: value for k, value in os.environ.items() if k not in spoken}
    kept |= {"PYTHONPATH": os.pathsep.join(sys.path), "QT_QPA_PLATFORM": "offscreen"}
    said = subprocess.run(
        [sys.executable, "-c", SPEAK, json.dumps(environments)],
        env=kept,
        capture_output=True,
        text=True,
        check=True,
    )
    assert said.stdout.split() == [*codes]


def test_a_choice_is_stronger_than_lang(application):
    assert [languages.wanted(code) for code in languages.NAMES] == [*languages.NAMES]
