"""Lines of matrices entry by entry, as trees: a matrix that a person defines is its entries.

D q'' + g = tau    ->    D_11 q1'' + D_12 q2'' + g_1 = tau1,    with D_11 = ..., D_12 = ...

An entry that is a name itself stands for it.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce

from mechanics.claims.claim import Written
from mechanics.claims.tree import (
    COMPOSED,
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
    ended,
    names,
    negative,
    parts,
    total,
)

Rows = tuple[tuple[Node, ...], ...]
Cells = Node | Rows
"""A number, or the entries of a matrix."""


class NoEntriesError(Exception):
    """Matrices are used in a way that has no entries in a few terms: an inverse."""


@dataclass(frozen=True)
class Entrywise:
    """Takes matrices apart.

    Attributes
    ----------
    matrices : dict of str to Rows
        What the entries of the matrices that the person defines are called, or are.
    named : set of str
        Those that are called otherwise.
    """

    matrices: dict[str, Rows]
    named: set[str]

    def __call__(self, node: Node) -> Cells:
        """The entries of a node; itself where there is no matrix in it."""
        if not self._holds(node):
            return node
        match node:
            case Name(name=name, order=order):
                return _each(self.matrices[name], lambda cell: _rate(cell, order))
            case Table(rows=rows):
                return tuple(tuple(self._number(cell) for cell in row) for row in rows)
            case Sum(terms=terms):
                return _sum([self._standing(term) for term in terms])
            case Product(factors=factors):
                return _alone(reduce(_times, map(self, factors)))
            case Rate(of=inner, order=order):
                return _each(self(inner), lambda cell: _rate(cell, order))
            case Call(function="transpose", arguments=(only,)):
                cells = self(only)
                return cells if isinstance(cells, Node) else tuple(zip(*cells, strict=True))
            case Call(at=at, function="partial", arguments=(of, by)):
                inner, kind = self._number(of), type(node)
                return _each(self(by), lambda cell: kind(at, "partial", (inner, cell)))
            case Call(function=function, arguments=(of, index)) if function == ENTRY:
                cells = self(of)
                if isinstance(cells, Node):
                    raise NoEntriesError
                return [cell for row in cells for cell in row][int(constant(index) or 1) - 1]
            case Call(function="cross", arguments=(left, right)):
                return _crossed(self(left), self(right))
            case Call(function=function, arguments=arguments):
                return Call(COMPOSED, function, tuple(map(self._number, arguments)))
            case Power(base=base, exponent=exponent) if constant(exponent) == -1:
                cells = self(base)
                return Power(COMPOSED, cells, exponent) if isinstance(cells, Node) else _over(cells)
            case Power(base=base, exponent=exponent):
                return Power(COMPOSED, self._number(base), self._number(exponent))
        raise NoEntriesError

    def _standing(self, term: Node) -> Cells:
        """The entries of a term where it stands in the text: its sign can be another one."""

        def placed(cell: Node) -> Node:
            own = isinstance(cell, Name) and cell.name not in self.named
            return (
                cell if cell.at != COMPOSED or own else ended(replace(cell, at=term.at), term.end)
            )

        return _each(self(term), placed)

    def _holds(self, node: Node) -> bool:
        vectors = isinstance(node, Call) and node.function == "cross"
        if (
            vectors
            or isinstance(node, Table)
            or (isinstance(node, Name) and node.name in self.matrices)
        ):
            return True
        return any(map(self._holds, parts(node)))

    def _number(self, node: Node) -> Node:
        cells = self(node)
        if not isinstance(cells, Node):
            raise NoEntriesError
        return cells


def _each(cells: Cells, change: Callable[[Node], Node]) -> Cells:
    if isinstance(cells, Node):
        return change(cells)
    return tuple(tuple(map(change, row)) for row in cells)


def _rate(cell: Node, order: int) -> Node:
    if not order:
        return cell
    if isinstance(cell, Name):
        return Name(COMPOSED, cell.name, cell.order + order)
    return Rate(COMPOSED, cell, order)


def _sum(terms: Sequence[Cells]) -> Cells:
    """Entry by entry; a zero beside a matrix is the zero matrix."""
    numbers = [term for term in terms if isinstance(term, Node)]
    matrices = [term for term in terms if not isinstance(term, Node)]
    if not matrices:
        return Sum(COMPOSED, tuple(numbers))
    if any(constant(number) != 0 for number in numbers):
        raise NoEntriesError
    return tuple(
        tuple(total(COMPOSED, list(cells)) for cells in zip(*rows, strict=True))
        for rows in zip(*matrices, strict=True)
    )


def _times(one: Cells, two: Cells) -> Cells:
    if isinstance(one, Node):
        return _each(two, lambda cell: Product(COMPOSED, (one, cell)))
    if isinstance(two, Node):
        return _each(one, lambda cell: Product(COMPOSED, (cell, two)))
    columns = tuple(zip(*two, strict=True))

    def entry(row: Sequence[Node], column: Sequence[Node]) -> Node:
        pairs = zip(row, column, strict=True)
        return total(COMPOSED, [Product(COMPOSED, pair) for pair in pairs])

    return tuple(tuple(entry(row, column) for column in columns) for row in one)


def _crossed(one: Cells, two: Cells) -> Cells:
    """A vector product, or the product of numbers."""
    if isinstance(one, Node) or isinstance(two, Node):
        return _times(one, two)
    (a, b, c), (x, y, z) = ([cell for row in column for cell in row] for column in (one, two))

    def less(left: tuple[Node, Node], right: tuple[Node, Node]) -> tuple[Node]:
        return (Sum(COMPOSED, (Product(COMPOSED, left), negative(Product(COMPOSED, right)))),)

    return less((b, z), (c, y)), less((c, x), (a, z)), less((a, y), (b, x))


def _over(cells: Rows) -> Rows:
    """The inverse of a matrix of two rows or three: cofactors over the determinant."""
    size = len(cells)
    if size not in (2, 3) or any(len(row) != size for row in cells):
        raise NoEntriesError

    def minor(i: int, j: int) -> Node:
        rows = [
            [cell for k, cell in enumerate(row) if k != j] for row in (*cells[:i], *cells[i + 1 :])
        ]
        if size == 2:
            return rows[0][0]
        (a, b), (c, d) = rows
        crossed = Product(COMPOSED, (a, d)), negative(Product(COMPOSED, (b, c)))
        return Sum(COMPOSED, crossed)

    def cofactor(i: int, j: int) -> Node:
        return negative(minor(i, j)) if (i + j) % 2 else minor(i, j)

    first = [Product(COMPOSED, (cells[0][j], cofactor(0, j))) for j in range(size)]
    below = Power(COMPOSED, Sum(COMPOSED, tuple(first)), Number(COMPOSED, Fraction(-1)))
    places = range(size)
    return tuple(tuple(Product(COMPOSED, (cofactor(j, i), below)) for j in places) for i in places)


def _alone(cells: Cells) -> Cells:
    """The number that a product is: q'^T M q'."""
    return (
        cells if isinstance(cells, Node) or (len(cells), len(cells[0])) != (1, 1) else cells[0][0]
    )


def entrywise(written: Written) -> Written:
    """The same with numbers only: every matrix among definitions and sides is its entries.

    What cannot be taken apart stays as it is.
    """
    trees = (*written.sides, *(tree for _, tree in written.definitions))
    taken = {name.name for tree in trees for name in names(tree)}
    taken |= {name for name, _ in written.definitions}
    own = {name for name, _ in written.definitions} | _resting(written, trees)
    apart = Entrywise({}, set())
    definitions: list[tuple[str, Node]] = []
    try:
        for name, tree in written.definitions:
            cells = apart(tree)
            if isinstance(cells, Node):
                definitions.append((name, cells))
                continue
            apart.matrices[name] = rows = _called(name, cells, taken, own)
            found = list(_named(rows, cells))
            apart.named.update(called for called, _ in found)
            definitions += found
        sides = tuple(_side(apart(side)) for side in written.sides)
    except (NoEntriesError, ValueError):
        return written
    return replace(written, sides=sides, definitions=tuple(definitions))


def _resting(written: Written, trees: Sequence[Node]) -> set[str]:
    """Names of the scene's that nobody differentiates: parameters and inputs."""
    vocabulary = written.naming.vocabulary
    scene = vocabulary.scene
    still = {*scene.parameters, *scene.input_symbols}
    found = set[str]()
    for name in (name for tree in trees for name in names(tree) if not name.order):
        try:
            symbol = written.naming.symbol(name.name, 0)
        except KeyError:
            continue
        found |= {name.name} if symbol in still else set()
    return found


def _side(cells: Cells) -> Node:
    return cells if isinstance(cells, Node) else Table(0, cells)


def _called(name: str, cells: Rows, taken: set[str], defined: set[str]) -> Rows:
    """Names of the entries; an entry that is a name of the scene keeps it."""

    def called(i: int, j: int, cell: Node) -> Node:
        if isinstance(cell, Name) and cell.name not in defined:
            return Name(COMPOSED, cell.name, cell.order)
        place = str(i) if len(cells[0]) == 1 else f"{i}{j}" if max(i, j) < 10 else f"{i},{j}"
        own = f"{name}_{place}"
        return Name(COMPOSED, own if own not in taken else f"{name}({i},{j})")

    return tuple(
        tuple(called(i, j, cell) for j, cell in enumerate(row, 1)) for i, row in enumerate(cells, 1)
    )


def _named(called: Rows, cells: Rows) -> Iterator[tuple[str, Node]]:
    for one, two in zip(called, cells, strict=True):
        for name, cell in zip(one, two, strict=True):
            if isinstance(name, Name) and not (isinstance(cell, Name) and cell.name == name.name):
                yield name.name, cell
