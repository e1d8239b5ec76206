"""Rotations, the Earth, the strapdown mechanization and its error models: pure functions of SymPy expressions."""
