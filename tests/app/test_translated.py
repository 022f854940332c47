"""What the engine says is shown in the language of the window."""

import errno
import os
import re
import xml.etree.ElementTree as ET

import pytest

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


def test_values_that_are_messages_are_translated_too(spoken):
    place = Message("{file}, line {line}", file="/you and me: or not/log.csv", line=3)
    problem = InputError(
        "{text!r} is not a {kind}",
        where=Message("{line}, column {column}", line=place, column="ax"),
        remedy="remove the line or correct the number",
        text="{x}",
        kind=Message("finite number"),
    )
    assert translated(message_of(problem)) == str(problem)
    spoken("de")
    assert translated(message_of(problem)) == (
        "/you and me: or not/log.csv, Zeile 3, Spalte ax: '{x}' ist nicht wie verlangt: "
        "endliche Zahl; entfernen Sie die Zeile, oder berichtigen Sie die Zahl"
    )
    spoken("fr")
    missing = InputError("is missing", where="a or b.csv", remedy="copy it again")
    assert translated(message_of(missing)) == (
        "a or b.csv\u00a0: manque\u00a0; copiez-le encore une fois"
    )


def test_what_the_system_says_is_translated_within(spoken):
    spoken("de")
    problem = InputError(
        "cannot be read ({reason})",
        reason=FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)),
    )
    assert translated(message_of(problem)) == (
        "kann nicht gelesen werden (Datei oder Ordner gibt es nicht)"
    )


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
