"""Frequencies of small oscillations: det(K - omega^2 M) = 0 about equilibria that are at hand.

The equilibria that are tried are those at which all coordinates are 0, angles 0 or pi.
Dampers are left out: a text gives the frequency that the motion has without them.
"""

from collections.abc import Iterator
from itertools import islice, product

from sympy import Expr, S, Symbol, pi

from mechanics.claims.kinds import angular
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, SingularError
from mechanics.linear.linearize import linearize

SQUARE = Symbol("omega2", real=True)
"""The square of a frequency."""
MOST = 3
"""Coordinates."""
MOST_PLACES = 4


def characteristic_polynomials(equations: Equations) -> Iterator[tuple[str, Expr]]:
    """What vanishes at the squares of frequencies, in `SQUARE`, and about which equilibrium.

    Parameters
    ----------
    equations : Equations

    Yields
    ------
    str
        The equilibrium, in words.
    Expr
        det(K - omega^2 M).
    """
    scene = equations.scene
    coordinates = tuple(q.name for q in scene.q)
    if not 0 < len(coordinates) <= MOST or scene.speeds:
        return
    turning = angular(scene)
    values = [(S.Zero, pi) if q in turning else (S.Zero,) for q in scene.q]
    for chosen in islice(product(*values), MOST_PLACES):
        place = dict(zip(coordinates, chosen, strict=True))
        inputs = dict.fromkeys((symbol.name for symbol in scene.input_symbols), S.Zero)
        try:
            linear = linearize(equations, place, inputs)
        except (InputError, ExpressionError, SceneError, SingularError):
            continue  # no equilibrium, or none that can be told
        if linear.moves or (len(coordinates) > 1 and not linear.undamped):
            continue
        pencil = linear.stiffness - SQUARE * linear.mass
        words = ", ".join(f"{name} = {value}" for name, value in place.items())
        yield words, pencil.det(method="berkowitz")
