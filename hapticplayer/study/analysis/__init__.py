"""Statistics, figures and reports of studies; power analysis."""

from hapticplayer.study.analysis.analysis import Analysis, AnalysisOptions, analyse
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.scores import MissingPolicy

__all__ = ["Analysis", "AnalysisOptions", "MissingPolicy", "Resampling", "analyse"]
