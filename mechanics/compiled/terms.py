"""The terms of a typed equation: how large its residual is against what is added up.

    lhs - rhs = t_1 + ... + t_n          ratio = |t_1 + ... + t_n| / (eps (|t_1| + ... + |t_n|))

Products over sums are multiplied out on each side; terms of the two sides are not merged. The terms
are evaluated in two ways, by routines that share no code: Arb balls at one state, from the SymPy
expression, and extended precision at many, from a program.
"""

import operator
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
import sympy
from flint import arb, fmpq
from numpy.typing import NDArray
from sympy import Expr, Symbol

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Program, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.running_error_domain import enclose
from mechanics.program.sympy_reader import read

Step = tuple[Callable[..., arb], tuple[int, ...]]

UNIT = np.finfo(np.longdouble).eps
CHUNK = 8192
"""States at once, so that values stay near the processor."""

BITS = 160
"""Working precision in Arb: enough for terms that cancel to the last bit of a double."""


def typed_terms(left: Expr, right: Expr) -> tuple[Expr, ...]:
    """Terms of left - right, products over sums multiplied out on each side."""
    sides = sympy.expand(left), sympy.expand(-right)
    return tuple(t for side in sides for t in sympy.Add.make_args(side) if t != 0)


@dataclass(frozen=True)
class BallTerms:
    """Terms as straight-line Arb code: symbols first, then constants, then steps."""

    constants: tuple[Callable[[], arb], ...]
    steps: tuple[Step, ...]
    terms: tuple[int, ...]

    def ratio(self, values: Sequence[float], epsilon: float) -> arb:
        """Enclosure of the ratio, not finite where a value is not; precision is the caller's."""
        v = [arb(value) for value in values]
        v += [constant() for constant in self.constants]
        for function, operands in self.steps:
            v.append(function(*[v[i] for i in operands]))
        total, size = arb(0), arb(0)
        for i in self.terms:
            total += v[i]
            size += abs(v[i])
        return total if total.is_zero() else abs(total) / (size * epsilon)


def ball_terms(terms: Sequence[Expr], symbols: Sequence[Symbol]) -> BallTerms:
    """Straight-line Arb code for terms; every shared part once.

    Raises
    ------
    ExpressionError
        If a term holds an operation that is not known here, or a symbol that is not given.
    """
    atoms = set().union(*(term.atoms(sympy.Rational, sympy.NumberSymbol) for term in terms))
    leaves = sorted(atoms, key=str)
    place: dict[sympy.Basic, int] = {s: i for i, s in enumerate((*symbols, *leaves))}
    steps: list[Step] = []

    base = len(symbols) + len(leaves)

    def add(function: Callable[..., arb], *operands: int) -> int:
        steps.append((function, operands))
        return base + len(steps) - 1

    def visit(node: sympy.Basic) -> int:
        if node not in place:
            place[node] = _emit(node, visit, add)
        return place[node]

    found = tuple(visit(term) for term in terms)
    return BallTerms(tuple(map(_constant, leaves)), tuple(steps), found)


def _emit(
    node: sympy.Basic,
    visit: Callable[[sympy.Basic], int],
    add: Callable[..., int],
) -> int:
    if isinstance(node, sympy.Add | sympy.Mul):
        combine = operator.add if isinstance(node, sympy.Add) else operator.mul
        first, *rest = (visit(part) for part in node.args)
        for part in rest:
            first = add(combine, first, part)
        return first
    if isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Rational) and node.exp.q <= 2:
        power, base = int(node.exp.p), visit(node.base)
        if node.exp.q == 2:
            base = add(arb.sqrt, base)
        return add(lambda x, n=power: x**n, base)
    if type(node) in _BALLS:
        return add(_BALLS[type(node)], visit(node.args[0]))
    raise ExpressionError(
        f"{type(node).__name__} in {str(node)[:80]}: a published equation of motion is checked with"
        " + - * /, roots, sin, cos, tan, |x|, signs and the symbols of its scene"
    )


_BALLS: dict[type, Callable[[arb], arb]] = {
    sympy.sin: arb.sin, sympy.cos: arb.cos, sympy.tan: arb.tan, sympy.Abs: abs,
    sympy.exp: arb.exp, sympy.sign: arb.sgn,
}  # fmt: skip


def _constant(number: Expr) -> Callable[[], arb]:
    """A number at the precision of the moment."""
    if isinstance(number, sympy.Rational):
        return lambda: arb(fmpq(int(number.p), int(number.q)))
    known = {sympy.pi: arb.pi, sympy.E: arb.const_e}
    if number not in known:
        raise ExpressionError(f"constant {number} has no enclosure: declare it as a parameter")
    return known[number]


@dataclass(frozen=True)
class ExtendedTerms:
    """Terms as a program for `numpy.longdouble`.

    Attributes
    ----------
    program : Program
        Of an input for each symbol, by its place among the symbols.
    """

    program: Program

    def bounds(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> tuple[NDArray[np.longdouble], NDArray[np.longdouble]]:
        """What the ratios at many states are not below, and not above."""
        parts = range(0, len(columns[0]), CHUNK)
        with ThreadPoolExecutor(os.cpu_count()) as pool:  # NumPy computes on all cores
            found = pool.map(
                lambda i: self._bounds([c[i : i + CHUNK] for c in columns], epsilon), parts
            )
        low, high = zip(*found, strict=True)
        return np.concatenate(low), np.concatenate(high)

    def _bounds(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> tuple[NDArray[np.longdouble], NDArray[np.longdouble]]:
        terms = enclose(self.program, self._inputs(columns))["terms"]
        filler = np.zeros(columns[0].shape, dtype=np.longdouble)
        with np.errstate(all="ignore"):
            size = sum((np.abs(term.value) for term in terms), filler)
            residual = np.abs(sum((term.value for term in terms), filler))
            # Higham, section 4.2: the roundings of a sum of n terms.
            relative = max(term.relative for term in terms) + len(terms) * UNIT
            error = relative * size + sum(t.error for t in terms if t.error is not None)
            low = np.maximum(residual - error, 0) / ((size + error) * epsilon) * (1 - 8 * UNIT)
            room = (size - error) * epsilon
            high = np.where(room > 0, (residual + error) / room * (1 + 8 * UNIT), np.inf)
        return np.where(np.isfinite(low), low, 0), high

    def ratios(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> NDArray[np.longdouble]:
        """Ratios at many states; infinite where a value is not finite."""
        inputs = {name: c.astype(np.longdouble) for name, c in self._inputs(columns).items()}
        with np.errstate(all="ignore"):
            terms = interpret(self.program, Arrays(np.longdouble), inputs)["terms"]
            total = np.abs(sum(terms))
            size = sum(np.abs(term) for term in terms)
            ratios = np.where(total == 0, np.longdouble(0), total / (size * epsilon))
        return np.where(np.isfinite(ratios), ratios, np.inf)

    def _inputs(self, columns: Sequence[NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
        return {name: columns[int(name)] for name in self.program.inputs}


def extended_terms(terms: Sequence[Expr], symbols: Sequence[Symbol]) -> ExtendedTerms:
    """The same terms as a program for extended precision.

    Raises
    ------
    ExpressionError
        If a term holds an operation that is not known, or a symbol that is not given.
    """
    builder = Builder()
    places = {symbol: builder.input(str(k)) for k, symbol in enumerate(symbols)}
    unknown = set().union(*(term.free_symbols for term in terms)) - set(places)
    if unknown:
        raise ExpressionError(f"symbol {min(map(str, unknown))} in terms has no place")
    return ExtendedTerms(builder.program({"terms": read(builder, terms, places)}))
