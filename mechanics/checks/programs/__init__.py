"""Checks of what the routes derive as programs: statements that the kernel decides."""
