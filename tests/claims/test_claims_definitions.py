"""A definition is judged where it is used; one that nothing judged uses leaves a doubt."""

import pytest

import mechanics
from mechanics.claims.definitions import in_order
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.text.read import read_text
from mechanics.judge.check import derived
from systems import cartpole, double_pendulum, elastic_pendulum

CART = derived(cartpole.scene())
PIVOT = derived(elastic_pendulum.scene())

RAIL = "(mc + mp)*xdd = F - mp*l*(theta''*cos(theta) - theta'^2*sin(theta))\n"


def verdicts(truth, text: str, **options) -> list[str]:
    found = mechanics.check(truth, text, blame=False, **options)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    "line",
    [
        "R = mc*g - 3*l*cos(theta)",
        "R = 7",
        "R = F",
        "K = [mc, mp; mp, 7*l]",
        "MM = [mc, mp; mp, 7, l]",
        "R = 2*S; S = 7*l",
        "R = S; S = R",
        "R = R + l",
        "R = mc + mc = 2*mc",
    ],
)
def test_what_nothing_uses_is_in_doubt_and_beside_what_is_right(line: str) -> None:
    found = mechanics.check(CART, RAIL + line, blame=False)
    assert found.judged[0].finding.verdict.name == "PROVED"
    assert not found.ok
    assert "UNDECIDED" in [entry.finding.verdict.name for entry in found.judged]


def test_the_doubt_says_that_it_is_not_checked_and_keeps_its_number() -> None:
    found = mechanics.check(CART, f"R = 7*l\n{RAIL}", blame=False)
    first, second = found.judged
    assert (first.statement.tag, second.statement.tag) == ("1", "2")
    assert "never used, so it is NOT checked" in first.finding.evidence
    assert not any("R is taken as defined" in remark for remark in found.remarks)


def test_what_code_returns_at_its_end_says_nothing() -> None:
    assert verdicts(CART, f"{RAIL}dz = [xd; thetad; xdd; thetadd]") == ["PROVED"]


@pytest.mark.parametrize(
    "text",
    [
        # Before and after its use, through another one, and in a circle beside it.
        f"{RAIL.replace('mc + mp', 'm_all')}m_all = mc + mp",
        f"{RAIL.replace('mc + mp', 'm_all')}m_all = mc + rest; rest = mp",
        f"m_all = mc + rest; rest = mp; {RAIL.replace('mc + mp', 'm_all')}",
    ],
)
def test_a_definition_holds_in_all_lines(text: str) -> None:
    assert verdicts(CART, text) == ["PROVED"]


def test_definitions_stand_behind_what_they_use() -> None:
    text = "a1 = b1 + c1; b1 = c1; c1 = 3; d1 = e1; e1 = d1"
    lines = read_text(text, Naming(Vocabulary(cartpole.scene())))
    defined = {line.sides[0].name: line for line in lines}
    assert in_order(defined) == ["c1", "b1", "a1", "e1", "d1"]


@pytest.mark.parametrize("rate", ["x' = v", "v = x'", "xd = v", "x.diff(t) = v"])
def test_a_name_for_a_rate_is_its_definition(rate: str) -> None:
    lines = f"{rate}\n{RAIL.replace('xdd', 'v.diff(t)')}"
    assert verdicts(CART, lines) == ["PROVED"]
    assert verdicts(CART, lines.replace("mc + mp", "mc - mp")) == ["REFUTED"]


def test_a_momentum_on_the_left_is_judged_as_it() -> None:
    right = "p_x = (mc + mp)*x' + mp*l*theta'*cos(theta)"
    assert verdicts(CART, right) == ["PROVED"]
    assert verdicts(CART, right.replace("cos", "sin")) == ["REFUTED"]
    # A place may go by the same name, which says nothing of the motion.
    place = mechanics.check(CART, "p_x = x + l*sin(theta)", blame=False)
    assert not place.judged and not place.ok and any("p_x" in words for words in place.remarks)
    # What is gone on with is the text's own.
    own = "p_x = mc*x'; p_x' = F - mp*(xdd + l*(theta''*cos(theta) - theta'^2*sin(theta)))"
    assert verdicts(CART, own) == ["PROVED"]


@pytest.mark.parametrize("name", [r"M", r"\mathbf{M}"])
def test_a_square_matrix_by_its_name_is_the_mass_matrix(name: str) -> None:
    rows = r"m_c + m_p & m_p l \cos\theta \\ m_p l \cos\theta & \frac43 m_p l^2"
    text = rf"\[ {name} = \begin{{bmatrix}} {rows} \end{{bmatrix}} \]"
    assert verdicts(CART, text) == ["PROVED"]
    assert verdicts(CART, text, about="mass matrix") == ["PROVED"]
    assert verdicts(CART, text.replace("43", "23")) == ["REFUTED"]


def test_rates_of_a_short_name_are_rates() -> None:
    line = "thdd = 3*(g*sin(theta) - xdd*cos(theta))/(4*l)"
    found = mechanics.check(CART, line, blame=False)
    assert [match.meaning for match in found.names if match.guessed] == ["theta_ddot"]
    assert found.ok
    assert verdicts(CART, line.replace("sin", "cos")) == ["REFUTED"]
    # Two angles begin so.
    assert verdicts(double_pendulum.scene(), "phdd = -g*sin(ph)/l1")[-1] == "UNDECIDED"


def test_an_energy_that_is_used_below_is_judged_itself() -> None:
    lines = "T = (M + m)*x'^2/2; V = 7*x; L = T - V"
    assert verdicts(PIVOT, lines) == ["REFUTED"] * 3


def test_a_matrix_with_the_name_of_an_energy_is_no_energy() -> None:
    assert verdicts(CART, f"{RAIL}H = [mc + mp, 7*l]") == ["PROVED", "UNDECIDED"]


def test_what_cancels_is_not_used() -> None:
    assert verdicts(CART, f"R = 7*l\n{RAIL.strip()} + R - R + 0*R") == ["UNDECIDED", "PROVED"]


def test_a_wrong_energy_beside_an_unused_definition_is_refuted() -> None:
    """The name of an energy is defined by its line, too: that alone does not make it right."""
    energy = (
        r"L = \frac{1}{2} (M + m) \dot x^2 + \frac{1}{2} M L \dot x \dot\theta \cos\theta"
        r" + \frac{1}{6} M L^2 \dot\theta^2 - k x^2 - \frac{1}{2} M g L \cos\theta"
    )
    text = rf"\begin{{align}} q &= 7 \zeta \\ {energy} \end{{align}}"
    assert verdicts(PIVOT, text) == ["UNDECIDED", "REFUTED"]


LAGRANGIAN = (
    r"$$ L = {} = \frac12 (m_c + m_p)\dot x^2 + m_p l\cos\theta\,\dot x\dot\theta"
    r" + \frac23 m_p l^2\dot\theta^2 {} m_p g l\cos\theta $$"
)


@pytest.mark.parametrize("law", [r"T - V_{\rm eff}", "T_k - U"])
def test_parts_of_energies_stand_by_their_law(law: str) -> None:
    right = LAGRANGIAN.replace("{}", law, 1)
    assert verdicts(CART, right.replace("{}", "-")) == ["PROVED"]
    assert verdicts(CART, right.replace("{}", "+")) == ["REFUTED"]
    assert "PROVED" not in verdicts(CART, right.replace("- V", "+ V").replace("- U", "- 2U"))


def test_a_text_says_that_an_input_has_another_name() -> None:
    rail = r"$$ (m_c + m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F $$"
    assert verdicts(CART, f"The control $u = F$. {rail}") == ["PROVED"]
    assert "PROVED" not in verdicts(CART, f"$$ R = F $$ {rail.replace('= F', '= 2F')}")


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("words", "formula", "short"),
    [
        ("the control", "u = F", True),
        ("with", "b = m_c + m_p", True),
        ("with", "M = m_c + m_p", False),
        ("the control", "u = -F", False),
        ("the tension", "T = F", False),
        ("the frequency", r"\omega = g", False),
        ("the control", "a = F", False),
    ],
)
def test_what_only_names_a_given_quantity_is_quoted_as_not_judged(
    words: str, formula: str, short: bool
) -> None:
    def answer(sign: str):
        pole = rf"$$\tfrac43 l\ddot\theta + \ddot x\cos\theta = {sign} g\sin\theta$$"
        return mechanics.check(CART, f"{words} ${formula}$ {pole}", notation="latex", blame=False)

    assert (formula in answer("").unjudged) is short
    assert (answer("").verdict.name == "PROVED") is short
    assert answer("-").verdict.name == "REFUTED"
