"""Texts that several pages show."""

from app.bridge.jobs import JobState
from app.widgets.texts import breakable, job_text
from hapticplayer.errors import Message


def test_french_has_a_space_before_its_colon_that_does_not_break(spoken):
    spoken("fr")
    state = JobState("Importation", 0.4, Message("synchronising"))
    assert job_text(state) == "Importation\u00a0: synchronisation"


def test_long_names_can_be_broken_between_lines():
    assert breakable("all of these are short") == "all of these are short"
    name = 60 * "x"
    assert max(map(len, breakable(f"the {name}!").split("\u200b"))) <= 28
    assert breakable(name).replace("\u200b", "") == name
