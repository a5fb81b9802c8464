r"""Manipulator equations: columns by one letter, matrices that depend on them, entry by entry."""

import re
from collections.abc import Sequence

import pytest
from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

import mechanics
from mechanics import RigidBody, Scene, parameters, torque
from mechanics.judge.check import Check, derived
from systems import acrobot, cartpole

ARM = derived(acrobot.scene())
EQUATION = r"\[ M(q)\ddot q + C(q,\dot q)\dot q + g(q) = B\tau \]"
PARTS = (
    r"\[ M(q) = \begin{bmatrix} m_1 l_{c1}^2 + m_2(l_1^2 + l_{c2}^2 + 2 l_1 l_{c2}\cos\theta_2)"
    r" + I_1 + I_2 & m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2 \\"
    r" m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2 & m_2 l_{c2}^2 + I_2 \end{bmatrix} \]",
    r"\[ C = \begin{bmatrix} h\dot\theta_2 & h(\dot\theta_1+\dot\theta_2) \\"
    r" -h\dot\theta_1 & 0 \end{bmatrix}, \qquad h = -m_2 l_1 l_{c2}\sin\theta_2 \]",
    r"\[ g(q) = \begin{bmatrix} (m_1 l_{c1}+m_2 l_1) g\sin\theta_1"
    r" + m_2 l_{c2} g\sin(\theta_1+\theta_2) \\ m_2 l_{c2} g\sin(\theta_1+\theta_2)\end{bmatrix},"
    r" \quad B = \begin{bmatrix} 0 \\ 1 \end{bmatrix} \]",
)


def checked(*texts: str, blame: bool = False) -> Check:
    return mechanics.check(ARM, "\n".join(texts), notation="latex", blame=blame)


def verdicts(*texts: str) -> list[str]:
    return [entry.finding.verdict.name for entry in checked(*texts).judged]


def changed(old: str, new: str) -> list[str]:
    assert sum(part.count(old) for part in (EQUATION, *PARTS)) >= 1
    return [part.replace(old, new, 1) for part in (EQUATION, *PARTS)]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "column",
    [
        "",
        r"\[ q = \begin{bmatrix} \theta_1 \\ \theta_2 \end{bmatrix} \]",
        r"with $\mathbf q = (\theta_1, \theta_2)^T$",
        r"\[ q = [\theta_1, \theta_2]^\top \]",
        r"\[ q = \begin{bmatrix} \theta_1 & \theta_2 \end{bmatrix}^{\mathsf T} \]",
    ],
)
def test_the_manipulator_form_is_proved(column: str) -> None:
    assert verdicts(EQUATION, *PARTS, column) == ["PROVED", "PROVED"]


def test_theta_is_the_column_of_numbered_thetas() -> None:
    texts = [re.sub(r"\bq\b", r"\\theta", text) for text in (EQUATION, *PARTS)]
    found = checked(*texts)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]
    assert any("theta = (theta_1, theta_2)" in remark for remark in found.remarks)


def test_what_a_letter_is_taken_for_is_told() -> None:
    found = checked(EQUATION, *PARTS)
    assert any("q = (theta1, theta2)" in remark for remark in found.remarks)
    notes = [note for entry in found.judged for note in entry.statement.notes]
    assert any(note.startswith("C(...) is read as C") for note in notes)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("old", "new", "rows"),
    [
        ("+ 2 l_1 l_{c2}", "+ l_1 l_{c2}", ["REFUTED", "PROVED"]),
        (r"-h\dot\theta_1 &", r"h\dot\theta_1 &", ["PROVED", "REFUTED"]),
        ("+ g(q)", "- g(q)", ["REFUTED", "REFUTED"]),
        (r"0 \\ 1", r"1 \\ 0", ["REFUTED", "REFUTED"]),
        (r"m_2 l_{c2}^2 + I_2 \end", r"m_2 l_{c2}^2 \end", ["PROVED", "REFUTED"]),
    ],
)
def test_a_wrong_entry_is_refuted_where_it_stands(old: str, new: str, rows: Sequence[str]) -> None:
    assert verdicts(*changed(old, new)) == rows


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("old", "new", "definition", "right"),
    [
        ("+ 2 l_1 l_{c2}", "+ l_1 l_{c2}", "M_11", r"2 l_1 l_{c2} \cos\theta_2"),
        (r"-h\dot\theta_1 &", r"h\dot\theta_1 &", "C_21", r"-h\dot\theta_1"),
        (r"+ m_2 l_{c2} g\sin(\theta_1+\theta_2) \\", r"+ m_2 l_{c2} g\cos(\theta_1+\theta_2) \\",
         "g(q)_1", r"\sin(\theta_1+\theta_2)"),
    ],
)  # fmt: skip
def test_the_entry_is_blamed_by_its_place(old: str, new: str, definition: str, right: str) -> None:
    found = checked(*changed(old, new), blame=True)
    (blame,) = [entry.blame for entry in found.judged if entry.blame is not None]
    (edit,) = blame.repairs[0].edits
    assert edit.definition == definition
    assert edit.right.replace(" ", "").replace(r"\left", "").replace(
        r"\right", ""
    ) == right.replace(" ", "")
    assert blame.repairs[0].finding.shown


def test_a_sign_before_a_matrix_is_found_in_every_row() -> None:
    found = checked(*changed("+ g(q)", "- g(q)"), blame=True)
    for entry in found.judged:
        assert entry.blame is not None
        (edit,) = entry.blame.repairs[0].edits
        assert (edit.written, edit.right) == ("-", "+")


@pytest.mark.campaign
def test_an_entry_that_is_nought_can_lack_a_term() -> None:
    texts = changed(r"h(\dot\theta_1+\dot\theta_2)", "0")
    blame = checked(*texts, blame=True).judged[0].blame
    assert blame is not None
    assert {edit.definition for edit in blame.repairs[0].edits} == {"C_12"}


@pytest.mark.campaign
def test_energies_as_quadratic_forms() -> None:
    kinetic = r"$T = \frac12 \dot q^T M(q) \dot q$"
    assert verdicts(kinetic, PARTS[0]) == ["PROVED"]
    wrong = verdicts(kinetic, PARTS[0].replace("2 l_1", "l_1", 1))
    assert wrong == ["REFUTED"]
    found = checked(kinetic, PARTS[0].replace("2 l_1", "l_1", 1), blame=True).judged[0].blame
    assert found is not None
    assert found.repairs[0].edits[0].definition == "M_11"


def test_a_name_before_a_bracket_stays_a_factor_where_it_may_be_one() -> None:
    found = mechanics.check(cartpole.scene(), r"m_p(l) = 0", notation="latex", blame=False)
    assert found.judged[0].finding.verdict.name in ("REFUTED", "UNDECIDED")
    assert not any("depends on" in note for note in found.judged[0].statement.notes)


def test_a_pair_that_is_raised_is_no_number() -> None:
    found = mechanics.check(ARM, r"\ddot\theta_1 + (l_1, l_2)^2 = 0; \ddot\theta_1 = \tau",
                            notation="latex", blame=False)  # fmt: skip
    assert "a comma is out of place" in found.judged[0].statement.doubt


@pytest.mark.campaign
def test_an_error_in_its_own_definition_ends_the_search_with_an_answer() -> None:
    """The name of an entry may not be put into its own definition."""
    blame = checked(*changed(r"h(\dot\theta_1+\dot\theta_2)", "0"), blame=True).judged[0].blame
    assert blame is not None
    assert "nested" not in blame.searched


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "rates", [("qdd", "qd"), ("q_ddot", "q_dot"), ("ddq", "dq"), ("q''", "q'")]
)
@pytest.mark.parametrize("own", ["theta", "q"])
def test_the_manipulator_form_in_text(rates: tuple[str, str], own: str) -> None:
    text = """h = -m2*l1*lc2*sin(theta2)
d = m2*(lc2^2 + l1*lc2*cos(theta2)) + I2
M = [m1*lc1^2 + m2*(l1^2 + lc2^2 + 2*l1*lc2*cos(theta2)) + I1 + I2, d; d, m2*lc2^2 + I2];
C = [h*theta2_dot, h*(theta1_dot + theta2_dot); -h*theta1_dot, 0];
G = [(m1*lc1 + m2*l1)*g*sin(theta1) + m2*lc2*g*sin(theta1 + theta2); m2*lc2*g*sin(theta1 + theta2)];
M*Q2 + C*Q1 + G == [0; tau]"""
    text = text.replace("Q2", rates[0]).replace("Q1", rates[1]).replace("theta", own)
    found = mechanics.check(ARM, text, notation="text", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]


def rigid() -> Scene:
    """A free rigid body under three torques, with its rates about its own axes."""
    phi, theta, psi, p, q, r = dynamicsymbols("phi theta psi p q r")
    torques = dynamicsymbols("tau_x tau_y tau_z")
    inertias = parameters("I_x I_y I_z", units="kg*m^2 kg*m^2 kg*m^2")
    ground, origin = ReferenceFrame("N"), Point("O")
    first = ground.orientnew("N1", "Axis", (psi, ground.z))
    second = first.orientnew("N2", "Axis", (theta, first.y))
    body = second.orientnew("B", "Axis", (phi, second.x))
    centre = origin.locatenew("C", 0 * ground.x)
    return Scene(
        "satellite", ground, origin, (phi, theta, psi),
        (RigidBody("hub", centre, body, 0, inertia(body, *inertias)),),
        loads=tuple(
            torque(f"{t.func}", t * axis, on="hub") for t, axis in zip(torques, body, strict=True)
        ),
        inputs=tuple(torques),
        speeds=(
            (p, phi.diff() - psi.diff() * sin(theta)),
            (q, theta.diff() * cos(phi) + psi.diff() * cos(theta) * sin(phi)),
            (r, -theta.diff() * sin(phi) + psi.diff() * cos(theta) * cos(phi)),
        ),
    )  # fmt: skip


BODY = derived(rigid())
EULER = r"""\[ J\dot\omega + \omega\times J\omega = \tau \]
where $J = \mathrm{diag}(I_x, I_y, I_z)$, $\omega = (p, q, r)^T$ and
\[ \tau = [\tau_x, \tau_y, \tau_z]^{\top} \]"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (EULER, "PROVED"),
        (EULER.replace(r"+ \omega", r"- \omega"), "REFUTED"),
        (EULER.replace(r"\omega\times J\omega", r"J\omega\times\omega"), "REFUTED"),
        (EULER.replace(r"+ \omega\times J\omega", r"- (J\omega)\times\omega"), "PROVED"),
        (EULER.replace("I_y, I_z)", "I_z, I_y)"), "REFUTED"),
    ],
)
def test_euler_s_equations_as_vectors(text: str, expected: str) -> None:
    found = mechanics.check(BODY, text, notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == [expected] * 3


@pytest.mark.campaign
def test_the_sign_of_a_vector_product_is_blamed_where_it_stands() -> None:
    found = mechanics.check(BODY, EULER.replace(r"+ \omega", r"- \omega"), notation="latex")
    for entry in found.judged:
        assert entry.blame is not None
        (edit,) = entry.blame.repairs[0].edits
        assert (edit.written, edit.right) == ("-", "+")


def test_times_between_numbers_is_a_product() -> None:
    turned = r"(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)"
    text = rf"(m_c + m_p)\times\ddot x + m_p \times l\times{turned} = F"
    found = mechanics.check(cartpole.scene(), text, notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]
    own = text.replace(r"m_p \times l", r"k_1 \times l") + r"\qquad k_1 = m_p \times 1"
    found = mechanics.check(cartpole.scene(), own, notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"]


@pytest.mark.parametrize(
    "column", [r"\[ q = (\theta_1, 2\theta_2)^T \]", r"$q = (\theta_1, -\theta_2)$"]
)
def test_a_column_of_something_else_is_not_passed_over(column: str) -> None:
    """It was called a list that is not used, and q taken for the coordinates."""
    assert "REFUTED" in verdicts(EQUATION, *PARTS, column)


def test_a_vector_product_of_three_is_one_with_brackets_only() -> None:
    """It was read as a x (b x c), which is not (a x b) x c."""
    for three, expected in (
        (r"\omega\times\tau\times\omega - \omega\times(\tau\times\omega)", "UNDECIDED"),
        (r"\omega\times\tau\times\omega - (\omega\times\tau)\times\omega", "UNDECIDED"),
        (r"2\times\omega\times\tau + 2\,\tau\times\omega", "PROVED"),
        (r"\omega\times(\tau\times\omega) - (\omega\times\tau)\times\omega", "PROVED"),
        (r"\omega\times(\tau\times\tau) + (\omega\times\tau)\times\tau", "REFUTED"),
    ):
        text = EULER.replace(r"= \tau \]", rf"= \tau + {three} \]")
        assert text != EULER
        try:
            found = mechanics.check(BODY, text, notation="latex", blame=False).verdict.name
        except mechanics.MechanicsError as error:
            assert "a vector product of three columns" in str(error)
            found = "UNDECIDED"
        assert found == expected


def test_what_the_mass_matrix_alone_uses_is_used() -> None:
    mass = PARTS[0].replace(r"m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2 &", "d &", 1)
    lines = (mass, r"\[ d = m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2 \]")
    assert mass != PARTS[0]
    assert verdicts(*lines) == ["PROVED"]
    assert verdicts(lines[0], lines[1].replace("+ I_2", "- I_2")) == ["REFUTED"]


@pytest.mark.parametrize("column", ["b = [F, 0]^T", r"\mathbf b = (F, 0)", "b = [F, 0]"])
def test_a_column_with_a_nought_is_a_definition(column: str) -> None:
    text = (
        r"\[ M \begin{bmatrix} \ddot x\\ \ddot\theta \end{bmatrix} + \begin{bmatrix}"
        r" -m_p l\dot\theta^2 \sin\theta \\ -m_p g l \sin\theta \end{bmatrix} = b \]"
        r"\[ M = \begin{bmatrix} m_c+m_p & m_p l\cos\theta \\ m_p l\cos\theta & \frac43 m_p l^2"
        rf"\end{{bmatrix}} \] where ${column}$."
    )
    found = mechanics.check(cartpole.scene(), text, notation="latex", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]
