"""Sums over an index, and the ways to miscount it.

m1 + m2 + m3  ->  m2 + m3,  m1 + m2,  m0 + m1 + m2 + m3        q1, q2 are siblings, and m1, m2

Terms that are each other with every index one higher are a run; a run has two ends.
"""

import re
from collections.abc import Collection, Iterator, Sequence

from sympy import Symbol

from benchmarks.detection.tree import Path, Tree, number, places, symbol, symbols, total

INDEX = re.compile(r"(.*?)(\d+)((?:_dot|_ddot|_dddot)?)")


def sibling(one: Symbol, step: int, known: Collection[Symbol]) -> Symbol | None:
    """The symbol with an index so much higher, where there is one."""
    match = INDEX.fullmatch(one.name)
    if match is None or int(match[2]) + step < 0:
        return None
    name = f"{match[1]}{int(match[2]) + step}{match[3]}"
    return next((s for s in known if s.name == name), None)


def moved(tree: Tree, step: int, known: Collection[Symbol]) -> Tree | None:
    """A term with every index so much higher; None where a symbol is missing or none has one."""
    found = {s: sibling(s, step, known) for s in symbols(tree) if INDEX.fullmatch(s.name)}
    if not found or None in found.values():
        return None
    return _renamed(tree, found)


def _renamed(tree: Tree, table: dict) -> Tree:
    if tree.kind == "symbol":
        return symbol(table.get(tree.value, tree.value))
    return Tree(tree.kind, tree.value, tuple(_renamed(part, table) for part in tree.parts))


def _run(terms: Sequence[Tree], start: int, known: Collection[Symbol]) -> list[int]:
    """Places of a term and of those that follow it by index."""
    run, term = [start], moved(terms[start], 1, known)
    while term is not None and term in terms:
        run.append(terms.index(term))
        term = moved(term, 1, known)
    return run


def shifted_sums(tree: Tree, vocabulary: Sequence[Sequence[Symbol]]) -> Iterator[tuple[Path, Tree]]:
    """Sums whose run of terms begins or ends one too early or too late."""
    known = {s for group in vocabulary for s in group}
    for path, node in places(tree):
        if node.kind != "sum":
            continue
        terms = list(node.parts)
        for start, first in enumerate(terms):
            before = moved(first, -1, known)
            run = _run(terms, start, known)
            if len(run) < 2 or before in terms:
                continue
            for end in (run[0], run[-1]):
                yield path, total(*(t for i, t in enumerate(terms) if i != end))
            after = moved(terms[run[-1]], 1, known)
            for more in (before, after):
                if more is not None and more != number(0):
                    yield path, total(*terms, more)
