"""Terms that a square may lack: those that stand in the other squares, and their like.

(l_1 theta_1' cos(theta_1))**2  ->  (l_1 theta_1' cos(theta_1) + l_2 theta_2' cos(theta_2))**2

The components of a velocity have the same terms, with sines for cosines.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import ADDED, HINT, Change, minus, plus, size_of, times
from mechanics.blame.search.edits import worth
from mechanics.blame.search.inverse_evaluation import integer_exponent
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.claims.tree import Call, Node, Number, Sum, parts, with_parts

NUMBERS = (Fraction(1), Fraction(1, 2), Fraction(2))

MOST = 24
"""Terms of squares that are looked at."""

OTHER = {"sin": "cos", "cos": "sin"}


def borrowed(problem: Problem) -> Iterator[Change]:
    """Terms of other squares added in each square."""
    tree, p = problem.tree, problem.prime
    squares = [index for index in range(len(tree.nodes)) if _squared(problem, index)]
    known = _terms(problem, squares)
    for index in squares:
        node = tree.nodes[index]
        has = [sheet.has[index] for sheet in problem.sheets]
        held = {v for part in tree.kids[index] for v in _either(problem, part)}
        for term, worths in known:
            if worths[0] in held:
                continue
            for number in NUMBERS:
                scale = number.numerator * pow(number.denominator, -1, p)
                scaled = term if number == 1 else times(Number(0, number), term)
                for sign, added in ((1, scaled), (-1, minus(scaled))):
                    sums = tuple(
                        (a + sign * scale * b) % p for a, b in zip(has, worths, strict=True)
                    )
                    wrap = partial(plus, added)
                    cost = ADDED + HINT + size_of(number)
                    yield Change(index, wrap(node), Mistake.MISSING, cost, index, sums, wrap)


def _squared(problem: Problem, index: int) -> bool:
    """Whether a node is the base of a square that somebody wrote."""
    tree, above = problem.tree, problem.tree.parent[index]
    if above < 0 or not tree.plain(index):
        return False
    return integer_exponent(tree.nodes[above]) == 2 and tree.kids[above][0] == index


def _terms(problem: Problem, squares: list[int]) -> list[tuple[Node, tuple[int, ...]]]:
    """Terms of all squares, without their signs, and their like; one of each."""
    found: dict[int, tuple[Node, tuple[int, ...]]] = {}
    for index in squares:
        node = problem.tree.nodes[index]
        for term in node.terms if isinstance(node, Sum) else (node,):
            for like in (term, _turned(term)):
                values = worth(problem.sheets, like)
                if values is not None and any(values) and len(found) < MOST:
                    found.setdefault(min(values[0], problem.prime - values[0]), (like, values))
    return list(found.values())


def _turned(node: Node) -> Node:
    """A term with sines for cosines, and cosines for sines."""
    if isinstance(node, Call):
        return Call(node.at, OTHER.get(node.function, node.function), node.arguments)
    return with_parts(node, tuple(_turned(part) for part in parts(node)))


def _either(problem: Problem, index: int) -> tuple[int, int]:
    """What a node is worth, with either sign."""
    value = problem.sheets[0].has[index]
    return value, -value % problem.prime
