"""Laws and cases of the differences of a refuted statement, term by term."""

import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest
from sympy import Expr, S, Symbol, sympify

import mechanics
from mechanics.blame.difference import differences, groups
from mechanics.blame.explanations import explanations
from mechanics.blame.reference import Reference
from mechanics.blame.result import Difference
from mechanics.blame.terms import Terms, terms_of, total, written
from mechanics.checks.ledger_motion import put_motion
from mechanics.checks.manifold import project
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.symbolic import Arithmetic, decide

Stated = Callable[..., Statement]
ONLY = "only their difference is shown"


def wrong_rows(reference: Reference, seed: str, count: int = 1) -> list[Expr]:
    """Each generalized row with the factor of some terms changed."""
    source = random.Random(seed)
    found = []
    for row in reference.derivation.generalized_rows:
        terms = total(terms_of([piece.value for piece in row.pieces]))
        changed: Terms = dict(terms)
        ordered = sorted(terms, key=lambda monomial: str(written({monomial: Fraction(1)})))
        for monomial in source.sample(ordered, min(count, len(terms))):
            changed[monomial] = source.choice([-1, 2, 3]) * terms[monomial]
        found.append(written(changed))
    return found


def parsed(truth: Equations, text: str) -> Expr:
    """What a difference shows, read back."""
    scene = truth.scene
    known = {*scene.q, *scene.u, *scene.ud, *scene.input_symbols, *scene.parameters}
    known |= {reaction.symbol for reaction in scene.reactions}
    return sympify(text, locals={symbol.name: symbol for symbol in known}) if text else S.Zero


def summed(truth: Equations, found: tuple[Difference, ...]) -> Expr:
    """Written less right, of all groups together."""
    values = S.Zero
    for difference in found:
        assert ONLY not in difference.group
        factor = S.One
        name = difference.group.split(",")[0]
        if name.startswith("coefficient of "):
            factor = Symbol(name.removeprefix("coefficient of "), real=True)
        values += factor * (parsed(truth, difference.written) - parsed(truth, difference.right))
    return values


@pytest.mark.sample(2)
@pytest.mark.parametrize("count", [1, 2])
def test_what_is_shown_sums_to_written_less_right(
    reference: Reference, stated: Stated, count: int
) -> None:
    for row in wrong_rows(reference, f"sum {count}", count):
        found = differences(reference, stated(row))
        assert 1 <= len(found) <= count
        shown = summed(reference.truth, found)

        # What is right vanishes along the motion, so that there the rest is the whole.
        def experiment(a: Arithmetic, row: Expr = row, shown: Expr = shown) -> list:
            project(a, reference.truth.kinematics)
            put_motion(a, reference.truth)
            return [(a.value(row), a.value(shown))]

        assert decide("differences", experiment, try_normal=False).shown


@pytest.mark.sample(2)
def test_a_changed_term_is_all_that_differs_and_has_an_origin(
    reference: Reference, stated: Stated
) -> None:
    for row in wrong_rows(reference, "one"):
        (found,) = groups(reference, stated(row))
        assert len(found.written) + len(found.right) >= 2
        assert found.origin


@pytest.mark.sample(2)
def test_scaled_swapped_and_divided_statements_have_the_same_origin(
    reference: Reference, stated: Stated
) -> None:
    scene = reference.truth.scene
    (mass, *_) = [p for p in scene.parameters if p.is_positive]
    for row in wrong_rows(reference, "scaled"):
        plain = groups(reference, stated(row))
        for other in (stated(3 * row / mass), stated(S.Zero, right=row)):
            assert [g.origin for g in groups(reference, other)] == [g.origin for g in plain]


@pytest.mark.sample(2)
def test_a_right_equation_has_no_differences(reference: Reference, stated: Stated) -> None:
    for row in reference.derivation.generalized_rows:
        assert differences(reference, stated(row.value)) == ()


@pytest.mark.sample(2)
def test_one_changed_term_says_what_is_meant_without_the_repair(
    reference: Reference, stated: Stated
) -> None:
    rows = wrong_rows(reference, "repaired")
    for row, right in zip(rows, reference.derivation.generalized_rows, strict=True):
        statement = stated(row)
        repaired = replace(statement.row, sides=(right.value, S.Zero))
        found = differences(reference, statement, repaired=repaired)
        assert found == differences(reference, statement)


@pytest.mark.sample(2)
def test_the_repaired_statement_is_what_is_meant(reference: Reference, stated: Stated) -> None:
    """With two changed terms another right equation may be as near; the repair decides."""
    rows = wrong_rows(reference, "repaired", 2)
    for row, right in zip(rows, reference.derivation.generalized_rows, strict=True):
        statement = stated(row)
        repaired = replace(statement.row, sides=(right.value, S.Zero))
        rest = (
            row
            - right.value
            - summed(reference.truth, differences(reference, statement, repaired=repaired))
        )
        assert decide("repaired", lambda a, rest=rest: [(a.value(rest), a.value(S.Zero))]).shown


PENDULUM = "(M+m)*x_ddot + 2*k*x + M*L/2*(theta_ddot*cos(theta) - theta_dot**2*sin(theta)) = 0"
MOMENT = "M*L/2*x_ddot*cos(theta) + M*L**2/3*theta_ddot + M*g*L/2*sin(theta) = 0"
LINEAR, ANGULAR = "pendulum: rate of linear momentum", "pendulum: rate of angular momentum"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (PENDULUM.replace("2*k", "k"), [("stiffness", "k*x", "2*k*x", ("load k on carriage",))]),
        (
            PENDULUM.replace("- theta_dot", "+ theta_dot"),
            [
                (
                    "products of speeds",
                    "L*M*theta_dot**2*sin(theta)/2",
                    "-L*M*theta_dot**2*sin(theta)/2",
                    (LINEAR,),
                )
            ],
        ),
        (
            MOMENT.replace("/3", "/4"),
            [("coefficient of theta_ddot", "L**2*M/4", "L**2*M/3", (LINEAR, ANGULAR))],
        ),
        (
            MOMENT.replace("sin", "cos"),
            [("gravity", "L*M*g*cos(theta)/2", "L*M*g*sin(theta)/2", ("gravity on pendulum",))],
        ),
        (
            "M*L/2*x_ddot*cos(theta) + (I_C + M*L**2/2)*theta_ddot + M*g*L/2*sin(theta) = 0",
            [("coefficient of theta_ddot", "L**2*M/2", "L**2*M/4", (LINEAR,))],
        ),
        (
            "N1 = (M+m)*g + M*L/2*(theta_ddot*sin(theta) - theta_dot**2*cos(theta))",
            [
                (
                    "products of speeds",
                    "L*M*theta_dot**2*cos(theta)/2",
                    "-L*M*theta_dot**2*cos(theta)/2",
                    (LINEAR,),
                )
            ],
        ),
        (
            "V = k*x**2/2 - M*g*L/2*cos(theta)",
            [("terms without speeds", "k*x**2/2", "k*x**2", ("load k",))],
        ),
    ],
)
def test_of_the_pendulum_on_an_elastic_support(
    truth_of: Callable[[str], Equations], text: str, expected: list
) -> None:
    truth = truth_of("elastic_pendulum")
    (entry,) = mechanics.check(truth, text, blame=False).judged
    found = differences(Reference(truth), entry.statement)
    assert [(d.group, d.written, d.right, d.origin) for d in found] == expected


def test_a_mass_matrix_is_compared_entry_by_entry(truth_of: Callable[[str], Equations]) -> None:
    truth = truth_of("elastic_pendulum")
    text = "Matrix([[M+m, M*L/2*cos(theta)], [M*L/2*sin(theta), M*L**2/3]])"
    (entry,) = mechanics.check(truth, text, about="mass matrix", blame=False).judged
    (found,) = differences(Reference(truth), entry.statement)
    assert (found.group, found.written, found.right) == (
        "entry (2, 1)", "L*M*sin(theta)/2", "L*M*cos(theta)/2",
    )  # fmt: skip
    assert found.origin == ("pendulum: kinetic energy of translation",)


def test_an_equation_solved_for_its_acceleration_has_its_denominators_multiplied_out(
    truth_of: Callable[[str], Equations],
) -> None:
    truth = truth_of("cartpole")
    text = (
        "theta_ddot = (g*sin(theta) - cos(theta)*(F + mp*l*theta_dot**2*sin(theta))/(mc+mp))"
        "/(l*(7/3 - mp*cos(theta)**2/(mc+mp)))"
    )
    (entry,) = mechanics.check(truth, text, blame=False).judged
    (found,) = differences(Reference(truth), entry.statement)
    assert found.group == "coefficient of theta_ddot, denominators multiplied out"
    assert (found.written, found.right) == ("7*(mc + mp)", "4*(mc + mp)")
    assert found.origin == ("pole: rate of linear momentum", "pole: rate of angular momentum")


def test_what_shares_no_term_with_a_right_equation_has_no_differences(
    truth_of: Callable[[str], Equations], stated: Stated
) -> None:
    truth = truth_of("rocker")
    strange = truth.scene.ud[0] ** 3 - 7
    assert differences(Reference(truth), stated(strange)) == ()


def test_beside_a_repair_terms_keep_the_denominators_that_were_written(
    truth_of: Callable[[str], Equations],
) -> None:
    truth = truth_of("cartpole")
    right = (
        "theta_ddot = (g*sin(theta) - cos(theta)*(F + mp*l*theta_dot**2*sin(theta))/(mc+mp))"
        "/(l*(4/3 - mp*cos(theta)**2/(mc+mp)))"
    )
    wrong = right.replace("(g*sin", "(-g*sin")
    one, two = mechanics.check(truth, f"{wrong}\n{right}", blame=False).judged
    (found,) = differences(Reference(truth), one.statement, repaired=two.statement.row)
    assert (found.group, found.origin) == ("gravity", ("gravity on pole",))
    assert sympify(found.written) == -sympify(found.right)


def test_a_generalized_momentum_is_compared_rate_by_rate(
    truth_of: Callable[[str], Equations],
) -> None:
    truth = truth_of("double_pendulum")
    text = "p1 = (m1 + m2)*l1*phi1_dot + m2*l1*l2*cos(phi1 - phi2)*phi2_dot"
    (entry,) = mechanics.check(truth, text, names={"p1": "p_phi1"}, blame=False).judged
    (found,) = differences(Reference(truth), entry.statement)
    assert found.group == "coefficient of phi1_dot"
    assert (found.written, found.right) == ("l1*(m1 + m2)", "l1**2*(m1 + m2)")
    assert len(found.origin) == 2


@pytest.mark.campaign
def test_hamiltons_equations_are_compared_in_their_momenta(
    truth_of: Callable[[str], Equations],
) -> None:
    truth = truth_of("double_pendulum")
    right = (
        "D = m1 + m2*sin(phi1 - phi2)**2\n"
        "h1 = p1*p2*sin(phi1 - phi2)/(l1*l2*D)\n"
        "h2 = (m2*l2**2*p1**2 + (m1 + m2)*l1**2*p2**2 - 2*m2*l1*l2*p1*p2*cos(phi1 - phi2))"
        "/(2*l1**2*l2**2*D**2)\n"
        "p2' = -m2*g*l2*sin(phi2) + h1 - h2*sin(2*(phi1 - phi2))"
    )
    wrong = right.replace("= -m2", "= m2")
    names = {"p1": "p_phi1", "p2": "p_phi2"}
    (one,) = mechanics.check(truth, wrong, names=names, blame=False).judged
    (two,) = mechanics.check(truth, right, names=names, blame=False).judged
    (found,) = differences(Reference(truth), one.statement, repaired=two.statement.row)
    assert (found.group, found.written, found.right, found.origin) == (
        "gravity", "-g*l2*m2*sin(phi2)", "g*l2*m2*sin(phi2)", ("gravity on lower",),
    )  # fmt: skip
    assert explanations(Reference(truth), [one.statement], [one.finding]) == (
        ("gravity reversed",),
    )
