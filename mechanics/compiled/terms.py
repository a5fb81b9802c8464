"""The terms of a typed equation: how large its residual is against what is added up.

    lhs - rhs = t_1 + ... + t_n          ratio = |t_1 + ... + t_n| / (eps (|t_1| + ... + |t_n|))

Products over sums are multiplied out on each side; terms of the two sides are not merged. The terms
are evaluated in two ways, by routines that share no code: Arb balls at one state, from the SymPy
expression, and extended precision at many, from the CasADi graph.
"""

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
import sympy
from flint import arb, fmpq
from numpy.typing import NDArray
from sympy import Expr, Symbol

from mechanics.compiled.program import Program, program, run
from mechanics.compiled.quantities import DIGITS
from mechanics.compiled.translate import Translator
from mechanics.errors import ExpressionError

Step = tuple[Callable[..., arb], tuple[int, ...]]

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
        " + - * /, roots, sin, cos, tan, |x| and the symbols of its scene"
    )


_BALLS: dict[type, Callable[[arb], arb]] = {
    sympy.sin: arb.sin, sympy.cos: arb.cos, sympy.tan: arb.tan, sympy.Abs: abs,
    sympy.exp: arb.exp,
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
    code : Program
        From the symbols and the named constants to the terms.
    constants : tuple of numpy.longdouble
    error : float
        Bound of the error of a ratio, in units of 2**-52; infinite where none is known.
    """

    code: Program
    constants: tuple[np.longdouble, ...]
    error: float

    def ratios(
        self, columns: Sequence[NDArray[np.float64]], epsilon: float
    ) -> NDArray[np.longdouble]:
        """Ratios at many states; infinite where a value is not finite."""
        (terms,) = run(self.code, [columns, self.constants], np.longdouble)
        with np.errstate(all="ignore"):
            total = np.abs(sum(terms))
            size = sum(np.abs(term) for term in terms)
            ratios = np.where(total == 0, np.longdouble(0), total / (size * epsilon))
        return np.where(np.isfinite(ratios), ratios, np.inf)


def extended_terms(terms: Sequence[Expr], symbols: Sequence[Symbol]) -> ExtendedTerms:
    """The same terms as a program for extended precision."""
    given = ca.SX.sym("symbols", len(symbols))
    translate = Translator({s: given[i] for i, s in enumerate(symbols)})
    graph = translate.column(list(terms))
    named = translate.constants
    constants = ca.vertcat(*named.values()) if named else ca.SX(0, 1)
    code = program(ca.Function("terms", [given, constants], [ca.cse(graph)]))
    numbers = tuple(np.longdouble(str(constant.evalf(DIGITS))) for constant in named)
    return ExtendedTerms(code, numbers, _error(terms, code))


def _error(terms: Sequence[Expr], code: Program) -> float:
    """Bound of the error of a ratio in extended precision, in units of 2**-52.

    A product of powers, sines and cosines of symbols is as accurate as its factors: each operation
    adds at most two units of the last place (four for sin and cos), relative to its term. Nothing
    is known where a sum is hidden in a factor or an angle, or without an extended precision.
    """
    unit = float(np.finfo(np.longdouble).eps)
    if unit > 2.0**-60 or not all(_simple(factor) for t in terms for factor in _factors(t)):
        return float("inf")
    return 4 * (code.operations + len(terms)) * unit / 2.0**-52


def _factors(term: Expr) -> tuple[Expr, ...]:
    factors: tuple[Expr, ...] = sympy.Mul.make_args(term)
    return factors


def _simple(factor: Expr) -> bool:
    if isinstance(factor, sympy.Pow):
        return factor.exp.is_Rational and _simple(factor.base)
    if isinstance(factor, sympy.sin | sympy.cos):
        return isinstance(factor.args[0], Symbol)
    return isinstance(factor, Symbol | sympy.Rational | sympy.NumberSymbol)
