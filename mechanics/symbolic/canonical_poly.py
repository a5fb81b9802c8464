"""A SymPy expression as a polynomial in generators that are SymPy expressions themselves.

Symbols, sines and cosines are generators; 1/base is a generator r with r * base = 1; a root is a
generator w with w**k = base; every other function of canonical arguments is opaque. Sums of angles
stay together: cos(a + b) is one generator, because expanding it would undo what made it short.
"""

from collections.abc import Iterable
from fractions import Fraction

import sympy
from flint import fmpq, fmpq_mpoly

from mechanics.errors import ExpressionError
from mechanics.kernel.ring import MOST_GENERATORS, Full, Ring, primitive_part
from mechanics.program.postorder import postorder
from mechanics.symbolic.canonical_back import expression
from mechanics.symbolic.decimals import float_as_rational

BAD = (sympy.S.NaN, sympy.S.ComplexInfinity, sympy.S.Infinity, sympy.S.NegativeInfinity)


class Reader:
    """Reads expressions into one ring; shared parts are read once."""

    def __init__(self, capacity: int) -> None:
        self.ring = Ring(capacity)
        self._memo: dict[sympy.Basic, fmpq_mpoly] = {}

    def read(self, expr: sympy.Expr) -> fmpq_mpoly:
        """Return the polynomial of an expression.

        Raises
        ------
        ExpressionError
            If it holds nan or infinity.
        """
        memo = self._memo
        for node in postorder(expr, _parts, memo):
            memo[node] = self._node(node, [memo[part] for part in _parts(node)])
        return memo[expr]

    def _node(self, node: sympy.Expr, parts: list[fmpq_mpoly]) -> fmpq_mpoly:
        ring = self.ring
        if isinstance(node, sympy.Add):
            return sum(parts[1:], parts[0])
        if isinstance(node, sympy.Mul):
            product = parts[0]
            for part in parts[1:]:
                product = ring.product(product, part)
            return product
        if isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Rational):
            return self._power(node, parts[0])
        if isinstance(node, sympy.Rational | sympy.Float):
            number = float_as_rational(node) if isinstance(node, sympy.Float) else node
            return ring.constant(1) * int(number.p) / int(number.q)
        if node in BAD:
            raise ExpressionError(f"{node} has no normal form: find the division by zero")
        if isinstance(node, sympy.Symbol | sympy.NumberSymbol):
            return ring.generator(node)
        return self._function(node)

    def _power(self, node: sympy.Pow, base: fmpq_mpoly) -> fmpq_mpoly:
        top, bottom = int(node.exp.p), int(node.exp.q)
        if bottom > 1:
            base = self._root(base, bottom)
        return self.ring.power(base if top > 0 else self._inverse(base), abs(top))

    def _root(self, base: fmpq_mpoly, k: int) -> fmpq_mpoly:
        """Return the generator w with w**k = base."""
        root = sympy.Pow(self.write(base), sympy.Rational(1, k))
        if not (isinstance(root, sympy.Pow) and root.exp == sympy.Rational(1, k)):
            return self.read(root)  # SymPy took something out: sqrt(4*x) = 2*sqrt(x)
        return self.ring.root(root, k, base)

    def _inverse(self, base: fmpq_mpoly) -> fmpq_mpoly:
        """Return 1/base: of a monomial factor by factor, of a sum as one generator."""
        if base == 0:
            raise ExpressionError("division by an expression that is identically zero")
        ring = self.ring
        if len(base) > 1:
            side = 1 if base.leading_coefficient() > 0 else -1
            unit, rest = primitive_part(side * base)
            return self._reciprocal(rest) / _flint(side * unit)
        result = ring.constant(1) / base.leading_coefficient()
        for place, power in enumerate(base.degrees()):
            if power:
                result = ring.product(result, self._reciprocal(ring.gen(place)) ** int(power))
        return result

    def _reciprocal(self, base: fmpq_mpoly) -> fmpq_mpoly:
        ring = self.ring
        inverse = sympy.Pow(self.write(base), -1)
        place = ring.place(inverse)
        r = ring.gen(place)
        if len(base) == 1:
            of = base.degrees().index(1)
            key = ring.keys[of]
            ring.relate(((place, 1), (of, 1)), r * base - 1)
            if isinstance(key, tuple) and key[0] == "sin":
                # Completes the rewriting: c**2/s = 1/s - s, because s**2 is what is replaced.
                c = ring.place(("cos", key[1]))
                ring.relate(((place, 1), (c, 2)), r * ring.gen(c) ** 2 - r + base)
        return r

    def _function(self, node: sympy.Expr) -> fmpq_mpoly:
        """Return a function: of its arguments' canonical forms, so that equal ones are one."""
        args = [
            arg if isinstance(arg, sympy.Symbol | sympy.Rational) else self._argument(arg)
            for arg in node.args
        ]
        again = node.func(*args)
        if type(again) is not type(node):
            return self.read(again)
        if isinstance(again, sympy.tan):
            return self.read(sympy.sin(again.args[0]) / sympy.cos(again.args[0]))
        if isinstance(again, sympy.sin | sympy.cos):
            c, s = self.ring.circle(again.args[0])
            return c if isinstance(again, sympy.cos) else s
        return self._modulus(again) if isinstance(again, sympy.Abs) else self.ring.generator(again)

    def _modulus(self, node: sympy.Abs) -> fmpq_mpoly:
        """Return the generator |x|, bound by |x|**2 = x**2 where x is real."""
        if not node.args[0].is_extended_real:
            return self.ring.generator(node)
        return self.ring.root(node, 2, self.ring.power(self.read(node.args[0]), 2))

    def _argument(self, arg: sympy.Basic) -> sympy.Basic:
        return self.write(self.read(arg)) if isinstance(arg, sympy.Expr) else arg

    def write(self, polynomial: fmpq_mpoly) -> sympy.Expr:
        """Return a polynomial as a SymPy expression."""
        return expression(self.ring, self.ring.reduced(polynomial))


def _parts(node: sympy.Expr) -> tuple[sympy.Expr, ...]:
    if isinstance(node, sympy.Add | sympy.Mul):
        parts: tuple[sympy.Expr, ...] = node.args
        return parts
    if isinstance(node, sympy.Pow) and isinstance(node.exp, sympy.Rational):
        return (node.base,)
    return ()


def _flint(ratio: Fraction) -> fmpq:
    return fmpq(ratio.numerator, ratio.denominator)


def reader(exprs: Iterable[sympy.Expr]) -> tuple[Reader, list[fmpq_mpoly]]:
    """Read expressions into one ring that is large enough.

    Raises
    ------
    ExpressionError
        If an expression holds nan or infinity, or needs too many generators.
    TooLarge
        If a product outgrows the limits of the ring.
    """
    exprs = [sympy.sympify(expr) for expr in exprs]
    parts = _all_parts(exprs)
    names = sorted((part for part in parts if isinstance(part, sympy.Symbol)), key=str)
    capacity = len(names) + 2 * len(_functions(parts)) + 8
    while capacity <= MOST_GENERATORS:
        result = Reader(capacity)
        try:
            for name in names:
                result.ring.place(name)
            return result, [result.read(expr) for expr in exprs]
        except Full:
            capacity *= 2
    raise ExpressionError(f"more than {MOST_GENERATORS} different symbols and functions: split it")


def _all_parts(exprs: Iterable[sympy.Expr]) -> set[sympy.Basic]:
    """Return all parts of expressions; `free_symbols` would visit shared ones again and again."""
    seen: set[sympy.Basic] = set()
    stack: list[sympy.Basic] = list(exprs)
    while stack:
        node = stack.pop()
        if node not in seen:
            seen.add(node)
            stack.extend(node.args)
    return seen


def _functions(parts: Iterable[sympy.Basic]) -> set[sympy.Basic]:
    """Return the functions and powers among parts that may become generators."""
    keep = sympy.Function, sympy.NumberSymbol
    return {
        node.args[0] if isinstance(node, sympy.sin | sympy.cos) else node
        for node in parts
        if isinstance(node, keep)
        or (isinstance(node, sympy.Pow) and not (node.exp.is_Integer and node.exp > 0))
    }
