"""Forward dynamics of a tree of joints under constraints, in unknowns in which joints drop out."""

from mechanics.recursions.constrained_trees.solution import forward_dynamics

__all__ = ["forward_dynamics"]
