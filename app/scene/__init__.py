"""What should be on the screen, as plain data: pure functions, no Qt and no VTK."""
