"""The scores of a page of questions: what is shown of them, and their fields."""

from typing import Any

from PySide6.QtCore import QCoreApplication

from app.experimenter.study.document import Place
from app.experimenter.study.fields import Fields
from hapticplayer.study.definition import ScoreRule
from hapticplayer.study.questions import ANSWER_KINDS

translate = QCoreApplication.translate


def new_score(key: str, page: dict[str, Any]) -> dict[str, Any]:
    """The mean of the questions of a page that are answered by a number."""
    asked = page["questions"]
    of = [one["key"] for one in asked if "least" in ANSWER_KINDS[one["kind"]].uses]
    return {"key": key, "text": key, "of": of, "by": str(ScoreRule.MEAN)}


def fill_score(fields: Fields, place: Place) -> None:
    """Make the fields of a score."""
    meaning = translate("ScoreFields", "Meaning (English)")
    fields.line(meaning, (*place, "text"))
    fields.listed(
        translate("ScoreFields", "Made of"),
        (*place, "of"),
        tip=translate(
            "ScoreFields", "Names of questions of the page, or of scores before it"
        ),
    )
    rules = {
        ScoreRule.SUM: translate("ScoreFields", "Sum"),
        ScoreRule.MEAN: translate("ScoreFields", "Mean"),
    }
    choices = [(name, str(rule)) for rule, name in rules.items()]
    fields.choice(translate("ScoreFields", "Computed as"), (*place, "by"), choices)
    fields.listed(
        translate("ScoreFields", "Reversed"),
        (*place, "reversed"),
        tip=translate(
            "ScoreFields", "Those that count from the other end of their range"
        ),
        is_optional=True,
    )
    fields.listed(
        translate("ScoreFields", "Factors of 1, x, x\u00b2 \u2026"),
        (*place, "polynomial"),
        tip=translate("ScoreFields", "0, 2.5 multiplies the sum or mean by 2.5"),
        is_optional=True,
    )
    fields.listed(
        translate("ScoreFields", "Least answers to a mean"),
        (*place, "least_answered"),
        tip=translate("ScoreFields", "All are needed where this is empty"),
        is_optional=True,
        is_one=True,
    )
    fields.line(translate("ScoreFields", "Name in the data"), (*place, "key"))
