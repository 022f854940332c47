"""The analysis of consistency trials."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.study.analysis.parts import AnalysisKind


def study_analyses() -> "tuple[AnalysisKind, ...]":
    """Shares by level, and psychometric curves."""
    from hapticplayer.study.analysis.parts import AnalysisKind
    from hapticplayer.study.definition import TrialKind

    home = "hapticplayer.extras.consistency.report:analysed"
    return (AnalysisKind(TrialKind.CONSISTENCY, home),)
