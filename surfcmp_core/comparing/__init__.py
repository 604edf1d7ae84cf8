"""The comparison itself, from two surfaces to its measures."""
