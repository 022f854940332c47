"""Codes of participants: made by the program, never a name."""

import secrets
from collections.abc import Collection

from hapticplayer.errors import StudyError

# without vowels (no words) and without what looks alike
LETTERS = "CDFGHJKMNPQRTVWXY34679"
LENGTH = 6


def new_code(taken: Collection[str]) -> str:
    """Return a code that nobody has."""
    while True:
        code = "".join(secrets.choice(LETTERS) for _ in range(LENGTH))
        if code not in taken:
            return code


def is_code(text: str) -> bool:
    """Whether a text could be a code."""
    return len(text) == LENGTH and all(letter in LETTERS for letter in text)


def checked_code(text: str) -> str:
    """Return a code as it is stored, however it was typed.

    Raises:
        StudyError: where it is none.
    """
    code = text.strip().upper()
    if not is_code(code):
        raise StudyError(
            "{text!r} is no participant's code",
            remedy="a code has {length} letters, as `study status` lists them",
            text=text,
            length=LENGTH,
        )
    return code


def number_of(code: str) -> int:
    """Return the code as a number, to seed what is random for this participant."""
    number = 0
    for letter in code:
        number = number * len(LETTERS) + LETTERS.index(letter)
    return number
