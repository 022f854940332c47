"""What the core does not need: each folder is one whole thing, and may be deleted."""
