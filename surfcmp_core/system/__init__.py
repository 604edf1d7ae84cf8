"""What is asked of the operating system: files that are whole, locks, processes that end."""
