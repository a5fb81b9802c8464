"""Double pendulum in momenta: a public notebook lost squares of lengths."""

import numpy as np
import pytest

import mechanics

POINT = {"m": (1, 2), "l": (1.5, 0.7), "phi": (0.5, -0.3), "p": (0.2, 0.4), "g": 10}
RIGHT, WRONG = "-0.0869915397290", "-0.0733843199812"
NAMES = {"p1": "p_phi1", "p2": "p_phi2"}
MOMENTA = {"pi_1": "p_phi1", "pi_2": "p_phi2"}


def rates(p1, p2, phi1, phi2, m1, m2, l1, l2, squared=True):
    """phi' from the momenta: the linear system that defines them, solved."""
    power = 2 if squared else 1
    mixed = m2 * l1 * l2 * np.cos(phi1 - phi2)
    mass = np.array([[(m1 + m2) * l1**power, mixed], [mixed, m2 * l2**power]])
    return np.linalg.solve(mass, np.array([p1, p2]))


@pytest.mark.parametrize(("squared", "printed"), [(True, RIGHT), (False, WRONG)])
def test_the_printed_values_are_reproduced(assert_agree, squared: bool, printed: str) -> None:
    arguments = (*POINT["p"], *POINT["phi"], *POINT["m"], *POINT["l"])
    assert_agree(rates(*arguments, squared=squared)[:1], (printed,))


LINES = {
    "notebook": r"""\dot{\phi_1} = \frac{l_{1} \pi_{2} \cos{\left(\phi_{1} - \phi_{2} \right)}
        - \pi_{1}}{l_{1} \left(l_{1} l_{2} m_{2} \cos^{2}{\left(\phi_{1} - \phi_{2} \right)}
        - m_{1} - m_{2}\right)}""",
    "right": r"""\dot{\phi_1} = \frac{l_{2} \pi_{1} - l_{1} \pi_{2}
        \cos{\left(\phi_{1} - \phi_{2} \right)}}{l_{1}^2 l_{2} \left(m_{1}
        + m_{2} \sin^{2}{\left(\phi_{1} - \phi_{2} \right)}\right)}""",
}


def test_the_rate_from_the_wrong_momenta_is_refuted(truth) -> None:
    for name, verdict in (("right", "PROVED"), ("notebook", "REFUTED")):
        found = mechanics.check(truth("double_pendulum"), LINES[name], names=MOMENTA, blame=False)
        assert [entry.finding.verdict.name for entry in found.judged] == [verdict]


@pytest.mark.parametrize(
    ("line", "factor"),
    [
        (r"\pi_1 = (m_1 + m_2) l_1 \dot\phi_1 + m_2 l_1 l_2 \cos(\phi_1 - \phi_2) \dot\phi_2", 1),
        (r"\pi_2 = m_2 l_1 l_2 \cos(\phi_1 - \phi_2) \dot\phi_1 + m_2 l_2 \dot\phi_2", 2),
    ],
)
def test_the_length_that_is_not_squared_is_named(truth, edits, line: str, factor: int) -> None:
    (entry,) = mechanics.check(truth("double_pendulum"), line, names=MOMENTA).judged
    ((mistake, wrong, right),) = edits(entry)
    assert (mistake, wrong) == ("POWER", f"l_{factor}")
    assert right.replace("{", "").replace("}", "") == f"l_{factor}^2"


def test_hamiltons_equations_are_read_with_momenta_guessed(truth) -> None:
    text = """
    D = m1 + m2*sin(phi1 - phi2)^2
    h1 = p1*p2*sin(phi1 - phi2)/(l1*l2*D)
    h2 = (m2*l2^2*p1^2 + (m1 + m2)*l1^2*p2^2 - 2*m2*l1*l2*p1*p2*cos(phi1 - phi2)) ...
        /(2*l1^2*l2^2*D^2)
    phi2' = ((m1 + m2)*l1*p2 - m2*l2*p1*cos(phi1 - phi2))/(m2*l1*l2^2*D)
    p1' = -(m1 + m2)*g*l1*sin(phi1) - h1 + h2*sin(2*(phi1 - phi2))
    p2' = -m2*g*l2*sin(phi2) + h1 - h2*sin(2*(phi1 - phi2))
    """
    found = mechanics.check(truth("double_pendulum"), text)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * 3
    meanings = {match.name: match.meaning for match in found.names}
    assert {"p1": "p_phi1", "p2": "p_phi2"}.items() <= meanings.items()
    wrong = text.replace("- h1 +", "+ h1 +")
    found = mechanics.check(truth("double_pendulum"), wrong, blame=False)
    verdicts = [entry.finding.verdict.name for entry in found.judged]
    assert verdicts == ["PROVED", "REFUTED", "PROVED"]


def test_what_a_text_calls_p_itself_is_no_generalized_momentum(truth) -> None:
    text = r"p_x = m_0 \dot x \\ \dot{p}_x = m_0 \ddot x"
    found = mechanics.check(truth("double_inverted_pendulum"), text)
    assert any(remark.startswith("p_x is taken as defined by") for remark in found.remarks)
    assert [entry.finding.verdict.name for entry in found.judged] == ["UNDECIDED"]


def test_an_energy_in_momenta_is_blamed_by_what_it_would_give(truth, edits) -> None:
    text = """
    phi1'' * (m1 + m2)*l1 + m2*l2*phi2''*cos(phi1 - phi2) ...
        + m2*l2*phi2'^2*sin(phi1 - phi2) + (m1 + m2)*g*sin(phi1) = 0
    L = (p1*phi1' + p2*phi2')/2 + (m1 + m2)*g*l1*cos(phi1) + m2*g*l2*sin(phi2)
    """
    equation, lagrangian = mechanics.check(truth("double_pendulum"), text).judged
    assert equation.finding.verdict.name == "PROVED"
    assert edits(lagrangian) == [("FUNCTION", "sin(phi2)", "cos(phi2)")]
    assert any("the equations would differ by (0," in w for w in lagrangian.blame.explanations)
