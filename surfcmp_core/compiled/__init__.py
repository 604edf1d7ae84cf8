"""How the core compiles: kernels, their cache, strict arithmetic."""
