"""Products of sines and cosines that a term may have, the simplest first.

1, sin a, cos a, sin a cos a, sin a cos b, ...        a, b: coordinates, their sums and differences
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, combinations_with_replacement

from mechanics.blame.search.edits import worth
from mechanics.blame.search.inverse_evaluation import Sheet
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.blame.search.words import Words
from mechanics.claims.kinds import angular
from mechanics.claims.tree import Call, Node, Number, Product, Sum

NOBODY = -1
"""Where twice a coordinate stands that nobody wrote."""

MOST_ANGLES = 12
MOST = 400


@dataclass(frozen=True)
class Circular:
    """A product of sines and cosines.

    Attributes
    ----------
    values : tuple of int
        Its residue at each point.
    """

    factors: tuple[Node, ...]
    values: tuple[int, ...]


def circular(tree: SyntaxTree, sheets: Sequence[Sheet], words: Words) -> tuple[Circular, ...]:
    """Products of at most two sines and cosines, one first."""
    p = sheets[0].point.prime
    known: dict[Node, tuple[int, ...]] = {}
    doubled: set[Node] = set()
    for angle in _angles(tree, sheets[0], words):
        for function in ("sin", "cos"):
            call = Call(0, function, (angle,))
            values = worth(sheets, call)
            if values is not None and all(values):
                known[call] = values
                # sin(x) cos(x) is likelier than sin(2 x), which nobody wrote.
                doubled |= {call} if isinstance(angle, Product) and angle.at == NOBODY else set()
    found = [Circular((call,), values) for call, values in known.items()]
    for (one, a), (two, b) in combinations_with_replacement(known.items(), 2):
        if len(found) >= MOST:
            break
        values = tuple(x * y % p for x, y in zip(a, b, strict=True))
        found.append(Circular((one, two), values))
    found.sort(key=lambda round_: bool(doubled.intersection(round_.factors)))
    return (Circular((), (1,) * len(sheets)), *found)


def _angles(tree: SyntaxTree, sheet: Sheet, words: Words) -> list[Node]:
    """Arguments that were written, coordinates, sums and differences of two."""
    found: list[Node] = []
    for node in tree.nodes:
        if isinstance(node, Call) and node.function in ("sin", "cos", "tan"):
            found += node.arguments
    found += list(_from_scene(words))
    kept: dict[int, Node] = {}
    for angle in found:
        value = sheet.opaque(angle)
        kept.setdefault(min(value, sheet.point.prime - value), angle)
    return list(kept.values())[:MOST_ANGLES]


def _from_scene(words: Words) -> Iterator[Node]:
    angles = angular(words.truth.scene)
    names = [word.name for word in words.symbols if word.symbol in angles]
    yield from names
    for one, two in combinations(names, 2):
        yield Sum(0, (one, Product(0, (Number(0, Fraction(-1)), two))))
        yield Sum(0, (one, two))
    for name in names:
        yield Product(NOBODY, (Number(0, Fraction(2)), name))
