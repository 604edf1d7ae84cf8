"""The panels around the views."""
