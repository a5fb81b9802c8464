"""Inputs that hold a scene at rest: what motors have to give at a pose, exactly.

r(q, 0, 0, w, lambda) = 0        rows of a route at rest, linear in inputs w and multipliers
"""

from collections.abc import Callable, Mapping
from typing import Any

from sympy import Expr, Integer, Matrix, Symbol, linsolve

from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.linear.operating_point import Place, Values, missing, operating_point
from mechanics.linear.reduction import as_rows
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import interpret
from mechanics.program.sympy_printer import Expressions
from mechanics.routes.rows import coefficients, remainder
from mechanics.symbolic import canonical


def trim(equations: Equations, at: Values) -> dict[str, Expr]:
    """Inputs with which a pose is an equilibrium, for `linearize`.

    Parameters
    ----------
    equations : Equations
        By any route.
    at : mapping
        A value for every coordinate, by name, dynamic symbol or plain symbol, as for `linearize`.

    Returns
    -------
    dict of str to Expr
        Each input by its name, in the parameters; those that nothing determines are zero.

    Raises
    ------
    InputError
        If no inputs hold it there, or a value is missing.

    Examples
    --------
    >>> from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
    >>> from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction
    >>> N, O, (z, f), (m, g) = ReferenceFrame("N"), Point("O"), dynamicsymbols("z f"), (
    ...     parameters("m g", "kg m/s^2", "2 9.81"))
    >>> P = O.locatenew("P", z * N.z)
    >>> lift = Scene("lift", N, O, (z,), (Particle("cabin", P, m),), inputs=(f,),
    ...     loads=(gravity(-g * N.z), force("rope", P, f * N.z)))
    >>> from mechanics.routes.derivation import by_route
    >>> trim(by_route("kane", lift), {"z": 0})
    {'f': g*m}
    """
    wanted(equations, Equations, "trim", "pass derive(scene, route)")
    scene = equations.scene
    none = dict.fromkeys(scene.input_symbols, Integer(0))
    point = operating_point(scene, at, none, {}, equations.fixed)
    for q in scene.q:
        if q not in point.coordinates:
            raise missing(scene, "coordinate", q)
    mechanism, rows, multipliers = as_rows(equations)
    still = dict.fromkeys([*map(str, (*scene.u, *scene.ud))], Integer(0))
    values = still | {
        s.name: value for s, value in {**equations.fixed, **point.coordinates}.items()
    }
    place = Place(mechanism.builder, values)
    unknowns = [place.builder.input(symbol.name) for symbol in scene.input_symbols]
    unknowns += place(multipliers)
    put = place(rows)
    nodes = {
        "matrix": [entry for row in coefficients(put, unknowns) for entry in row],
        "rest": remainder(place.builder, put, unknowns),
    }
    program = expand_solves(place.builder.program(nodes))
    symbols = {symbol.name: symbol for symbol in scene.parameters}
    printed = interpret(program, _Canonical(), {name: symbols[name] for name in program.inputs})
    matrix, rest = Matrix(len(rows), len(unknowns), printed["matrix"]), Matrix(printed["rest"])
    sizes = [Symbol(f"x{k}") for k in range(len(unknowns))]
    if not sizes:
        found = [()] if rest.is_zero_matrix else []
    else:
        found = list(linsolve((matrix, -rest), sizes))
    if not found:
        raise InputError(
            f"{scene.name}: no inputs hold it at rest at {point.words({})}: something is not driven"
        )
    solution: tuple[Expr, ...] = tuple(found[0])
    solved = [canonical(entry.subs(dict.fromkeys(sizes, 0))) for entry in solution]
    names = [symbol.name for symbol in scene.input_symbols]
    return dict(zip(names, solved, strict=False))


class _Canonical(Expressions):
    """SymPy's expressions, each reduced when it is made: roots of numbers cancel at once."""

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """By name."""
        return {name: _reduced(code) for name, code in super().operations.items()}


def _reduced(code: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *operands: canonical(code(*operands))
