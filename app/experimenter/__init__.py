"""What an experimenter works with: recordings coming in, studies, their sessions."""
