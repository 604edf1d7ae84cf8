"""The command line."""

NAMES = ("compare", "batch", "info", "thin")
"""The commands; a first argument that is none of them is a file."""
