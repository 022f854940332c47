"""The editor of the effects of a sequence: one time line with clip, force and sound."""
