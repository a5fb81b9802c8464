"""Kernels against each other: generated, written by hand, and those of other packages."""
