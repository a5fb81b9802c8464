"""Known mistakes: each fires on a scene made wrong that way, and none on right equations."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import count, islice

import pytest
from sympy import Add, Expr, Symbol, cos, linsolve
from sympy.physics.mechanics import (
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.blame.explanations import MOST, explanations
from mechanics.blame.mistakes import forgotten_constraints, substituted_constraint
from mechanics.blame.mistakes.catalogue import KNOWN
from mechanics.blame.mistakes.fault_model import Fault, equations, right
from mechanics.blame.reference import Reference
from mechanics.checks.ledger import check_row
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.kernel import Finding, Verdict
from mechanics.scene import force
from mechanics.scene.actions import frictions
from mechanics.symbolic import independent_rows, is_zero
from systems import rolling_disc

Stated = Callable[..., Statement]


def judged(truth: Equations, statements: list[Statement]) -> list[Finding]:
    return [check_row(truth.scene, s.row, truth) for s in statements if s.row is not None]


def faults(truth: Equations) -> Iterator[Fault]:
    """Mistakes that leave the motion determined; with constraints, one of each that is new then."""
    derivation = right(Derivation(truth), with_reactions=False)
    tied = bool(truth.scene.constraints)
    for known in (forgotten_constraints.faults, substituted_constraint.faults) if tied else KNOWN:
        found = (fault for fault in known(derivation) if determined(truth, fault))
        yield from islice(found, 1 if tied else None)


def determined(truth: Equations, fault: Fault) -> bool:
    """Whether there is a motion with the mistake: a disc without inertia has none."""
    left, _ = equations(truth, fault).system
    return len(independent_rows(left.tolist())) == left.cols


def made_wrong(fault: Fault, stated: Stated) -> list[Statement]:
    """The equations that a person would find who makes the mistake."""
    rows = (Add(*(times * piece.value for times, piece in row)) for row in fault.rows)
    return [stated(value, str(tag)) for tag, value in zip(count(1), rows, strict=False)]


@pytest.mark.sample(2)
def test_every_mistake_is_named_where_it_was_made(reference: Reference, stated: Stated) -> None:
    truth, fired = reference.truth, 0
    # Friction keeps the reactions in the equations: they are rows of free bodies, tried below.
    for fault in () if frictions(truth.scene) else faults(truth):
        statements = made_wrong(fault, stated)
        findings = judged(truth, statements)
        told = explanations(reference, statements, findings)
        for finding, words in zip(findings, told, strict=True):
            if finding.verdict is Verdict.REFUTED:
                assert fault.words in words or len(words) == MOST
                fired += 1
            else:
                assert words == ()
    assert fired or frictions(truth.scene)


MADE = (
    "gravity reversed", "gravity is missing", "spring k: half of its stiffness",
    "spring k: its force has the wrong sign", "load tau has the wrong sign", "load tau is missing",
    "friction track uses the value of N_c at rest", "friction track is the coefficient",
    "parallel axis counted twice: pendulum", "parallel axis forgotten: pendulum",
    "rotational inertia is missing: pendulum", "parallel axis counted twice: link1, link2",
    "Coriolis terms are missing", "centrifugal terms are missing",
    "Coriolis and centrifugal terms are missing", "coordinates treated as free that",
    "the constraints, solved for x_dot, y_dot, substituted into the Lagrangian",
)  # fmt: skip
MAKERS = ("elastic_pendulum", "acrobot", "cartpole_friction", "rolling_disc", "four_bar")


def test_every_kind_of_mistake_can_be_made(truth_of: Callable[[str], Equations]) -> None:
    derivations = [right(Derivation(truth_of(name)), with_reactions=False) for name in MAKERS]
    found = [fault.words for one in derivations for known in KNOWN for fault in known(one)]
    assert [made for made in MADE if not any(words.startswith(made) for words in found)] == []


def test_friction_with_the_wrong_sign(truth_of: Callable[[str], Equations]) -> None:
    truth = truth_of("cartpole_friction")
    (track,) = frictions(truth.scene)
    found = [
        fault for fault in faults(truth) if fault.words == f"load {track.name} has the wrong sign"
    ]
    assert len(found) == 1


@pytest.mark.sample(2)
def test_nothing_is_explained_where_all_is_right(reference: Reference, stated: Stated) -> None:
    truth, derivation = reference.truth, reference.derivation
    rows = [*derivation.generalized_rows, *(moment.row for moment in derivation.moving_rows)]
    values = [row.value for row in rows if row.value.free_symbols & set(truth.scene.ud)]
    statements = [stated(value, str(tag)) for tag, value in zip(count(1), values, strict=False)]
    findings = judged(truth, statements)
    assert all(finding.shown for finding in findings)
    assert explanations(Reference(truth), statements, findings) == ((),) * len(statements)


def test_a_mere_slip_of_the_pen_is_not_explained(
    truth_of: Callable[[str], Equations], stated: Stated
) -> None:
    truth = truth_of("elastic_pendulum")
    first, second = (row.value for row in Derivation(truth).generalized_rows)
    statements = [stated(first), stated(second + 5 * truth.scene.q[0])]
    findings = judged(truth, statements)
    assert [finding.verdict for finding in findings] == [Verdict.PROVED, Verdict.REFUTED]
    assert explanations(Reference(truth), statements, findings) == ((), ())


PENDULUM = "(M+m)*x_ddot + 2*k*x + M*L/2*(theta_ddot*cos(theta) - theta_dot**2*sin(theta)) = 0"
MOMENT = "M*L/2*x_ddot*cos(theta) + M*L**2/3*theta_ddot + M*g*L/2*sin(theta)"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("moment", "words"),
    [
        (MOMENT.replace("+ M*g", "- M*g"), "gravity reversed"),
        (MOMENT.replace("/3", "*7/12"), "parallel axis counted twice: pendulum"),
        (MOMENT.replace("/3", "/12"), "parallel axis forgotten: pendulum"),
        (MOMENT.replace("/3", "/4"), "rotational inertia is missing: pendulum"),
        (
            MOMENT + " - M*L/2*x_dot*theta_dot*sin(theta)",
            "v_B x P is missing in the moment about B = B",
        ),
        (
            MOMENT.replace("M*L/2*x_ddot*cos(theta) +", ""),
            "BC x m a_B is missing in the moment about B = B, which accelerates",
        ),
    ],
)
def test_of_the_moment_about_the_moving_pivot(
    truth_of: Callable[[str], Equations], moment: str, words: str
) -> None:
    truth = truth_of("elastic_pendulum")
    found = mechanics.check(truth, f"{PENDULUM}\n{moment} = 0", blame=False)
    told = explanations(
        Reference(truth), [e.statement for e in found.judged], [e.finding for e in found.judged]
    )
    assert told == ((), (words,))


def test_a_reaction_explains_itself_too(truth_of: Callable[[str], Equations]) -> None:
    truth = truth_of("elastic_pendulum")
    text = "N1 = -(M+m)*g + M*L/2*(theta_ddot*sin(theta) + theta_dot**2*cos(theta))"
    (entry,) = mechanics.check(truth, text, blame=False).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert explanations(Reference(truth), [entry.statement], [entry.finding]) == (
        ("gravity reversed",),
    )


def test_cart_pole_with_the_parallel_axis_counted_twice(
    truth_of: Callable[[str], Equations],
) -> None:
    truth = truth_of("cartpole")
    text = (
        "theta_ddot = (g*sin(theta) - cos(theta)*(F + mp*l*theta_dot**2*sin(theta))/(mc+mp))"
        "/(l*(7/3 - mp*cos(theta)**2/(mc+mp)))"
    )
    (entry,) = mechanics.check(truth, text, blame=False).judged
    told = explanations(Reference(truth), [entry.statement], [entry.finding])
    assert told == (("parallel axis counted twice: pole",),)


def lagrangian_of_the_disc(height_sign: int) -> list[Expr]:
    """Lagrange's equations of SymPy's tutorial: the velocity of the centre holds no slip already.

    The tutorial prints the potential energy with the sign that `height_sign` = -1 gives.
    """
    yaw, lean, spin = dynamicsymbols("yaw lean spin")
    m, r, g = rolling_disc.m, rolling_disc.R, rolling_disc.g
    ground = ReferenceFrame("N")
    heading = ground.orientnew("Y", "Axis", (yaw, ground.z))
    leaning = heading.orientnew("L", "Axis", (lean, heading.x))
    disc = leaning.orientnew("D", "Axis", (spin, leaning.y))
    centre = Point("C")
    centre.set_vel(ground, disc.ang_vel_in(ground).cross(r * leaning.z))
    across, along = m * r**2 / 4, m * r**2 / 2
    body = RigidBody("disc", centre, disc, m, (inertia(leaning, across, along, across), centre))
    body.potential_energy = height_sign * m * g * r * cos(lean)
    method = LagrangesMethod(Lagrangian(ground, body), [yaw, lean, spin])
    return list(method.form_lagranges_equations())


SUBSTITUTED = "the constraints, solved for x_dot, y_dot, substituted into the Lagrangian"


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("height_sign", "words"),
    [(1, SUBSTITUTED), (-1, f"{SUBSTITUTED}; gravity reversed")],
)
def test_rolling_disc_whose_constraints_were_put_into_the_lagrangian(
    truth_of: Callable[[str], Equations], stated: Stated, height_sign: int, words: str
) -> None:
    truth = truth_of("rolling_disc")
    statements = [
        stated(truth.scene.rates(value.doit()), str(tag))
        for tag, value in zip(count(1), lagrangian_of_the_disc(height_sign), strict=False)
    ]
    findings = judged(truth, statements)
    told = explanations(Reference(truth), statements, findings)
    for finding, found in zip(findings, told, strict=True):
        assert found == ((words,) if finding.verdict is Verdict.REFUTED else ())
    assert findings[0].verdict is findings[2].verdict is Verdict.REFUTED


def test_loads_without_potential_follow_the_constraints_that_were_put_in() -> None:
    """A push at the centre along X does work where the disc rolls: Q_spin = P R cos yaw."""
    plain = rolling_disc.scene()
    push = Symbol("push", real=True)
    centre = plain.bodies[0].centre
    scene = replace(plain, loads=(*plain.loads, force("push", centre, push * plain.frame.x)))
    (fault, *_) = substituted_constraint.faults(
        right(Derivation(mechanics.derive(scene, "free_body")), with_reactions=False)
    )
    pushed = [
        Add(*(times * piece.value for times, piece in row if piece.origin.name == "push"))
        for row in fault.rows
    ]
    assert fault.words == SUBSTITUTED
    assert is_zero(pushed[-1] + push * rolling_disc.R * cos(scene.q[2]))


def test_the_tutorial_prints_what_these_two_mistakes_give() -> None:
    q = dynamicsymbols("yaw lean spin")
    time, unknown = dynamicsymbols._t, dynamicsymbols("a b c")
    parameters = {rolling_disc.m: 1.3, rolling_disc.R: 0.7, rolling_disc.g: 9.81}
    tables = (
        dict(zip((f.diff(time, 2) for f in q), unknown, strict=True)),
        dict(zip((f.diff(time) for f in q), (0.5, -0.2, 1.5), strict=True)),
        dict(zip(q, (0.4, 0.3, 1.1), strict=True)) | parameters,
    )
    rows = [row.doit() for row in lagrangian_of_the_disc(-1)]
    for table in tables:
        rows = [row.xreplace(table) for row in rows]
    (found,) = linsolve(rows, *unknown)
    printed = (2.0078873826124033, -2.382820539009993, -0.49783764534975306)
    assert [float(value) for value in found] == pytest.approx(printed, rel=1e-12)
