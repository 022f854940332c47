"""What happens in a recording, such as impacts: detectors and the command `events`."""
