"""What an experimenter works with: bringing recordings in."""
