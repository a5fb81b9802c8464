"""Equations in SymPy, solved in any arithmetic.

[[M, -B], [A, 0]] (u', lambda) = (f, b)
"""

from mechanics.equations import Equations
from mechanics.scene import Scene
from mechanics.symbolic import Arithmetic, Number

Pairs = list[tuple[Number, Number]]

LARGEST_PROOF = 5
"""Number of speeds up to which the normal form is tried: beyond, it outgrows its limit anyway."""


def proof_pays(scene: Scene) -> bool:
    """Whether to try for a proof, or be content with a certificate."""
    return len(scene.u) <= LARGEST_PROOF


def solve(a: Arithmetic, equations: Equations) -> list[Number]:
    """Values of (u', lambda) in an arithmetic."""
    left, right = equations.system
    rows = [[a.value(entry) for entry in left[i, :]] for i in range(left.rows)]
    return a.solve(rows, [a.value(entry) for entry in right])
