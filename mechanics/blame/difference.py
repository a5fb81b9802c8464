"""What is written less what is right, term by term, in groups.

written - right = sum of differences        right: the repaired statement where there is one,
                                            else the true equation that leaves the fewest terms
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from sympy import Expr, S, Symbol, factor_terms

from mechanics.blame.candidates import constrained, implicit, solved, with_reactions
from mechanics.blame.entries import entries_of
from mechanics.blame.folded import folded
from mechanics.blame.groups import grouped
from mechanics.blame.nearest import Candidate, Meant, nearest
from mechanics.blame.origin import holds, origins_in_field, origins_of
from mechanics.blame.pieces import Kind, Origin
from mechanics.blame.result import Difference
from mechanics.blame.shape import shortest
from mechanics.blame.terms import Terms, difference, terms_of, written
from mechanics.blame.view import View, view_of
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.exact import TooLarge
from mechanics.reading.statement import Statement
from mechanics.scene.published import Published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

Spell = Callable[[Expr], str]

GIVEN = Origin(Kind.CONSTRAINT, "", "the repaired statement")

LARGE = 12
"""Terms of a group beyond which only their difference is shown, factored where it can be."""

ENDLESS = 40
"""Terms beyond which nobody reads it."""


@dataclass(frozen=True)
class Group:
    """Terms of one group that differ.

    Attributes
    ----------
    name : str
    written, right : Terms
        Without the terms that both sides have; of a coefficient, without its acceleration.
    origin : tuple of str
    """

    name: str
    written: Terms
    right: Terms
    origin: tuple[str, ...]


def differences(
    truth: Equations,
    statement: Statement,
    *,
    repaired: Published | None = None,
    spell: Spell = str,
) -> tuple[Difference, ...]:
    """Where a refuted statement differs from the right one that is meant.

    Parameters
    ----------
    truth : Equations
        Derived, with reactions.
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
    return tuple(_shown(group, spell) for group in groups(truth, statement, repaired))


def groups(
    truth: Equations, statement: Statement, repaired: Published | None = None
) -> tuple[Group, ...]:
    """The same as data."""
    row = statement.row
    if row is None:
        return ()
    try:
        if isinstance(row.quantity, EquationOfMotion | ReactionValue):
            return _of_equation(truth, row, repaired)
        return tuple(
            _group(name, left, right, origins_of(pieces, _kept(right, left)))
            for side in row.sides
            for other, own in [folded(truth, side)]
            for name, left, right, pieces in entries_of(other.scene, replace(row, sides=(own,)))
        )
    except (ExpressionError, TooLarge):
        return ()


def _of_equation(truth: Equations, row: Published, repaired: Published | None) -> tuple[Group, ...]:
    truth, expression = folded(truth, residual(row))
    right = None if repaired is None else folded(truth, residual(repaired))[1]
    found = meant(truth, expression, right)
    if found is None:
        return ()
    scene, by_field = truth.scene, {}
    if not found.pieces:
        by_field = origins_in_field(truth, written(found.right))
    left, other = grouped(scene, found.written), grouped(scene, found.right)
    result = []
    for name in dict.fromkeys((*grouped(scene, found.different), *left, *other)):
        one, two = left.get(name, {}), other.get(name, {})
        if one == two:
            continue
        origin = by_field.get(name, ())
        if found.pieces:
            parts = [(o, grouped(scene, terms).get(name, {})) for o, terms in found.pieces]
            origin = origins_of(parts, _kept(two, one))
        result.append(_group(name, one, two, origin))
    return tuple(result)


def residual(row: Published) -> Expr:
    """First side less the last; of a reaction, the reaction less the side."""
    if isinstance(row.quantity, ReactionValue):
        return Symbol(row.quantity.name, real=True) - row.sides[-1]
    return row.sides[0] - row.sides[-1]


def meant(truth: Equations, expression: Expr, right: Expr | None = None) -> Meant | None:
    """The right equation that a residual is nearest to, with its pieces.

    Parameters
    ----------
    truth : Equations
    expression : Expr
        What is written, as a residual.
    right : Expr, optional
        The residual of what is meant, where that is known.
    """
    view = view_of(truth, expression)
    moving = {*view.speeds, *view.accelerations, *truth.scene.input_symbols}
    moving |= {reaction.symbol for reaction in truth.scene.reactions}
    left = _cleared(expression, moving)
    known = list(_candidates(view, expression))
    if right is not None:
        target = Candidate("the repaired statement", ((GIVEN, _cleared(right, moving)),))
        aimed = nearest(left, [target], moving, view.accelerations)
        if aimed is None:
            return None
        same = nearest(aimed.right, known, moving, view.accelerations)
        pieces = same.pieces if same is not None and not same.different else ()
        return Meant(aimed.words, aimed.written, aimed.right, pieces)
    found = nearest(left, known, moving, view.accelerations)
    if found is None or not holds(truth, found.right):
        return None
    return found


def _cleared(expression: Expr, moving: set[Symbol]) -> Terms:
    (terms,) = terms_of([expression], cleared=True, moving=moving)
    return terms


def _candidates(view: View, expression: Expr) -> Iterator[Candidate]:
    """Right equations in the same unknowns, those with few terms first."""
    held = expression.free_symbols
    if held & {reaction.symbol for reaction in view.scene.reactions}:
        yield from with_reactions(view)
    accelerations = [symbol for symbol in view.accelerations if symbol in held]
    if len(accelerations) == 1:
        yield from solved(view, accelerations[0])
    yield from constrained(view, frozenset(held & {*view.speeds, *view.accelerations}))
    yield from implicit(view)


def _kept(one: Terms, two: Terms) -> Terms:
    """The terms of one that two has not, or with another factor."""
    return {monomial: value for monomial, value in one.items() if two.get(monomial) != value}


def _group(name: str, left: Terms, right: Terms, origin: tuple[str, ...]) -> Group:
    return Group(name, _kept(left, right), _kept(right, left), origin)


def _shown(group: Group, spell: Spell) -> Difference:
    count = len(group.written) + len(group.right)
    if count <= LARGE:
        left, right = shortest(group.written, group.right)
        return Difference(group.name, _spelt(left, spell), _spelt(right, spell), group.origin)
    rest = difference(group.written, group.right)
    name = f"{group.name}, difference only: {len(rest)} terms"
    if len(rest) > ENDLESS:
        return Difference(name, "", "", group.origin)
    shown, _ = shortest(rest, {})
    return Difference(name, _spelt(factor_terms(shown), spell), "", group.origin)


def _spelt(side: Expr, spell: Spell) -> str:
    return "" if side == S.Zero else spell(side)
