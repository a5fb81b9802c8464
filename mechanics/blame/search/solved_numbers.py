"""Edits that are solved for: the number that would make it right.

number: needed = n / d         term: needed / has = n / d
"""

from collections.abc import Iterator
from functools import partial

from mechanics.blame.result import Mistake
from mechanics.blame.search.change import (
    HINT,
    RATIOS,
    TOKEN,
    Change,
    size_of,
    times,
)
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.residues import rational
from mechanics.claims.tree import Number


def numbers(problem: Problem) -> Iterator[Change]:
    """Numbers and factors of terms that make the statement right."""
    if not problem.plain:
        yield from _of_two_states(problem)
        return
    (sheet,) = problem.sheets
    tree, p = problem.tree, problem.prime
    for index, node in enumerate(tree.nodes):
        need, has = sheet.needs[index], sheet.has[index]
        if not need or not has or not tree.written(index):
            continue
        if isinstance(node, Number) and node.value not in (-1, 0):
            value = rational(need, p)
            if value is not None and value != node.value:
                new = Number(node.at, value)
                cost = TOKEN + size_of(value)
                if value < 0:
                    cost += TOKEN - HINT
                yield Change(index, new, Mistake.FACTOR, cost, index, (need,))
        elif tree.term(index):
            ratio = rational(need * pow(has, -1, p) % p, p)
            if ratio is None or ratio in RATIOS or abs(ratio) == 1:
                continue
            cost = TOKEN + 2 * HINT + size_of(ratio)
            if ratio < 0:
                cost += TOKEN - HINT
            wrap = partial(times, Number(0, ratio))
            yield Change(index, wrap(node), Mistake.FACTOR, cost, index, (need,), wrap)


def _of_two_states(problem: Problem) -> Iterator[Change]:
    """The same where two states are subtracted: the residual grows evenly with a factor."""
    tree, p = problem.tree, problem.prime
    for index, node in enumerate(tree.nodes):
        number = isinstance(node, Number) and node.value not in (-1, 0)
        if not tree.written(index) or not tree.single(index):
            continue
        if not number and not tree.term(index):
            continue
        slopes = problem.slopes(index)
        if slopes is None:
            continue
        first, second = (
            s * sheet.has[index] for s, sheet in zip(slopes, problem.sheets, strict=True)
        )
        if (first - second) % p == 0:
            continue
        step = rational(-problem.residual * pow(first - second, -1, p), p)
        if step is None or step == -1 or 1 + step in RATIOS:
            continue
        ratio = 1 + step
        values = tuple(
            sheet.has[index] * ratio.numerator * pow(ratio.denominator, -1, p) % p
            for sheet in problem.sheets
        )
        cost = TOKEN + 2 * HINT + size_of(ratio) + (TOKEN - HINT if ratio < 0 else 0.0)
        if isinstance(node, Number):
            new = Number(node.at, node.value * ratio)
            yield Change(index, new, Mistake.FACTOR, cost, index, values)
        elif ratio != -1:
            wrap = partial(times, Number(0, ratio))
            yield Change(index, wrap(node), Mistake.FACTOR, cost, index, values, wrap)
