r"""The tree of what a person typed as LaTeX, term by term as it was typed, wrong nodes marked.

M*L**2/12*theta''    12 wrong    ->    \frac{M L^{2}}{\class{wrong}{12}...} \ddot{\theta}
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Power,
    Product,
    Rate,
    Sum,
    Table,
    constant,
)
from mechanics.report.answer.person_latex import both
from mechanics.report.notation import latex_name
from mechanics.scene.symbols import DOTS

Span = tuple[int, int]
MINUS, OVER = Fraction(-1), Fraction(-1)
WORD = re.compile(r"\\mathrm\{\w+\}$")
KNOWN = frozenset(("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "exp"))


@dataclass(eq=False)
class TreeLatex:
    """Sets nodes as LaTeX.

    Attributes
    ----------
    marks : mapping of (int, int) to str
        LaTeX of what has to stand where a node, a sign or a whole term begins and ends; a term
        that is missing begins where it ends.
    placed : set of (int, int)
        The marks that were met.
    """

    marks: Mapping[Span, str] = field(default_factory=dict)
    placed: set[Span] = field(default_factory=set)

    def __call__(self, node: Node) -> str:
        """LaTeX of a node without brackets around it, and of what is missing behind it."""
        behind = self._marked((node.end, node.end), "")
        return self._marked((node.at, node.end), self._bare(node)) + behind

    def _marked(self, span: Span, text: str) -> str:
        if span not in self.marks or span in self.placed:
            return text
        self.placed.add(span)
        return both(text, self.marks[span])

    def _bare(self, node: Node) -> str:
        match node:
            case Number(value=value):
                return _number(value)
            case Name(name=name, order=order):
                return latex_name(name + DOTS[order])
            case Sum(terms=terms):
                return self._sum(terms)
            case Product():
                return self._signed(node)
            case Power(base=base, exponent=exponent):
                return self._power(base, exponent)
            case Call():
                return self._call(node)
            case Rate(of=inner, order=order):
                power = f"^{{{order}}}" if order > 1 else ""
                return rf"\frac{{d{power}}}{{dt{power}}} {_bracketed(self(inner))}"
            case Table(rows=rows):
                cells = r" \\ ".join(" & ".join(map(self, row)) for row in rows)
                return rf"\begin{{bmatrix}}{cells}\end{{bmatrix}}"
        raise TypeError(f"{type(node).__name__} is no node")

    def _sum(self, terms: Sequence[Node]) -> str:
        parts: list[str] = []
        before = terms[0].at - 1
        for n, term in enumerate(terms):
            negative, inner = _sign(term)
            sign = "-" if negative else "+" if n else ""
            body = self._factor(inner) if negative else self(term)
            # The sign stands somewhere between the term before and this one.
            sign = self._between(before, inner.at, inner.at, sign)
            whole = f"{sign} {body}" if sign else body
            parts.append(self._between(before, inner.at, term.end, whole) if sign else whole)
            before = term.end
        return " ".join(parts)

    def _between(self, first: int, last: int, end: int, text: str) -> str:
        """A text marked where a mark begins between two places, and ends at or before another."""
        for start, stop in self.marks:
            if first <= start < last and last <= end and (stop == end or start < stop <= last):
                return self._marked((start, stop), text)
        return text

    def _signed(self, node: Product) -> str:
        """A product; the sign of its first factor stands before all of it."""
        first, *others = _factors(node)
        negative, inner = _sign(first if others else node)
        if not negative:
            return self._product([first, *others])
        factors = [*_factors(inner), *others]
        return f"-{self._product(factors)}"

    def _product(self, factors: Sequence[Node]) -> str:
        """Factors in their order; what is divided becomes a fraction with all before it."""
        parts: list[str] = []
        over: list[Node] = []
        under: list[Node] = []
        for factor in factors:
            divided = _divided(factor)
            if divided is not None:
                under.append(divided)
                continue
            if under:
                parts.append(self._fraction(over, under))
                over, under = [], []
            over.append(factor)
        parts += [self._fraction(over, under)] if under else map(self._factor, over)
        return _beside(parts)

    def _fraction(self, over: Sequence[Node], under: Sequence[Node]) -> str:
        top, bottom = (
            self(row[0]) if len(row) == 1 else _beside(map(self._factor, row)) if row else "1"
            for row in (over, under)
        )
        return rf"\frac{{{top}}}{{{bottom}}}"

    def _factor(self, node: Node) -> str:
        text = self(node)
        return _bracketed(text) if isinstance(node, Sum) or text.startswith("-") else text

    def _power(self, base: Node, exponent: Node) -> str:
        if constant(exponent) == Fraction(1, 2):
            return rf"\sqrt{{{self(base)}}}"
        if constant(exponent) == OVER:
            return rf"\frac{{1}}{{{self(base)}}}"
        if isinstance(base, Call) and base.function in KNOWN and constant(exponent) == 2:
            return self._call(base, f"^{{{self(exponent)}}}")
        plain = isinstance(base, Name | Number)
        return f"{self(base) if plain else _bracketed(self(base))}^{{{self(exponent)}}}"

    def _call(self, node: Call, power: str = "") -> str:
        function, arguments = node.function, node.arguments
        if function == "pi":
            return r"\pi"
        if function == "sqrt":
            return rf"\sqrt{{{self(arguments[0])}}}"
        name = function_latex(function)
        name = self._between(node.at, node.at + 1, node.at + len(function), name)
        inner = ", ".join(map(self, arguments))
        alone = len(arguments) == 1 and isinstance(arguments[0], Name)
        return f"{name}{power} {inner if alone else _bracketed(inner)}"


def function_latex(function: str) -> str:
    """The name of a function."""
    return rf"\{function}" if function in KNOWN else rf"\operatorname{{{function}}}"


def _beside(texts: Iterable[str]) -> str:
    """Factors beside each other: a dot before a digit, a thin space beside a name of letters."""
    found = ""
    for text in texts:
        gap = ""
        if found and (text[:1].isdigit() or text.startswith(r"\frac{1}")):
            gap = r" \cdot "
        elif found:
            gap = r" \, " if WORD.search(found) or text.startswith(r"\mathrm") else " "
        found += gap + text
    return found


def _sign(node: Node) -> tuple[bool, Node]:
    """Whether a node is another one with a minus before it, and that one."""
    if isinstance(node, Product) and len(node.factors) == 2:
        first, second = node.factors
        if isinstance(first, Number) and first.value == MINUS:
            return True, second
    return False, node


def _factors(node: Node) -> list[Node]:
    """Factors of a product, and of the product that it begins with."""
    if not isinstance(node, Product) or _sign(node)[0]:
        return [node]
    first, *others = node.factors
    return [*_factors(first), *others]


def _divided(node: Node | None) -> Node | None:
    """What a factor divides by, if it does."""
    if isinstance(node, Power) and constant(node.exponent) == OVER:
        return node.base
    return None


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value.numerator)
    digits = len(str(value.denominator)) + 2
    decimal = f"{float(value):.{digits}g}"
    if Fraction(decimal) == value and "e" not in decimal:
        return decimal
    return rf"\frac{{{value.numerator}}}{{{value.denominator}}}"


def _bracketed(text: str) -> str:
    return rf"\left({text}\right)"
