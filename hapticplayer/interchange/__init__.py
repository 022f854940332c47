"""Other people's formats: what a study or a record is for other programs."""
