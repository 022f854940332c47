"""Plays a packed file from a web server, and is a small one for others."""
