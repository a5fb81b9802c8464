"""Statements that are known to be true or false; a run of the kernel decides them first.

Each part of the kernel has one that passes only if that part works, and one that a part which says
yes to everything would let pass.
"""

from collections.abc import Callable
from fractions import Fraction

from mechanics.kernel.statement import LEFT, RIGHT, Range, Statement
from mechanics.program import Builder, Node

Sides = Callable[[Node, Node, Node], tuple[Node, Node]]
"""Of x and y, which are positive, and z, which is free."""


def _of_solution(x: Node, y: Node, z: Node) -> Node:
    """(M u) of M u = f, its first component: f is (x z, y z)."""
    matrix = [[x, y], [y, z]]
    first, second = x.builder.solve(matrix, [x * z, y * z], symmetric=True)
    return x * first + y * second


def _of_sum(x: Node, y: Node, sign: int) -> Node:
    return x.sin() * y.cos() + sign * x.cos() * y.sin()


KNOWN: tuple[tuple[str, Sides, bool], ...] = (
    ("sin(x + y)", lambda x, y, z: ((x + y).sin(), _of_sum(x, y, 1)), True),
    ("sin(x + y) with a wrong sign", lambda x, y, z: ((x + y).sin(), _of_sum(x, y, -1)), False),
    ("M x = f", lambda x, y, z: (_of_solution(x, y, z), x * z), True),
    ("M x = 2 f", lambda x, y, z: (_of_solution(x, y, z), 2 * x * z), False),
    ("sqrt(x y)", lambda x, y, z: ((x * y).sqrt(), x.sqrt() * y.sqrt()), True),
    ("sqrt((x - z)**2) = x - z", lambda x, y, z: (((x - z) * (x - z)).sqrt(), x - z), False),
    ("z (1 + 2**-200) = z", lambda x, y, z: (z * (1 + Fraction(1, 2**200)), z), False),
)
"""Subject, sides, and whether they are equal."""


def canaries() -> list[tuple[Statement, bool]]:
    """Statements, and whether they are true."""
    found = []
    for subject, sides, known in KNOWN:
        builder = Builder()
        left, right = sides(*map(builder.input, "xyz"))
        program = builder.program({LEFT: [left], RIGHT: [right]})
        signs = {name: Range.POSITIVE for name in "xy"}
        found.append((Statement(f"canary: {subject}", program, signs), known))
    return found
