"""The core at work beside the window."""
