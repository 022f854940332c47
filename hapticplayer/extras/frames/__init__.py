"""What frames tell of the camera's motion; the only place for OpenCV."""
