"""The sequence on disk: a clip with its motion and its force tracks."""

from hapticplayer.sequence.build import build_sequence
from hapticplayer.sequence.store import Sequence, open_sequence, verify_sequence

__all__ = ["Sequence", "build_sequence", "open_sequence", "verify_sequence"]
