"""Values of parameters for which statements are right: fitted to numbers, to be proved then.

    x'' = (u + 0.05 w^2 sin(a))/1.1    ->    m l = 0.05, M + m = 1.1    ->    m = 0.1, l = 0.5
    x'' = 0.05 sin(20 pi t)            ->    A = 0.05, w = 20 pi: numbers as they stand

Numbers as they stand are tried first. Gauss and Newton in the logarithms of the values, damped, at
drawn states; what the statements leave free is 1. Nothing here is a verdict: values are proposed,
the ledger decides.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import islice, permutations

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Integer, Rational, Symbol, pi, preorder_traversal
from sympy.matrices import MatrixBase

from mechanics.checks.ledger_compare import define
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.program import Program
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.scene.published import Published
from mechanics.symbolic import Arithmetic

Numbers = NDArray[np.float64]

STEPS = 40
STARTS = 3
MOST = 6
"""Values that are looked for."""
SMALL = 1e-10
"""Relative, of what is left."""
STEP = 1e-7
"""Of the logarithm of a value, for its derivative."""
DENOMINATORS = (1, 10, 100)
DECIMALS = (3, 4, 5, 6)
ASSIGNMENTS = 400
"""Ways to give numbers as they stand to parameters that are tried."""


def values_for(
    truth: Equations, rows: Sequence[Published], free: Sequence[Symbol]
) -> dict[Symbol, Expr]:
    """Values of free parameters with which all rows hold at drawn states; empty without any.

    Parameters
    ----------
    rows : sequence of Published
        About the motion, in plain symbols.
    free : sequence of Symbol
        Positive parameters that the rows do not hold.
    """
    fit, free = _fit(truth, rows, free)
    if fit is None:
        return {}
    numbers = [*_numbers(rows), *(Integer(1) for _ in free)]
    for values in dict.fromkeys(islice(permutations(numbers, len(free)), ASSIGNMENTS)):
        logs = np.log([float(value) for value in values])
        if np.max(np.abs(fit.left(logs))) < SMALL:
            return {s: v for s, v, one in zip(free, values, fit.matters(logs), strict=True) if one}
    open_places = list(range(len(free)))
    for start in _starts(len(free)):
        found = fit.solved(start, open_places)
        while found is not None and (loose := fit.loose(found, open_places)) is not None:
            open_places = [place for place in open_places if place != loose]
            found[loose] = 0.0
            found = fit.solved(found, open_places)
        if found is not None:
            some = zip(free, found, fit.matters(found), strict=True)
            return {s: _rational(float(np.exp(v))) for s, v, one in some if one}
        open_places = list(range(len(free)))
    return {}


class _Fit:
    """What the sides of rows differ by at drawn states."""

    def __init__(
        self, program: Program, inputs: Mapping[str, Numbers], free: Sequence[str]
    ) -> None:
        self.program, self.inputs, self.free = program, inputs, free
        self.size = self._sizes(np.zeros(len(free)))

    def left(self, logs: Numbers) -> Numbers:
        """By how much sides differ, relative to their size where all values are 1."""
        one, other = self._sides(logs)
        return np.nan_to_num((one - other) / self.size, nan=1e3, posinf=1e3, neginf=-1e3)

    def _sizes(self, logs: Numbers) -> Numbers:
        one, other = self._sides(logs)
        states = len(next(iter(self.inputs.values())))
        sizes = np.abs(np.nan_to_num(one)) + np.abs(np.nan_to_num(other)) + 1e-3
        return np.repeat(sizes.reshape(-1, states).mean(axis=1), states)

    def _sides(self, logs: Numbers) -> tuple[Numbers, Numbers]:
        given = dict(self.inputs) | {
            name: np.exp(value) for name, value in zip(self.free, logs, strict=True)
        }
        with np.errstate(all="ignore"):
            found = interpret(self.program, Arrays(), given)
            size = len(next(iter(self.inputs.values())))
            one, other = (
                np.concatenate([np.broadcast_to(v, size) for v in found[name]])
                for name in ("left", "right")
            )
        return one, other

    def slope(self, logs: Numbers, places: Sequence[int]) -> Numbers:
        """Derivatives by the logarithms at some places."""
        columns = []
        for place in places:
            moved = np.array(logs)
            moved[place] += STEP
            back = np.array(logs)
            back[place] -= STEP
            columns.append((self.left(moved) - self.left(back)) / (2 * STEP))
        return np.array(columns).T

    def matters(self, logs: Numbers) -> list[bool]:
        """Whether anything depends on each value."""
        return list(np.max(np.abs(self.slope(logs, range(len(logs)))), axis=0) > STEP)

    def solved(self, start: Numbers, places: Sequence[int]) -> Numbers | None:
        """Logarithms where nothing is left, only those at some places moved; None without any."""
        logs, damping = np.array(start), 1e-2
        left = self.left(logs)
        for _ in range(STEPS):
            if np.max(np.abs(left)) < SMALL:
                return logs
            if not places:
                return None
            slope = self.slope(logs, places)
            normal = slope.T @ slope
            # Singular where nothing depends on a value but by less than a double keeps.
            step = np.linalg.lstsq(
                normal + damping * (np.diag(np.diag(normal)) + 1e-12 * np.eye(len(places))),
                -slope.T @ left,
                rcond=None,
            )[0]
            new = np.array(logs)
            new[list(places)] = np.clip(new[list(places)] + np.clip(step, -2, 2), -15, 15)
            there = self.left(new)
            if there @ there < left @ left:
                logs, left, damping = new, there, damping / 10
            else:
                damping *= 10
                if damping > 1e8:
                    return None
        return None

    def loose(self, logs: Numbers, places: Sequence[int]) -> int | None:
        """The place of a value that can be chosen, because others follow it; None without any."""
        if not places:
            return None
        _, sizes, axes = np.linalg.svd(self.slope(logs, places), full_matrices=True)
        if len(sizes) == len(places) and sizes[-1] > 1e-6 * max(sizes[0], 1e-12):
            return None
        return places[int(np.argmax(np.abs(axes[-1])))]


def _fit(
    truth: Equations, rows: Sequence[Published], free: Sequence[Symbol]
) -> tuple[_Fit | None, list[Symbol]]:
    """What is fitted, and the parameters on which anything depends."""
    a, scene = Arithmetic(), truth.scene
    try:
        define(a, scene)
        put_motion(a, truth)
        pairs = [pair for row in rows for pair in _pairs(row)]
        left, right = ([a.value(pair[k]) for pair in pairs] for k in (0, 1))
    except (ExpressionError, ValueError):
        return None, []  # nothing is proposed then
    program = a.builder.program({"left": left, "right": right})
    names = {symbol: name for symbol, name in a.inputs.items() if name in program.inputs}
    some = [symbol for symbol in free if symbol in names]
    if not 0 < len(some) <= MOST or scene.constraints:
        return None, []
    draw = np.random.default_rng(0)
    size = 4 + 4 * len(some)
    inputs = {
        name: draw.uniform(0.4, 1.6, size)
        for symbol, name in sorted(names.items(), key=lambda item: item[1])
        if symbol not in some
    }
    try:
        return (_Fit(program, inputs, [names[s] for s in some]) if inputs else None), some
    except OverflowError:
        return None, []  # a number that no double holds


def _pairs(row: Published) -> list[tuple[Expr, Expr]]:
    first, *others = (list(s) if isinstance(s, MatrixBase) else [s] for s in row.sides)
    return [pair for side in others for pair in zip(first, side, strict=True)]


def _numbers(rows: Sequence[Published]) -> list[Expr]:
    """Positive numbers and numeric factors of rows: 0.05, 20 pi, which is 2 pi by 10."""
    sides = (side for row in rows for pair in _pairs(row) for side in pair)
    parts = (part for side in sides for part in preorder_traversal(side))
    factors = (
        part if part.is_number else part.as_independent(*part.free_symbols)[0]
        for part in parts
        if part.is_number or part.is_Mul
    )  # fmt: skip
    found = {abs(n) for n in factors if n != 1}
    found |= {n / (2 * pi) for n in found if n.has(pi)}
    return sorted((n for n in found if n.is_positive), key=lambda n: (float(n), str(n)))


def _starts(count: int) -> list[Numbers]:
    draw = np.random.default_rng(1)
    return [np.zeros(count), *(draw.uniform(-2.5, 2.5, count) for _ in range(STARTS - 1))]


def _rational(value: float) -> Expr:
    """The simplest number near a value."""
    for denominator in DENOMINATORS:
        found = Fraction(value).limit_denominator(denominator)
        if abs(float(found) - value) < 1e-7 * abs(value):
            return Rational(found.numerator, found.denominator)
    for places in DECIMALS:
        if abs(round(value, places) - value) < 1e-9 * abs(value):
            return Rational(str(round(value, places)))
    return Rational(Fraction(value).limit_denominator(10**9))
