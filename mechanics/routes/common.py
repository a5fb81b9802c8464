"""Entries of SymPy's methods in the normal form."""

from sympy import Matrix

from mechanics.scene import Scene
from mechanics.symbolic import canonical


def tidied(scene: Scene, matrix: Matrix) -> Matrix:
    """Entries of SymPy's methods in the normal form where time is explicit.

    A frame that turns as Omega t leaves sin(Omega t)^2 + cos(Omega t)^2 all over them.
    """
    return matrix.applyfunc(canonical) if scene.explicit_time else matrix
