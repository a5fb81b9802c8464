"""The ledger: every typed row holds, and rows that say nothing or the wrong thing do not."""

from collections import Counter
from functools import cache

import pytest
from sympy import Symbol, cos, sin
from sympy.physics.mechanics import dynamicsymbols

import systems
from mechanics.checks.ledger import QUANTITIES, check_row
from mechanics.checks.ledger_compare import ordered
from mechanics.checks.ledger_motion import check_complete
from mechanics.equations import Equations
from mechanics.errors import InputError, SceneError
from mechanics.kernel import Finding, Verdict
from mechanics.linear import ledger as linear
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes import free_body
from mechanics.routes.derivation import as_program, by_route
from mechanics.scene import quantities as q
from mechanics.scene.published import Published, Quantity, published
from mechanics.scene.system import System
from mechanics.scene.typed import along_z, d_dt, rounded
from systems import elastic_pendulum as pendulum
from systems import four_bar, rocker

PENDULUM, ROCKER = systems.SEED[:2]
T, N, N1 = (Symbol(name, real=True) for name in ("T", "N", "N1"))
a, b = Symbol("a"), Symbol("b")
x, theta, t = pendulum.x, pendulum.theta, dynamicsymbols._t


@cache
def equations(system: System) -> Equations:
    return by_route("free_body", system.scene())


def rows(system: System) -> list[Published]:
    return [row for row in system.published if isinstance(row.quantity, QUANTITIES)]


def check(system: System, quantity: Quantity, *sides: object) -> Finding:
    row = published("tag", quantity, *sides, label="label")
    return check_row(equations(system).scene, row, equations(system))


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", [s for s in systems.ALL if rows(s)], ids=lambda s: s.name)
def test_every_row_is_shown(system: System) -> None:
    derived = equations(system)
    findings = [check_row(derived.scene, row, derived) for row in rows(system)]
    assert [finding for finding in findings if not finding.shown] == []


@pytest.mark.parametrize("system", systems.ALL, ids=lambda system: system.name)
def test_every_row_belongs_to_one_ledger(system: System) -> None:
    strays = [
        row
        for row in system.published
        if isinstance(row.quantity, QUANTITIES) == isinstance(row.quantity, linear.QUANTITIES)
    ]
    assert system.published
    assert strays == []


@pytest.mark.parametrize("system", systems.ALL, ids=lambda system: system.name)
def test_rows_can_be_told_apart(system: System) -> None:
    names = Counter((row.tag, row.label) for row in system.published)
    assert [name for name, count in names.items() if count > 1] == []


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "system",
    [s for s in systems.ALL if any(r.quantity == q.EquationOfMotion() for r in s.published)],
    ids=lambda system: system.name,
)
def test_the_equations_of_motion_are_complete(system: System) -> None:
    finding = check_complete(equations(system).scene, rows(system), equations(system))
    assert finding.shown, finding


def test_one_equation_of_motion_of_two_is_not_complete() -> None:
    six = [row for row in PENDULUM.published if row.tag == "(6)"]
    finding = check_complete(equations(PENDULUM).scene, six, equations(PENDULUM))
    assert finding.verdict is Verdict.REFUTED


def test_squares_of_equations_determine_nothing() -> None:
    """Their slopes by u' vanish along every motion."""
    squares = [
        published(row.tag, q.EquationOfMotion(), (row.sides[0] - row.sides[-1]) ** 2, 0, label="")
        for row in PENDULUM.published if isinstance(row.quantity, q.EquationOfMotion)
    ]  # fmt: skip
    finding = check_complete(equations(PENDULUM).scene, squares, equations(PENDULUM))
    assert not finding.shown


def test_completeness_needs_an_equation_of_motion() -> None:
    with pytest.raises(InputError, match="no equation of motion among"):
        check_complete(equations(PENDULUM).scene, PENDULUM.published[:2], equations(PENDULUM))


def test_definitions_are_expanded_only_where_needed() -> None:
    momentum = q.AngularMomentum("rocker", along="-z")
    rate = rocker.theta.diff(t)
    plain = check(ROCKER, momentum, rocker.I_C * rate)
    expanded = check(ROCKER, momentum, (2 * rocker.I_1 + rocker.I_2) * rate)
    assert "by definition" not in plain.evidence
    assert expanded.verdict is Verdict.PROVED
    assert "I_1, I_2, I_C by definition" in expanded.evidence


def test_a_definition_may_use_another() -> None:
    order = [symbol for symbol, _ in ordered({a: 2 * b, b: Symbol("c")})]
    assert order == [b, a]


def test_definitions_in_a_circle_are_refused() -> None:
    with pytest.raises(SceneError, match="a, b go round in a circle"):
        ordered({a: b, b: a})


def test_a_row_without_accelerations_is_no_equation_of_motion() -> None:
    finding = check(PENDULUM, q.EquationOfMotion(), x.diff(t, 2), x.diff(t, 2))
    assert finding.verdict is Verdict.UNDECIDED
    assert "holds no acceleration" in finding.evidence


def test_an_identity_by_definition_is_no_equation_of_motion() -> None:
    rate = rocker.theta.diff(t, 2)
    finding = check(ROCKER, q.EquationOfMotion(), rocker.I_C * rate, rocker.ROCKER.inertia * rate)
    assert finding.verdict is Verdict.UNDECIDED
    assert "holds no acceleration" in finding.evidence


def test_a_multiple_of_an_equation_of_motion_is_one() -> None:
    (row,) = (row for row in PENDULUM.published if row.tag == "(7)")
    scaled = check(PENDULUM, q.EquationOfMotion(), 0, -3 * cos(theta) * row.sides[0])
    assert scaled.shown


def test_reactions_along_the_motion() -> None:
    (M, m, L, g) = (pendulum.M, pendulum.m, pendulum.L, pendulum.g)
    lift = M * L / 2 * (theta.diff(t, 2) * sin(theta) + theta.diff(t) ** 2 * cos(theta))
    assert check(PENDULUM, q.ReactionValue("N1"), (M + m) * g + lift).shown
    wrong = check(PENDULUM, q.ReactionValue("N1"), (M + m) * g - lift)
    assert wrong.verdict is Verdict.REFUTED
    assert wrong.witness is not None


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("0.88", Verdict.PROVED),
        ("0.8797", Verdict.PROVED),
        ("0.87", Verdict.REFUTED),
        ("0.8796", Verdict.REFUTED),
        ("-0.88", Verdict.REFUTED),
    ],
)
def test_rounded_numbers(text: str, verdict: Verdict) -> None:
    typed = rounded(text) * rocker.M * rocker.R**2
    finding = check(ROCKER, q.Inertia(rocker.ROCKER), typed)
    assert finding.verdict is verdict
    assert (finding.witness is None) == (verdict is Verdict.PROVED)


def test_a_rounded_number_times_the_wrong_expression_is_refuted() -> None:
    finding = check(ROCKER, q.Inertia(rocker.ROCKER), rounded("0.88") * rocker.M * rocker.R)
    assert finding.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("quantity", "sides", "message"),
    [
        (Quantity(), (0,), "Quantity is no quantity that a scene alone gives"),
        (q.EquationOfMotion(), (x,), "1 of 2 sides typed"),
        (q.MomentumPrinciple("carriage", "x"), (T,), "1 of 2 sides typed"),
        (q.Position("C"), (), "0 of 1 sides typed"),
        (q.Position("C"), (x,), "1 entries typed for 3 derived"),
        (q.Position("C", "x"), (along_z(x),), "3 entries typed for 1 derived"),
        (q.Position("D", "x"), (x,), "no point 'D'"),
        (q.ReactionValue("Q"), (N,), "has no reaction .Q.: they are"),
        (q.AngularMomentum(("carriage", "pendulum"), along="z"), (x,), "name the point"),
        (q.Position("C", "x"), (rounded("0.5") + x,), "is no rounded number times"),
    ],
)
def test_rows_that_cannot_be_checked(quantity: Quantity, sides: tuple, message: str) -> None:
    with pytest.raises(InputError, match=message):
        check(PENDULUM, quantity, *sides)


def test_an_unknown_body_is_named() -> None:
    with pytest.raises(SceneError, match="no body 'cart'"):
        check(PENDULUM, q.Momentum("cart", "x"), x)


def test_rows_along_the_motion_need_equations() -> None:
    (row,) = (row for row in PENDULUM.published if row.tag == "(6)")
    with pytest.raises(InputError, match="pass equations="):
        check_row(PENDULUM.scene(), row)


def test_equations_of_another_scene_are_refused() -> None:
    (row,) = (row for row in PENDULUM.published if row.tag == "(6)")
    with pytest.raises(InputError, match="belong to another scene, rocker"):
        check_row(PENDULUM.scene(), row, equations(ROCKER))


def test_rows_of_a_constrained_scene_hold_on_its_manifold() -> None:
    (system,) = (system for system in systems.ALL if system.name == "four_bar")
    end = q.Position("end of the rocker", "x")
    assert check(system, end, four_bar.d).shown
    assert check(system, end, -four_bar.d).verdict is Verdict.REFUTED
    closure = sum(
        length * cos(angle)
        for length, angle in (
            (four_bar.l1, four_bar.q1),
            (four_bar.l2, four_bar.q2),
            (four_bar.l3, four_bar.q3),
        )
    )
    assert check(system, q.EquationOfMotion(), d_dt(d_dt(closure)), 0).shown


SIXTH, SEVENTH = (
    row.sides[0] - row.sides[1] for row in rows(PENDULUM) if row.tag in ("(6)", "(7)")
)


@pytest.mark.parametrize("sides", [(SIXTH**2, 0), (SIXTH * SEVENTH, 0), (SIXTH**3, SIXTH**2)])
def test_a_product_of_right_equations_is_no_equation_of_motion(sides: tuple[object, ...]) -> None:
    # It vanishes along the motion, and along others: right, yet it says too little.
    found = check(PENDULUM, q.EquationOfMotion(), *sides)
    assert found.verdict is Verdict.UNDECIDED
    assert "other motions satisfy too" in found.evidence


def test_a_ratio_of_accelerations_is_an_equation_of_motion() -> None:
    equation = SEVENTH / x.diff(t, 2)
    assert check(PENDULUM, q.EquationOfMotion(), equation, 0).shown
    assert check(PENDULUM, q.EquationOfMotion(), equation + 1, 0).verdict is Verdict.REFUTED


def test_a_symbol_that_the_scene_does_not_have_is_named() -> None:
    stranger = Symbol("mm", positive=True)
    found = check(PENDULUM, q.EquationOfMotion(), SIXTH + stranger * x, 0)
    assert found.verdict is Verdict.UNDECIDED and found.evidence.startswith("mm: the scene has no")
    found = check(PENDULUM, q.ReactionValue("N"), Symbol("M") * 9)
    assert found.verdict is Verdict.UNDECIDED and found.evidence.startswith("M: the scene has no")


def test_a_reaction_equal_to_itself_is_no_equation_of_motion() -> None:
    finding = check(PENDULUM, q.EquationOfMotion(), N1, N1)
    assert finding.verdict is Verdict.UNDECIDED
    assert "holds no acceleration" in finding.evidence


@pytest.mark.parametrize(
    ("sides", "verdict", "words"),
    [
        ((SIXTH, 0), Verdict.PROVED, ""),
        ((SEVENTH, 0), Verdict.PROVED, ""),
        ((SEVENTH + x, 0), Verdict.REFUTED, ""),
        ((theta.diff(t, 2), theta.diff(t, 2)), Verdict.UNDECIDED, "holds no acceleration"),
        ((N1, N1), Verdict.UNDECIDED, "holds no acceleration"),
        ((SIXTH * SEVENTH, 0), Verdict.UNDECIDED, "not linear in the accelerations"),
    ],
)
def test_rows_along_the_motion_of_equations_too_long_to_be_written(
    sides: tuple[object, ...], verdict: Verdict, words: str
) -> None:
    """Equations that stay a program judge rows as those in SymPy do."""
    scene = PENDULUM.scene()
    mechanism = lower(scene, Builder())
    long = as_program(scene, mechanism, free_body.derive(mechanism))
    finding = check_row(scene, published("tag", q.EquationOfMotion(), *sides, label="row"), long)
    assert finding.verdict is verdict, finding
    assert words in finding.evidence
