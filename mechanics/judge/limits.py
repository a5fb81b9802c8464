"""Inputs that are limited before anything else is done with them, as motors are.

    f(u) = truth(min(max(u, low), high))        PROVED, u is limited to +-u_max

The limits are read off what the input is compared with; that the statement is the truth of the
limited input, and of nothing else, is then decided. Coordinates are not limited by anybody, and
inputs by nothing that moves, nor by what has another unit.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice, permutations, product

from sympy import Abs, Dummy, Expr, Max, Min, Piecewise, Rational, Symbol
from sympy.core.relational import Relational

from mechanics.compiled.dimensions import known_dimensions
from mechanics.equations import Equations
from mechanics.judge.cases import in_region
from mechanics.judge.converted_rows import each_side
from mechanics.kernel import Finding
from mechanics.scene.dimensions import MixedDimensions, dimension_of
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.symbolic import decide
from mechanics.symbolic.arithmetic import Experiment

MOST = 8
"""Choices of limits and of their order that are tried."""
LEAST = Rational(1, 10**6)
"""A limit below this leaves next to nothing of an input."""
MOST_MODULI = 3
"""In one another."""

Limits = tuple[Expr | None, Expr | None]
"""The least and the largest value."""


def limited(truth: Equations, row: Published) -> Finding | None:
    """The finding of a row as one about limited inputs, if it is shown; else None.

    Parameters
    ----------
    row : Published
        In plain symbols.
    """
    if not isinstance(row.quantity, EquationOfMotion):
        return None
    still = {*truth.scene.parameters, *truth.scene.definitions}
    choices = {u: some for u in truth.scene.input_symbols if (some := _limits(row.sides, u, still))}
    choices = {u: some for u, some in choices.items() if _are_of(truth, u, some)}
    if not choices:
        return None
    found = (
        (dict(zip(choices, chosen, strict=True)), order)
        for chosen in product(*choices.values()) for order in (1, -1)
    )  # fmt: skip
    for limits, order in islice(found, MOST):
        finding = decide(f"{row.tag} {row.label}", _of_limited(truth, row, limits, order))
        if finding.shown:
            words = " and ".join(_words(u, *pair) for u, pair in limits.items())
            return replace(finding, domain=words)
    return None


def _are_of(truth: Equations, u: Symbol, choices: Sequence[Limits]) -> bool:
    """Whether an input may be compared with its limits; numbers are in its unit."""
    known = known_dimensions(truth)
    bounds = {b for pair in choices for b in pair if b is not None and b.free_symbols}
    try:
        return {dimension_of(truth.scene, b, known) for b in bounds} <= {None, known.get(u)}
    except MixedDimensions:
        return False


def _of_limited(
    truth: Equations, row: Published, limits: Mapping[Symbol, Limits], order: int
) -> Experiment:
    """The experiment in which the truth sees limited inputs and the row sees them as they are."""
    free = {u: Dummy(u.name, real=True) for u in limits}
    clipped = {u: _clipped(w, *limits[u], order) for u, w in free.items()}
    return in_region(truth, each_side(row, lambda side: side.xreplace(free)), clipped)


def _clipped(u: Expr, low: Expr | None, high: Expr | None, order: int) -> Expr:
    """The limited value; a field has no order, and asks in that of the code."""
    cases = [(low, u < low)] if low is not None else []
    cases += [(high, u > high)] if high is not None else []
    return Piecewise(*cases[::order], (u, True))


def _limits(sides: Sequence[Expr], u: Symbol, still: set[Symbol]) -> list[Limits]:
    """What an input may be limited to: numbers and parameters, nothing that moves."""
    bounds = dict.fromkeys(bound for side in sides for bound in _compared(side, u))
    if any(not bound.free_symbols <= still for bound in bounds):
        return []
    if len(bounds) == 1:
        (bound,) = bounds
        pairs: list[Limits] = [(None, bound), (bound, None)]
    elif len(bounds) == 2:
        pairs = list(permutations(sorted(bounds, key=str)))
    else:
        return []
    return [pair for pair in pairs if _holds_rest(*pair)]


def _holds_rest(low: Expr | None, high: Expr | None) -> bool:
    """Whether nothing is limited at rest, where inputs are 0."""
    bounds = [bound for bound in (low, high) if bound is not None]
    if len(bounds) == 2 and (bounds[1] - bounds[0]).is_positive is False:
        return False
    if any(b.is_number and not b.is_zero and abs(b) < LEAST for b in bounds):
        return False
    return (low is None or not low.is_positive) and (high is None or not high.is_negative)


def _compared(side: Expr, u: Symbol) -> Iterator[Expr]:
    """What an input is compared with, however that is written: where u - bound is zero."""
    for node in side.atoms(Relational, Max, Min, Abs):
        if isinstance(node, Relational):
            zeros = [node.lhs - node.rhs]
        elif isinstance(node, Abs):
            zeros = _without((Abs,), node.args[0])
        else:
            zeros = [one - two for one, two in combinations(node.args, 2)]
            zeros = [zero for one in zeros for zero in _without((Max, Min), one)]
        for zero in zeros:
            slope = zero.expand().coeff(u)
            if slope.is_number and slope != 0 and not (bound := (u - zero / slope).expand()).has(u):
                yield bound


def _without(kinds: tuple[type[Expr], ...], expression: Expr) -> list[Expr]:
    """What it is where each modulus, largest or least of it is one or the other."""
    found = [expression]
    for node in sorted(expression.atoms(*kinds), key=str)[:MOST_MODULI]:
        each = (node.args[0], -node.args[0]) if isinstance(node, Abs) else node.args
        found = [e.xreplace({node: one}) for e in found for one in each]
    return found


def _words(u: Symbol, low: Expr | None, high: Expr | None) -> str:
    if low is None or high is None:
        return (
            f"{u} is limited to {u} <= {high}" if low is None else f"{u} is limited to {u} >= {low}"
        )
    opposite = low + high == 0
    return f"{u} is limited to +-{high}" if opposite else f"{u} is limited to {low} .. {high}"
