"""A simulated Haply Inverse3: its service in a process, on the Falcon's physics."""
