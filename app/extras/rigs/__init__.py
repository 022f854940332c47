"""The window of the motion rigs."""
