"""What differs from what is right, term by term, and what each term is worth at the points.

residual = sum of wrongs        wrong = written - right, one product of symbols, sines and cosines

The right equation of motion is the nearest one, of the same scale; anything else is compared with
what the scene gives.
"""

from dataclasses import dataclass, replace

from sympy import Expr, Symbol

from mechanics.blame.difference import nearly
from mechanics.blame.groups import second_rates
from mechanics.blame.nearest import Meant
from mechanics.blame.search.claim import ALONG, CONSTANT_FREE, Claim, targets
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.terms import Terms, difference, terms_of, written
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.scene.quantities import Identity

MEANT = 4
"""Right equations that are compared with."""

MOST = 16
"""Terms that differ; of more there are too many choices."""


@dataclass(frozen=True)
class Wrong:
    """One term that differs.

    Attributes
    ----------
    term : Expr
        Written less right, up to a factor that all of them have in common.
    values : tuple of int
        What it is worth at each point.
    share : int
        What it adds to the residual of the problem.
    meets : bool
        Whether what is written holds such a term, if with another factor.
    moving : frozenset of Symbol
        Speeds and accelerations in it.
    """

    term: Expr
    values: tuple[int, ...]
    share: int
    meets: bool
    moving: frozenset[Symbol]


@dataclass(frozen=True)
class Wrongs:
    """All terms that differ.

    Attributes
    ----------
    cleared : bool
        Whether sums in denominators were multiplied out.
    """

    each: tuple[Wrong, ...]
    cleared: bool


def wrongs(claim: Claim, problem: Problem) -> list[Wrongs]:
    """What differs in a problem from each right equation that may be meant, the nearest first.

    Raises
    ------
    ExpressionError, TooLarge
        For what has no normal form.
    """
    if isinstance(claim.row.quantity, Identity):
        return []
    if isinstance(claim.row.quantity, ALONG):
        options = [(near.written, near.right, near.multiplied) for near in _meant(claim, problem)]
    else:
        options = [(*_sides(claim, problem), False)]
    found = (_against(claim, problem, *option) for option in options)
    return [each for each in found if each is not None]


def _against(
    claim: Claim, problem: Problem, left: Terms, right: Terms, cleared: bool
) -> Wrongs | None:
    """Terms that differ, with shares that add up to the residual; None where they are too many."""
    different = difference(left, right)
    if len(different) > MOST:
        return None
    p = problem.prime
    at_rest = isinstance(claim.row.quantity, CONSTANT_FREE) and problem.plain
    scene = claim.truth.scene
    speeds = {*scene.u, *scene.qd}
    moving = {*speeds, *scene.ud, *second_rates(scene)}
    found = []
    for monomial, value in different.items():
        term = written({monomial: value})
        if at_rest and not term.free_symbols & speeds:
            continue  # what is right at rest is no part of this problem
        values = tuple(sheet.point.value(term) for sheet in problem.sheets)
        share = (values[0] - (values[1] if len(values) > 1 else 0)) % p
        if share:
            held = frozenset(term.free_symbols & moving)
            found.append(Wrong(term, values, share, monomial in left, held))
    total = sum(wrong.share for wrong in found) % p
    if not total:
        return None
    scale = problem.residual * pow(total, -1, p)
    return Wrongs(tuple(replace(each, share=each.share * scale % p) for each in found), cleared)


def _meant(claim: Claim, problem: Problem) -> list[Meant]:
    builder = claim.written.builder()
    sides = [builder(claim.entries[number]) for number in problem.numbers]
    other = sides[1] if len(sides) > 1 else targets(claim, claim.truth)[0]
    plain = momenta_written_out(claim.truth.kinematics, sides[0] - other)
    return nearly(*claim.reference.folded(plain), MEANT)


def _sides(claim: Claim, problem: Problem) -> tuple[Terms, Terms]:
    """An energy, a momentum, an entry of a mass matrix: what is written, and what is right."""
    (number,) = problem.numbers
    own = claim.written.builder()(claim.entries[number])
    plain = momenta_written_out(claim.truth.kinematics, own)
    other, expression = claim.reference.folded(plain)
    right = targets(claim, other.truth)[number]
    scene = other.truth.scene
    one, two = terms_of([scene.plain(side) for side in (expression, right)])
    return one, two
