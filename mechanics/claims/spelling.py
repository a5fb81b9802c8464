r"""Nodes in the person's own notation: what was written as it stands there, new nodes spelled out.

\frac{M L}{2} \ddot{\theta}        M*L*theta''/2        M*L*theta_ddot/2
"""

import re
from collections.abc import Collection
from dataclasses import dataclass
from fractions import Fraction

from mechanics.claims.claim import Written
from mechanics.claims.names import GREEK
from mechanics.claims.tree import (
    ENTRY,
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
    inverse,
)

SUM, PRODUCT, POWER, ATOM = range(4)
"""How tightly a node holds together."""

ACCENTS = ("", r"\dot", r"\ddot", r"\dddot")
DOTS = ("", "_dot", "_ddot", "_dddot")


@dataclass(frozen=True, eq=False)
class Spelling:
    """Spells nodes.

    Attributes
    ----------
    written : Written
    known : collection of int
        Identities of the nodes that the person wrote, which are quoted.
    """

    written: Written
    known: Collection[int]

    @property
    def latex(self) -> bool:
        """Whether it is LaTeX."""
        return self.written.notation == "latex"

    def __call__(self, node: Node) -> str:
        """The text of a node."""
        return self.quoted(node) or self._spelled(node)

    def quoted(self, node: Node) -> str:
        """The node as it was written; empty where it was not, or not in one piece."""
        span = self.span(node)
        if span is None or hidden_minus(node):
            return ""
        return " ".join(self.written.text[slice(*span)].split())

    def span(self, node: Node) -> tuple[int, int] | None:
        """Where a node stands in the text, without the sign before it; None for a new one."""
        if id(node) not in self.known or not 0 <= node.at < node.end:
            return None
        return (node.at, node.end) if balanced(self.written.text[node.at : node.end]) else None

    def _spelled(self, node: Node) -> str:
        match node:
            case Number(value=value):
                return self._number(value)
            case Name():
                return self._name(node)
            case Sum(terms=terms):
                return self._sum(terms)
            case Product():
                return self._product(node)
            case Power(base=base, exponent=exponent):
                return self._power(node, base, exponent)
            case Call():
                return self._call(node)
            case Rate(of=inner, order=order):
                return self._rate(inner, order)
            case Table(rows=rows):
                cells = ", ".join("[" + ", ".join(map(self, row)) + "]" for row in rows)
                return f"[{cells}]"
        return ""

    def _number(self, value: Fraction) -> str:
        if value.denominator == 1:
            return str(value.numerator)
        if self.latex:
            sign = "-" if value < 0 else ""
            return rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
        return f"{value.numerator}/{value.denominator}"

    def _name(self, node: Name) -> str:
        if not self.latex:
            if self.written.notation == "text" and node.order:
                return node.name + "'" * node.order
            return node.name + DOTS[node.order]
        base, _, sub = node.name.partition("_")
        if not sub and (match := re.fullmatch(r"([A-Za-z]+)(\d+)", base)):
            base, sub = match[1], match[2]
        letter = "\\" + base if base in GREEK else base
        if len(base) > 1 and base not in GREEK:
            letter = rf"\mathrm{{{base}}}"
        if node.order:
            letter = rf"{ACCENTS[node.order]}{{{letter}}}"
        return rf"{letter}_{{{sub}}}" if sub else letter

    def _sum(self, terms: tuple[Node, ...]) -> str:
        found = ""
        for term in terms:
            text = self.tight(term, SUM + 1) if isinstance(term, Sum) else self(term)
            if not found:
                found = text
            elif text.startswith("-"):
                found += " - " + text[1:].lstrip()
            else:
                found += " + " + text
        return found

    def tight(self, node: Node, level: int) -> str:
        """The text of a node, in brackets where it would fall apart."""
        text = self(node)
        if level_of(node, text) >= level:
            return text
        return rf"\left({text}\right)" if self.latex else f"({text})"

    def _product(self, node: Product) -> str:
        above, below, minus = _split(node)
        sign = "-" if minus else ""
        if not below and len(above) == 1:
            return sign + self.tight(above[0], PRODUCT)
        if not below:
            return sign + self._side_by_side(above)
        if self.latex:
            over = self._side_by_side(above) if above else "1"
            return rf"{sign}\frac{{{over}}}{{{self._side_by_side(below)}}}"
        over = self._side_by_side(above) if above else "1"
        under = self._side_by_side(below)
        under = f"({under})" if len(below) > 1 else self.tight(below[0], POWER)
        return f"{sign}{over}/{under}"

    def _side_by_side(self, factors: list[Node]) -> str:
        if len(factors) == 1:
            return self(factors[0]) if self.latex else self.tight(factors[0], PRODUCT)
        texts = [self.tight(factor, PRODUCT) for factor in factors]
        if not self.latex:
            return "*".join(texts)
        found = texts[0]
        for text in texts[1:]:
            # Two numbers side by side would be one.
            found += (r" \cdot " if text[0].isdigit() else " ") + text
        return found

    def _power(self, node: Node, base: Node, exponent: Node) -> str:
        number = constant(exponent)
        if number == -1:
            return self._product(Product(node.at, (node,)))
        if number is not None and number < 0:
            return self._product(
                Product(node.at, (inverse(Power(node.at, base, Number(0, -number))),))
            )
        if number == Fraction(1, 2):
            return rf"\sqrt{{{self(base)}}}" if self.latex else f"sqrt({self(base)})"
        if self.latex:
            if isinstance(base, Call) and len(base.arguments) == 1 and not self.quoted(base):
                return rf"\{base.function}^{{{self(exponent)}}}{self._argument(base.arguments[0])}"
            return rf"{self._base(base)}^{{{self(exponent)}}}"
        mark = "^" if self.written.notation == "text" and "**" not in self.written.text else "**"
        halves = self.written.notation == "code" and number is not None and number.denominator == 2
        above = str(float(number)) if halves else self.tight(exponent, ATOM)  # type: ignore[arg-type]
        return f"{self.tight(base, ATOM)}{mark}{above}"

    def _base(self, base: Node) -> str:
        text = self.tight(base, ATOM)
        if isinstance(base, Call):
            return rf"\left({text}\right)"
        return text

    def _call(self, node: Call) -> str:
        if node.function == "pi":
            return r"\pi" if self.latex else "pi"
        inside = ", ".join(map(self, node.arguments))
        if node.function == ENTRY:
            return f"{self(node.arguments[0])}({self(node.arguments[1])})"
        if not self.latex:
            return f"{node.function}({inside})"
        if node.function == "abs":
            return rf"\left|{inside}\right|"
        if node.function == "sign":
            return rf"\operatorname{{sgn}}\left({inside}\right)"
        if len(node.arguments) == 1:
            return rf"\{node.function}{self._argument(node.arguments[0])}"
        return rf"\operatorname{{{node.function}}}\left({inside}\right)"

    def _argument(self, node: Node) -> str:
        text = self(node)
        if isinstance(node, Name) and text.startswith("\\"):
            return " " + text
        return rf"\left({text}\right)"

    def _rate(self, inner: Node, order: int) -> str:
        if self.latex:
            power = f"^{order}" if order > 1 else ""
            return rf"\frac{{d{power}}}{{dt{power}}}\left({self(inner)}\right)"
        return f"diff({self(inner)}, t{f', {order}' if order > 1 else ''})"


def hidden_minus(node: Node) -> bool:
    """Whether a term has a minus sign, which stands before the place of the term."""
    return isinstance(node, Product) and any(
        isinstance(factor, Number) and factor.value == -1 and factor.end < 0
        for factor in node.factors
    )


def level_of(node: Node, text: str) -> int:
    """How tightly the text of a node holds together."""
    if text.startswith("-") or isinstance(node, Sum):
        return SUM
    if isinstance(node, Product) or "/" in text:
        return PRODUCT
    if isinstance(node, Number) and node.value.denominator != 1:
        return PRODUCT
    return POWER if isinstance(node, Power) else ATOM


def _split(node: Product) -> tuple[list[Node], list[Node], bool]:
    """Factors above and below the line, and whether there is a minus sign."""
    above: list[Node] = []
    below: list[Node] = []
    minus = False
    for factor in node.factors:
        if isinstance(factor, Number) and factor.value == -1:
            minus = not minus
        elif isinstance(factor, Power) and (constant(factor.exponent) or 0) < 0:
            number = -(constant(factor.exponent) or Fraction(1))
            base = factor.base
            below.append(base if number == 1 else Power(0, base, Number(0, number)))
        elif isinstance(factor, Number) and abs(factor.value.numerator) == 1 != factor.value:
            minus ^= factor.value < 0
            below.insert(0, Number(0, Fraction(factor.value.denominator)))
        else:
            above.append(factor)
    return above, below, minus


def balanced(text: str) -> bool:
    """Whether every bracket of a text is opened and closed in it."""
    depth = 0
    for character in text:
        depth += character in "([{"
        depth -= character in ")]}"
        if depth < 0:
            return False
    return depth == 0
