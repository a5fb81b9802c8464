"""The four routes as programs: on every system they determine the same accelerations.

Compared at one point of a field, where a false equality survives with a chance of degree / 2^61;
the kernel's verdicts on them are tests of `mechanics.checks`.
"""

import pytest
from linkages import slider_crank
from spatial_joints import door, telescope, universal_joint

from benchmarks.faults.scenes import trammel
from mechanics.checks.admissible import check_scene
from mechanics.equations import Rows
from mechanics.kinematics import differentiate
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.residues import Residues
from mechanics.program.vectors import dot
from mechanics.routes import free_body, kane, lagrange, moving_point
from mechanics.routes.moving_point import null_space
from mechanics.routes.moving_point_terms import body_terms, load_terms
from mechanics.routes.rows import (
    acceleration_forms,
    coefficients,
    remainder,
)
from mechanics.scene import Scene
from mechanics.scene.system import System
from systems import ALL, VARIANTS, pendulum_chain

ROUTES = (free_body, moving_point, kane, lagrange)
SCENES = {system.name: system.scene for system in (*ALL, *VARIANTS)}
SCENES |= {"a chain of 12": lambda: pendulum_chain.scene(12), "trammel": trammel, "door": door}
SCENES |= {"universal joint": universal_joint, "telescope": lambda: telescope(oblique=True)}


def accelerations(mechanism: Mechanism, rows: Rows, filter_: Residues) -> tuple[int, ...]:
    """u' at the point of the filter, from the rows and the constraints."""
    unknowns = [*mechanism.ud, *rows.multipliers]
    every = [*rows.values, *acceleration_forms(mechanism)]
    assert len(every) == len(unknowns)
    matrix = coefficients(every, unknowns)
    rest = remainder(mechanism.builder, every, unknowns)
    table = [filter_.values([*row, -right]) for row, right in zip(matrix, rest, strict=True)]
    pivots = filter_.eliminate(table, len(unknowns))
    assert len(pivots) == len(unknowns), "the rows do not determine the accelerations"
    values = {column: table[row][-1] for row, column in pivots}
    return tuple(values[i] % filter_.prime for i in range(len(mechanism.u)))


@pytest.mark.sample(2)
@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_all_routes_give_the_same_accelerations(scene) -> None:
    built: Scene = scene()
    mechanism = lower(built, Builder())
    filter_ = Residues(mechanism.builder)
    found = {
        route.__name__: accelerations(mechanism, route.derive(mechanism), filter_)
        for route in ROUTES
    }
    assert len(set(found.values())) == 1


@pytest.mark.sample(2)
@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_kane_and_lagrange_have_the_same_rows(scene) -> None:
    """Both are power-conjugate to u, so that not only their solutions agree."""
    mechanism = lower(scene(), Builder())
    filter_ = Residues(mechanism.builder)
    left, right = kane.derive(mechanism), lagrange.derive(mechanism)
    if mechanism.constraints:
        left, right = (
            remainder(mechanism.builder, rows.values, rows.multipliers) for rows in (left, right)
        )
    else:
        left, right = left.values, right.values
    assert [filter_.is_zero(a - b) for a, b in zip(left, right, strict=True)] == [True] * len(left)


def test_reactions_of_free_bodies_make_their_rows_zero() -> None:
    """Put back into the rows before elimination, with the accelerations of Kane's rows."""
    mechanism = lower(ALL[0].scene(), Builder())
    rows = free_body.derive(mechanism)
    assert set(rows.reactions) == {"T", "N", "N1"}
    filter_ = Residues(mechanism.builder)
    bodies = free_body.free_body_rows(mechanism, filter_, differentiate.motions(mechanism))
    names = [reaction.name for reaction in mechanism.reactions]
    own = [
        row.rate - row.applied
        - sum((c * rows.reactions[names[j]] for j, c in row.coefficients.items()),
              mechanism.builder.zero)
        for row in bodies
    ]  # fmt: skip
    # What is left of each row is a combination of the equations of motion.
    matrix = coefficients([*own, *rows.values], mechanism.ud)
    rest = remainder(mechanism.builder, [*own, *rows.values], mechanism.ud)
    table = [filter_.values([*row, r]) for row, r in zip(matrix, rest, strict=True)]
    assert len(filter_.eliminate(table, len(mechanism.ud) + 1)) == len(mechanism.u)


@pytest.mark.parametrize(
    ("numbers", "rank"),
    [("s 0 0 1", 1), ("s s 0; s r q", 2), ("1 s r; s 1 q", 2), ("s r q 1; r s 1 q", 2),
     ("s r q; s r q", 1), ("0 1 s; 0 r 0", 2), ("0 0 0", 0), ("s r 0; q 0 r; 1 1 1", 3)],
)  # fmt: skip
def test_every_row_annihilates_the_null_space(numbers: str, rank: int) -> None:
    """Whether pivots are numbers or not, and in any mixture of both."""
    build = Builder()
    known = {"0": build.zero, "1": build.one, "s": build.constant(2).sqrt() / 2}
    rows = [
        [known[name] if name in known else build.input(name) for name in row.split()]
        for row in numbers.split(";")
    ]
    filter_ = Residues(build)
    width = len(rows[0])
    basis = null_space(rows, width, (filter_, filter_), build.one)
    assert len(basis) == width - rank
    for vector in basis:
        for row in rows:
            assert filter_.is_zero(dot(row, vector))
    assert len(filter_.eliminate([filter_.values(vector) for vector in basis], width)) == len(basis)


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_what_bodies_and_loads_contribute_adds_up_to_each_principle(system: System) -> None:
    mechanism = lower(system.scene(), Builder())
    filters = mechanism.filters
    found = moving_point.candidates(mechanism, filters)
    assert found.balances
    for balance in found.balances:
        rest = balance.value
        for terms in body_terms(mechanism, found, balance):
            rest = rest - terms.turning - terms.moving - terms.linear
        for _, _, value in load_terms(mechanism, found, balance):
            rest = rest + value
        assert filters[0].is_zero(rest)
    for row in free_body.free_body_rows(mechanism, filters[0], found.motions):
        loads = row.applied
        for _, part in row.loads:
            loads = loads - part
        assert filters[0].is_zero(loads)


def test_forces_alone_hold_a_door_against_its_weight() -> None:
    """X1, X2 = -m L theta'^2/2 +- m g L/h: moments about axes that nothing turns about."""
    mechanism = check_scene(door())
    reactions = free_body.derive(mechanism).reactions
    m, J, L, h, g, rate = 3.0, 0.5, 0.4, 1.8, 9.81, 1.7
    state = {"theta": 0.3, "theta_dot": rate, "theta_ddot": 0.0}
    numbers = {"m": m, "J": J, "L": L, "h": h, "g": g, **state}
    program = mechanism.builder.program({name: [value] for name, value in reactions.items()})
    given = {name: numbers[name] for name in program.inputs}
    values = {name: value for name, (value,) in interpret(program, Arrays(), given).items()}
    outward, couple = -m * L * rate**2 / 2, m * g * L / h
    expected = {"X1": outward + couple, "X2": outward - couple, "Z1": m * g, "Y1": 0, "Y2": 0}
    assert values == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    ("oblique", "words"), [(False, "linear momentum along C.z"), (True, "along oblique in N")]
)
def test_principles_are_told_in_the_frame_of_the_guides(oblique: bool, words: str) -> None:
    """Where they have one; else in the inertial frame, and a long direction is not written out."""
    mechanism = lower(telescope(oblique), Builder())
    chosen = moving_point.derive(mechanism).chosen
    assert chosen[-1].endswith(words)
    assert len(chosen) == 4 and all("moment about O" in other for other in chosen[:-1])


def test_principles_are_the_first_that_do_not_follow_from_others() -> None:
    """From the leaves inward; told from the ground outward."""
    mechanism = lower(slider_crank("slider"), Builder())
    _, closed = mechanism.filters
    found = moving_point.candidates(mechanism, mechanism.filters)
    loose = [mechanism.builder.zero] * len(found.let_in)
    forms = coefficients(acceleration_forms(mechanism), mechanism.ud)
    rows, expected = [closed.values([*form, *loose]) for form in forms], []
    for balance in found.balances:
        (own,) = coefficients([balance.value], mechanism.ud)
        held = [balance.coefficients.get(j, mechanism.builder.zero) for j in found.let_in]
        rows.append(closed.values([*own, *(-entry for entry in held)]))
        if len(closed.eliminate([*map(list, rows)], len(rows[0]))) == len(rows):
            expected.append(balance.words)
        else:
            rows.pop()
    assert len(expected) < len(found.balances)
    assert moving_point.derive(mechanism).chosen == tuple(reversed(expected))
