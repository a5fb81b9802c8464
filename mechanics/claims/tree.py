"""What a person wrote, as a tree: numbers, names with dots, sums, products, powers, functions.

    size of a product = sum of sizes      size of a power = size * |exponent|

The size bounds the degree and the digits of whatever the tree is expanded into; it, the depth and
the number of nodes are limited while the tree grows, so that nothing large is ever built.
"""

from dataclasses import dataclass, field
from fractions import Fraction

from mechanics.claims.place import Refused

LARGEST = 2048
"""Size: the degree in all symbols together, or the bits of a number."""

COMPOSED = -1
"""Where a node begins that nobody wrote: an entry of a product of matrices."""

DEEPEST = 80
LARGEST_EXPONENT = 64
ENTRY = "entry"
"""The function of a matrix and a number."""


@dataclass(frozen=True)
class Node:
    """Base of the nodes.

    Attributes
    ----------
    at : int
        Where it begins in the text.
    end : int
        Where it ends there, without the brackets around it; -1 where that is not known.
    size, depth : int
        See the module.
    """

    at: int
    end: int = field(init=False, default=-1, compare=False)
    size: int = field(init=False, default=1, compare=False)
    depth: int = field(init=False, default=1, compare=False)

    def _limit(self, size: int, parts: "tuple[Node, ...]") -> None:
        depth = 1 + max((part.depth for part in parts), default=0)
        if size > LARGEST:
            raise Refused(self.at, "too large: powers and products are limited to degree 2048")
        if depth > DEEPEST:
            raise Refused(self.at, f"nested too deeply: {DEEPEST} levels are the limit")
        object.__setattr__(self, "end", max((part.end for part in parts), default=self.end))
        object.__setattr__(self, "size", max(1, size))
        object.__setattr__(self, "depth", depth)


@dataclass(frozen=True)
class Number(Node):
    """A number as it was typed, exactly."""

    value: Fraction

    def __post_init__(self) -> None:
        top = max(abs(self.value.numerator), self.value.denominator)
        self._limit(top.bit_length(), ())


@dataclass(frozen=True)
class Name(Node):
    """A name, without its dots; `order` is the number of dots.

    `bracket` says that ``(t)`` stood behind it, and `given` what else it is said to depend on.
    `primes` are those of its dots that are written as primes, and need not be by time.
    """

    name: str
    order: int = 0
    bracket: bool = False
    given: tuple[str, ...] = field(default=(), compare=False)
    primes: int = field(default=0, compare=False)


@dataclass(frozen=True)
class Sum(Node):
    """A sum of terms."""

    terms: tuple[Node, ...]

    def __post_init__(self) -> None:
        self._limit(max(term.size for term in self.terms), self.terms)


@dataclass(frozen=True)
class Product(Node):
    """A product of factors, in their order."""

    factors: tuple[Node, ...]

    def __post_init__(self) -> None:
        self._limit(sum(factor.size for factor in self.factors), self.factors)


class Pointwise(Product):
    """A product entry by entry, ``a .* b``: of numbers it is a product, of matrices not."""


@dataclass(frozen=True)
class Power(Node):
    """base ** exponent."""

    base: Node
    exponent: Node

    def __post_init__(self) -> None:
        number = constant(self.exponent)
        factor = 1 if number is None else max(1, -(-abs(number.numerator) // number.denominator))
        if factor > LARGEST_EXPONENT or (number is not None and number.denominator > 64):
            raise Refused(
                self.exponent.at,
                f"the exponent is too large: {LARGEST_EXPONENT} is the limit",
            )
        self._limit(self.base.size * factor + self.exponent.size, (self.base, self.exponent))


@dataclass(frozen=True)
class Call(Node):
    """A function of the whitelist."""

    function: str
    arguments: tuple[Node, ...]

    def __post_init__(self) -> None:
        self._limit(sum(part.size for part in self.arguments), self.arguments)


class Total(Call):
    """A derivative by a name with an upright d, ``dT/dx``: partial, or along the motion."""


@dataclass(frozen=True)
class Rate(Node):
    """The time derivative of an expression, `order` times."""

    of: Node
    order: int = 1

    def __post_init__(self) -> None:
        if not 0 < self.order <= 3:
            raise Refused(self.at, f"a derivative of order {self.order}: 1, 2 or 3 can be taken")
        self._limit(self.of.size * 2**self.order, (self.of,))


@dataclass(frozen=True)
class Table(Node):
    """A matrix, row by row."""

    rows: tuple[tuple[Node, ...], ...]

    def __post_init__(self) -> None:
        cells = tuple(cell for row in self.rows for cell in row)
        if len({len(row) for row in self.rows}) > 1:
            raise Refused(self.at, "the rows of this matrix are not equally long")
        self._limit(max((cell.size for cell in cells), default=1), cells)


def ended(node: Node, end: int) -> Node:
    """The node, which a parser has just made, with the place where it ends."""
    object.__setattr__(node, "end", end)
    return node


def move(node: Node, by: int) -> None:
    """Count the places of a tree, which a parser has just made, from further on."""
    if not by:
        return
    seen: set[int] = set()
    todo = [node]
    while todo:
        here = todo.pop()
        if id(here) in seen:
            continue
        seen.add(id(here))
        object.__setattr__(here, "at", here.at + by)
        object.__setattr__(here, "end", here.end + by if here.end >= 0 else -1)
        todo += parts(here)


def parts(node: Node) -> tuple[Node, ...]:
    """What a node is made of, in order."""
    match node:
        case Sum(terms=inner) | Product(factors=inner) | Call(arguments=inner):
            return inner
        case Power(base=base, exponent=exponent):
            return base, exponent
        case Rate(of=of):
            return (of,)
        case Table(rows=rows):
            return tuple(cell for row in rows for cell in row)
    return ()


def with_parts(node: Node, new: tuple[Node, ...]) -> Node:
    """A node of the same kind with other parts; it stands where the old one stood."""
    match node:
        case Sum() | Product():
            empty = Number(node.at, Fraction(0 if isinstance(node, Sum) else 1))
            if len(new) < 2:
                return new[0] if new else empty
            return type(node)(node.at, new)
        case Power():
            return Power(node.at, *new)
        case Call(function=function):
            return type(node)(node.at, function, new)
        case Rate(order=order):
            return Rate(node.at, new[0], order)
        case Table(rows=rows):
            width = len(rows[0])
            return Table(node.at, tuple(new[i : i + width] for i in range(0, len(new), width)))
    return node


def constant(node: Node) -> Fraction | None:
    """The rational number that a node is, if it is one without further ado."""
    if isinstance(node, Number):
        return node.value
    if isinstance(node, Product):
        total = Fraction(1)
        for factor in node.factors:
            value = constant(factor)
            if value is None:
                return None
            total *= value
        return total
    if isinstance(node, Power) and constant(node.exponent) == -1:
        value = constant(node.base)
        return 1 / value if value else None
    return None


def negative(node: Node) -> Node:
    """The node with the other sign."""
    return Product(node.at, (Number(node.at, Fraction(-1)), node))


def inverse(node: Node) -> Node:
    """1 / node."""
    if constant(node) == 0:
        raise Refused(node.at, "a division by zero")
    return Power(node.at, node, Number(node.at, Fraction(-1)))


def product(at: int, factors: list[Node]) -> Node:
    """A product, or its only factor."""
    return factors[0] if len(factors) == 1 else Product(at, tuple(factors))


def total(at: int, terms: list[Node]) -> Node:
    """A sum, or its only term."""
    return terms[0] if len(terms) == 1 else Sum(at, tuple(terms))


def names(node: Node) -> list[Name]:
    """Every name in a tree, in order."""
    if isinstance(node, Name):
        return [node]
    return [name for part in parts(node) for name in names(part)]
