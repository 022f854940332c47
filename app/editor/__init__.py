"""The editor of the effects of a sequence: one timeline with clip, force and sound."""
