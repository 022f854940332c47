"""A felt video over HTTP: what `serve` offers, and what `play --allow-network` takes."""
