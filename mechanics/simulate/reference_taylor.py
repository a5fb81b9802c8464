"""A solution by Taylor series of high order, in fixed-point integers.

    y(t + s h) = c_0 + c_1 s + ... + c_N s^N        s at most where c_N s^N is below the tolerance

Jorba and Zou, A software package for the numerical integration of ODEs by means of high-order
Taylor methods, Experimental Mathematics 14 (2005), section 3. Wanted times are not stepped onto:
the polynomial is evaluated there.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from weakref import WeakKeyDictionary

import casadi as ca
import sympy

from mechanics.compiled.forms.members import ELIMINATION, LDL, PRIMITIVE
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.model import Model
from mechanics.compiled.programs.program import Program, program
from mechanics.errors import SingularError
from mechanics.simulate.integrators.problem import OverBudget, Problem
from mechanics.simulate.integrators.rate import motion_graphs
from mechanics.simulate.reference_series import Taylor

# Steps after which the solution is given up, and after how many it is known what it will take.
STEPS, TRIAL = 40_000, 20
# Instructions below which it does not pay to look for another form.
SHORT = 120
# log2 of how far the reach of a polynomial may differ from the step that scales its coefficients:
# beyond it their last bits would be amplified, and well below it the terms in the middle
# would be larger than the solution.
LEAST, MOST = -1.0, 0.5

_known: WeakKeyDictionary[Model, dict[bool, tuple[ca.Function, tuple[sympy.Expr, ...]]]] = (
    WeakKeyDictionary()
)


@dataclass(frozen=True, eq=False)
class Exact:
    """The problem in exact numbers.

    Attributes
    ----------
    rate : casadi.Function
        y' from the state (with t as its last entry where the equations hold t), inputs, parameters
        and named constants.
    start : tuple of Fraction
    held : tuple of tuple of (Fraction or sympy.Expr)
        Inputs, parameters, constants.
    compiler : str or None
        For what is quicker in C, with the same digits.
    """

    rate: ca.Function
    start: tuple[Fraction, ...]
    held: tuple[tuple[Fraction | sympy.Expr, ...], ...]
    compiler: str | None = None

    @cached_property
    def code(self) -> Program:
        """Instructions of the rate."""
        return program(self.rate)

    @property
    def key(self) -> tuple[object, ...]:
        """Everything that the solution depends on."""
        return self.code, self.start, self.held

    @property
    def spread(self) -> int:
        """Binary digits between 1 and the smallest number but zero."""
        numbers = [*self.start, *(x for group in self.held for x in group)]
        sizes = [abs(float(x)) for x in numbers if x != 0]
        return max(0, math.ceil(-math.log2(min(sizes, default=1.0))))


def exact(problem: Problem) -> Exact:
    """The equations with named constants, and numbers as the rationals that doubles are."""
    timed = "t" in problem.varying
    function, constants = _shortest(problem.model, timed)
    inputs = tuple(Fraction(value) for value in problem.signals(0.0))
    parameters = tuple(Fraction(float(value)) for value in problem.p)
    start = [Fraction(float(value)) for value in problem.start] + [Fraction(0)] * timed
    held = inputs, parameters, constants
    return Exact(function, tuple(start), held, problem.model.compiler)


def _shortest(model: Model, timed: bool) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
    """The rate in the form with the fewest instructions: in exact numbers all forms are equal."""
    known = _known.setdefault(model, {})
    if timed not in known:
        known[timed] = _searched(model, timed)
    return known[timed]


def _searched(model: Model, timed: bool) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
    best = _rate(model, motion_graphs(model), timed)
    if best[0].n_instructions() < SHORT:
        return best
    for form in (LDL, ELIMINATION, PRIMITIVE):
        if form.name == model.form or form.unsuited(model.equations):
            continue
        other = _rate(model, motion_graphs(model, form.name), timed)
        best = min(best, other, key=lambda found: found[0].n_instructions())
    return best


def _rate(model: Model, graphs: Graphs, timed: bool) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
    """``rate(y, inputs, p, constants)`` with t' = 1 at the end of y if asked for."""
    sizes = {group: len(getattr(model.quantities, group)) for group in ("q", "u", "inputs", "p")}
    size = sizes["q"] + sizes["u"]
    dynamics, _ = graphs.exact("forward_dynamics")
    rates, constants = graphs.exact("coordinate_rates")
    y, w, p, c = (
        ca.SX.sym(name, count)
        for name, count in (
            ("y", size + timed), ("w", sizes["inputs"]), ("p", sizes["p"]), ("c", len(constants)),
        )
    )  # fmt: skip
    used = ca.SX(w)
    if timed:
        used[model.entries["inputs"].index("t")] = y[size]
    state = (y[: sizes["q"]], y[sizes["q"] : size], used, p)
    # Constants are numbered in the order in which they were found: an earlier graph has fewer.
    found = [rates(*state, c), dynamics(*state, c[: dynamics.numel_in(4)])[0]]
    yd = ca.densify(ca.vertcat(*found, *([1] * timed)))
    return ca.Function("rate", [y, w, p, c], ca.cse([yd])), constants


def solve(
    problem: Exact, times: Sequence[float], digits: int, bits: int, order: int
) -> tuple[list[list[int]], int]:
    """The states at the times, times 2^bits, and the number of steps.

    Parameters
    ----------
    times : sequence of float
        Increasing from 0.
    digits : int
        Digits that a step keeps of each entry.
    bits : int
        Of the fixed-point numbers behind the binary point.
    order : int
        N.

    Raises
    ------
    OverBudget
        If it would take more than `STEPS` steps.
    SingularError
        If the motion cannot be continued.
    """
    held = [[_fixed(number, bits) for number in group] for group in problem.held]
    taylor = Taylor(problem.code, held, bits, problem.compiler)
    wanted = [_fixed(Fraction(float(time)), bits) for time in times]
    state = [_fixed(number, bits) for number in problem.start]
    found, t, steps = [state], 0, 0
    step = max(1, wanted[-1] // 64)
    keep = math.ceil(digits * math.log2(10))
    while len(found) < len(wanted):
        left = max(1, wanted[-1] - t)
        coefficients, step, reach = _expanded(taylor, state, step, left, order, keep)
        if steps == TRIAL and (needed := wanted[-1] // max(t // steps, 1)) > STEPS:
            raise OverBudget(_too_many(needed, wanted[-1] / 2**bits))
        while len(found) < len(wanted) and wanted[len(found)] - t <= reach:
            found.append(_along(coefficients, ((wanted[len(found)] - t) << bits) // step, bits))
        state = _along(coefficients, (reach << bits) // step, bits)
        t, step, steps = t + reach, reach, steps + 1
        if steps > STEPS:
            raise OverBudget(_too_many(steps, wanted[-1] / 2**bits))
    return found, steps


def _too_many(steps: int, duration: float) -> str:
    return (
        f"a reference over {duration:g} s takes {steps} steps, more than {STEPS}: the motion is too"
        f" fast for it: ask for {0.9 * duration * STEPS / steps:.2g} s"
    )


def _expanded(
    taylor: Taylor, state: Sequence[int], step: int, left: int, order: int, keep: int
) -> tuple[list[list[int]], int, int]:
    """Coefficients, the step they are scaled with, and how far they reach.

    A polynomial that reaches far beyond the time that is `left`, as that of a body at rest does, is
    not scaled to its reach.
    """
    while True:
        coefficients = taylor.expand(state, step, order)
        stretch = _stretch(coefficients, order, keep)
        reach = step * int(2.0 ** (stretch + 60)) >> 60
        if reach <= 0:
            raise SingularError("no step is small enough: the motion is singular there")
        if LEAST <= stretch <= MOST:
            return coefficients, step, reach
        if stretch > MOST and step >= left:
            return coefficients, step, step
        step = min(reach, step << 8)


def _stretch(coefficients: Sequence[Sequence[int]], order: int, keep: int) -> float:
    """log2 of the largest s at which the last two terms are 2^-keep of the largest one."""
    least = 16.0
    for series in coefficients:
        size = max(map(abs, series)).bit_length()
        for j in (order - 1, order):
            if series[j]:
                least = min(least, (size - keep - series[j].bit_length()) / j)
    return least


def _along(coefficients: Sequence[Sequence[int]], s: int, bits: int) -> list[int]:
    """The polynomials at s, by Horner's rule."""
    values = []
    for series in coefficients:
        value = 0
        for coefficient in reversed(series):
            value = (value * s >> bits) + coefficient
        values.append(value)
    return values


def _fixed(number: Fraction | sympy.Expr, bits: int) -> int:
    if isinstance(number, sympy.Expr):
        digits = math.ceil(bits * math.log10(2)) + 40
        return int(sympy.floor((number * sympy.Integer(2) ** bits).evalf(digits)))
    return (number.numerator << bits) // number.denominator
