"""Velocities from positions in SymPy, two ways, for statements that people write."""
