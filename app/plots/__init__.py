"""Live plots around the playhead."""
