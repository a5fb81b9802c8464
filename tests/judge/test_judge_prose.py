"""What is printed, and what sentences say of it, counts; nothing of a page is passed over."""

import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

from mechanics import check
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import quadrotor, rod_pendulum

RIGHT = r"\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}"
HANGING = r"\ddot\theta = -\frac{3g}{2l}\sin\theta - \frac{3u}{ml^2}"
RATE = "(theta'' - 3*g/(2*l)*sin(theta) - 3*u/(m*l**2))"


@pytest.fixture(scope="module")
def truth() -> Equations:
    return derived(rod_pendulum.scene())


def verdicts(truth: Equations, text: str) -> list[Verdict]:
    return [entry.finding.verdict for entry in check(truth, text, blame=False).judged]


@pytest.mark.parametrize(
    ("boxed", "verdict"),
    [
        (r"+ \mbox{$\frac{3u}{ml^2}$}", Verdict.PROVED),
        (r"+ \mbox{$-$}\frac{3u}{ml^2}", Verdict.REFUTED),
        (r"+ \text{ $-$ }\frac{3u}{ml^2}", Verdict.REFUTED),
        (r"+ \frac{3u}{ml^2}\text{ $- u$}", Verdict.REFUTED),
        (r"+ \frac{3u}{ml^2} \quad\text{for all $u$}", Verdict.PROVED),
    ],
)
def test_a_formula_in_a_box_of_words_is_part_of_what_is_printed(
    truth: Equations, boxed: str, verdict: Verdict
) -> None:
    text = rf"$$\ddot\theta = \frac{{3g}}{{2l}}\sin\theta {boxed}$$"
    assert verdicts(truth, text) == [verdict]


def test_an_operator_beside_words_in_a_box_is_refused_by_its_place(truth: Equations) -> None:
    with pytest.raises(InputError, match="a formula inside"):
        check(truth, rf"$${RIGHT} \text{{ or less: $- u$}}$$")


@pytest.mark.parametrize(("label", "count"), [("=0", 2), (r"=\text{drive}", 1), (r"\text{u}", 1)])
def test_an_equation_in_the_label_of_a_brace_is_named(
    truth: Equations, label: str, count: int
) -> None:
    brace = rf"\underbrace{{\frac{{3u}}{{ml^2}}}}_{{{label}}}"
    found = verdicts(truth, rf"$$\ddot\theta = \frac{{3g}}{{2l}}\sin\theta + {brace}$$")
    assert found == [Verdict.PROVED, Verdict.UNDECIDED][:count]


def test_a_sign_as_a_subscript_is_no_letter(truth: Equations) -> None:
    with pytest.raises(InputError, match="a sign as a subscript"):
        check(truth, RIGHT.replace("u", "u_{-}"))


@pytest.mark.parametrize(
    ("before", "verdict"),
    [
        ("This is wrong:", Verdict.UNDECIDED),
        ("It is not true that", Verdict.UNDECIDED),
        ("It is wrong to think otherwise. Then", Verdict.UNDECIDED),
        ("It is not hard to see that", Verdict.PROVED),
    ],
)
def test_what_its_own_sentence_calls_wrong_is_not_shown(
    truth: Equations, before: str, verdict: Verdict
) -> None:
    assert verdicts(truth, f"{before} $${RIGHT}$$") == [verdict]


@pytest.mark.parametrize(
    ("said", "formula", "verdict"),
    [
        (r"$\theta$ is measured from the upward vertical", RIGHT, Verdict.PROVED),
        (r"$\theta$ is measured from the downward vertical", RIGHT, Verdict.REFUTED),
        (r"$\theta$ is counted clockwise from the downward vertical", HANGING, Verdict.PROVED),
        (r"$\theta$ is measured in degrees", RIGHT, Verdict.UNDECIDED),
        (r"$l$ is half the length of the rod", RIGHT, Verdict.REFUTED),
        (
            r"$l$ is half the length of the rod",
            r"\ddot\theta = \frac{3g}{4l}\sin\theta + \frac{3u}{4ml^2}",
            Verdict.PROVED,
        ),
    ],
)
def test_a_sentence_says_how_it_counts(
    truth: Equations, said: str, formula: str, verdict: Verdict
) -> None:
    assert verdicts(truth, f"where {said}, $${formula}$$") == [verdict]


HALF = r"\ddot\theta = \frac{3g}{4l}\sin\theta + \frac{3u}{4ml^2}"
DRIVEN = r"\ddot\theta = \frac{3g}{2l}\sin\theta - \frac{3u}{ml^2}"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        (r"$l$ is the distance from the pivot to the centre of mass", HALF, RIGHT),
        (r"$l$ is the length from the pivot to its centre of mass", HALF, RIGHT),
        (r"$l$ is the half-length of the rod", HALF, RIGHT),
        (r"$2l$ is the length of the rod", HALF, RIGHT),
        (r"$l$ is its length", RIGHT, HALF),
        (r"$\theta=0$ is the upright position", RIGHT, HANGING),
        (r"$u$ is minus the applied torque", DRIVEN, RIGHT),
        (r"$l$ is the length of the rod, $u$ the applied torque", RIGHT, HALF),
    ],
)
def test_a_sentence_says_what_a_name_is(
    truth: Equations, said: str, right: str, wrong: str
) -> None:
    assert verdicts(truth, f"where {said}, $${right}$$") == [Verdict.PROVED]
    assert verdicts(truth, f"where {said}, $${wrong}$$") == [Verdict.REFUTED]


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        (r"where $\theta$ is the angle from the horizontal,", Verdict.REFUTED),
        (r"where $u$ acts clockwise,", Verdict.UNDECIDED),
        (r"where $u$ is the torque acting clockwise,", Verdict.UNDECIDED),
        (r"where $u$ is twice the torque,", Verdict.UNDECIDED),
        (r"with $\theta$ from the downward vertical,", Verdict.REFUTED),
        (r"where $\theta=0$ is the hanging position,", Verdict.REFUTED),
        (r"where $u$ acts counterclockwise,", Verdict.PROVED),
        (r"where $m$ is twice the mass of the rod,", Verdict.UNDECIDED),
        (r"where $m$ is the mass of the rod,", Verdict.PROVED),
        (r"A point mass $m$ on a massless rod:", Verdict.UNDECIDED),
        (r"A uniform rod, not a point mass on a massless rod:", Verdict.UNDECIDED),
    ],
)
def test_what_contradicts_the_scene_shows_nothing(
    truth: Equations, said: str, verdict: Verdict
) -> None:
    (entry,) = check(truth, f"{said} $${RIGHT}$$", blame=False).judged
    assert entry.verdict is verdict


@pytest.mark.parametrize("factor", ["max(0,theta)", "(theta-abs(theta))", "(1+sign(theta))"])
def test_a_factor_that_vanishes_on_an_open_set_says_nothing_there(
    truth: Equations, factor: str
) -> None:
    (entry,) = check(truth, f"{factor}*{RATE} = 0", blame=False).judged
    assert entry.finding.verdict is Verdict.UNDECIDED
    assert "WHERE" in str(check(truth, f"{factor}*{RATE} = 0", blame=False))


@pytest.mark.parametrize(("factor", "told"), [("u", "except where u = 0"), ("(2+cos(theta))", "")])
def test_where_a_factor_is_zero_is_told(truth: Equations, factor: str, told: str) -> None:
    (entry,) = check(truth, f"{factor}*{RATE} = 0", blame=False).judged
    assert entry.finding.verdict is Verdict.PROVED
    assert entry.finding.domain == told


def test_a_power_of_a_power_needs_its_brackets(truth: Equations) -> None:
    text = "theta'' = {}/512*3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    assert verdicts(truth, text.format("2**3**2")) == [Verdict.PROVED]
    for power in ("2^3^2", "2^-1^2"):
        with pytest.raises(InputError, match="write the brackets"):
            check(truth, text.format(power))


def test_cases_without_a_last_one_are_shown_only_where_one_applies(truth: Equations) -> None:
    theta, u = dynamicsymbols("theta u")
    m, l, g, t = sympy.symbols("m l g t")
    right = 3 * g / (2 * l) * sympy.sin(theta) + 3 * u / (m * l**2)
    statement = sympy.Eq(theta.diff(t, 2), sympy.Piecewise((right, theta < 10)))
    (entry,) = check(truth, statement, blame=False).judged
    assert entry.finding.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("lead", "verdict"),
    [
        ("", "PROVED"),
        ("where $L$ is half the length of the arm, ", "UNDECIDED"),
        (r"where $\theta$ is measured from the horizontal, ", "UNDECIDED"),
    ],
)
def test_what_a_text_counts_otherwise_is_not_proved_where_equations_stay_a_program(
    lead: str, verdict: str
) -> None:
    row = r"$$I_{xx}\dot p = L(F_2-F_4) - (I_{zz}-I_{yy}) q r$$"
    assert check(quadrotor.scene(), lead + row, blame=False).verdict.name == verdict


def test_a_part_of_an_energy_is_not_refuted_where_equations_stay_a_program() -> None:
    text = r"The translational kinetic energy is $T = \frac12 m (v_x^2 + v_y^2 + v_z^2)$."
    (entry,) = check(quadrotor.scene(), text, blame=False).judged
    assert entry.verdict is Verdict.UNDECIDED
