"""What the engine says is shown in the language of the window."""

import os
import re
import xml.etree.ElementTree as ET
from typing import ClassVar

import pytest
from PySide6.QtCore import QTranslator

from app.bridge import languages
from app.bridge.languages import translated
from app.player.remake import dress
from hapticplayer.errors import DeviceError, InputError, Message, message_of

FOREIGN = [code for code in languages.NAMES if code != languages.ENGLISH]


@pytest.fixture
def spoken(application):
    yield lambda code: languages.install(application, code)
    languages.install(application, languages.ENGLISH)


@pytest.fixture
def german(make_window, settings, application):
    """A window that speaks German."""
    settings.keep("language", "de")
    dress(application, settings)
    yield make_window()
    settings.keep("language", languages.ENGLISH)
    dress(application, settings)


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
        return self.KNOWN.get(text, "") if context == languages.ENGINE else ""


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
def test_what_has_no_translation_stays_english(spoken, code, text):
    spoken(code)
    assert translated(text) == text
    assert translated(message_of(DeviceError(text))) == text
    assert translated(Message("not yet, {name}", name=text)) == f"not yet, {text}"


# --- in the window -------------------------------------------------------------
