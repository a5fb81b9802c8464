"""Truncated Taylor series over any domain of numbers: one set of rules.

    u(t) = u_0 + u_1 t + ... + u_n t^n

    v = u w          v_k = sum_(j<=k) u_j w_(k-j)                                          (1)
    v = u / w        v_k = (u_k - sum_(j<k) v_j w_(k-j)) / w_0                             (2)
    v = sqrt u       v_k = (u_k - sum_(0<j<k) v_j v_(k-j)) / (2 v_0)                       (3)
    v = exp u        k v_k = sum_(0<j<=k) j u_j v_(k-j)                                    (4)
    s, c = sin u, cos u    k s_k = sum_(0<j<=k) j u_j c_(k-j),   k c_k = -(the same of s)  (5)
    v = tan u        k v_k = sum_(0<j<=k) j u_j w_(k-j),   w = 1 + v v                     (6)
    v = u^r          k u_0 v_k = r sum_(0<j<=k) j u_j v_(k-j) - sum_(0<j<k) j v_j u_(k-j)  (7)
    v = f(u)         v' = f'(u) u', f' from the table of operations                        (8)
    M x = b          M_0 x_k = b_k - sum_(0<j<=k) M_j x_(k-j)                              (9)

The hyperbolic functions have (5) and (6) with their signs. (8) serves log, the inverse functions,
erf and |u|. What jumps is constant between its jumps: sign, floor and comparisons have the first
coefficient only, and `select` takes the series of the side that its condition has at t = 0.

Source: Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM 2008, section 13.2:
tables 13.1 and 13.2 for (1) to (5) and (7), proposition 13.1 for (6) and (8).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce
from typing import Any

from mechanics.program.builder import Builder
from mechanics.program.interpret import Domain, interpret
from mechanics.program.operations import OPERATIONS, Operation
from mechanics.program.program import Program

Series = tuple[Any, ...]
"""Coefficients; those that are left out at the end are 0."""


@dataclass(frozen=True)
class TaylorSeries:
    """The domain of truncated Taylor series.

    Attributes
    ----------
    numbers : Domain
        Of the coefficients: NumPy arrays, multiple precision, nodes of a builder.
    order : int
        Highest power that is kept.

    Examples
    --------
    >>> from mechanics.program import Builder, interpret
    >>> from mechanics.program.numpy_domain import Arrays
    >>> b = Builder()
    >>> program = b.program({"f": [1 / (1 - b.input("x"))]})
    >>> (series,) = interpret(program, TaylorSeries(Arrays(), 3), {"x": (0.0, 1.0)})["f"]
    >>> [float(coefficient) for coefficient in series]
    [1.0, 1.0, 1.0, 1.0]
    """

    numbers: Domain
    order: int

    def constant(self, value: Fraction) -> Series:
        """A series of one coefficient."""
        return (self.numbers.constant(value),)

    def pi(self) -> Series:
        """A series of one coefficient."""
        return (self.numbers.pi(),)

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., Series]]:
        """The rules by the names of the table."""
        rules: dict[str, Callable[..., Series]] = {
            "add": lambda u, w: self._by_power(self._add, u, w),
            "subtract": lambda u, w: self._by_power(self._subtract, u, w),
            "negate": lambda u: tuple(map(self._negate, u)),
            "multiply": self._product,
            "divide": self._quotient,
            "sqrt": self._root,
            "exp": self._exp,
            "sin": lambda u: self._pair("sin", "cos", u)[0],
            "cos": lambda u: self._pair("sin", "cos", u)[1],
            "sinh": lambda u: self._pair("sinh", "cosh", u)[0],
            "cosh": lambda u: self._pair("sinh", "cosh", u)[1],
            "tan": lambda u: self._tangent("tan", u),
            "tanh": lambda u: self._tangent("tanh", u),
            "power": self._power,
            "abs": self._abs,
            "select": self._select,
        }
        for row in OPERATIONS:
            if row.arity and row.name not in rules and row.name in self.numbers.operations:
                jumps = row.boolean or row.name in ("sign", "floor")
                rules[row.name] = self._jumping(row) if jumps else self._by_partials(row)
        return rules

    # ------------------------------------------------------------------ arithmetic of numbers

    def _call(self, name: str, *numbers: Any) -> Any:
        return self.numbers.operations[name](*numbers)

    @cached_property
    def _add(self) -> Callable[[Any, Any], Any]:
        return self.numbers.operations["add"]

    @cached_property
    def _subtract(self) -> Callable[[Any, Any], Any]:
        return self.numbers.operations["subtract"]

    @cached_property
    def _multiply(self) -> Callable[[Any, Any], Any]:
        return self.numbers.operations["multiply"]

    @cached_property
    def _divide(self) -> Callable[[Any, Any], Any]:
        return self.numbers.operations["divide"]

    @cached_property
    def _negate(self) -> Callable[[Any], Any]:
        return self.numbers.operations["negate"]

    def _number(self, value: int) -> Any:
        return self.numbers.constant(Fraction(value))

    def _times(self, factor: int, number: Any) -> Any:
        return number if factor == 1 else self._multiply(self._number(factor), number)

    def _over(self, number: Any, divisor: int) -> Any:
        return number if divisor == 1 else self._divide(number, self._number(divisor))

    # ------------------------------------------------------------------ arithmetic of series

    def _by_power(self, function: Callable[[Any, Any], Any], u: Series, w: Series) -> Series:
        """Sum or difference, power by power."""
        zero = self._number(0)
        length = max(len(u), len(w))
        left, right = (s + (zero,) * (length - len(s)) for s in (u, w))
        return tuple(map(function, left, right))

    def _convolution(
        self, u: Sequence[Any], w: Sequence[Any], k: int, first: int, last: int
    ) -> Any:
        """sum of u_j w_(k-j) for first <= j <= last, None where there is nothing to add."""
        start, end = max(first, k - len(w) + 1), min(last, len(u) - 1)
        products = [self._multiply(u[j], w[k - j]) for j in range(start, end + 1)]
        return reduce(self._add, products) if products else None

    def _product(self, u: Series, w: Series) -> Series:
        """Equation (1)."""
        length = min(len(u) + len(w) - 2, self.order) + 1
        return tuple(self._convolution(u, w, k, 0, k) for k in range(length))

    def _orders(self, *operands: Series) -> range:
        """Powers above 0, where an operand has any."""
        moves = any(len(u) > 1 for u in operands)
        return range(1, self.order + 1 if moves else 1)

    def _less(self, u: Series, k: int, sum_: Any) -> Any:
        """u_k - sum."""
        coefficient = u[k] if k < len(u) else self._number(0)
        return coefficient if sum_ is None else self._subtract(coefficient, sum_)

    def _quotient(self, u: Series, w: Series) -> Series:
        """Equation (2)."""
        v = [self._divide(u[0], w[0])]
        orders = range(1, len(u)) if len(w) == 1 else self._orders(u, w)
        for k in orders:
            v.append(self._divide(self._less(u, k, self._convolution(v, w, k, 0, k - 1)), w[0]))
        return tuple(v)

    def _root(self, u: Series) -> Series:
        """Equation (3)."""
        v = [self._call("sqrt", u[0])]
        for k in self._orders(u):
            above = self._less(u, k, self._convolution(v, v, k, 1, k - 1))
            v.append(self._divide(above, self._times(2, v[0])))
        return tuple(v)

    def _slopes(self, u: Series) -> list[Any]:
        """The numbers j u_j."""
        return [self._times(j, u[j]) if j else self._number(0) for j in range(len(u))]

    def _exp(self, u: Series) -> Series:
        """Equation (4)."""
        v, slopes = [self._call("exp", u[0])], self._slopes(u)
        for k in self._orders(u):
            v.append(self._over(self._convolution(slopes, v, k, 1, k), k))
        return tuple(v)

    def _pair(self, sine: str, cosine: str, u: Series) -> tuple[Series, Series]:
        """Equation (5)."""
        s, c, slopes = [self._call(sine, u[0])], [self._call(cosine, u[0])], self._slopes(u)
        for k in self._orders(u):
            s_k = self._over(self._convolution(slopes, c, k, 1, k), k)
            c_k = self._over(self._convolution(slopes, s, k, 1, k), k)
            s.append(s_k)
            c.append(self._negate(c_k) if cosine == "cos" else c_k)
        return tuple(s), tuple(c)

    def _tangent(self, name: str, u: Series) -> Series:
        """Equation (6)."""
        v, slopes = [self._call(name, u[0])], self._slopes(u)
        combine = self._add if name == "tan" else self._subtract
        w = [combine(self._number(1), self._multiply(v[0], v[0]))]
        for k in self._orders(u):
            v.append(self._over(self._convolution(slopes, w, k, 1, k), k))
            square = self._convolution(v, v, k, 0, k)
            w.append(square if name == "tan" else self._negate(square))
        return tuple(v)

    def _power(self, u: Series, r: Series) -> Series:
        """Equation (7), or exp(r log u) where the exponent moves."""
        if len(r) > 1:
            return self._exp(self._product(r, self.operations["log"](u)))
        v, slopes = [self._call("power", u[0], r[0])], self._slopes(u)
        rates = [self._number(0)]
        for k in self._orders(u):
            total = self._multiply(r[0], self._convolution(slopes, v, k, 1, k))
            known = self._convolution(rates, u, k, 1, k - 1)
            total = total if known is None else self._subtract(total, known)
            rates.append(self._divide(total, u[0]))
            v.append(self._over(rates[k], k))
        return tuple(v)

    def _abs(self, u: Series) -> Series:
        """Equation (8), with the slope |u_0| / u_0, which has no value where |u| has no slope."""
        value = self._call("abs", u[0])
        if len(u) == 1:
            return (value,)
        slope = self._divide(value, u[0])
        return (value, *(self._multiply(slope, coefficient) for coefficient in u[1:]))

    def _by_partials(self, row: Operation) -> Callable[..., Series]:
        """Equation (8); the derivative must not need the function itself."""
        slopes = _partials(row)

        def rule(*operands: Series) -> Series:
            value = self._call(row.name, *(u[0] for u in operands))
            if not self._orders(*operands):
                return (value,)
            lower = TaylorSeries(self.numbers, self.order - 1)
            inputs = {f"u{k}": u[: self.order] for k, u in enumerate(operands)}
            factors = interpret(slopes, lower, inputs)["slopes"]
            total: Series = (self._number(0),)
            for factor, u in zip(factors, operands, strict=True):
                if len(u) > 1:
                    rate = tuple(self._slopes(u)[1:])
                    total = self._by_power(self._add, total, lower._product(factor, rate))
            return (value, *(self._over(rate, k + 1) for k, rate in enumerate(total)))

        return rule

    def _jumping(self, row: Operation) -> Callable[..., Series]:
        """What is constant between its jumps."""
        return lambda *operands: (self._call(row.name, *(u[0] for u in operands)),)

    def _select(self, condition: Series, u: Series, w: Series) -> Series:
        def choose(x: Any, y: Any) -> Any:
            return self._call("select", condition[0], x, y)

        return self._by_power(choose, u, w)

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Series]:
        """Equation (9)."""
        leading = [[entry[0] for entry in row] for row in matrix]
        solution: list[list[Any]] = [[] for _ in right]
        entries = [entry for row in matrix for entry in row]
        for k in (0, *self._orders(*entries, *right)):
            sides = []
            for row, b in zip(matrix, right, strict=True):
                terms = [
                    self._convolution(entry, x, k, 1, k)
                    for entry, x in zip(row, solution, strict=True)
                ]
                known = [term for term in terms if term is not None]
                sides.append(self._less(b, k, reduce(self._add, known) if known else None))
            for x, number in zip(
                solution, self.numbers.solve(leading, sides, symmetric), strict=True
            ):
                x.append(number)
        return [tuple(x) for x in solution]


def _partials(row: Operation) -> Program:
    """The partial derivatives of an operation as a program of its operands."""
    builder = Builder()
    operands = [builder.input(f"u{k}") for k in range(row.arity)]
    if row.partials is None:
        raise ValueError(f"operation {row.name} has no derivative")
    return builder.program({"slopes": row.partials(*operands, builder.input("result"))})
