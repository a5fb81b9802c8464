"""Whether edits make a statement right at its points: the quick look before the proof.

    sum of weight * (root with the edits - target) = 0

One point with weight one; for what is known up to a constant two states, one less the other.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import InsideHere, Sheet
from mechanics.blame.search.point import Point
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.kernel.field import DivisionHere


@dataclass(frozen=True, eq=False)
class Problem:
    """One equality that does not hold.

    Attributes
    ----------
    tree : SyntaxTree
    numbers : tuple of int
        Of the entries that are compared.
    sheets : tuple of Sheet
        One, or two that are subtracted.
    target : callable
        What the root has to be at a point.
    """

    tree: SyntaxTree
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
        if self.plain and self.tree.single(change.at):
            need = self.sheets[0].needs[change.at]
            if need is not None:
                return change.values[0] == need
        return self.together([change])

    def together(self, changes: Iterable[Change]) -> bool:
        """Whether several edits do."""
        try:
            return self.residual_with(changes) == 0
        except (DivisionHere, InsideHere):
            return False

    def residual_with(self, changes: Iterable[Change]) -> int:
        """What should be zero, with edits at all copies of their nodes.

        Raises
        ------
        DivisionHere, InsideHere
            Where that is not known.
        """
        places = [(self.tree.copies[self.tree.place[c.at]], c) for c in changes]
        news = (
            {copy: change.values[k] for copies, change in places for copy in copies}
            for k in range(len(self.sheets))
        )
        return self._difference(
            [root_with(sheet, new) for sheet, new in zip(self.sheets, news, strict=True)]
        )

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
    open_nodes = {sheet.tree.parent[index] for index in values} - {-1}
    while open_nodes:
        index = max(open_nodes)  # what stands below has a larger number
        open_nodes.remove(index)
        values[index] = sheet.above(index, values)
        above = sheet.tree.parent[index]
        if above >= 0:
            open_nodes.add(above)
    return values.get(0, sheet.has[0])
