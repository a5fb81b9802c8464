"""From the tree of the text grammar to nodes: sums, products, calls, derivatives.

x.diff(t, 2), Derivative(x(t), (t, 2)), diff(x, t, t), x''    ->    x with two dots
"""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple
from unicodedata import digit, numeric

from lark import Token, Tree

from mechanics.claims.arguments import at_one_time
from mechanics.claims.dimension import arguments, first_with_name
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.latex.item import rate_of
from mechanics.claims.lines import PRODUCT
from mechanics.claims.names import GREEK, Naming
from mechanics.claims.partials import partial_of
from mechanics.claims.place import Refused
from mechanics.claims.text.elements import element
from mechanics.claims.text.letters import plain
from mechanics.claims.text.side_by_side import BESIDE, TOGETHER
from mechanics.claims.tree import (
    Call,
    Name,
    Node,
    Number,
    Pointwise,
    Power,
    Product,
    Sum,
    Table,
    constant,
    ended,
    inverse,
    negative,
    parts,
    product,
    with_parts,
)

LONGEST_SPAN = 60
"""Entries of an array that are taken at once."""
DEEPEST = 300
"""Nesting of the parser's tree; that of brackets is limited by the nodes themselves."""
TIMES = ("t", "_t")
DERIVATIVES = ("Derivative", "diff", "D")
RATIONALS = ("Rational", "Integer", "Float", "S", "sympify", "Symbol")
MODELICA = "der"
FUNCTION = re.compile(r"([a-z]+)\W*(\d?)")
PERIODIC = ("sin", "cos")
SECOND = re.compile(r"d(?:\^?2|\u00b2)")
"""Of the second differential."""
INVERSE = "\u207b"
"""The sign of a negative power, above the line."""
INVERTED = ("inv", "pinv", "inverse")
MATRICES = ("Matrix", "ImmutableMatrix", "array", "vertcat", "asarray")


class Below(NamedTuple):
    """What a slash divides by: of ``/2L`` the name, too, and what stands beside it."""

    scaled: bool
    beside: bool


FIRST = Below(scaled=True, beside=False)
OTHERS = (Below(scaled=False, beside=True), Below(scaled=True, beside=True))
"""Other ways to read ``3g/2l + 3/ml^2``: 3 g l/2 and 3/(m l^2), 3 g/(2 l) and 3/(m l^2)."""


class Nodes:
    """Makes nodes of the parser's trees."""

    def __init__(
        self, naming: Naming, offset: int, notes: list[str], below: Below = FIRST,
        arrays: bool = False, state: bool = False, operators: Mapping[str, int] | None = None,
        columns: bool = False,
    ) -> None:  # fmt: skip
        self.naming, self.offset, self.notes, self.below = naming, offset, notes, below
        self.arrays, self.state, self.operators = arrays, state, operators or {}
        self.columns = columns
        self.slash = ""
        self.depth = 0

    def sides(self, statement: Tree) -> tuple[Node, ...]:
        """The sides of a statement."""
        children = list(statement.children)
        for child in children:
            if child.data == "equation":
                # A name that holds an equation, as ``eq1 = Eq(...)``, says nothing itself.
                children = list(child.children)
        return tuple(self.node(child) for child in children)

    def values(self, trees: Sequence[Tree]) -> list[Node] | None:
        """What ``a, b = c, d`` and ``s, c = sincos(x)`` give to the names; None for one array."""
        if len(trees) > 1:
            return [self.node(tree) for tree in trees]
        (tree,) = trees
        if tree.data != "call" or str(tree.children[0]) != TOGETHER:
            return None
        angle = self.node(tree.children[1].children[0])
        return [Call(angle.at, name, (angle,)) for name in PERIODIC]

    def node(self, tree: Tree) -> Node:
        """The node of a tree."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise Refused(self._at(tree), "nested too deeply")
        result: Node = getattr(self, tree.data)(tree, self._at(tree))
        self.depth -= 1
        if tree.data != "bracket" and not tree.meta.empty:
            ended(result, self.offset + int(tree.meta.end_pos))
        return result

    def span(self, tree: Tree, at: int) -> Node:
        """What stands around a colon is no number."""
        raise Refused(at, "a colon is out of place")

    def _at(self, tree: Tree) -> int:
        return self.offset + (0 if tree.meta.empty else int(tree.meta.start_pos))

    def add(self, tree: Tree, at: int) -> Node:
        """A sum; long ones are walked, not recursed into."""
        terms: list[Node] = []
        while isinstance(tree, Tree) and tree.data == "add":
            left, sign, right = tree.children
            term = self.node(right)
            terms.append(term if sign == "+" else negative(term))
            tree = left
        terms.append(self.node(tree))
        return Sum(at, tuple(reversed(terms)))

    def multiply(self, tree: Tree, at: int) -> Node:
        """A product or quotient, likewise."""
        factors: list[Node] = []
        beside: list[Tree] = []  # with no sign, behind the next operand to the left
        pointwise = False
        while isinstance(tree, Tree) and tree.data == "multiply":
            left, sign, right = tree.children
            tree = left
            if sign.type == BESIDE:
                beside.append(right)
                continue
            if sign == "\\":
                # MATLAB's A \ b is the inverse of A times b.
                rest = map(self.node, (right, *beside[::-1]))
                return Product(at, (inverse(self.node(left)), *rest, *factors[::-1]))
            pointwise = pointwise or self.arrays or "." in f"{_last(left)[-1:]}{sign}"
            if "/" in sign and beside:
                factors += self._below(right, beside[::-1])
            else:
                factors += map(self.node, beside)
                factors += self._divided(right) if "/" in sign else [self.node(right)]
            beside = []
        factors += map(self.node, (*beside, tree))
        return (Pointwise if pointwise else Product)(at, tuple(reversed(factors)))

    def _below(self, first: Tree, beside: list[Tree]) -> list[Node]:
        """What a slash divides by, and what stands beside it: ``a/b c`` may be a/(b c)."""
        words = " ".join(map(_word, (first, *beside)))
        self.slash = f"/{words} is /({words})"
        if not self.below.beside:
            self.notes.append(f"a/b c is read as (a/b) c: /{words}")
            return [*map(self.node, beside[::-1]), *self._divided(first)]
        below = [self.node(first), *map(self.node, beside)]
        return [inverse(product(below[0].at, below))]

    def _divided(self, tree: Tree) -> list[Node]:
        """What a slash divides by: ``/2L`` may be 1/(2 L), or L/2."""
        node = self.node(tree)
        if tree.data != "scaled" or not isinstance(node, Product):
            return [inverse(node)]
        words = f"{tree.children[0]}{_letters(tree.children[1])}"
        self.slash = f"/{words} is /{words[: len(tree.children[0])]} * {_letters(tree.children[1])}"
        if self.below.scaled:
            self.notes.append(f"/{words} is read as /({words})")
            return [inverse(node)]
        number, name = node.factors
        return [name, inverse(number)]

    def signed(self, tree: Tree, at: int) -> Node:
        """A factor with a sign."""
        sign, factor = tree.children
        node = self.node(factor)
        return node if sign == "+" else negative(node)

    def power(self, tree: Tree, at: int) -> Node:
        """base ** exponent."""
        base, sign, exponent = tree.children
        if sign != "**" and _is_power(exponent):
            raise Refused(at, "a^b^c: write the brackets: MATLAB takes (a^b)^c, others a^(b^c)")
        below, above = self.node(base), self.node(exponent)
        if (factor := _applied_to(base, below)) is not None:
            return _raised(at, factor, above)
        node = Power(at, below, above)
        inverted = constant(node.exponent) == -1 and (self.arrays or "." in sign)
        return Pointwise(at, (node,)) if inverted else node

    def superscripted(self, tree: Tree, at: int) -> Node:
        """A power in Unicode."""
        base, mark = tree.children
        exponent = Fraction("".join("-" if c == INVERSE else str(digit(c)) for c in mark))
        below, above = self.node(base), Number(at, exponent)
        factor = _applied_to(base, below)
        return Power(at, below, above) if factor is None else _raised(at, factor, above)

    def number(self, tree: Tree, at: int) -> Node:
        """A number, exactly as it is typed."""
        text = str(tree.children[0])
        if not text.isascii() and len(text) > 1:
            raise Refused(at, "a number of other digits than 0 to 9 is not read")
        if not text.isascii():
            return Number(at, Fraction(numeric(text)).limit_denominator(10))
        mantissa, _, exponent = text.lower().partition("e")
        if exponent and abs(int(exponent)) > 300:
            raise Refused(at, "the exponent of this number is too large")
        return Number(
            at,
            Fraction(mantissa + "0" if "." in mantissa else mantissa)
            * Fraction(10) ** int(exponent or 0),
        )

    def scaled(self, tree: Tree, at: int) -> Node:
        """A number before a name: ``2x^2`` is 2 (x^2)."""
        number, name = tree.children
        first = self.number(Tree("number", [number], tree.meta), at)
        ended(first, at + len(number))
        second = self.node(name)
        self.notes.append(f"{number} {_letters(name)} is read as a product")
        return Product(at, (first, second))

    def function(self, tree: Tree, at: int) -> Node:
        """A function without brackets: ``cos w t``; one with its power: ``sin^2(x)``."""
        token, *beside = tree.children
        name, power = FUNCTION.match(plain(str(token))[0]).groups()  # type: ignore[union-attr]
        factors = [self._timed(self.node(part)) for part in beside]
        count = (arguments(self.naming, factors) or [first_with_name(factors)])[0]
        node: Node = Call(at, name, (product(factors[0].at, factors[:count]),))
        if count > 1:
            words = " ".join(_letters(part) for part in beside[:count])
            self.notes.append(f"{name} {words} is read as {name}({words})")
        if power:
            node = Power(at, node, Number(at, Fraction(int(power))))
        return product(at, [node, *factors[count:]])

    def _timed(self, node: Node) -> Node:
        """In an argument ``wt`` is w t, where only w means something."""
        if isinstance(node, Product | Sum):
            new = tuple(map(self._timed, parts(node)))
            return node if new == parts(node) else ended(with_parts(node, new), node.end)
        if not isinstance(node, Name) or node.order or not node.name.endswith("t"):
            return node
        first = node.name[:-1]
        whole = self.naming.knows(node.name) or node.name in self.naming.own
        letter = len(first.rstrip("0123456789_")) == 1 or first in GREEK
        if whole or not first or not (letter or self.naming.knows(first)):
            return node
        self.notes.append(f"{node.name} {PRODUCT} {first} t")
        both = [Name(node.at, first), Name(node.at + len(first), "t")]
        return product(node.at, [ended(one, one.at + len(one.name)) for one in both])

    def bars(self, tree: Tree, at: int) -> Node:
        """An absolute value."""
        return Call(at, "abs", (self.node(tree.children[1]),))

    def indexed(self, tree: Tree, at: int) -> Node:
        """An entry of an array, ``u[1]``."""
        name, order = plain(str(tree.children[0]))
        given = tree.children[1].children
        if len(given) == 1 and given[0].data == "span" and not order:
            return self._sliced(name, given[0], "[]", at)
        inside = [self.node(part) for part in given]
        found = None if order else element(name, inside, "[]")
        if found is None:
            raise Refused(at, f"{name}[...] is no entry that is known here: write its number")
        return Name(at, found)

    def name(self, tree: Tree, at: int) -> Node:
        """A name."""
        return self._named(str(tree.children[0]), at)

    def _named(self, text: str, at: int) -> Node:
        name, order = plain(text)
        if name == "time" and order == 0 and not self.naming.knows(name):
            name = "t"  # Modelica's
        if name == "pi" and not self.naming.knows("pi"):
            return Call(at, "pi", ())
        if name in FUNCTIONS and not self.naming.knows(name):
            raise Refused(at, f"the argument of {name} is missing")
        return Name(at, name, order)

    def leibniz(self, tree: Tree, at: int) -> Node:
        """A rate as a quotient of differentials: dx/dt, d^2x/dt^2."""
        above, _, _ = str(tree.children[0]).partition("/")
        second = SECOND.match(above)
        name, order = plain(above[second.end() if second else 1 :])
        return Name(at, name, order + (2 if second else 1))

    def partial(self, tree: Tree, at: int) -> Node:
        """A quotient of partial differentials: \u2202L/\u2202q'."""
        above, below = (part.strip() for part in str(tree.children[0]).split("/"))
        of, order = plain(above[1:].strip())
        name, dots = plain(below[1:].strip().rstrip("'"))
        by = Name(at, name, dots + below.count("'"))
        return partial_of(self.naming, Name(at, of, order), by, at)

    def bracket(self, tree: Tree, at: int) -> Node:
        """A bracket around one expression."""
        if len(tree.children) != 1:
            raise Refused(at, "a comma is out of place")
        return self.node(tree.children[0])

    def primed(self, tree: Tree, at: int) -> Node:
        """A name with primes; behind anything else MATLAB means the transpose."""
        node = self.node(tree.children[0])
        if isinstance(node, Name):
            if str(tree.children[1]) == "'" and self._holds_no_coordinates(node.name):
                return Call(at, "transpose", (node,))
            if self.naming.is_function(node.name) is False:
                raise Refused(at, f"{node.name}' is the rate of a constant")
            return Name(at, node.name, node.order + len(tree.children[1]))
        return Call(at, "transpose", (node,))

    def _holds_no_coordinates(self, name: str) -> bool:
        """Whether a name is a column of the person's own of which a prime is no rate."""
        own = self.naming.own.get(name)
        if not isinstance(own, Table):
            return False
        cells = [cell for row in own.rows for cell in row]
        found = [self.naming.lookup(c.name) for c in cells if isinstance(c, Name) and not c.order]
        return len(found) < len(cells) or not all(
            target and target[1] == 0 and self.naming.is_function(target[0]) for target in found
        )

    def transposed(self, tree: Tree, at: int) -> Node:
        """A transposed matrix."""
        return Call(at, "transpose", (self.node(tree.children[0]),))

    def matrix(self, tree: Tree, at: int) -> Node:
        """A matrix of MATLAB, or a list of lists."""
        if not tree.children:
            raise Refused(at, "an empty matrix")
        (rows,) = tree.children
        cells = [[self.node(cell) for cell in row.children] for row in rows.children]
        if len(cells) == len(cells[0]) == 1 and not isinstance(cells[0][0], Name | Number | Table):
            return cells[0][0]  # MATLAB: [a + b]/[c + d]
        if len(cells) == 1 and all(isinstance(cell, Table) for cell in cells[0]):
            inner = [cell for cell in cells[0] if isinstance(cell, Table)]
            if all(len(table.rows) == 1 for table in inner):
                return Table(at, tuple(table.rows[0] for table in inner))
        if self.columns and len(cells) == 1:
            cells = [[cell] for cell in cells[0]]
        return Table(at, tuple(tuple(row) for row in cells))

    def differentiated(self, tree: Tree, at: int) -> Node:
        """``x.diff(t, 2)`` and ``x.dt()``."""
        inner, _, *rest = tree.children
        arguments = list(rest[0].children) if rest else []
        return self._derivative(self.node(inner), arguments, at)

    def _derivative(self, node: Node, by: list[Tree], at: int) -> Node:
        name = self.node(by[0]) if len(by) == 1 and by[0].data != "bracket" else None
        if isinstance(name, Name) and name.name not in TIMES and self.naming.target(name.name):
            return partial_of(self.naming, node, name, at)
        order = 0
        for tree in by:
            pair = tree.children if tree.data == "bracket" else [tree]
            parts = [self.node(part) for part in pair]
            if len(parts) == 1 and constant(parts[0]) is not None and order:
                order += int(constant(parts[0]) or 0) - 1
                continue
            if not (isinstance(parts[0], Name) and parts[0].name in TIMES):
                raise Refused(at, "a derivative is by the time t")
            order += int(constant(parts[1]) or 0) if len(parts) == 2 else 1
        order = order if by else 1
        if not 1 <= order <= 3:
            raise Refused(at, f"a derivative of order {order}: 1, 2 or 3 can be taken")
        return rate_of(node, order, at)

    def call(self, tree: Tree, at: int) -> Node:
        """A function of the whitelist, a function of time, or a product."""
        token, *rest = tree.children
        name, order = plain(str(token))
        if name.isupper() and name.lower() in FUNCTIONS and not self.naming.knows(name):
            name = name.lower()  # Fortran's
        given = list(rest[0].children) if rest else []
        if name in FUNCTIONS and not self.naming.knows(name):
            if order:
                raise Refused(at, f"a dot above {name} is not read")
            least, most, _ = FUNCTIONS[name]
            if not least <= len(given) <= most:
                raise Refused(at, f"{name} with {len(given)} arguments")
            inside = tuple(self.node(part) for part in given)
            periodic = name in PERIODIC and len(inside) == 1
            return Call(at, name, (self._timed(inside[0]),) if periodic else inside)
        if name in DERIVATIVES and given and not self.naming.knows(name):
            return self._derivative(self.node(given[0]), given[1:], at)
        if name in RATIONALS and given and not (name == "S" and self.state):
            return self._rational(name, given, at)
        if name in INVERTED and len(given) == 1 and not self.naming.knows(name):
            return inverse(self.node(given[0]))
        if name in MATRICES and len(given) == 1:
            return self._column(self.node(given[0]), name)
        if name in self.operators and len(given) == 1:
            return rate_of(self.node(given[0]), self.operators[name], at)
        if name == MODELICA and len(given) == 1 and not self.naming.knows(name):
            return rate_of(self.node(given[0]), 1, at)
        if len(given) == 1 and given[0].data == "span":
            return self._sliced(name, given[0], "()", at)
        entry = None if order or self.naming.is_function(name) is False else (
            element(name, [self.node(part) for part in given])
        )  # fmt: skip
        if entry is not None:
            return Name(at, entry)
        if len(given) != 1:
            raise Refused(at, f"the function {name} is not supported")
        return self._applied(name, order, given[0], at)

    def _sliced(self, name: str, span: Tree, brackets: str, at: int) -> Table:
        """Entries ``x(1:2)`` as a column, the last one too; of ``x[0:2]`` not."""
        last = 2 * len(self.naming.vocabulary.scene.q)
        ends = [_letters(part) if part.data == "name" else constant(self.node(part))
                for part in span.children]  # fmt: skip
        first, end = (last if value == "end" else value for value in ends)
        if isinstance(first, str) or isinstance(end, str) or first is None or end is None:
            raise Refused(
                at, f"which entries of {name} are meant is not known: write their numbers"
            )
        stop = int(end) + (first != 0)
        found = [
            element(name, [Number(at, Fraction(i))], brackets) for i in range(int(first), stop)
        ]
        if not found or len(found) > LONGEST_SPAN or None in found:
            raise Refused(at, f"{name} has no such entries")
        return Table(at, tuple((Name(at, entry),) for entry in found if entry))

    def _applied(self, name: str, order: int, given: Tree, at: int) -> Node:
        inside = self.node(given)
        of_time = isinstance(inside, Name) and inside.name in ("t", "_t") and not inside.order
        moving = self.naming.is_function(name)
        if of_time and moving is not False and not self.naming.knows("t"):
            return Name(at, name, order, True)
        if moving:
            at_one_time(self.naming, Name(at, name, order), inside)
        if moving is None:
            raise Refused(at, f"the function {name} is not supported")
        self.notes.append(f"{name}(...) is read as a product: {name} is no function")
        return Product(at, (Name(at, name, order), inside))

    def _rational(self, name: str, given: list[Tree], at: int) -> Node:
        parts = [self.node(part) for part in given]
        values = [constant(part) for part in parts]
        if len(parts) == 1:
            return parts[0]
        if len(parts) != 2 or None in values or not values[1]:
            raise Refused(at, f"{name} takes two numbers")
        return Product(at, (parts[0], inverse(parts[1])))

    def _column(self, node: Node, name: str) -> Node:
        """A plain list given to Matrix is a column."""
        if (
            isinstance(node, Table)
            and len(node.rows) == 1
            and name in ("Matrix", "ImmutableMatrix")
        ):
            return Table(node.at, tuple((cell,) for cell in node.rows[0]))
        return node


def _is_power(exponent: Tree) -> bool:
    """Whether an exponent without brackets is a power itself, signs aside."""
    while exponent.data == "signed":
        exponent = exponent.children[1]
    return bool(exponent.data == "power")


def _applied_to(tree: Tree, node: Node) -> Product | None:
    """The product that ``M(x + 1)`` is: in its square only the bracket is raised."""
    return node if tree.data == "call" and isinstance(node, Product) else None


def _raised(at: int, below: Product, above: Node) -> Node:
    name, bracket = below.factors
    return Product(at, (name, Power(bracket.at, bracket, above)))


def _last(tree: Tree | Token) -> str:
    """The token that a tree ends with: of ``1./M`` it is the number that has the dot."""
    while isinstance(tree, Tree) and tree.children:
        tree = tree.children[-1]
    return str(tree) if isinstance(tree, Token) else ""


def _word(tree: Tree | Token) -> str:
    """A factor in a note."""
    return "(...)" if isinstance(tree, Tree) and tree.data == "bracket" else _letters(tree)


def _letters(tree: Tree | Token) -> str:
    """The name that a tree begins with."""
    return str(tree) if isinstance(tree, Token) else _letters(tree.children[0])
