"""Mechanisms in space: times of the four routes, their growth, and counts of compiled outputs."""
