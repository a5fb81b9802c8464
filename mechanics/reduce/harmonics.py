"""Deviations that are polynomials in sines and cosines, bounded for all angles at once.

    after - before  =  sum over monomials v of speeds and the like, and over harmonics m, of
                       v  sum_s t_s prod_k (cos or sin)(m_k theta_k)                           (1)
    |...|          <=  sum max |v|  sqrt(sum_s t_s t_s)                                        (2)

(cos a, sin a) is a unit vector, and a form that is linear in each of several unit vectors is not
larger than the root of its squared coefficients. Terms that cancel are gone before anything is
bounded, which no interval sees.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from mechanics.errors import ExpressionError
from mechanics.kernel.balls import ball, precision
from mechanics.program import Program
from mechanics.program import operations as op
from mechanics.reduce.edits import Edits, values

MOST_TERMS = 20_000
"""Of a polynomial; beyond it there is none."""
BITS = 96

Range = tuple[Fraction, Fraction]
Form = tuple[tuple[int, ...], tuple[int, ...]]
"""Exponents of the other unknowns, and harmonics."""


@dataclass(frozen=True)
class Polynomials:
    """Outputs of a program as polynomials in its inputs, and sines and cosines of angles.

    Attributes
    ----------
    box : mapping of str to (Fraction, Fraction)
    numbers : mapping of str to Fraction
        Inputs that have one value.
    """

    program: Program
    box: Mapping[str, Range]
    numbers: Mapping[str, Fraction]

    def deviations(self, edits: Edits) -> list[fmpq_mpoly] | None:
        """After less before, or None where it is no such polynomial."""
        domain = _Domain(self.program)
        given = {
            name: domain.constant(self.numbers[name])
            if name in self.numbers
            else domain.input(name)
            for name in self.program.inputs
        }
        try:
            before, after = (values(self.program, domain, given, some) for some in ({}, edits))
        except (ExpressionError, KeyError):
            return None
        return [after[k] - before[k] for k in self.program.roots]

    def bounds(self, edits: Edits, digits: bool = False) -> list[Any] | None:
        """Equation (2) of each output: floats, or balls that hold every value of the deviation."""
        found = self.deviations(edits)
        if found is None:
            return None
        names = self.program.inputs
        most = [max(map(abs, self.box[name])) for name in names]
        with precision(BITS):
            return [(_ball if digits else _number)(polynomial, most) for polynomial in found]


class _Domain:
    """Polynomials modulo c c + s s = 1; other operations are not there."""

    def __init__(self, program: Program) -> None:
        codes, first = program.operations, program.operands[0]
        angles = {first[k] for k, code in enumerate(codes) if code in (op.SIN, op.COS)}
        names = [f"x{k}" for k in range(len(program.inputs))]
        names += [f"{kind}{k}" for k in range(2 * len(angles)) for kind in "cs"]
        context = fmpq_mpoly_ctx.get(names, Ordering.lex)
        generators = context.gens()
        self.context, self.angles = context, dict[str, int]()
        self.inputs = dict(zip(program.inputs, generators, strict=False))
        self.start = len(program.inputs)
        self.circles = [
            (c, s, c**2 + s**2 - 1)
            for c, s in zip(
                generators[self.start :: 2], generators[self.start + 1 :: 2], strict=True
            )
        ]
        self.operations: dict[str, Callable[..., fmpq_mpoly]] = {
            "add": lambda a, b: a + b, "subtract": lambda a, b: a - b, "negate": lambda a: -a,
            "multiply": self._product,
            "sin": lambda a: self._circle(a)[1], "cos": lambda a: self._circle(a)[0],
        }  # fmt: skip

    def input(self, name: str) -> fmpq_mpoly:
        return self.inputs[name]

    def constant(self, value: Fraction) -> fmpq_mpoly:
        return self.context.constant(fmpq(value.numerator, value.denominator))

    def pi(self) -> fmpq_mpoly:
        raise ExpressionError("pi is no rational")

    def _circle(self, angle: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]:
        place = self.angles.setdefault(str(angle), len(self.angles))
        return self.circles[place]

    def _product(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        if len(a) * len(b) > MOST_TERMS:
            raise ExpressionError("the polynomial is too long")
        found = a * b
        for place, degree in enumerate(found.degrees()[self.start :: 2]):
            if degree >= 2:
                _, found = divmod(found, self.circles[place][2])
        return found


@cache
def _harmonics(c: int, s: int) -> dict[tuple[int, int], Fraction]:
    """cos^c sin^s as a sum of cos(m x), (m, 0), and sin(m x), (m, 1)."""
    if c == s == 0:
        return {(0, 0): Fraction(1)}
    found: dict[tuple[int, int], Fraction] = {}

    def put(m: int, kind: int, value: Fraction) -> None:
        if kind and m < 0:
            value = -value
        if not (kind and m == 0):
            found[abs(m), kind] = found.get((abs(m), kind), Fraction(0)) + value

    for (m, kind), value in _harmonics(c - bool(c), s - (not c)).items():
        # cos x times cos m x or sin m x, else sin x times one of these.
        half = value / 2
        if c:
            put(m + 1, kind, half)
            put(m - 1, kind, half)
        elif kind:
            put(m - 1, 0, half)
            put(m + 1, 0, -half)
        else:
            put(m + 1, 1, half)
            put(m - 1, 1, -half)
    return found


def _forms(polynomial: fmpq_mpoly, inputs: int, as_number: Callable[[fmpq], Any]) -> dict:
    """Squares of the coefficients of equation (1), summed for each form."""
    coefficients: dict[tuple[Form, tuple[int, ...]], Any] = {}
    for powers, value in polynomial.to_dict().items():
        terms: list[tuple[tuple, tuple, Any]] = [((), (), as_number(value))]
        for k in range(inputs, len(powers), 2):
            if not (powers[k] or powers[k + 1]):
                continue
            table = _harmonics(int(powers[k]), int(powers[k + 1]))
            terms = [
                (ms if not m else (*ms, (k, m)), kinds if not m else (*kinds, kind), t * weight)
                for ms, kinds, t in terms for (m, kind), weight in table.items()
            ]  # fmt: skip
        for ms, kinds, t in terms:
            key = (tuple(map(int, powers[:inputs])), ms), kinds
            coefficients[key] = coefficients.get(key, 0) + t
    forms: dict[Form, Any] = {}
    for (form, _), t in coefficients.items():
        forms[form] = forms.get(form, 0) + t * t
    return forms


def _number(polynomial: fmpq_mpoly, most: list[Fraction]) -> float:
    total = 0.0
    forms = _forms(polynomial, len(most), lambda value: int(value.p) / int(value.q))
    for (powers, _), square in forms.items():
        size = float(square) ** 0.5
        for power, largest in zip(powers, most, strict=True):
            size *= float(largest) ** power
        total += size
    return total


def _ball(polynomial: fmpq_mpoly, most: list[Fraction]) -> arb:
    total = arb(0)
    forms = _forms(polynomial, len(most), lambda value: Fraction(int(value.p), int(value.q)))
    for (powers, _), square in forms.items():
        size = ball(square).sqrt()
        for power, largest in zip(powers, most, strict=True):
            size *= ball(largest) ** power
        total += size
    return arb(0, total.upper())
