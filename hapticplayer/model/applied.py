"""Answers of a person, each of which is applied or refused.

Whoever applies an answer takes it; what nobody has taken in the end had no effect.
"""

import dataclasses
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, slots=True)
class AppliedAnswers:
    """Base of choices about one file.

    Attributes:
        taken: names of the answers that were applied; a copy begins with none.
    """

    taken: set[str] = field(default_factory=set, init=False, repr=False, compare=False)

    def take(self, name: str) -> Any:
        """The answer of that name, which is applied now."""
        self.taken.add(name)
        return getattr(self, name)

    def untaken(self) -> tuple[str, ...]:
        """The names of answers other than the defaults that nobody has taken."""
        return tuple(
            one.name
            for one in dataclasses.fields(self)
            if one.init
            and one.name not in self.taken
            and getattr(self, one.name) != one.default
        )
