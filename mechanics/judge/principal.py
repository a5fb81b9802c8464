"""Statements that are right on the principal range of a wrap or inverse that they hold.

    (theta + pi) % (2 pi) - pi = theta        where -pi < theta < pi
    asin(sin(theta)) = theta                  where -pi/2 < theta < pi/2

On that range the wrap is its argument; where the statement is shown of the argument, what differs
lies beyond. A wrap whose range begins or ends at rest turns angles there into others:

    (theta + pi) % pi - pi = -pi              at theta = 0

and what it makes wrong stays refuted.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from sympy import Abs, Expr, S, Symbol, acos, asin, atan, atan2, cos, floor, pi, sin, tan
from sympy.core.function import Function

from mechanics.kernel import Finding, undecided
from mechanics.scene.published import Published


class Wrap(NamedTuple):
    """A function, what it is on its principal range, and what lies in that range."""

    function: Expr
    value: Expr
    inside: Expr
    low: Expr
    high: Expr


def on_principal_range(
    row: Published, found: Finding, check: Callable[[Published], Finding]
) -> Finding | None:
    """The finding of a refuted row that is shown on the principal range of its wraps; else None.

    Parameters
    ----------
    found : Finding
        That refutes it.
    check : callable
        The finding of another row.
    """
    wraps = list(_wraps(row.sides))
    if not wraps or not all(_is_principal_at_rest(wrap) for wrap in wraps):
        return None
    table = {wrap.function: wrap.value for wrap in wraps}
    inside = check(replace(row, sides=tuple(side.xreplace(table) for side in row.sides)))
    if not inside.shown:
        return None
    words = " and ".join(dict.fromkeys(_words(wrap) for wrap in wraps))
    beyond = "beyond that its own wraps are other angles, and the values differ"
    return undecided(found.subject, beyond, f"{inside.verdict.name} WHERE {words}")


def _is_principal_at_rest(wrap: Wrap) -> bool:
    """Whether the wrap is its argument where all symbols are zero, if it is a number there."""
    inside = wrap.inside.subs(dict.fromkeys(wrap.inside.free_symbols, 0))
    if not inside.is_number:
        return True
    if inside.is_comparable is not True:  # it has no value there, or none that is real
        return False
    at_the_end = inside == wrap.high and not isinstance(wrap.function, floor)
    return bool(wrap.low <= inside < wrap.high) or at_the_end


def _wraps(sides: Sequence[Expr]) -> Iterator[Wrap]:
    for node in sorted(set().union(*(side.atoms(Function) for side in sides)), key=str):
        wrap = _wrap(node)
        if wrap is not None:
            yield wrap


def _wrap(node: Expr) -> Wrap | None:
    argument = node.args[0] if node.args else S.Zero
    for inverse, function, low, high in (
        (asin, sin, -pi / 2, pi / 2), (acos, cos, S.Zero, pi), (atan, tan, -pi / 2, pi / 2),
    ):  # fmt: skip
        if isinstance(node, inverse) and isinstance(argument, function):
            return Wrap(node, argument.args[0], argument.args[0], low, high)
    if isinstance(node, atan2):
        angle = _angle(*node.args)
        return None if angle is None else Wrap(node, angle, angle, -pi, pi)
    if isinstance(node, floor) and argument.has(pi):
        # a - b floor(a/b), or with |a/b| as of fmod
        inside = argument.args[0] if isinstance(argument, Abs) else argument
        low = S.NegativeOne if isinstance(argument, Abs) else S.Zero
        return Wrap(node, S.Zero, inside, low, S.One)
    return None


def _angle(y: Expr, x: Expr) -> Expr | None:
    """The angle e of y = k sin(e), x = k cos(e), k > 0."""
    for sine in y.atoms(sin):
        ratio = y / sine
        if ratio.is_positive and ratio * cos(sine.args[0]) == x:
            return sine.args[0]
    return None


def _words(wrap: Wrap) -> str:
    """Where it is on its principal range: of one symbol, where it is linear in that."""
    low, high, inside = wrap.low, wrap.high, wrap.inside
    symbols = [s for s in inside.free_symbols if isinstance(s, Symbol)]
    if len(symbols) == 1 and (slope := inside.expand().coeff(symbols[0])).is_number and slope != 0:
        rest = inside - slope * symbols[0]
        if not rest.expand().has(symbols[0]):
            ends = sorted(((low - rest) / slope, (high - rest) / slope), key=lambda end: end.n())
            return f"{ends[0].expand()} < {symbols[0]} < {ends[1].expand()}"
    return f"{low} < {inside} < {high}"
