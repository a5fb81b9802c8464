"""Mechanical systems with the equations that their sources publish."""
