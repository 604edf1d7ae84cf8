"""Which colour a difference has, in the window and in every report."""
