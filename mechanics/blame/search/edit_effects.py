"""How much an edit changes the residual, so that edits of several terms add up.

    step = residual with the edit - residual

Where sums in denominators were multiplied out an edit of one, Q, changes all terms but its own:

    step = residual with the edit * Q with the edit / Q - residual
"""

from collections.abc import Iterator

from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import InsideHere, integer_exponent
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.claims.tree import Sum
from mechanics.kernel.field import DivisionHere


def steps(problem: Problem, change: Change, cleared: bool) -> Iterator[int]:
    """What an edit adds to the residual; nothing where that is not known."""
    if not problem.tree.single(change.at):
        return
    try:
        step = (problem.residual_with([change]) - problem.residual) % problem.prime
        factor = _growth(problem, change) if cleared else 1
    except (DivisionHere, InsideHere):
        return
    if step:
        yield step
    if factor != 1:
        yield ((problem.residual + step) * factor - problem.residual) % problem.prime


def _growth(problem: Problem, change: Change) -> int:
    """By what the sums grow that are divided by, at the last point."""
    sheet, tree, p = problem.sheets[-1], problem.tree, problem.prime
    factor, child, value = 1, change.at, change.values[-1]
    for above, new in sheet.climb(child, value):
        exponent = integer_exponent(tree.nodes[above])
        if exponent is not None and exponent < 0 and isinstance(tree.nodes[child], Sum):
            factor = factor * pow(value * pow(sheet.has[child], -1, p), -exponent, p) % p
        child, value = above, new
    return factor
