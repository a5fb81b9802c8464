"""Every way to write a solution from the bodies, found once for a set of equations.

The graphs are kept over symbols of their own, and are taken over into those of a model.
"""

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
from sympy import Expr, Symbol

from mechanics.compiled.forms.bodies.leaf_to_root import WAYS, Way
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.forms.system import System
from mechanics.compiled.quantities import input_symbols
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, SingularError
from mechanics.kernel.ring import TooLarge


@dataclass(frozen=True)
class Tried:
    """What came of it.

    Attributes
    ----------
    failure : str
        Why there is none; empty where there is.
    ways : tuple of Way
        Those that lead to a solution.
    function : casadi.Function or None
        From the symbols and the constants to one column for each of these.
    symbols, constants : tuple
        What the inputs stand for.
    """

    failure: str
    ways: tuple[Way, ...] = ()
    function: ca.Function | None = None
    symbols: tuple[Symbol, ...] = ()
    constants: tuple[Expr, ...] = ()

    def graphs(self, system: System) -> list[tuple[Way, ca.SX]]:
        """The columns that solve a system, over its symbols; none where there are none."""
        if self.function is None:
            return []
        translate = system.translate
        given = [
            ca.vertcat(*(translate(symbol) for symbol in self.symbols)),
            ca.vertcat(*(translate.named(constant) for constant in self.constants)),
        ]
        columns = zip(self.ways, self.function.call(given), strict=True)
        return [(way, column) for way, column in columns if system.solved_by(column)]


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
    columns: dict[Way, ca.SX] = {}
    failures = []
    for way in WAYS:
        try:
            columns[way] = solved(reading, way)
        except (ExpressionError, SingularError, TooLarge) as error:
            failures.append(str(error))
    if not columns:
        return Tried(failures[0])
    given = [ca.vertcat(*graphs.values()), ca.vertcat(*constants.values())]
    function = ca.Function("ways", given, list(columns.values()))
    return Tried("", tuple(columns), function, tuple(graphs), tuple(constants))
