"""A Falcon that is not there, for everyone who has none."""
