"""Synchronises a log with a clip: by pats, or otherwise."""
