"""What a participant sees: calm, large, and nothing that reveals the condition."""
