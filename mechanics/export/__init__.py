"""Compiled functions as files for others: a C folder with its own test."""

from mechanics.export.write_c import write_c

__all__ = ["write_c"]
