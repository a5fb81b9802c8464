"""What a missing term may hold that does not grow as a power of a quantity that is doubled.

    M**2 R**3 theta_dot**2 / 4      mu_c g sign(x_dot)      m l theta_ddot / (I + m l**2)

Definitions, accelerations and reactions follow from the rest; signs and sums below a line stand as
they are. A term divided by one of these, or by two, grows as a power if it holds them.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations_with_replacement

from sympy import Symbol, sign

from mechanics.blame.search.change import raised
from mechanics.blame.search.edits import worth
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.words import Words
from mechanics.claims.tree import Call, Node, Number, Power, Sum, constant
from mechanics.scene.actions import frictions

MOST_DIVISORS = 3

Series = dict[Symbol | None, int]
"""A residue at the point, by None, and where each symbol is doubled."""

Grown = Mapping[Symbol | None, Problem]
"""A problem at these points."""


@dataclass(frozen=True, eq=False)
class Factor:
    """A product of nodes, and one over it at every point.

    Attributes
    ----------
    inverse : dict
        Residues of one over the product.
    """

    nodes: tuple[Node, ...]
    inverse: Series

    def out_of(self, series: Series, p: int) -> Series:
        """A series divided by the product."""
        return {symbol: value * self.inverse[symbol] % p for symbol, value in series.items()}


def factors(grown: Grown, words: Words, following: set[Symbol]) -> tuple[Factor, ...]:
    """None, one, or two of what was written; a sum below a line; nothing comes twice.

    Parameters
    ----------
    grown : mapping of Symbol or None to Problem
    following : set of Symbol
        What cannot be doubled.
    """
    p = grown[None].prime
    told = [word for word in words.symbols if word.symbol in following]
    written = {*words.held}
    singles = [(word.name, word) for word in told]
    known: dict[Node, Series] = {node: _inverse(grown, node) for node, _ in singles}
    likely: list[Node] = [
        name for name, word in singles if word.symbol in written or word.kind == HARDLY_TWICE
    ]
    accelerations = {name for name, word in singles if word.kind == HARDLY_TWICE}
    for call in _signs(grown[None], words):
        known[call] = _inverse(grown, call)
        likely.append(call)
    found = [Factor((), dict.fromkeys(grown, 1))]
    found += [Factor((node,), values) for node, values in known.items() if values]
    for one, two in combinations_with_replacement(likely, 2):
        a, b = known[one], known[two]
        if (
            a
            and b
            and not {one, two} <= accelerations
            and not (one == two and isinstance(one, Call))
        ):
            nodes = (raised(one, 2),) if one == two else (one, two)
            found.append(Factor(nodes, {s: a[s] * b[s] % p for s in a}))
    return (*found, *_divisors(grown))


HARDLY_TWICE = "acceleration"
"""The kind of word of which an equation of motion has no products."""


def _inverse(grown: Grown, node: Node) -> Series:
    """One over a node at every point; empty where it has none."""
    found: Series = {}
    for symbol, problem in grown.items():
        values = worth(problem.sheets[:1], node)
        if not values or not values[0]:
            return {}
        found[symbol] = pow(values[0], -1, problem.prime)
    return found


def _signs(problem: Problem, words: Words) -> Iterator[Node]:
    """Signs that were written, and those of the speeds at which friction slides."""
    scene = words.truth.scene
    found: dict[int, Node] = {}
    calls = [n for n in problem.tree.nodes if isinstance(n, Call) and n.function == "sign"]
    sliding = [words.written.tree(sign(scene.plain(load.sliding))) for load in frictions(scene)]
    for call in (*calls, *sliding):
        for value in worth(problem.sheets[:1], call) or ():
            found.setdefault(value, call)
    yield from found.values()


def _divisors(grown: Grown) -> Iterator[Factor]:
    """One over each sum below a line that was written."""
    tree = grown[None].tree
    known: set[int] = set()
    for index, node in enumerate(tree.nodes):
        exponent = constant(node.exponent) if isinstance(node, Power) else None
        below = tree.kids[index][0] if exponent is not None and exponent < 0 else index
        if below == index or not isinstance(tree.nodes[below], Sum):
            continue
        values = {symbol: problem.sheets[0].has[below] for symbol, problem in grown.items()}
        if values[None] not in known and len(known) < MOST_DIVISORS:
            known.add(values[None])
            inverse = Power(0, tree.nodes[below], Number(0, Fraction(-1)))
            yield Factor((inverse,), values)
