"""Motion rigs: software that moves a seat, and takes the packets that games send by UDP."""
