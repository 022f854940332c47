"""Toys that vibrate, with the strength of the force."""
