"""Whether edits make a statement right at its points: the quick look before the proof.

    sum of weight * (root with the edits - target) = 0

One point with weight one; for what is known up to a constant two states, one less the other.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import (
    InsideHere,
    Sheet,
    integer_exponent,
    power,
    root_of,
)
from mechanics.blame.search.point import Point
from mechanics.blame.search.syntax_tree import Forest, is_root
from mechanics.claims.tree import Name, Power, Product, Rate, Sum
from mechanics.kernel.field import DivisionHere


@dataclass(frozen=True, eq=False)
class Problem:
    """One equality that does not hold.

    Attributes
    ----------
    forest : Forest
    numbers : tuple of int
        Of the entries that are compared.
    sheets : tuple of Sheet
        One, or two that are subtracted.
    target : callable
        What the root has to be at a point.
    """

    forest: Forest
    numbers: tuple[int, ...]
    sheets: tuple[Sheet, ...]
    target: Callable[[Point], int]

    @property
    def prime(self) -> int:
        """The modulus."""
        return self.sheets[0].point.prime

    @property
    def plain(self) -> bool:
        """Whether one point tells all, so that what nodes need is known."""
        return len(self.sheets) == 1

    @property
    def residual(self) -> int:
        """What should be zero."""
        return self._difference([sheet.has[0] for sheet in self.sheets])

    def _difference(self, roots: Sequence[int]) -> int:
        off = [root - sheet.target for root, sheet in zip(roots, self.sheets, strict=True)]
        return (off[0] - (off[1] if len(off) > 1 else 0)) % self.prime

    def mends(self, change: Change) -> bool:
        """Whether one edit makes the statement right."""
        if self.plain and self.forest.single(change.at):
            need = self.sheets[0].needs[change.at]
            if need is not None:
                return change.values[0] == need
        return self.together([change])

    def together(self, changes: Iterable[Change]) -> bool:
        """Whether several edits do."""
        chosen = list(changes)
        roots = []
        for k, sheet in enumerate(self.sheets):
            new: dict[int, int] = {}
            for change in chosen:
                for copy in self.forest.copies[self.forest.place[change.at]]:
                    new[copy] = change.values[k]
            try:
                roots.append(root_with(sheet, new))
            except (DivisionHere, InsideHere):
                return False
        return self._difference(roots) == 0

    def slopes(self, index: int) -> list[int] | None:
        """How the root grows with a node at each point; None where that is no straight line."""
        found = []
        for sheet in self.sheets:
            has, root, p = sheet.has[index], sheet.has[0], self.prime
            try:
                one, two = (root_with(sheet, {index: has + step}) for step in (1, 2))
            except (DivisionHere, InsideHere):
                return None
            if (two - one - one + root) % p:
                return None
            found.append((one - root) % p)
        return found


def root_with(sheet: Sheet, new: Mapping[int, int]) -> int:
    """What the root is worth when some nodes have other values.

    Raises
    ------
    DivisionHere
        Where a divisor becomes zero.
    InsideHere
        Where one of the nodes stands inside of a function.
    """
    values = dict(new)
    open_nodes = {sheet.forest.parent[index] for index in values} - {-1}
    while open_nodes:
        index = max(open_nodes)  # what stands below has a larger number
        open_nodes.remove(index)
        values[index] = _again(sheet, index, values)
        above = sheet.forest.parent[index]
        if above >= 0:
            open_nodes.add(above)
    return values.get(0, sheet.has[0])


def _again(sheet: Sheet, index: int, values: Mapping[int, int]) -> int:
    node, kids, p = sheet.forest.nodes[index], sheet.forest.kids[index], sheet.point.prime
    if isinstance(node, Sum):
        # A term may have been added to it.
        steps = (values[kid] - sheet.has[kid] for kid in kids if kid in values)
        return (sheet.has[index] + sum(steps)) % p
    parts = [values.get(kid, sheet.has[kid]) for kid in kids]
    if sheet.forest.opaque(index):
        raise InsideHere
    if isinstance(node, Product):
        total = 1
        for part in parts:
            total = total * part % p
        return total
    if isinstance(node, Name | Rate):
        return parts[0]
    if is_root(node):
        return root_of(parts[0], p)
    exponent = integer_exponent(node)
    if isinstance(node, Power) and exponent is not None and kids[1] not in values:
        return power(parts[0], exponent, p)
    raise InsideHere
