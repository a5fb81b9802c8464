"""A solution by Taylor series of high order, in fixed-point integers.

    y(t + s h) = c_0 + c_1 s + ... + c_N s^N        s at most where c_N s^N is below the tolerance

Jorba and Zou, A software package for the numerical integration of ODEs by means of high-order
Taylor methods, Experimental Mathematics 14 (2005), section 3. Wanted times are not stepped onto:
the polynomial is evaluated there.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from mechanics.errors import SingularError
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.program.taylor import Recurrences, recurrences
from mechanics.simulate.integrators.problem import OverBudget, Problem
from mechanics.simulate.reference_series import FixedPoint, Taylor

# Steps after which the solution is given up, and after how many it is known what it will take.
STEPS, TRIAL = 40_000, 20
# log2 of how far the reach of a polynomial may differ from the step that scales its coefficients:
# beyond it their last bits would be amplified, and well below it the terms in the middle
# would be larger than the solution.
LEAST, MOST = -1.0, 0.5


@dataclass(frozen=True, eq=False)
class Exact:
    """The problem in exact numbers.

    Attributes
    ----------
    program : Program
        y' from the state, inputs and parameters, by name; the rate of t is 1 where t moves.
    start : mapping of str to Fraction
        The state at t = 0, in the order of y; t is its last entry where it moves.
    held : mapping of str to Fraction
        Inputs and parameters.
    compiler : str or None
        For what is quicker in C, with the same digits.
    """

    program: Program
    start: Mapping[str, Fraction]
    held: Mapping[str, Fraction]
    compiler: str | None = None

    @cached_property
    def rules(self) -> Recurrences:
        """What the series follow, whatever their digits."""
        return recurrences(self.program, tuple(self.start))

    @property
    def spread(self) -> int:
        """Binary digits between 1 and the smallest number but zero."""
        numbers = (*self.start.values(), *self.held.values())
        sizes = [abs(float(x)) for x in numbers if x != 0]
        return max(0, math.ceil(-math.log2(min(sizes, default=1.0))))


def exact(problem: Problem) -> Exact:
    """The equations with exact constants, and numbers as the rationals that doubles are."""
    known, timed = problem.model.right_hand_side, "t" in problem.varying
    names = known.entries
    start = dict(zip(names["y"], map(_rational, problem.start), strict=True))
    held = dict(zip(names["inputs"], map(_rational, problem.signals(0.0)), strict=True))
    held |= dict(zip(names["p"], map(_rational, problem.p), strict=True))
    if timed:
        start["t"] = held.pop("t")
    program = known.shortest
    if timed:
        builder = Builder()
        outputs = {"yd": [*include(builder, program)["yd"], builder.one]}
        program = builder.program(outputs, program.inputs)
    return Exact(program, start, held, problem.model.compiler)


def _rational(value: float) -> Fraction:
    return Fraction(float(value))


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
    ExpressionError
        If the program holds an operation that is not analytic; it is named.
    OverBudget
        If it would take more than `STEPS` steps.
    SingularError
        If the motion cannot be continued.
    """
    fixed = FixedPoint(bits).constant
    held = {name: fixed(value) for name, value in problem.held.items()}
    taylor = Taylor(problem.rules, tuple(problem.start), held, bits, problem.compiler)
    wanted = [fixed(_rational(time)) for time in times]
    state = [*map(fixed, problem.start.values())]
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
