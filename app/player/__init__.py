"""The player's window: picture, plots, controls, health."""
