"""The linear system K x = k of a set of equations as straight-line Arb code, terms kept apart.

    K_ij = sum of terms,  |K|_ij = sum of their magnitudes         in normal form

Terms that cancel identically are gone, so a sum of magnitudes holds what is really added up.
"""

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import sympy
from flint import arb, fmpq

from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact.canonical_back import generator_expression, shortest, terms
from mechanics.exact.canonical_poly import Reader, reader

Step = tuple[Callable[..., arb], tuple[int, ...]]


@dataclass(frozen=True)
class Entry:
    """One entry of K or k: where it stands, and the places of its terms in the code."""

    row: int
    column: int
    terms: tuple[int, ...]


@dataclass(frozen=True)
class LinearCode:
    """Straight-line code from values of the symbols to the terms of K and k.

    Attributes
    ----------
    size : int
        Number of unknowns n; column n of an entry is k.
    numbers : tuple of callable
        Rational constants and pi at the precision of the moment; they follow the symbols.
    steps : tuple of (callable, operands)
    entries : tuple of Entry
    """

    size: int
    numbers: tuple[Callable[[], arb], ...]
    steps: tuple[Step, ...]
    entries: tuple[Entry, ...]

    def values(self, symbols: Sequence[arb]) -> list[arb]:
        """Every value of the code, at the precision of the moment."""
        v = [*symbols, *(number() for number in self.numbers)]
        for function, operands in self.steps:
            v.append(function(*[v[i] for i in operands]))
        return v


def linear_code(equations: Equations, symbols: Sequence[sympy.Symbol]) -> LinearCode:
    """Code for the linear system of a set of equations.

    Raises
    ------
    ExpressionError
        If an operation has no enclosure here; it is named.
    TooLarge
        If the normal form is.
    """
    left, right = equations.system
    augmented = left.row_join(right)
    read, polynomials = reader(list(augmented))
    polynomials = [shortest(read.ring, read.ring.reduced(p)) for p in polynomials]
    writer = _Code(read, symbols)
    entries = [
        Entry(
            place // augmented.cols,
            place % augmented.cols,
            tuple(map(writer.term, terms(polynomial))),
        )
        for place, polynomial in enumerate(polynomials)
        if polynomial != 0
    ]
    return LinearCode(left.rows, *writer.finished(entries))


class _Code:
    """Collects steps; equal products are computed once."""

    def __init__(self, read: Reader, symbols: Sequence[sympy.Symbol]) -> None:
        self._ring = read.ring
        self._places: dict[object, int] = {symbol: i for i, symbol in enumerate(symbols)}
        self._symbols = len(symbols)
        self._numbers: list[Callable[[], arb]] = []
        self._steps: list[Step] = []

    def finished(
        self, entries: Sequence[Entry]
    ) -> tuple[tuple[Callable[[], arb], ...], tuple[Step, ...], tuple[Entry, ...]]:
        """Numbers, steps and entries, with numbers (negative so far) put before the steps."""
        first = self._symbols + len(self._numbers)

        def place(i: int) -> int:
            if i < 0:
                return self._symbols - i - 1
            return i if i < self._symbols else i - self._symbols + first

        steps = tuple((f, tuple(map(place, operands))) for f, operands in self._steps)
        placed = tuple(Entry(e.row, e.column, tuple(map(place, e.terms))) for e in entries)
        return tuple(self._numbers), steps, placed

    def term(self, term: tuple[tuple[tuple[int, int], ...], sympy.Rational]) -> int:
        """The place of coefficient times product of powers."""
        factors, number = term
        product: int | None = None
        done: tuple[tuple[int, int], ...] = ()
        for factor in factors:
            done = (*done, factor)
            power = self._power(*factor)
            if product is None:
                product = power
                continue
            product = self._shared(done, operator.mul, product, power)
        if product is None:
            return self._number(number)
        if number == 1:
            return product
        return self._shared((number, product), operator.mul, self._number(number), product)

    def _shared(self, key: object, function: Callable[..., arb], *operands: int) -> int:
        if key not in self._places:
            self._steps.append((function, operands))
            self._places[key] = self._symbols + len(self._steps) - 1
        return self._places[key]

    def _power(self, generator: int, power: int) -> int:
        base = self.expression(generator_expression(self._ring, generator))
        if power == 1:
            return base
        return self._shared(("power", base, power), lambda x, n=power: x**n, base)

    def _number(self, number: sympy.Expr) -> int:
        if number not in self._places:
            if isinstance(number, sympy.Rational):
                ratio = fmpq(int(number.p), int(number.q))
                self._numbers.append(lambda: arb(ratio))
            elif number in _CONSTANTS:
                self._numbers.append(_CONSTANTS[number])
            else:
                raise ExpressionError(f"constant {number} has no enclosure: make it a parameter")
            self._places[number] = -len(self._numbers)
        return self._places[number]

    def expression(self, node: sympy.Expr) -> int:
        """The place of a generator or of a part of its argument."""
        if node in self._places:
            return self._places[node]
        if node.is_number and not node.args:
            return self._number(node)
        if isinstance(node, sympy.Add | sympy.Mul):
            combine = operator.add if isinstance(node, sympy.Add) else operator.mul
            first, *rest = node.args
            at = self.expression(first)
            for n, part in enumerate(rest):
                at = self._shared((node, n), combine, at, self.expression(part))
            self._places[node] = at
            return at
        if isinstance(node, sympy.Pow) and node.exp.is_Rational and node.exp.q <= 2:
            base, power = self.expression(node.base), int(node.exp.p)
            if node.exp.q == 2:
                base = self._shared(("root", base), arb.sqrt, base)
            return self._shared(node, lambda x, n=power: x**n, base)
        if type(node) in _FUNCTIONS:
            return self._shared(node, _FUNCTIONS[type(node)], self.expression(node.args[0]))
        raise ExpressionError(
            f"{type(node).__name__} in {str(node)[:80]}: extremes are walked for equations with"
            " + - * /, roots, sin, cos, tan, |x|, exp, log"
        )


_CONSTANTS: dict[sympy.Expr, Callable[[], arb]] = {sympy.pi: arb.pi, sympy.E: arb.const_e}
_FUNCTIONS: dict[type, Callable[[arb], arb]] = {
    sympy.sin: arb.sin, sympy.cos: arb.cos, sympy.tan: arb.tan, sympy.Abs: abs,
    sympy.exp: arb.exp, sympy.log: arb.log, sympy.sign: arb.sgn,
}  # fmt: skip
