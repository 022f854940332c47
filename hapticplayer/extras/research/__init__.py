"""Data of a study for other programs: BIDS, XDF, LSL."""
