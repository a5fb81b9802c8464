"""A wrong energy beside right equations is blamed on the energy."""

from collections.abc import Callable

import pytest

import mechanics
from mechanics.blame.difference import differences
from mechanics.blame.energies import wrong_energies, wrong_rows
from mechanics.blame.explanations import UNBALANCED, explanations
from mechanics.blame.reference import Reference
from mechanics.checks.ledger import check_row
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene.published import published
from mechanics.scene.quantities import KineticEnergy, PotentialEnergy
from mechanics.symbolic import prove_equal

TruthOf = Callable[[str], Equations]
FINE = "the equations are right, this energy is not: "

EQUATIONS = """
c1 = m0 + m1 + m2
c2 = m1*l1 + m2*L1
c3 = m2*l2
c4 = m1*l1**2 + m2*L1**2 + J1
c5 = m2*l2*L1
c6 = m2*l2**2 + J2
c7 = (m1*l1 + m2*L1)*g
c8 = m2*l2*g
c1*x_ddot + c2*theta1_ddot*cos(theta1) + c3*theta2_ddot*cos(theta2) = c2*theta1_dot**2*sin(theta1) + c3*theta2_dot**2*sin(theta2) + u
c2*cos(theta1)*x_ddot + c4*theta1_ddot + c5*cos(theta1 - theta2)*theta2_ddot = c7*sin(theta1) - c5*theta2_dot**2*sin(theta1 - theta2)
c3*cos(theta2)*x_ddot + c5*cos(theta1 - theta2)*theta1_ddot + c6*theta2_ddot = c5*theta1_dot**2*sin(theta1 - theta2) + c8*sin(theta2)
"""  # noqa: E501
ENERGY = (
    "T = m0*x_dot**2/2 + m1/2*((x_dot + l1*theta1_dot*cos(theta1))**2"
    " + (l1*theta1_dot*sin(theta1))**2)"
    " + m2/2*((x_dot + L1*theta1_dot*cos(theta1) + l2*theta2_dot*cos(theta2))**2"
    " + (L1*theta1_dot*sin(theta1) + l2*theta2_dot*sin(theta2))**2)"
    " + J1*theta1_dot**2/2 + J2*theta1_dot**2/2"
)


def told(truth: Equations, text: str) -> list[tuple[str, tuple[str, ...]]]:
    judged = mechanics.check(truth, text, blame=False).judged
    words = explanations(
        Reference(truth), [e.statement for e in judged], [e.finding for e in judged]
    )
    return [(e.finding.verdict.name, own) for e, own in zip(judged, words, strict=True)]


def test_double_inverted_pendulum_whose_energy_has_the_wrong_rate(truth_of: TruthOf) -> None:
    truth = truth_of("double_inverted_pendulum")
    *rows, energy = told(truth, EQUATIONS + ENERGY)
    assert rows == [("PROVED", ())] * 3
    assert energy == (
        "REFUTED",
        (
            FINE + "derived from it, the equations would differ by"
            " (0, J2*theta1_ddot, -J2*theta2_ddot); along the motion its rate is not the power of"
            " the loads",
        ),
    )


def test_its_differences_name_the_rotation_of_the_second_rod(truth_of: TruthOf) -> None:
    truth = truth_of("double_inverted_pendulum")
    (entry,) = mechanics.check(truth, ENERGY, blame=False).judged
    found = differences(Reference(truth), entry.statement)
    assert sorted((d.group, d.written, d.right, d.origin) for d in found) == [
        ("coefficient of theta1_dot**2", "J2/2", "", ()),
        ("coefficient of theta2_dot**2", "", "J2/2", ("rod2: kinetic energy of rotation",)),
    ]


@pytest.mark.campaign
def test_equations_that_follow_from_a_wrong_energy_say_so(truth_of: TruthOf) -> None:
    truth = truth_of("double_inverted_pendulum")
    wrong = EQUATIONS.replace("m2*L1**2 + J1", "m2*L1**2 + J1 + J2").replace("l2**2 + J2", "l2**2")
    first, second, third, energy = told(truth, wrong + ENERGY)
    words = "it follows from the energy as it is written, which is wrong"
    assert first == ("PROVED", ())
    assert second == third == ("REFUTED", (words,))
    assert energy[0] == "REFUTED"
    assert not energy[1][0].startswith(FINE)


def test_a_right_energy_is_not_blamed_for_wrong_equations(truth_of: TruthOf) -> None:
    truth = truth_of("double_inverted_pendulum")
    right = ENERGY.replace("J2*theta1_dot", "J2*theta2_dot")
    wrong = EQUATIONS.replace("+ c8*sin", "- c8*sin")
    *_, third, energy = told(truth, wrong + right)
    assert third == ("REFUTED", ("gravity reversed", UNBALANCED))
    assert energy == ("PROVED", ())


def test_a_check_looks_at_what_stands_beside(truth_of: TruthOf) -> None:
    """The energy is right, and so it is not searched; it tells of the equation all the same."""
    truth = truth_of("double_inverted_pendulum")
    right = ENERGY.replace("J2*theta1_dot", "J2*theta2_dot")
    wrong = EQUATIONS.replace("+ c8*sin", "- c8*sin")
    *_, third, _ = mechanics.check(truth, wrong + right).judged
    assert third.blame is not None
    assert third.blame.explanations == ("gravity reversed", UNBALANCED)


def test_a_wrong_equation_that_keeps_the_energy_is_not_called_unbalanced(
    truth_of: TruthOf,
) -> None:
    truth = truth_of("elastic_pendulum")
    # A force that is always across the motion does no work: it has no place here, but no power.
    text = (
        "V = k*x**2 - M*g*L/2*cos(theta)\n"
        "(M+m)*x_ddot + 2*k*x + M*L/2*(theta_ddot*cos(theta) - theta_dot**2*sin(theta))"
        " + m*L*theta_dot*x_dot = 0\n"
        "M*L/2*x_ddot*cos(theta) + M*L**2/3*theta_ddot + M*g*L/2*sin(theta) - m*L*x_dot**2 = 0"
    )
    energy, *rows = told(truth, text)
    assert energy == ("PROVED", ())
    assert rows == [("REFUTED", ())] * 2


def test_a_wrong_potential_energy(truth_of: TruthOf) -> None:
    truth = truth_of("elastic_pendulum")
    text = (
        "V = k*x**2/2 - M*g*L/2*cos(theta)\n"
        "(M+m)*x_ddot + 2*k*x + M*L/2*(theta_ddot*cos(theta) - theta_dot**2*sin(theta)) = 0"
    )
    (verdict, (words,)), equation = told(truth, text)
    assert verdict == "REFUTED"
    assert words.startswith(FINE + "derived from it, the equations would differ by (-k*x, 0)")
    assert equation == ("PROVED", ())


@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", [KineticEnergy, PotentialEnergy])
def test_rows_of_a_wrong_energy_are_those_of_lagrange_from_it(
    reference: Reference, kind: type
) -> None:
    """Twice the energy: the rows that are too much are the rates, or the loads, themselves."""
    truth, derivation, scene = reference.truth, reference.derivation, reference.truth.scene
    pieces = derivation.kinetic if kind is KineticEnergy else derivation.potential
    value = sum(piece.value for piece in pieces)
    row = published("1", kind(), 2 * value, label="energy")
    finding = check_row(scene, row, truth)
    energies = wrong_energies(derivation, [Statement(row, "energy", "1")], [finding])
    if finding.verdict is not Verdict.REFUTED:
        assert not value.free_symbols & {*scene.q, *scene.u}
        return
    extra = wrong_rows(scene, energies)
    if kind is PotentialEnergy:
        assert scene.speeds or not set().union(*(r.free_symbols for r in extra)) & {*scene.ud}
    elif not scene.speeds:
        # d/dt(dT/dq') - dT/dq has the metric of the kinetic energy before the accelerations.
        wanted = Kinematics(scene).mass_matrix
        slopes = [row.diff(ud) for row in extra for ud in scene.ud]
        assert prove_equal("rows", slopes, list(wanted)).shown
