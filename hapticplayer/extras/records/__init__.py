"""Records of the haptic loop (`play --record`) for other programs."""
