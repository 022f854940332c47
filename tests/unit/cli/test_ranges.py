"""Numeric options out of their range: one sentence that names it, and status 2."""

import pytest

from tests.e2e.command import hapticplayer, refused

COMMANDS = {
    ("process", "none.csv"): [
        ("--lowpass", "1e-9", "0.01 and 10000 Hz"),
        ("--time-constant", "1e300", "0.1 and 1000 s"),
        ("--average", "nan", "0.1 and 10000 Hz"),
    ],
    ("import", "none.mp4", "-o", "none"): [
        ("--offset", "1e300", "-10000000000 and 10000000000 s"),
        ("--skew", "-3", "-2 and 2 s"),
        ("--gain", "0", "0.0001 and 100 N per m/s^2"),
        ("--seed", "-1", "0 and 9007199254740992"),
        ("--seed", "1.5", "a whole number"),
        ("--seed", "9" * 5000, "0 and 9007"),
    ],
    ("render", "none", "--in-place"): [
        ("--gain", "nan", "0.0001 and 100 N per m/s^2"),
    ],
    ("play", "none.mp4", "--headless"): [
        ("--start", "-1", "0 and 10000000 s"),
        ("--duration", "1e400", "0 and 10000000 s"),
        ("--speed", "9", "0.5 and 4"),
    ],
    ("device", "home"): [("--timeout", "soon", "0.1 and 3600 s")],
    ("study", "power"): [("--seed", "-1", "0 and 9007199254740992")],
}


@pytest.mark.parametrize(
    ("words", "option", "text", "allowed"),
    [(words, *case) for words, cases in COMMANDS.items() for case in cases],
)
def test_a_number_out_of_range_names_the_range(words, option, text, allowed):
    sentence = refused(hapticplayer(*words, f"{option}={text}"), status=2)
    assert f"{option} must be " in sentence
    assert allowed in sentence
    assert f"not {text[:40]}" in sentence
