"""What the simulator's rider sees and hears; nothing here knows of the truth."""
