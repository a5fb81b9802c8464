"""Measurements, each with one command that prints a table."""
