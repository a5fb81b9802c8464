"""Every way to write a solution from the bodies, found once for a set of equations.

The graphs are kept over symbols of their own, and are taken over into those of a model.
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
from sympy import Expr, Symbol

from mechanics.compiled.forms.bodies.leaf_to_root import WAYS, Way
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.quantities import input_symbols
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, SingularError


@dataclass(frozen=True)
class Tried:
    """What came of it.

    Attributes
    ----------
    failure : str
        Why there is none; empty where there is.
    function : casadi.Function or None
        From the symbols and the constants to one column for each of `WAYS`.
    symbols, constants : tuple
        What the inputs stand for.
    """

    failure: str
    function: ca.Function | None = None
    symbols: tuple[Symbol, ...] = ()
    constants: tuple[Expr, ...] = ()

    def graphs(self, translate: Translator) -> list[ca.SX]:
        """The columns, over the symbols of a translator; none where there are none."""
        if self.function is None:
            return []
        given = [
            ca.vertcat(*(translate(symbol) for symbol in self.symbols)),
            ca.vertcat(*(translate.named(constant) for constant in self.constants)),
        ]
        return list(self.function.call(given))


def tried(equations: Equations, solved: Callable[[Reading, Way], ca.SX]) -> Tried:
    """Try all ways.

    Parameters
    ----------
    equations : Equations
    solved : callable
        Writes the column in one way.
    """
    scene = equations.scene
    symbols = (*scene.q, *scene.u, *scene.parameters, *input_symbols(equations))
    graphs = {symbol: ca.SX.sym(symbol.name) for symbol in symbols if symbol not in equations.fixed}
    constants: dict[Expr, ca.SX] = {}
    reading = Reading(scene, Translator(graphs, constants), equations.fixed)
    try:
        columns = [solved(reading, way) for way in WAYS]
    except (ExpressionError, SingularError) as error:
        return Tried(str(error))
    given = [ca.vertcat(*graphs.values()), ca.vertcat(*constants.values())]
    function = ca.Function("ways", given, columns)
    return Tried("", function, tuple(graphs), tuple(constants))
