"""Velocities from positions, two ways."""
