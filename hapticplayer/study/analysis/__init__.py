"""Statistics, figures and the report of a study; simulated answers and power."""

from hapticplayer.study.analysis.analysis import Analysis, AnalysisOptions, analyse
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.scores import MissingPolicy

__all__ = ["Analysis", "AnalysisOptions", "MissingPolicy", "Resampling", "analyse"]
