"""What the window shows and how it came about, as frozen data."""
