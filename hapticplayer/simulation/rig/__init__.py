"""A motion rig that is only simulated: it listens to all formats and reports."""
