"""Psychometric curves of the answers "consistent" to forces that were changed."""
