"""Makes pages in the participant's language."""

from hapticplayer.study.definition import Definition, Question, Text
from hapticplayer.study.pages import Page, PageKind, ask, feedback_name
from hapticplayer.study.plan import Plan
from hapticplayer.study.steps import POST_TEST, SHEET, position_of

Replays = tuple[tuple[str, tuple[tuple[str, str], ...]], ...]


class PageMaker:
    """Makes the pages of one session.

    Args:
        definition: of the study as it was when the session began.
        plan: of the session.
    """

    def __init__(self, definition: Definition, plan: Plan) -> None:
        self._definition, self._plan = definition, plan

    def page(self, kind: PageKind, step: str, number: int) -> Page:
        """Return the page of a kind at a step."""
        is_asking = kind is PageKind.QUESTIONS
        return Page(
            kind=kind,
            step=step,
            text=self._text_of(kind, step),
            questions=ask(
                self._definition,
                self._questions(step),
                self._plan.language,
                self._plan.labels,
            )
            if is_asking
            else (),
            replays=self._replays() if is_asking and step == POST_TEST else (),
            position=position_of(step) or 0,
            count=len(self._plan.order),
            number=number,
        )

    def text(self, name: str) -> str:
        """Return a text in the participant's language."""
        text: Text = getattr(self._definition.texts, name)
        return text[self._plan.language]

    def word(self, name: str) -> str:
        """Return a word of a button in the participant's language."""
        word: Text = getattr(self._definition.words, name)
        return word[self._plan.language]

    def scale(self) -> tuple[str, str]:
        """Return what the ends of the five-point scale say."""
        scale, language = self._definition.scale, self._plan.language
        return scale.lowest[language], scale.highest[language]

    def _text_of(self, kind: PageKind, step: str) -> str:
        if kind is PageKind.QUESTIONS:
            if step == SHEET:
                return ""
            return self.text("post_test" if step == POST_TEST else "questions")
        if kind in (PageKind.PAUSED, PageKind.PROBLEM, PageKind.STOPPED):
            return self.word(kind.value)
        return "" if kind is PageKind.PLAYING else self.text(kind.value)

    def _questions(self, step: str) -> tuple[Question, ...]:
        if step == SHEET:
            return self._definition.sheet
        if step == POST_TEST:
            return self._definition.post_test
        return self._definition.trial_questions

    def _replays(self) -> Replays:
        word, language = self.word("clip"), self._plan.language
        clips = range(1, 1 + len(self._definition.sequences))
        return tuple(
            (
                feedback_name(self._definition, language, number),
                tuple((f"{word} {clip}", f"{number}.{clip}") for clip in clips),
            )
            for number in range(1, 1 + len(self._plan.labels))
        )
