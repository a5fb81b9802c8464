"""Comparison of what the routes derived: with each other, with laws, with published equations."""
