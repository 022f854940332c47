"""What developers try the Falcon's driver with."""
