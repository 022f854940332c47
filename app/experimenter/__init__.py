"""What an experimenter sees: where the participant is, and whether all is well."""
