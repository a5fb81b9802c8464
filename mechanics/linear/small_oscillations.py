"""Frequencies of small oscillations: det(K - omega^2 M) = 0 about equilibria that are at hand.

    Q(q) = 0 with angles 0 or pi, solved for the other coordinates, those that stay free 0

Where the loads are not linear in these, all of them are 0. One freedom with a damper has three:

    natural     M omega^2 = K                      without the damper
    damped      4 M^2 omega^2 = 4 M K - C^2        of its free motion
    resonant    2 M^2 omega^2 = 2 M K - C^2        of a force, of one amplitude, under which it
                                                   swings widest
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, product

from sympy import Expr, S, Symbol, cancel, linsolve, pi
from sympy.solvers.solveset import NonlinearError

from mechanics.claims.kinds import angular
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError, SingularError
from mechanics.linear.linearize import linearize
from mechanics.scene.symbols import DOTS

SQUARE = Symbol("omega2", real=True)
"""The square of a frequency."""
MOST = 3
"""Coordinates."""
MOST_PLACES = 4


@dataclass(frozen=True)
class Oscillation:
    """What vanishes at the squares of frequencies, in `SQUARE`.

    Attributes
    ----------
    place : str
        The equilibrium, in words.
    natural : Expr
        det(K - omega^2 M).
    damped, resonant : Expr or None
        With the damper; None where nothing damps, or no force drives it.
    """

    place: str
    natural: Expr
    damped: Expr | None = None
    resonant: Expr | None = None


def oscillations(equations: Equations) -> Iterator[Oscillation]:
    """Small oscillations about each equilibrium that is at hand."""
    scene = equations.scene
    for place in equilibria(equations):
        inputs = dict.fromkeys((symbol.name for symbol in scene.input_symbols), S.Zero)
        try:
            linear = linearize(equations, place, inputs)
        except (InputError, ExpressionError, SceneError, SingularError):
            continue  # no equilibrium, or none that can be told
        if linear.moves or (len(place) > 1 and not linear.undamped):
            continue
        pencil = linear.stiffness - SQUARE * linear.mass
        words = ", ".join(f"{name} = {value}" for name, value in place.items())
        free = pencil.det(method="berkowitz")
        if linear.undamped:
            yield Oscillation(words, free)
        else:
            mass, damping = linear.mass[0], linear.damping[0]
            damped, resonant = (n * mass * free - damping**2 for n in (4, 2))
            yield Oscillation(words, free, damped, resonant if _is_forced(equations) else None)


def _is_forced(equations: Equations) -> bool:
    """Whether an input is a force, and none is a motion, of which rates count, too."""
    scene = equations.scene
    rates = {f"{u.name}{dots}" for u in scene.input_symbols for dots in DOTS[1:]}
    symbols = set().union(*(row.free_symbols for row in equations.residual))
    return len(scene.input_symbols) == 1 and rates.isdisjoint(map(str, symbols))


def equilibria(equations: Equations) -> Iterator[Mapping[str, Expr]]:
    """Places that may be equilibria, by the names of the coordinates."""
    scene = equations.scene
    if not 0 < len(scene.q) <= MOST or scene.speeds:
        return
    turning = angular(scene)
    angles = [q for q in scene.q if q in turning]
    still = dict.fromkeys((*scene.qd, *scene.u, *scene.ud, *scene.input_symbols), S.Zero)
    loads = [row.xreplace(still) for row in equations.residual]
    for chosen in islice(product((S.Zero, pi), repeat=len(angles)), MOST_PLACES):
        place = dict(zip(angles, chosen, strict=True))
        lengths = [q for q in scene.q if q not in place]
        place |= _solved([load.xreplace(place) for load in loads], lengths)
        yield {q.name: place[q] for q in scene.q}


def _solved(loads: list[Expr], lengths: list[Symbol]) -> dict[Symbol, Expr]:
    """Where loads vanish that are linear in lengths; zero where nothing tells."""
    zero = dict.fromkeys(lengths, S.Zero)
    try:
        values = next(iter(linsolve(loads, lengths)), None) if lengths else None
    except NonlinearError:
        values = None
    if values is None:
        return zero
    return {q: cancel(v.xreplace(zero)) for q, v in zip(lengths, values, strict=True)}
