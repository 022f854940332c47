"""Figures of a Falcon that nobody has published, measured by its owner."""
