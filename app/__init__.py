"""The Qt front end of hapticplayer."""
