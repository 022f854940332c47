"""What a participant sees: calm, large, and nothing that tells the condition."""
