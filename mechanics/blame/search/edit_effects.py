"""How much an edit changes the residual, so that edits of several terms add up.

    step = residual with the edit - residual

Where sums in denominators were multiplied out an edit of one, Q, changes all terms but its own:

    step = residual with the edit * Q with the edit / Q - residual
"""

from collections.abc import Iterator

from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import InsideHere, Sheet, integer_exponent
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.claims.tree import Sum
from mechanics.kernel.field import DivisionHere


def steps(problem: Problem, change: Change, cleared: bool) -> Iterator[int]:
    """What an edit adds to the residual; nothing where that is not known."""
    if not problem.forest.single(change.at):
        return
    found, factor = [], 1
    for k, sheet in enumerate(problem.sheets):
        try:
            root, factor = _up(sheet, change.at, change.values[k])
        except (DivisionHere, InsideHere):
            return
        found.append(root - sheet.has[0])
    p = problem.prime
    step = (found[0] - (found[1] if len(found) > 1 else 0)) % p
    if step:
        yield step
    if cleared and factor != 1:
        yield ((problem.residual + step) * factor - problem.residual) % p


def _up(sheet: Sheet, child: int, value: int) -> tuple[int, int]:
    """What the root is worth with an edit, and by what a sum that is divided by grows."""
    forest, p, factor = sheet.forest, sheet.point.prime, 1
    while (above := forest.parent[child]) >= 0:
        exponent = integer_exponent(forest.nodes[above])
        if exponent is not None and exponent < 0 and isinstance(forest.nodes[child], Sum):
            factor = factor * pow(value * pow(sheet.has[child], -1, p), -exponent, p) % p
        value, child = sheet.above(above, child, value), above
    return value, factor
