"""The values that nodes have at a point, and those that they have to have.

    needed(root) = target
    needed(term) = needed(sum) - other terms        needed(factor) = needed(product) / others
    needed(base of 1/x) = 1 / needed                needed(radicand) = needed ** 2

The terms below d/dt are worth their derivatives.

A node is right as something else if that is worth what is needed there.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from mechanics.blame.search.point import Point
from mechanics.blame.search.residues import others_of
from mechanics.blame.search.syntax_tree import SyntaxTree, is_root
from mechanics.claims.build import Builder
from mechanics.claims.tree import Name, Node, Number, Power, Product, Rate, Sum, constant
from mechanics.kernel.field import DivisionHere


class InsideHere(Exception):
    """What stands inside of a function is not known by its value; nobody outside of the search
    meets it.
    """


@dataclass(eq=False)
class Sheet:
    """Residues by the numbers of the nodes.

    Attributes
    ----------
    builder : Builder
        Makes expressions of nodes.
    target : int
        What the root has to be.
    needs : list of int or None
        None where that is not known, as inside of functions.
    squares : dict of int to int
        What the square of a node has to be.
    """

    tree: SyntaxTree
    point: Point
    builder: Builder
    target: int
    has: list[int]
    needs: list[int | None]
    squares: dict[int, int] = field(default_factory=dict)

    def opaque(self, node: Node) -> int:
        """The residue of a node as an expression."""
        return self.point.value(self.builder(node))

    def needed(self, index: int) -> list[int]:
        """What a node has to be; one of two below a square."""
        need, p = self.needs[index], self.point.prime
        if need is not None:
            return [need]
        square = self.squares.get(index)
        if square is None:
            return []
        try:
            root = root_of(square, p)
        except DivisionHere:
            return []
        return [root, p - root]

    def above(self, index: int, values: Mapping[int, int]) -> int:
        """What a node is worth when some parts of it have other values.

        Raises
        ------
        DivisionHere
            For a power of zero.
        InsideHere
            For a part inside of a function.
        """
        p, node, has = self.point.prime, self.tree.nodes[index], self.has
        kids = self.tree.kids[index]
        if isinstance(node, Sum):
            # A term may have been added to it.
            steps = (values[kid] - has[kid] for kid in kids if kid in values)
            return (has[index] + sum(steps)) % p
        if self.tree.opaque(index):
            raise InsideHere
        first, *others = (values.get(kid, has[kid]) for kid in kids)
        if isinstance(node, Product):
            for other in others:
                first = first * other % p
            return first
        if isinstance(node, Name | Rate):
            return first
        if isinstance(node, Power) and kids[1] in values:
            raise InsideHere
        if is_root(node):
            return root_of(first, p)
        exponent = integer_exponent(node)
        if exponent is None:
            raise InsideHere
        return power(first, exponent, p)

    def climb(self, child: int, value: int) -> Iterator[tuple[int, int]]:
        """Each node above one that has another value, and what it is worth then.

        Raises
        ------
        DivisionHere, InsideHere
            As `above`.
        """
        while (index := self.tree.parent[child]) >= 0:
            value, child = self.above(index, {child: value}), index
            yield child, value


def integer_exponent(node: Node) -> int | None:
    """The exponent of a power, where it is an integer."""
    if not isinstance(node, Power):
        return None
    number = constant(node.exponent)
    return int(number) if number is not None and number.denominator == 1 else None


def power(base: int, exponent: int, p: int) -> int:
    """A power of a residue.

    Raises
    ------
    DivisionHere
        For one divided by zero.
    """
    if exponent < 0 and base % p == 0:
        raise DivisionHere("division by zero")
    return pow(base, exponent, p)


def root_of(square: int, p: int) -> int:
    """The root of a residue that is a square itself.

    Raises
    ------
    DivisionHere
        For what has no root.
    """
    root = pow(square, (p + 1) // 4, p)
    if root * root % p != square % p:
        raise DivisionHere("no root")
    return root


def scaled(sheets: Sequence[Sheet], index: int, ratio: Fraction) -> tuple[int, ...]:
    """What a node is worth at each point, times a number."""
    p = sheets[0].point.prime
    factor = ratio.numerator * pow(ratio.denominator, -1, p)
    return tuple(sheet.has[index] * factor % p for sheet in sheets)


def sheet_of(tree: SyntaxTree, point: Point, builder: Builder, target: int) -> Sheet:
    """Values from the leaves up, and what is needed from the root down."""
    count = len(tree.nodes)
    sheet = Sheet(tree, point, builder, target, [0] * count, [None] * count)
    for index in reversed(range(count)):
        sheet.has[index] = _value(sheet, index)
    return _from_root(sheet)


def again(sheet: Sheet) -> Sheet:
    """What is needed where the nodes have other values."""
    needs: list[int | None] = [None] * len(sheet.has)
    return _from_root(replace(sheet, needs=needs, squares={}))


def _from_root(sheet: Sheet) -> Sheet:
    """What is needed from the root down; not where a node stands at several places."""
    tree = sheet.tree
    sheet.needs[0] = sheet.target % sheet.point.prime
    for index in range(len(tree.nodes)):
        if tree.kids[index]:
            _needed_below(sheet, index)
    for indices in tree.copies.values():
        if len(indices) > 1:
            for index in indices:
                sheet.needs[index] = None
    return sheet


def _value(sheet: Sheet, index: int) -> int:
    tree, p = sheet.tree, sheet.point.prime
    node, kids = tree.nodes[index], tree.kids[index]
    values = [sheet.has[kid] for kid in kids]
    if isinstance(node, Sum):
        return sum(values) % p
    if tree.opaque(index):
        return sheet.opaque(tree.as_told(index, node))
    if isinstance(node, Rate):
        return values[0]
    if isinstance(node, Product):
        total = 1
        for value in values:
            total = total * value % p
        return total
    if isinstance(node, Number):
        ratio = Fraction(node.value)
        return ratio.numerator * pow(ratio.denominator, -1, p) % p
    if isinstance(node, Name) and kids:
        return values[0]
    exponent = integer_exponent(node)
    if exponent is not None:
        return power(values[0], exponent, p)
    return sheet.opaque(node)


def _needed_below(sheet: Sheet, index: int) -> None:
    tree, p, has = sheet.tree, sheet.point.prime, sheet.has
    node, kids, need = tree.nodes[index], tree.kids[index], sheet.needs[index]
    if need is None:
        _squared_below(sheet, index)
        return
    if isinstance(node, Sum):
        for kid in kids:
            sheet.needs[kid] = (need - has[index] + has[kid]) % p
    elif tree.opaque(index):
        return
    elif isinstance(node, Rate):
        sheet.needs[kids[0]] = need
    elif isinstance(node, Product):
        for kid, others in zip(kids, others_of([has[kid] for kid in kids], p), strict=True):
            sheet.needs[kid] = need * pow(others, -1, p) % p if others else None
    elif isinstance(node, Name):
        sheet.needs[kids[0]] = need
    elif is_root(node):
        sheet.needs[kids[0]] = need * need % p
    elif isinstance(node, Power):
        exponent = constant(node.exponent)
        if exponent == 1:
            sheet.needs[kids[0]] = need
        elif exponent == -1 and need:
            sheet.needs[kids[0]] = pow(need, -1, p)
        elif exponent == 2:
            sheet.squares[kids[0]] = need


def _squared_below(sheet: Sheet, index: int) -> None:
    """What the squares of parts have to be, or the part below a root."""
    tree, p, has = sheet.tree, sheet.point.prime, sheet.has
    node, kids, square = tree.nodes[index], tree.kids[index], sheet.squares.get(index)
    if square is None:
        return
    if is_root(node):
        sheet.needs[kids[0]] = square
    elif isinstance(node, Name):
        sheet.squares[kids[0]] = square
    elif isinstance(node, Product):
        for kid, others in zip(kids, others_of([has[kid] for kid in kids], p), strict=True):
            if others:
                sheet.squares[kid] = square * pow(others, -2, p) % p
