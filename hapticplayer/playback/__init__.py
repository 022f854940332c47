"""Frames, sound and force of one clip on one clock."""
