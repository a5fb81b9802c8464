"""Forward dynamics by Gauss's principle of least constraint, body by body."""

from mechanics.recursions.least_constraint.solution import WAYS, Way, forward_dynamics

__all__ = ["WAYS", "Way", "forward_dynamics"]
