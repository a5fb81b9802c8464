"""One mistake, as people make them, at one place of a tree.

sign            + b -> - b                     wrong symbol    M -> m, theta' -> theta
factor          2 k x -> k x, 3 k x            wrong power     L^2 -> L, x'^2 -> x'^3
dropped term    a + b + c -> a + c             swapped index   m1 -> m2
function        sin -> cos, tan -> sin         off-by-one sum  m1 + m2 + m3 -> m2 + m3
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from sympy import Symbol

from benchmarks.detection.sums import shifted_sums, sibling
from benchmarks.detection.tree import (
    Path,
    Tree,
    at,
    negative,
    number,
    places,
    power,
    product,
    put,
    symbol,
    total,
    written,
)

FUNCTIONS = {"sin": ("cos",), "cos": ("sin",), "tan": ("sin", "cos")}

Vocabulary = Sequence[Sequence[Symbol]]
"""Symbols of a scene by kind: those that are taken for each other."""


@dataclass(frozen=True)
class Mutation:
    """One mistake.

    Attributes
    ----------
    side : int
        Which of the trees of a statement.
    path : Path
        Where in it.
    """

    kind: str
    side: int
    path: Path
    was: Tree
    now: Tree

    @property
    def words(self) -> str:
        """What was changed."""
        return f"{written(self.was)} -> {written(self.now)}"

    def apart(self, other: "Mutation") -> bool:
        """Whether neither place lies inside the other."""
        if self.side != other.side:
            return True
        n = min(len(self.path), len(other.path))
        return self.path[:n] != other.path[:n]


Change = tuple[Path, Tree]
Finder = Callable[[Tree, Vocabulary], Iterator[Change]]


def _signs(tree: Tree, _: Vocabulary) -> Iterator[Change]:
    """A whole side, or a term of a sum."""
    if tree != number(0):
        yield (), negative(tree)
    for path, node in places(tree):
        if node.kind == "sum":
            for i, term in enumerate(node.parts):
                yield (*path, i), negative(term)


def _factors(tree: Tree, _: Vocabulary) -> Iterator[Change]:
    """Numbers that are one more or less, left out or upside down; terms twice or half."""
    for path, node in _terms(tree):
        first = node.parts[0] if node.kind == "product" else node
        if first.kind == "number":
            ratio = first.value
            numbers = {ratio + 1, ratio - 1, 1 / ratio, Fraction(1 if ratio > 0 else -1), 2 * ratio}
            for other in sorted(numbers - {ratio, Fraction(0), -ratio}):
                yield path, product(number(other), product(number(1 / ratio), node))
        else:
            for other in (Fraction(2), Fraction(1, 2)):
                yield path, product(number(other), node)


def _terms(tree: Tree) -> Iterator[tuple[Path, Tree]]:
    """Terms of sums, and sides, that are not zero."""
    for path, node in places(tree):
        if node.kind == "sum":
            yield from (((*path, i), term) for i, term in enumerate(node.parts))
    if tree.kind != "sum" and tree != number(0):
        yield (), tree


def _dropped(tree: Tree, _: Vocabulary) -> Iterator[Change]:
    for path, node in places(tree):
        if node.kind == "sum":
            for i in range(len(node.parts)):
                yield path, total(*node.parts[:i], *node.parts[i + 1 :])


def _functions(tree: Tree, _: Vocabulary) -> Iterator[Change]:
    for path, node in places(tree):
        for other in FUNCTIONS.get(node.kind, ()):
            yield path, Tree(other, None, node.parts)


def _symbols(tree: Tree, vocabulary: Vocabulary) -> Iterator[Change]:
    for path, node in places(tree):
        if node.kind == "symbol":
            for group in vocabulary:
                if node.value in group:
                    yield from ((path, symbol(s)) for s in group if s != node.value)


def _powers(tree: Tree, _: Vocabulary) -> Iterator[Change]:
    """One more or less; a factor of a product squared. Nothing becomes one or a denominator."""
    for path, node in places(tree):
        if node.kind == "power":
            base, exponent = node.parts[0], node.parts[1].value
            for other in (exponent + 1, exponent - 1):
                if other != 0 and (other > 0) == (exponent > 0):
                    yield path, power(base, other)
        elif node.kind == "product":
            for i, factor in enumerate(node.parts):
                if factor.kind in ("symbol", "sin", "cos", "tan"):
                    yield (*path, i), power(factor, 2)


def _indices(tree: Tree, vocabulary: Vocabulary) -> Iterator[Change]:
    known = {s for group in vocabulary for s in group}
    for path, node in places(tree):
        if node.kind == "symbol":
            yield from (
                (path, symbol(s))
                for step in (-1, 1)
                if (s := sibling(node.value, step, known)) is not None
            )


KINDS: tuple[tuple[str, Finder], ...] = (
    ("sign", _signs),
    ("factor", _factors),
    ("dropped term", _dropped),
    ("function", _functions),
    ("wrong symbol", _symbols),
    ("wrong power", _powers),
    ("swapped index", _indices),
    ("off-by-one sum", shifted_sums),
)


def mutations(kind: str, trees: Sequence[Tree], vocabulary: Vocabulary) -> list[Mutation]:
    """Every mistake of a kind that can be made in a statement."""
    (find,) = (find for name, find in KINDS if name == kind)
    return [
        Mutation(kind, side, path, at(tree, path), now)
        for side, tree in enumerate(trees)
        for path, now in find(tree, vocabulary)
        if at(tree, path) != now
    ]


def made(trees: Sequence[Tree], mistakes: Sequence[Mutation]) -> tuple[Tree, ...]:
    """The trees with mistakes made at places apart."""
    return tuple(
        put(tree, {m.path: m.now for m in mistakes if m.side == side})
        for side, tree in enumerate(trees)
    )


def draw(
    source: Random, kinds: Sequence[str], trees: Sequence[Tree], vocabulary: Vocabulary
) -> tuple[Mutation, ...] | None:
    """One mistake of each of the kinds, at places apart; None where there are no such places."""
    chosen: list[Mutation] = []
    for kind in kinds:
        found = mutations(kind, trees, vocabulary)
        free = [m for m in found if all(m.apart(other) for other in chosen)]
        if not free:
            return None
        chosen.append(source.choice(free))
    return tuple(chosen)
