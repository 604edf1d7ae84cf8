"""The window: two surfaces, both triangulations, the united one and the difference."""
