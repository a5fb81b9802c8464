"""Laws: every equation of every route is the sum of pieces that say where its terms come from."""

import pytest
from sympy import Add

from mechanics.blame.motion import holds
from mechanics.blame.origin import origins_in_field
from mechanics.blame.reference import Reference
from mechanics.blame.terms import terms_of, written
from mechanics.checks.ledger_motion import put_motion
from mechanics.checks.manifold import project
from mechanics.crosscheck.routes import derive
from mechanics.equations import Equations
from mechanics.kernel import Finding
from mechanics.routes.derivation import by_route
from mechanics.symbolic import Arithmetic, decide

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def along(truth: Equations, expressions: list) -> Finding:
    """Whether expressions vanish along the motion."""

    def experiment(a: Arithmetic) -> list:
        project(a, truth.kinematics)
        put_motion(a, truth)
        return [(a.value(expression), a.rational(0)) for expression in expressions]

    return decide("pieces", experiment, try_normal=False)


@pytest.mark.sample(2)
def test_pieces_of_every_row_sum_to_zero_along_the_motion(reference: Reference) -> None:
    truth, derivation = reference.truth, reference.derivation
    rows = [*derivation.generalized_rows, *derivation.free_rows]
    rows += [moment.row for moment in derivation.moving_rows]
    assert len(rows) >= len(truth.scene.u)
    assert along(truth, [row.value for row in rows]).shown


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
def test_every_route_is_taken_apart_into_pieces_that_add_up(
    reference: Reference, route: str
) -> None:
    truth = reference.truth
    equations = derive(truth.scene, route)
    names = dict(zip(equations.multipliers, truth.multipliers, strict=False))
    for row in equations.residual:
        # It is empty where the pieces do not sum to the row at the point that was looked at.
        found = origins_in_field(reference.derivation, row.xreplace(names))
        assert found
        assert all(words for words in found.values())


@pytest.mark.sample(2)
def test_pieces_are_those_of_kane_term_by_term(reference: Reference) -> None:
    scene = reference.truth.scene
    kane = by_route("kane", scene)
    compared = 0
    for row, residual in zip(reference.derivation.generalized_rows, kane.residual, strict=False):
        # Kane's rows are reduced where there are constraints, and hold no reactions with friction.
        if kane.conjugate:
            ours, theirs = terms_of([row.value, residual])
            assert ours == theirs
            compared += 1
    assert compared or not kane.conjugate


@pytest.mark.sample(2)
def test_a_sum_without_one_of_its_pieces_is_no_equation(reference: Reference) -> None:
    truth = reference.truth
    missing = [
        Add(*(other.value for other in row.pieces if other is not piece))
        for row in reference.derivation.generalized_rows
        for piece in row.pieces
        if not holds(truth, piece.value)
    ]
    assert missing
    assert not any(holds(truth, rest) for rest in missing)


@pytest.mark.sample(2)
def test_candidates_hold_along_the_motion(reference: Reference) -> None:
    candidates = list(reference.in_speeds.implicit())
    assert candidates
    assert all(holds(reference.truth, written(candidate.terms)) for candidate in candidates)


@pytest.mark.sample(2)
def test_candidates_in_other_unknowns_hold_along_the_motion(reference: Reference) -> None:
    """With the constraints put in, with reactions, and solved for each acceleration."""
    truth = reference.truth
    candidates = reference.in_rates if truth.scene.speeds else reference.in_speeds
    tied = candidates.constrained(frozenset())
    assert bool(tied) is bool(truth.scene.constraints)
    found = [*tied, *candidates.with_reactions]
    for acceleration in candidates.view.accelerations:
        found += candidates.solved(acceleration)
    assert all(holds(truth, written(candidate.terms)) for candidate in found)


@pytest.mark.sample(2)
def test_no_reaction_of_a_constraint_is_left_where_it_is_put_in(reference: Reference) -> None:
    forces = {reaction.symbol for reaction in reference.truth.scene.reactions}
    for candidate in reference.in_speeds.constrained(frozenset()):
        assert not written(candidate.terms).free_symbols & forces
