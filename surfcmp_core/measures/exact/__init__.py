"""The exact reading: over the overlay of T1, T2 and T."""
