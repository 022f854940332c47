"""Psychometric curves, staircases and power laws of what is felt of a force."""
