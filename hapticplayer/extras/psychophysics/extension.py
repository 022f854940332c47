"""The analysis of yes-no, two-interval and magnitude trials."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.study.analysis.parts import AnalysisKind


def study_analyses() -> "tuple[AnalysisKind, ...]":
    """Shares by level, psychometric curves, staircases, exponents."""
    from hapticplayer.study.analysis.parts import AnalysisKind
    from hapticplayer.study.definition import TrialKind

    levels = "hapticplayer.extras.psychophysics.level_report:analysed"
    magnitudes = "hapticplayer.extras.psychophysics.magnitude_report:analysed"
    return (
        AnalysisKind(TrialKind.YES_NO, levels),
        AnalysisKind(TrialKind.TWO_INTERVAL, levels),
        AnalysisKind(TrialKind.MAGNITUDE, magnitudes),
    )
