"""Frequencies of small oscillations: det(K - omega^2 M) = 0 about equilibria that are at hand.

The equilibria that are tried are those at which all coordinates are 0, and pi for a single angle.
Dampers are left out: a text gives the frequency that the motion has without them.
"""

from collections.abc import Iterator

from sympy import Expr, Symbol, pi

from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, SingularError
from mechanics.linear.linearize import linearize
from mechanics.reading.kinds import angular

SQUARE = Symbol("omega2", real=True)
"""The square of a frequency."""
MOST = 3
"""Coordinates."""


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
    places: list[dict[str, Expr]] = [dict.fromkeys(coordinates, 0 * pi)]
    if len(coordinates) == 1 and set(scene.q) <= angular(scene):
        places.append({coordinates[0]: pi})
    for place in places:
        inputs = {symbol.name: 0 * pi for symbol in scene.input_symbols}
        try:
            linear = linearize(equations, place, inputs)
        except (InputError, ExpressionError, SceneError, SingularError):
            continue  # no equilibrium, or none that can be told
        if linear.moves or (len(coordinates) > 1 and not linear.undamped):
            continue
        pencil = linear.stiffness - SQUARE * linear.mass
        words = ", ".join(f"{name} = {value}" for name, value in place.items())
        yield words, pencil.det(method="berkowitz")
