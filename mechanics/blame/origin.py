"""Where in the derivation the terms of a right equation come from.

    right = sum of pieces        a piece is named for a term that it holds with a factor not zero

What is claimed was added up: the pieces sum to the right equation, and that vanishes along the
motion. A right equation that is none of those that are known by their pieces is taken apart in a
field: c G = A gives the factors of the free-body equations in it.
"""

from collections.abc import Iterable, Mapping
from functools import lru_cache

from sympy import Expr, S, Symbol

from mechanics.blame.groups import COEFFICIENT, grouped
from mechanics.blame.pieces import Kind, Origin, Piece, momenta
from mechanics.blame.terms import Monomial, Terms, terms_of, written
from mechanics.checks.ledger_compare import project_defined
from mechanics.checks.ledger_motion import put_motion
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kernel.ring import TooLarge
from mechanics.kernel.trial import Answer
from mechanics.symbolic import Arithmetic, Number, collect_linear
from mechanics.symbolic.decide import answer

QUICK = 2.0**-40
"""Bound of the chance that a claim is wrong."""


def origins_of(
    pieces: Iterable[tuple[Origin, Terms]], monomials: Iterable[Monomial]
) -> tuple[str, ...]:
    """Words for the pieces that hold any of the terms."""
    wanted = set(monomials)
    return tuple(dict.fromkeys(origin.words for origin, terms in pieces if wanted & terms.keys()))


def holds(truth: Equations, right: Expr) -> bool:
    """Whether an equation vanishes along the motion, at a point of a field."""
    value = truth.scene.plain(right)

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(truth.kinematics.manifold, a)
        put_motion(a, truth)
        return [(a.value(value), a.rational(0))]

    return answer(experiment, QUICK) is Answer.ZERO


def origins_in_field(truth: Equations, right: Expr) -> dict[str, tuple[str, ...]]:
    """Words by group for a right equation, linear in accelerations and reactions.

    Returns
    -------
    dict of str to tuple of str
        Empty where the equation cannot be taken apart, or its pieces do not sum to it.
    """
    try:
        basis = _basis(truth)
        target, _ = collect_linear(truth.scene.plain(right), _unknowns(truth))
        parts = _parts(truth)
    except (ExpressionError, TooLarge):
        return {}
    if len(basis) != len(target):
        return {}
    found: dict[str, dict[str, None]] = {}

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(truth.kinematics.manifold, a)
        columns = [[a.value(row[j]) for row in basis] for j in range(len(basis))]
        factors = a.solve(columns, [a.value(entry) for entry in target])
        found.clear()
        whole = a.rational(0)
        for (group, words), held in parts.items():
            part = a.rational(0)
            for index, expression in held:
                part = part + factors[index] * a.value(expression)
            whole = whole + part
            if not a.is_zero(part):
                found.setdefault(group, {})[words] = None
        return [(whole, a.value(truth.scene.plain(right)))]

    if answer(experiment, QUICK) is not Answer.ZERO:
        return {}
    return {group: tuple(words) for group, words in found.items()}


def _unknowns(truth: Equations) -> tuple[Symbol, ...]:
    scene = truth.scene
    return (*scene.ud, *(reaction.symbol for reaction in scene.reactions))


@lru_cache(maxsize=16)
def pieces_of_all(truth: Equations) -> tuple[tuple[Piece, ...], ...]:
    """Free-body equations piece by piece, and the constraints, differentiated down to u'."""
    scene = truth.scene
    rows = [momentum.pieces for momentum in momenta(scene)]
    for index, constraint in enumerate(scene.constraints):
        ud = zip(truth.constraint_matrix[index, :], scene.ud, strict=True)
        value = sum((c * s for c, s in ud), S.Zero) - truth.constraint_bias[index]
        rows.append((Piece(Origin(Kind.CONSTRAINT, "", constraint.name), value),))
    return tuple(rows)


@lru_cache(maxsize=16)
def _basis(truth: Equations) -> tuple[tuple[Expr, ...], ...]:
    """Factors of the unknowns in each of these equations."""
    return tuple(
        tuple(collect_linear(sum((p.value for p in pieces), S.Zero), _unknowns(truth))[0])
        for pieces in pieces_of_all(truth)
    )


@lru_cache(maxsize=16)
def _parts(truth: Equations) -> Mapping[tuple[str, str], tuple[tuple[int, Expr], ...]]:
    """For each group and origin: which equation holds what of it."""
    symbols = {f"{COEFFICIENT}{symbol.name}": symbol for symbol in truth.scene.ud}
    found: dict[tuple[str, str], list[tuple[int, Expr]]] = {}
    for index, pieces in enumerate(pieces_of_all(truth)):
        terms = terms_of([piece.value for piece in pieces])
        for piece, part in zip(pieces, terms, strict=True):
            for group, own in grouped(truth.scene, part).items():
                value = written(own)
                if group.startswith(COEFFICIENT):
                    value *= symbols[group]
                found.setdefault((group, piece.origin.words), []).append((index, value))
    return {key: tuple(held) for key, held in found.items()}
