"""The sequence on disk: a clip with its motion and its force tracks."""

from hapticplayer.sequence.store import Sequence, open_sequence, verify_sequence

__all__ = ["Sequence", "open_sequence", "verify_sequence"]
