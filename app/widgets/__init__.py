"""Small widgets that the pages share, and how everything looks."""
