"""The engine's sentences in the language of the window.

The engine speaks English everywhere, and its sentences cross processes and files as text.
Here a sentence is found again among the templates that `packaging/engine_sentences.py`
has collected, and its values are put into the translation. What is not found stays as it
is. A sentence may quote anything that somebody has written into a file: the search has
limits, and each step of it takes time in proportion to the text.
"""

import functools
import json
import re
from collections.abc import Iterator
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.bridge import languages
from hapticplayer.errors import InputError

CONTEXT = "engine"
FILE = languages.FOLDER / "engine.json"
LONGEST = 4000
"""Characters of a sentence that is looked for; a longer one is shown as it is."""
MOST_PARTS = 150
"""Parts of one sentence that are looked for."""

_DEEPEST = 6  # values within values
_MOST_PLACES = 8  # where a sentence may be parted at one kind of mark
_SHORT = 4  # letters: too few to know a sentence by, whatever follows
_PLACEHOLDER = re.compile(r"\{(\d+)\}")
_AFTER, _THEN = "{0}: {1}", "{0}; {1}"
_PLACES = ("{0}, column {1}", "{0}, line {1}")
_LINKS = ("{0} or {1}", "{0} and {1}", "{0} and no {1}", "{0}, or {1}")
_MOST_KEPT = 256
_originals: dict[str, str] = {}
_NOT_LOOKED_FOR = {_AFTER, _THEN, *_PLACES, "{0}, line 1"}


class _Phrase(NamedTuple):
    """A template taken apart.

    Attributes:
        text: the template.
        literals: what stands before, between and after the values.
        numbers: of the values, in their order.
        weight: letters that are the template's own.
    """

    text: str
    literals: tuple[str, ...]
    numbers: tuple[int, ...]
    weight: int

    def values(self, sentence: str) -> list[str] | None:
        """Return what stands in the places of the values; None where it is another."""
        first, *between, last = self.literals
        at, end = len(first), len(sentence) - len(last)
        if at > end or not (sentence.startswith(first) and sentence.endswith(last)):
            return None
        found = []
        for literal in between:
            place = sentence.find(literal, at, end)
            if place < 0:
                return None
            found.append(sentence[at:place])
            at = place + len(literal)
        return [*found, sentence[at:end]]

    def fits(self, values: list[str]) -> bool:
        """Whether few words of its own are enough to know it by."""
        if self.text in _LINKS:
            return True
        if self.weight < _SHORT:
            return all(value[:1] in "'\"0123456789" for value in values)
        is_word = not self.literals[0] and len(" ".join(self.literals).split()) < 2
        return not is_word or all(_is_number(value) for value in values)


class _Found(NamedTuple):
    """A translation, and how many letters of it were found in the templates."""

    text: str
    letters: int = 0


def told(problem: BaseException) -> str:
    """Return what an exception says in the window's language."""
    if not isinstance(problem, InputError) or _is_english():
        return translated(str(problem))
    text = translated(problem.what)
    if problem.where:
        text = _put(_AFTER, [_place(problem.where), text])
    if problem.remedy:
        text = _put(_THEN, [text, translated(problem.remedy)])
    _remember(text, str(problem))
    return text


def translated(sentence: str) -> str:
    """Return a sentence of the engine in the window's language, as far as it is known."""
    if _is_english() or len(sentence) > LONGEST:
        return sentence
    text = _kept(sentence, languages.spoken())
    _remember(text, sentence)
    return text


def _is_english() -> bool:
    return languages.spoken() == languages.ENGLISH


@functools.lru_cache(maxsize=_MOST_KEPT)
def _kept(sentence: str, _language: str) -> str:
    return Search().found(sentence).text


def in_english(text: str) -> str:
    """Return what the engine said, for a text that was shown lately."""
    return _originals.get(text, text)


def _remember(text: str, sentence: str) -> None:
    _originals.pop(text, None)
    _originals[text] = sentence
    while len(_originals) > _MOST_KEPT:
        del _originals[next(iter(_originals))]


@functools.cache
def _phrases() -> tuple[frozenset[str], list[_Phrase]]:
    """Return the templates without values, and those with, the most telling first."""
    texts = json.loads(FILE.read_text(encoding="utf-8"))
    phrases = []
    for text in set(texts) - _NOT_LOOKED_FOR:
        parts = _PLACEHOLDER.split(text)
        literals, numbers = tuple(parts[::2]), tuple(map(int, parts[1::2]))
        weight = sum(letter.isalpha() for part in literals for letter in part)
        if numbers:
            phrases.append(_Phrase(text, literals, numbers, weight))
    phrases.sort(key=lambda phrase: (-phrase.weight, phrase.text))
    return frozenset(texts), phrases


class Search:
    """Looks for one sentence and for what it is made of.

    Attributes:
        parts: how many different texts were looked for.
    """

    def __init__(self) -> None:
        self.parts = 0
        self._known: dict[tuple[str, bool], _Found] = {}

    def found(self, sentence: str, depth: int = 0) -> _Found:
        """Return the reading of a sentence that knows most of its letters."""
        key = sentence, depth > 0
        if key not in self._known:
            if depth > _DEEPEST or self.parts >= MOST_PARTS:
                return _Found(sentence)
            self.parts += 1
            self._known[key] = _Found(sentence)  # nothing is made of itself
            self._known[key] = self._best(sentence, depth)
        return self._known[key]

    def _best(self, sentence: str, depth: int) -> _Found:
        whole, phrases = _phrases()
        if sentence in whole:
            return _Found(_say(sentence), len(sentence))
        best = _Found(sentence)
        for one in self._parted(sentence, depth):
            best = max(best, one, key=_letters)
        for phrase in phrases:
            values = phrase.values(sentence)
            if values is not None and phrase.fits(values):
                best = max(best, self._filled(phrase, values, depth), key=_letters)
        return best

    def _filled(self, phrase: _Phrase, values: list[str], depth: int) -> _Found:
        found = [self._value(value, depth + 1) for value in values]
        is_link = phrase.text in _LINKS
        if is_link and not (depth and all(map(_letters, found))):
            return _Found("")  # a name may hold `and`
        texts = [""] * len(values)
        for number, one in zip(phrase.numbers, found, strict=True):
            texts[number] = one.text
        letters = phrase.weight + sum(map(_letters, found))
        return _Found(_put(phrase.text, texts), letters)

    def _value(self, text: str, depth: int) -> _Found:
        """Return a value; quoted, a path or a number it stays as it is."""
        core = text.strip(" ,;.")
        if not core or core[0] in "'\"/\\~" or _is_number(core):
            return _Found(text)
        before, _, after = text.partition(core)
        found = self.found(core, depth)
        inner = _Found(f"{before}{found.text}{after}", found.letters)
        return max(inner, self.found(text, depth), key=_letters) if before else inner

    def _parted(self, sentence: str, depth: int) -> Iterator[_Found]:
        """Yield readings as a place with what is there, or as two sentences."""
        for left, right in _halves(sentence, ": "):
            after = self.found(right, depth)
            if after.letters:
                yield _Found(_put(_AFTER, [_place(left), after.text]), after.letters)
        for left, right in _halves(sentence, "; "):
            yield self._two(left, right, depth, _say(_THEN))
        if depth:
            for left, right in _halves(sentence, ", "):
                yield self._two(left, right, depth, "{0}, {1}")
            left, bracket, right = sentence.partition(" (")
            if bracket and right.endswith(")"):
                yield self._two(left, right[:-1], depth, "{0} ({1})")

    def _two(self, left: str, right: str, depth: int, how: str) -> _Found:
        first, second = (self._value(text, depth + 1) for text in (left, right))
        text = _fill(how, [first.text, second.text])
        return _Found(text, first.letters + second.letters)


def _letters(found: _Found) -> int:
    return found.letters


def _halves(sentence: str, mark: str) -> Iterator[tuple[str, str]]:
    at = sentence.find(mark)
    for _ in range(_MOST_PLACES):
        if at < 0:
            return
        yield sentence[:at], sentence[at + len(mark) :]
        at = sentence.find(mark, at + len(mark))


def _place(where: str) -> str:
    """Return a file with its line or column; the name of the file stays."""
    for template in _PLACES:
        word = _PLACEHOLDER.split(template)[2]
        left, found, right = where.rpartition(word)
        if found and " " not in right:
            return _put(template, [_place(left), right])
    if where.startswith(("participant ", "span ")):
        return Search().found(where).text
    return where


def _is_number(text: str) -> bool:
    return text.replace(".", "", 1).lstrip("+-").rstrip(" %").isdecimal()


def _say(template: str) -> str:
    return QCoreApplication.translate(CONTEXT, template)


def _put(template: str, values: list[str]) -> str:
    return _fill(_say(template), values)


def _fill(text: str, values: list[str]) -> str:
    return _PLACEHOLDER.sub(lambda found: values[int(found[1])], text)
