"""A packed file for others on this machine or a local network."""
