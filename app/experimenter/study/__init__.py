"""A study in the window: made, edited, and what came of it."""
