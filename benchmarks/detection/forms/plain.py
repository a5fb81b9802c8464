"""Plain text: SymPy's notation with functions of time, MATLAB's with names.

Eq((M + m)*x.diff(t, 2) + 2*k*x, 0)        (M + m)*x_ddot + 2*k*x == 0;
"""

from dataclasses import dataclass
from fractions import Fraction
from math import prod
from random import Random

from sympy import Symbol

from benchmarks.detection.forms.spelling import (
    Labels,
    Quotient,
    is_negative,
    plain_name,
    quotient,
)
from benchmarks.detection.rows import Row
from benchmarks.detection.tree import Tree
from mechanics.scene import Scene


@dataclass(frozen=True)
class Notation:
    """How products, powers and numbers are typed.

    Attributes
    ----------
    names : dict of Symbol to str
        Other symbols are typed by their names.
    prefix : str
        Of functions: ``"np."``.
    decimal : bool
        Whole numbers with a point, as C needs where two are divided.
    call : str
        Name of the function for powers, where there is no operator.
    point : bool
        Fractions that have few decimals are typed as decimals: 0.5 for one half.
    """

    times: str
    divide: str
    power: str
    names: dict[Symbol, str]
    prefix: str = ""
    decimal: bool = False
    call: str = ""
    point: bool = False
    modulus: str = "abs"
    root: str = "sqrt"
    pi: str = "pi"


class Plain:
    """Writes trees with operators."""

    def __init__(self, notation: Notation) -> None:
        self.notation = notation

    def __call__(self, tree: Tree) -> str:
        """A whole expression."""
        if tree.kind != "sum":
            return self._term(tree, True)
        return " ".join(self._term(term, i == 0) for i, term in enumerate(tree.parts))

    def _term(self, tree: Tree, first: bool) -> str:
        words = self._product(tree)
        if is_negative(tree):
            return f"-{words}" if first else f"- {words}"
        return words if first else f"+ {words}"

    def _product(self, tree: Tree) -> str:
        parts = quotient(tree)
        if self.notation.point and (short := _decimal(parts)):
            ratio, parts = short
            rest = [self._factor(factor) for factor in parts.above]
            above = self.notation.times.join([ratio, *rest])
        else:
            above = self.notation.times.join(self._factor(factor) for factor in parts.above)
        words = above or self._number(Fraction(1))
        for factor in parts.below:
            words += f"{self.notation.divide}{self._factor(factor)}"
        return words

    def _factor(self, tree: Tree) -> str:
        n = self.notation
        match tree.kind:
            case "number" if tree.value >= 0 and tree.value.denominator == 1:
                return self._number(tree.value)
            case "symbol":
                return n.names.get(tree.value, tree.value.name)
            case "pi":
                return n.pi
            case "sin" | "cos" | "tan" | "sign":
                return f"{n.prefix}{tree.kind}({self(tree.parts[0])})"
            case "Abs":
                return f"{n.modulus}({self(tree.parts[0])})"
            case "power":
                return self._power(tree)
        return f"({self(tree)})"

    def _power(self, tree: Tree) -> str:
        n, (base, exponent) = self.notation, tree.parts
        if exponent.value == Fraction(1, 2):
            return f"{n.prefix}{n.root}({self(base)})"
        if exponent.value < 0:
            return f"({self._product(tree)})"
        if n.call:
            return f"{n.call}({self(base)}, {self._number(exponent.value)})"
        inner = self._factor(base)
        if base.kind == "power":
            inner = f"({inner})"
        whole = exponent.value.denominator == 1
        return f"{inner}{n.power}{exponent.value if whole else f'({exponent.value})'}"

    def _number(self, value: Fraction) -> str:
        return f"{value}.0" if self.notation.decimal else str(value)


def _decimal(parts: Quotient) -> tuple[str, Quotient] | None:
    """The ratio of a product as a decimal in front, where it has two digits behind the point."""
    numbers = [[f.value for f in side if f.kind == "number"] for side in (parts.above, parts.below)]
    ratio = prod(numbers[0], start=Fraction(1)) / prod(numbers[1], start=Fraction(1))
    if ratio.denominator == 1 or 100 % ratio.denominator:
        return None
    above, below = (
        tuple(f for f in side if f.kind != "number") for side in (parts.above, parts.below)
    )
    return f"{float(ratio):.2f}".rstrip("0"), Quotient(parts.negative, above, below)


def sympy_text(
    scene: Scene, row: Row, trees: tuple[Tree, ...], labels: Labels, source: Random, head: str
) -> str:
    """A statement as SymPy prints or people type it."""
    way = source.choice(("method", "call", "Derivative", "names", "primes"))
    still = set(scene.parameters)
    names = {
        symbol: plain_name(label) if symbol in still else _of_time(way, label)
        for symbol, label in labels.items()
    }
    write = Plain(Notation("*", "/", "**", names))
    if row.about == "mass matrix":
        return f"Matrix([{', '.join(_table(scene, trees, write))}])"
    if not row.equation:
        return f"{head} = {write(trees[0])}"
    left, right = map(write, trees)
    return source.choice((f"Eq({left}, {right})", f"{left} = {right}", f"{left} == {right}"))


def _of_time(way: str, label: tuple[str, int]) -> str:
    base, order = label
    if way == "names":
        return plain_name(label)
    if way == "primes":
        return base + "'" * order
    bare = base if way == "method" else f"{base}(t)"
    if order == 0:
        return bare
    if way == "Derivative":
        return f"Derivative({bare}, t)" if order == 1 else f"Derivative({bare}, (t, {order}))"
    return f"{bare}.diff(t)" if order == 1 else f"{bare}.diff(t, {order})"


def _table(scene: Scene, trees: tuple[Tree, ...], write: Plain) -> list[str]:
    size = len(scene.u)
    return [f"[{', '.join(map(write, trees[i : i + size]))}]" for i in range(0, size**2, size)]


def matlab_text(
    scene: Scene, row: Row, trees: tuple[Tree, ...], labels: Labels, source: Random, head: str
) -> str:
    """A statement in MATLAB's notation."""
    short = source.random() < 0.3
    names = {
        symbol: base + "d" * order if short and order and order < 3 else plain_name((base, order))
        for symbol, (base, order) in labels.items()
    }
    times, divide, power = source.choice((("*", "/", "^"), (" * ", " / ", "^"), (".*", "./", ".^")))
    point = source.random() < 0.3
    write = Plain(Notation(times, divide, power, names, point=point))
    if row.about == "mass matrix":
        return "[" + "; ".join(line[1:-1] for line in _table(scene, trees, write)) + "];"
    if not row.equation:
        return f"{head} = {write(trees[0])};"
    left, right = map(write, trees)
    return f"{left} {source.choice(('=', '=='))} {right};"
