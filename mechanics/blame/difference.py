"""What is written less what is right, term by term, in groups.

written - right = sum of differences        right: the repaired statement where there is one,
                                            else the true equation that leaves the fewest terms
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from sympy import Add, Expr, S, Symbol, cos, sin

from mechanics.blame.candidates import Candidates
from mechanics.blame.entries import entries_of
from mechanics.blame.groups import COEFFICIENT
from mechanics.blame.motion import holds
from mechanics.blame.nearest import Candidate, Meant, nearest
from mechanics.blame.origin import origins_in_field, origins_of
from mechanics.blame.pieces import Kind, Origin
from mechanics.blame.reference import Reference
from mechanics.blame.result import Difference
from mechanics.blame.shape import apart, shortest
from mechanics.blame.terms import Terms, difference, terms_of, written
from mechanics.claims.statement import Statement
from mechanics.errors import ExpressionError
from mechanics.kernel.ring import TooLarge
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

Spell = Callable[[Expr], str]

GIVEN = Origin(Kind.CONSTRAINT, "", "the repaired statement")

LARGE = 10
"""Terms of a group beyond which only their difference is shown, factored where it can be."""

LARGEST = 1500
"""Terms of a statement beyond which it is not compared term by term."""


@dataclass(frozen=True)
class Group:
    """One group of terms that differs.

    Attributes
    ----------
    written, right : Terms
        All its terms on either side; of a coefficient, without its acceleration.
    about : Expr or None
        What the terms are the coefficient of.
    summed : bool
        Whether the person writes sines and cosines of sums of angles.
    multiplied : bool
        Whether denominators were multiplied out.
    """

    name: str
    written: Terms
    right: Terms
    origin: tuple[str, ...]
    about: Expr | None = None
    summed: bool = False
    multiplied: bool = False


def differences(
    reference: Reference,
    statement: Statement,
    *,
    repaired: Published | None = None,
    spell: Spell = str,
) -> tuple[Difference, ...]:
    """Where a refuted statement differs from the right one that is meant.

    Parameters
    ----------
    statement : Statement
        Refuted.
    repaired : Published, optional
        The row of the statement with a repair put in, which is then what is meant.
    spell : callable
        Gives an expression in plain symbols in the person's own notation.

    Returns
    -------
    tuple of Difference
        Empty where no right equation shares a term with the statement, or where it has no normal
        form. Denominators are multiplied out, in what is written and in what is right.
    """
    return tuple(_shown(group, spell) for group in groups(reference, statement, repaired))


def groups(
    reference: Reference, statement: Statement, repaired: Published | None = None
) -> tuple[Group, ...]:
    """The same as data."""
    row = statement.row
    if row is None:
        return ()
    kinematics = reference.truth.kinematics
    try:
        if isinstance(row.quantity, EquationOfMotion | ReactionValue):
            return _of_equation(reference, row, repaired)
        return tuple(
            Group(name, left, right, origins_of(pieces, apart(right, left)), about)
            for side in row.sides
            for other, own in [reference.folded(momenta_written_out(kinematics, side))]
            for name, about, left, right, pieces in entries_of(
                other.derivation, replace(row, sides=(own,))
            )
        )
    except (ExpressionError, TooLarge):
        return ()


def _of_equation(
    reference: Reference, row: Published, repaired: Published | None
) -> tuple[Group, ...]:
    own = residual(row)
    plain = momenta_written_out(reference.truth.kinematics, own)
    if repaired is not None:
        # Both are in the person's symbols, momenta among them.
        other, expression = reference.folded(own)
        near = meant(other, expression, other.folded(residual(repaired))[1])
    else:
        other, expression = reference.folded(plain)
        near = meant(other, expression)
        if near is not None and near.multiplied and plain != own:
            return ()  # momenta over sums, written out in speeds: nothing that one could read
    return () if near is None else tuple(_by_group(other, expression, near))


def _by_group(reference: Reference, expression: Expr, near: Meant) -> Iterator[Group]:
    derivation, meanings = reference.derivation, reference.derivation.meanings
    by_field: dict[str, tuple[str, ...]] = {}
    if not near.pieces:
        right = momenta_written_out(reference.truth.kinematics, written(near.right))
        by_field = origins_in_field(derivation, right)
    left, other = meanings.grouped(near.written), meanings.grouped(near.right)
    symbols = {f"{COEFFICIENT}{s.name}": s for s in meanings.accelerations}
    summed = any(not node.args[0].is_Symbol for node in expression.atoms(sin, cos))
    for name in dict.fromkeys((*meanings.grouped(near.different), *left, *other)):
        one, two = left.get(name, {}), other.get(name, {})
        if one == two:
            continue
        origin = by_field.get(name, ())
        if near.pieces:
            parts = [(o, meanings.grouped(terms).get(name, {})) for o, terms in near.pieces]
            origin = origins_of(parts, apart(two, one))
        yield Group(name, one, two, origin, symbols.get(name), summed, near.multiplied)


def residual(row: Published) -> Expr:
    """First side less the last; of a reaction, the reaction less the side."""
    if isinstance(row.quantity, ReactionValue):
        return Symbol(row.quantity.name, real=True) - row.sides[-1]
    return row.sides[0] - row.sides[-1]


def meant(reference: Reference, expression: Expr, right: Expr | None = None) -> Meant | None:
    """The right equation that a residual is nearest to, with its pieces.

    Parameters
    ----------
    expression : Expr
        What is written, as a residual.
    right : Expr, optional
        The residual of what is meant, where that is known.
    """
    if right is None:
        return next(iter(nearly(reference, expression, 1)), None)
    candidates = reference.candidates(expression)
    accelerations, moving = candidates.view.accelerations, _moving(candidates)
    left = _cleared(expression, moving, accelerations)
    multiplied = terms_of([expression]) != [left]
    target = Candidate("the repaired statement", ((GIVEN, _cleared(right, moving, accelerations)),))
    aimed = next(iter(nearest(left, [target], moving, accelerations)), None)
    as_written = _as_written(expression, right)
    if aimed is None or (multiplied and len(as_written.different) <= len(aimed.different)):
        return as_written
    if not multiplied:
        aimed = as_written  # of the same scale, for a repair is an edit of what is written
    known = nearest(aimed.right, _alike(candidates, expression), moving, accelerations)
    pieces = known[0].pieces if known and not known[0].different else ()
    return replace(aimed, pieces=pieces, multiplied=multiplied)


def nearly(reference: Reference, expression: Expr, count: int) -> list[Meant]:
    """The right equations that a residual is nearest to, as many as are wanted."""
    candidates = reference.candidates(expression)
    accelerations, moving = candidates.view.accelerations, _moving(candidates)
    left = _cleared(expression, moving, accelerations)
    multiplied = terms_of([expression]) != [left]
    return [
        replace(near, multiplied=multiplied)
        for near in nearest(left, _alike(candidates, expression), moving, accelerations, count)
        if holds(reference.truth, written(near.right))
    ]


def _moving(candidates: Candidates) -> set[Symbol]:
    """All that no factor of an equation holds."""
    view = candidates.view
    moving = {*view.speeds, *view.accelerations, *view.scene.input_symbols}
    moving |= {reaction.symbol for reaction in view.scene.reactions}
    momenta = momentum_symbols(view.scene)
    return moving | {*momenta, *map(rate_symbol, momenta)}


def _as_written(expression: Expr, right: Expr) -> Meant:
    """Both with the denominators that they have; a sum there counts as one factor."""
    one, two = terms_of([expression, right])
    return Meant("the repaired statement", one, two, ())


def _cleared(expression: Expr, moving: set[Symbol], leading: Sequence[Symbol]) -> Terms:
    """Terms without denominators, the first acceleration with the sign that it was written with."""
    (plain,) = terms_of([expression])
    if len(plain) > LARGEST:
        raise TooLarge(f"{len(plain)} terms")
    (terms,) = terms_of([expression], cleared=True, moving=moving)
    if _sign(plain, leading) * _sign(terms, leading) < 0:
        return {monomial: -value for monomial, value in terms.items()}
    return terms


def _sign(terms: Terms, leading: Sequence[Symbol]) -> Fraction:
    """Sum of the factors of the first acceleration that stands in terms."""
    for symbol in leading:
        held = [v for monomial, v in terms.items() if any(a == symbol for a, _ in monomial)]
        if held:
            return sum(held, Fraction(0))
    return Fraction(0)


def _alike(candidates: Candidates, expression: Expr) -> Iterator[Candidate]:
    """Right equations in the same unknowns, those with few terms first."""
    view, held = candidates.view, expression.free_symbols
    reactions = [r.symbol for r in view.scene.reactions if r.symbol in held]
    accelerations = [symbol for symbol in view.accelerations if symbol in held]
    if reactions:
        yield from candidates.with_reactions
    if len(reactions) == 1 and not accelerations:
        yield from candidates.solved(reactions[0])
    if len(accelerations) == 1:
        yield from candidates.solved(accelerations[0])
    yield from candidates.constrained(frozenset(held & {*view.speeds, *view.accelerations}))
    yield from candidates.implicit()


def _shown(group: Group, spell: Spell) -> Difference:
    name = group.name if group.about is None else f"{COEFFICIENT}{spell(group.about)}"
    if group.multiplied:
        name = f"{name}, denominators multiplied out"
    count = len(apart(group.written, group.right)) + len(apart(group.right, group.written))
    left, right = shortest(group.written, group.right, summed=group.summed)
    if _addends(left) + _addends(right) <= LARGE:
        return Difference(name, _spelt(left, spell), _spelt(right, spell), group.origin)
    rest = difference(group.written, group.right)
    name = f"{name}: {count} terms differ, only their difference is shown"
    shown, _ = shortest(rest, {}, summed=group.summed)
    text = f"{_addends(shown)} terms" if _addends(shown) > LARGE else _spelt(shown, spell)
    return Difference(name, text, "", group.origin)


def _addends(side: Expr) -> int:
    """Number of terms that a reader sees."""
    return len(Add.make_args(side))


def _spelt(side: Expr, spell: Spell) -> str:
    return "" if side == S.Zero else spell(side)
