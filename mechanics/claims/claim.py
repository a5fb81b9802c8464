"""What a person wrote, as trees, beside the row of the ledger that was made of it.

row.sides  =  build(trees)        so that an edited tree makes an edited row
"""

from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from sympy import Expr, ImmutableMatrix, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.build import Builder, Value
from mechanics.claims.from_sympy import tree_of
from mechanics.claims.names import Naming
from mechanics.claims.tree import COMPOSED, Name, Node, Number, Power, Table, names, parts
from mechanics.errors import MechanicsError
from mechanics.scene.published import Published
from mechanics.scene.symbols import DOTS
from mechanics.symbolic import is_zero

Trees = tuple[Node, ...]


@dataclass(frozen=True, eq=False)
class Written:
    """What a statement was read from.

    Attributes
    ----------
    sides : tuple of Node
        Of the line; a line of matrices makes several statements.
    definitions : tuple of (str, Node)
        The person's own, in order, each with what may stand in those that follow.
    naming : Naming
        What the names in the trees mean.
    notation : str
        ``"latex"``, ``"text"`` or ``"code"``.
    text : str
        In which the places of the nodes count; empty where they have none.
    start : int
        Where the statement begins in it.
    put : mapping of Symbol to Expr
        What stands for symbols of the scene in all expressions that are made of the trees.
    places : mapping of str to str
        Where definitions stand, by their names: ``cart.py, line 12``.
    """

    sides: Trees
    definitions: tuple[tuple[str, Node], ...]
    naming: Naming
    notation: str
    text: str
    start: int = 0
    put: Mapping[Symbol, Expr] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)

    def builder(self) -> Builder:
        """Makes expressions of the trees."""
        known: dict[str, Value] = {}
        builder = Builder(self.naming, known, {}, dict(self.definitions), put=self.put)
        for name, tree in self.definitions:
            known[name] = builder(tree)
        return builder

    @cached_property
    def named(self) -> dict[Symbol, Name]:
        """How the person writes symbols: as they stand in the trees, or as names were given."""
        own = dict(self.definitions)
        found: dict[Symbol, Name] = {}
        self._keep_all(found, self.sides, own)
        # A definition that only renames is the name that is used: omega in der(theta) = omega.
        for alias, tree in self.definitions:
            symbol = self._symbol(tree) if isinstance(tree, Name) and tree.name not in own else None
            if symbol is not None:
                found.setdefault(symbol, Name(0, alias))
        self._keep_all(found, own.values(), own)
        given = (*self.naming.given, *(match.name for match in self.naming.guessed))
        # A name itself first; theta'' is that of theta, not the rate of a name of theta'.
        for order in (0, *range(2, len(DOTS)), 1):
            for own_name in given:
                self._keep(found, Name(0, own_name, order))
        return found

    def _keep_all(
        self, found: dict[Symbol, Name], trees: Iterable[Node], own: Container[str]
    ) -> None:
        for tree in trees:
            for name in names(tree):
                if name.name not in own:
                    self._keep(found, name)

    def _keep(self, found: dict[Symbol, Name], name: Name) -> None:
        symbol = self._symbol(name)
        if symbol is not None:
            found.setdefault(symbol, name)

    def _symbol(self, name: Name) -> Symbol | None:
        try:
            return self.naming.symbol(name.name, name.order)
        except KeyError:
            return None  # a parameter has no rates

    def name_of(self, symbol: Symbol) -> Name:
        """The person's name of a symbol; the scene's own where there is none."""
        if symbol in self.named:
            return self.named[symbol]
        base, order = self.naming.vocabulary.lookup(symbol.name) or (symbol.name, 0)
        known = self.named.get(Symbol(base, real=True))
        return Name(0, known.name if known is not None else base, order)

    def tree(self, expression: Expr) -> Node:
        """An expression in plain symbols as the person would write it.

        Raises
        ------
        Untreeable
            Where it holds what the trees do not know.
        """
        return tree_of(expression, self.name_of)


def row_trees(row: Published, written: Written) -> Trees:
    """Trees of the entries that a row compares: one for each side, matrices entry by entry.

    What the row holds beyond what was written (a zero, what products of matrices come to) gets the
    tree of its expression.

    Raises
    ------
    Untreeable
        Where an entry holds what the trees do not know.
    """
    entries = [e for side in row.sides for e in (side if isinstance(side, MatrixBase) else [side])]
    builder = written.builder()
    known: list[tuple[Expr, Node]] = []
    for side in written.sides:
        for tree in _cells(side, dict(written.definitions)):
            value = builder(tree)
            if not isinstance(value, MatrixBase) and not _through_matrices(tree, builder):
                known.append((value, tree))
                # Of a frequency its square is compared.
                known.append((value**2, Power(COMPOSED, tree, Number(0, Fraction(2)))))
    return tuple(_tree(entries, i, known, written) for i in range(len(entries)))


def _through_matrices(tree: Node, builder: Builder) -> bool:
    """Whether a number is made of matrices, whose parts are worth no numbers: q'^T M q'."""
    if isinstance(tree, Table):
        return True
    if isinstance(tree, Name):
        return isinstance(builder.defined.get(tree.name), MatrixBase)
    return any(_through_matrices(part, builder) for part in parts(tree))


def _cells(side: Node, definitions: Mapping[str, Node]) -> Trees:
    """A side, or the entries of the matrix that it is."""
    if isinstance(side, Name) and isinstance(definitions.get(side.name), Table):
        side = definitions[side.name]
    return tuple(cell for row in side.rows for cell in row) if isinstance(side, Table) else (side,)


def _tree(entries: list[Expr], i: int, known: list[tuple[Expr, Node]], written: Written) -> Node:
    """The tree of an entry; of several that are equal each has its own place in the text."""
    entry = entries[i]
    alike = [tree for value, tree in known if value == entry]
    if not alike and entry != 0:  # tan as sin/cos, a factor that cancels
        alike = [tree for value, tree in known if _equal(value, entry)]
    if not alike:
        return Number(0, Fraction(0)) if entry == 0 else written.tree(entry)
    if len(alike) == entries.count(entry):
        return alike[entries[:i].count(entry)]
    # The last one: in E_k = m v**2 / 2 the formula, not the name that it has from here on.
    return alike[-1]


def _equal(one: Expr, other: Expr) -> bool:
    try:
        return bool(is_zero(one - other))
    except MechanicsError:
        return False


def row_of(row: Published, written: Written, trees: Trees) -> Published:
    """A row with other trees for its entries.

    Raises
    ------
    Refused
        For what has no finite value.
    """
    builder = written.builder()
    entries = iter(trees)
    sides: list[Any] = []
    for side in row.sides:
        if isinstance(side, MatrixBase):
            sides.append(ImmutableMatrix(*side.shape, [builder(next(entries)) for _ in side]))
        else:
            sides.append(builder(next(entries)))
    return replace(row, sides=tuple(sides))
