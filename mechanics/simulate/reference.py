"""A solution with thirty digits, so that errors down to 1e-15 mean something.

Two runs by Taylor series, with different order, step and arithmetic, are compared; the finer one is
the reference, and what they share are its digits. Where the equations are linear, the matrix
exponential in Arb balls encloses the solution, and the reference has to lie inside.

    error of x:   (x - y) - z        reference = y + z,  y the nearest double
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from decimal import Context, Decimal
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.simulate.integrators.problem import Problem
from mechanics.simulate.integrators.rate import unsound
from mechanics.simulate.reference_growth import Growth, growth
from mechanics.simulate.reference_linear import linear_solution
from mechanics.simulate.reference_taylor import Exact, exact, solve

Array = NDArray[np.float64]

# What the first run has more than is asked for, the second more than the first, and how often a
# finer one follows when the motion loses more than that.
MORE, FINER, ROUNDS = 3, 3, 4
# Order of a run with so many digits: the cheapest is near 1.15 times the digits.
ORDER = 1.2
# Binary digits behind those that are wanted.
GUARD = 64
# More digits than these are not distinguished.
ALL = 1000.0
ROUNDED = 2.0**-44
"""Share of the largest entry, below which one that should be zero is rounding: it has no scale."""


@dataclass(frozen=True, eq=False)
class Reference:
    """A solution at N times and how far it can be trusted.

    Attributes
    ----------
    times : array, shape (N,)
    states : array, shape (N, n + m)
        Nearest doubles.
    rest : array, shape (N, n + m)
        What the nearest doubles leave: the solution is ``states + rest`` to 32 digits.
    scale : array, shape (n + m,)
        Largest magnitude of each entry along the way; 1 where it is zero but for rounding.
    digits : array, shape (N,)
        Correct decimal digits at each time, relative to the scale.
    verified_by : tuple of str
        How that is known, in sentences.
    growth : Growth
        What becomes of small errors.
    exact : tuple of tuple of Fraction
        The solution with all its digits.
    """

    times: Array
    states: Array
    rest: Array
    scale: Array
    digits: Array
    verified_by: tuple[str, ...]
    growth: Growth = field(repr=False)
    exact: tuple[tuple[Fraction, ...], ...] = field(repr=False)

    @property
    def meaningful_until(self) -> float:
        """Time in s until which a double can tell the motion: see `Growth.meaningful_until`."""
        return self.growth.meaningful_until

    def errors(self, states: Array) -> Array:
        """|states - reference| at the first k times, shape (k, n + m), in the units of each entry.

        The difference of two near doubles is exact, so errors below 1e-16 are seen.
        """
        count = len(states)
        return np.abs((states - self.states[:count]) - self.rest[:count])

    def text(self, index: int, digits: int = 30) -> tuple[str, ...]:
        """The state at ``times[index]`` in decimals."""
        return tuple(_decimal(value, digits) for value in self.exact[index])


def reference(problem: Problem, digits: int = 30) -> Reference:
    """Solve a problem with at least so many digits.

    Parameters
    ----------
    problem : Problem
        Initial values, parameters and inputs are taken for the rationals that their doubles are.

    Raises
    ------
    InputError
        If an input is a function of time, of which only doubles are known, or a number or the
        motion at the start is not finite.
    ExpressionError
        If the equations hold an operation that is not analytic; it is named.
    OverBudget
        If the motion is too fast for the duration; the message says what is affordable.
    SingularError
        If the motion cannot be continued up to the last time.
    """
    if why := unsound(problem):
        raise InputError(why)
    moved = [name for name in problem.varying if name != "t"]
    if moved:
        raise InputError(
            f"input {', '.join(moved)}: a function gives doubles, of which no reference with"
            f" {digits} digits can be made: give a number"
        )
    given = exact(problem)
    solved = _compared(given, tuple(problem.times.tolist()), digits)
    values, states = solved.values, _doubles(solved.values)
    rest = np.array([[float(x - Fraction(float(x))) for x in row] for row in values])
    scale = scale_of(states)
    sentences = [solved.words]
    enclosed = linear_solution(given, problem.times)
    if enclosed is not None:
        sentences.append(enclosed.compared(values))
    size = len(problem.start)
    return Reference(
        problem.times,
        states[:, :size],
        rest[:, :size],
        scale[:size],
        _digits(solved.difference, scale),
        tuple(sentences),
        growth(problem, scale[:size]),
        tuple(tuple(row[:size]) for row in values),
    )


@dataclass(frozen=True)
class _Solved:
    """The finest run, its difference from the one before, and a sentence about both."""

    values: list[list[Fraction]]
    difference: Array
    words: str


def _compared(given: Exact, times: tuple[float, ...], digits: int) -> _Solved:
    coarse = _run(given, times, digits + MORE)
    keep = digits + MORE + FINER
    for last in (False,) * (ROUNDS - 1) + (True,):
        fine = _run(given, times, keep)
        difference = _difference(coarse.values, fine.values)
        shared = float(np.min(_digits(difference, scale_of(_doubles(fine.values)))))
        if shared >= digits or last:
            break
        coarse, keep = fine, keep + int(digits - shared) + FINER
    return _Solved(
        fine.values,
        difference,
        f"{fine.words}, and {coarse.words}: they share {min(shared, ALL):.0f} digits",
    )


@dataclass(frozen=True)
class _Run:
    values: list[list[Fraction]]
    words: str


def _run(given: Exact, times: Sequence[float], digits: int) -> _Run:
    order = int(ORDER * digits)
    bits = int(digits * 3.33) + GUARD + 2 * given.spread
    states, steps = solve(given, times, digits, bits, order)
    values = [[Fraction(x, 1 << bits) for x in state] for state in states]
    return _Run(values, f"Taylor series of order {order} in {steps} steps with {bits} bits")


def _difference(one: list[list[Fraction]], other: list[list[Fraction]]) -> Array:
    return np.array(
        [
            [abs(float(x - y)) for x, y in zip(a, b, strict=True)]
            for a, b in zip(one, other, strict=True)
        ]
    )


def _doubles(values: list[list[Fraction]]) -> Array:
    return np.array([[float(x) for x in row] for row in values])


def scale_of(states: Array) -> Array:
    """Largest magnitude of each entry along the way, 1 for what should be zero, shape (n + m,)."""
    largest = np.max(np.abs(states), axis=0)
    return np.where(largest > ROUNDED * np.max(largest), largest, 1.0)


def _digits(difference: Array, scale: Array) -> Array:
    """Decimal digits that are shared at each time."""
    relative = np.max(difference / scale, axis=1)
    shared = np.full(len(relative), ALL)
    some = relative > 0
    shared[some] = np.minimum(-np.log10(relative[some]), ALL)
    return shared


def _decimal(value: Fraction, digits: int) -> str:
    """A rational to so many significant digits, the last one rounded."""
    if value == 0:
        return "0"
    context = Context(prec=digits)
    return str(context.divide(Decimal(value.numerator), Decimal(value.denominator)))
