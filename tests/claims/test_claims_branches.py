"""Equations that are right on one branch: sqrt(l^2 - r^2 sin(theta)^2) is l |cos(phi)|."""

import pytest
from sympy import Integer, Rational, cos, sin, sqrt, sympify
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.scene import Particle, RigidBody, Scene, gravity, holonomic, parameters, reaction
from systems import four_bar, rod_pendulum

pytestmark = pytest.mark.campaign

theta, phi, s, x, y = dynamicsymbols("theta phi s x y")
r, l, m, J, g = parameters("r l m J g", units="m m kg kg*m^2 m/s^2", typical="0.05 0.2 1 0.01 9.81")


def crank() -> Scene:
    """Crank, massless rod and piston in a horizontal plane."""
    ground = ReferenceFrame("N")
    turned = ground.orientnew("K", "Axis", (theta, ground.z))
    rod = ground.orientnew("R", "Axis", (-phi, ground.z))
    origin = Point("O")
    pin = origin.locatenew("P", r * turned.x)
    end = pin.locatenew("E", l * rod.x)
    piston = origin.locatenew("S", s * ground.x)
    forces = [
        reaction(f"{at.name}{axis}", at=at, on=on, by=by, along=along)
        for at, on, by in ((origin, "crank", None), (pin, "rod", "crank"), (end, "piston", "rod"))
        for axis, along in (("x", ground.x), ("y", ground.y))
    ]
    forces.append(reaction("W", at=piston, on="piston", by=None, along=ground.y))
    return Scene(
        "slider-crank", ground, origin, coordinates=(theta, phi, s),
        bodies=(RigidBody("crank", origin, turned, m, J), RigidBody("rod", end, rod, m, J),
                Particle("piston", piston, m)),
        reactions=tuple(forces),
        constraints=(holonomic("along", r * cos(theta) + l * cos(phi) - s, "Ex"),
                     holonomic("across", r * sin(theta) - l * sin(phi), "Ey")),
        example={"theta": 0.6, "phi": 0.1, "s": 0.24},
    )  # fmt: skip


def bead() -> Scene:
    """A bead on a circle of radius 1, in Cartesian coordinates."""
    ground, origin = ReferenceFrame("N"), Point("O")
    centre = origin.locatenew("B", x * ground.x + y * ground.y)
    outwards = (x * ground.x + y * ground.y) / sqrt(x**2 + y**2)
    return Scene(
        "bead", ground, origin, coordinates=(x, y), bodies=(Particle("bead", centre, m),),
        loads=(gravity(-g * ground.y),),
        reactions=(reaction("S", at=centre, on="bead", by=None, along=outwards),),
        constraints=(holonomic("circle", x**2 + y**2 - Integer(1), "S"),),
    )  # fmt: skip


CRANK = derived(crank())
BEAD = derived(bead())
PISTON = "s = r*cos(theta) + sqrt(l^2 - r^2*sin(theta)^2)"
TURNING = "phi' = r*cos(theta)*theta'/sqrt(l^2 - r^2*sin(theta)^2)"
APART = "((d - l1*cos(q1))^2 + (l1*sin(q1))^2 - l2^2 - l3^2)"
CROSSING = f"l2*l3*sin(q3 - q2) = sqrt(l2^2*l3^2 - {APART}^2/4)"


@pytest.mark.parametrize(
    ("truth", "text", "where", "elsewhere"),
    [
        (CRANK, PISTON, "cos(phi) > 0", "cos(phi) < 0"),
        (CRANK, TURNING, "cos(phi) > 0", "sin(theta) > 0"),
        (CRANK, PISTON.replace("+ sqrt", "- sqrt"), "cos(phi) < 0", "0 < cos(phi)"),
        (BEAD, "y = -sqrt(1 - x^2)", "y < 0", "x < 0"),
        (BEAD, "x = sqrt(1 - y^2)", "x > 0", "y > 0"),
        (BEAD, "abs(x) = x", "x > 0", "x < 0"),
    ],
)
def test_right_on_one_branch(truth: Equations, text: str, where: str, elsewhere: str) -> None:
    (entry,) = mechanics.check(truth, text, blame=False).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert len(entry.right_if) == 1 and entry.right_if[0].startswith(where)
    found = mechanics.check(truth, text, where=where)
    if text.startswith("abs"):
        assert found.verdict.name == "UNDECIDED"  # of any number, it says nothing about the scene
        return
    assert found.ok
    assert where in found.judged[0].finding.evidence
    assert found.remarks == (f"judged where {where}",)
    assert mechanics.check(truth, text, where=elsewhere).verdict.name == "REFUTED"


def test_how_two_rods_cross_is_a_branch() -> None:
    truth = derived(four_bar.scene())
    (entry,) = mechanics.check(truth, CROSSING, blame=False).judged
    assert entry.right_if and "sin(q2 - q3) < 0" in entry.right_if[0]
    assert mechanics.check(truth, CROSSING, where="sin(q3 - q2) > 0").ok


@pytest.mark.parametrize("change", [("l^2 -", "l^2 +"), ("r*cos", "2*r*cos"), ("r^2*", "r*")])
def test_no_branch_helps_what_is_wrong(change: tuple[str, str]) -> None:
    wrong = PISTON.replace(*change)
    (entry,) = mechanics.check(CRANK, wrong, blame=False).judged
    assert entry.finding.verdict.name == "REFUTED" and entry.right_if == ()
    found = mechanics.check(CRANK, wrong, where="cos(phi) > 0")
    assert found.verdict.name in ("REFUTED", "UNDECIDED")


@pytest.mark.parametrize(
    "text", ["cos(phi) = sqrt(1 - sin(phi)^2)", "0 = 0", "sqrt(cos(phi)^2) = cos(phi)"]
)
def test_what_says_nothing_on_the_branch_is_undecided(text: str) -> None:
    assert mechanics.check(CRANK, text, where="cos(phi) > 0").verdict.name == "UNDECIDED"


@pytest.mark.parametrize("factor", ["sqrt(cos(phi)^2) - cos(phi)", "(abs(cos(phi)) - cos(phi))"])
def test_an_equation_that_vanishes_on_the_branch_is_none(factor: str) -> None:
    found = mechanics.check(CRANK, f"({factor})*theta'' = 0", where="cos(phi) > 0")
    assert found.verdict.name == "UNDECIDED"


def test_names_of_the_person_may_be_used() -> None:
    text, names = PISTON.replace("theta", "a"), {"a": "theta", "b": "phi"}
    assert mechanics.check(CRANK, text, names=names, where="cos(b) > 0").ok


@pytest.mark.parametrize(
    ("where", "words"),
    [
        ("cos(phi) > 2", "no state of slider-crank was found"),
        ("cos(phi) > 0 and cos(phi) < 0", "no state of slider-crank was found"),
        ("cos(psi) > 0", "psi is no name of slider-crank"),
        ("phi' > 0", "write one inequality"), ("cos(phi) = 0", "write one inequality"),
        ("1 > 0", "write one inequality"), ("Ex > 0", "write one inequality"),
        ("0 < phi < 1", "write one inequality"), ("((((", "write one inequality"),
        ("__import__('os') > 0", "cannot be read"), ("phi^(9^9^9) > 0", "brackets"),
        ("z9 > 0", "'z9 > 0': z9: the scene has no such name"),
        ("theta* > 1", "^where 'theta[*] > 1': '[)]' cannot be read$"),
        ("theta) - (1 > 0", "write one inequality"), ("2*(theta > 1)", "write one inequality"),
    ],
)  # fmt: skip
def test_what_is_no_condition_is_refused(where: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        mechanics.check(CRANK, PISTON, where=where)


def test_only_one_of_them_is_given() -> None:
    with pytest.raises(InputError, match="give one"):
        mechanics.check(CRANK, PISTON, where="cos(phi) > 0", convention="other sign of angles")


ROD = derived(rod_pendulum.scene())
BRANCH = "(sqrt(sin(theta)^2) - sin(theta))"
"""Zero where sin(theta) > 0."""


@pytest.mark.parametrize(
    ("right", "about"),
    [
        ("V = m*g*l*cos(theta)/2 + m*g*l*{}", None),
        ("T = m*l^2*theta'^2/6 + m*l^2*theta'^2*{}", None),
        ("p_theta = m*l^2*theta'/3 + m*l^2*theta'*{}", None),
        ("[m*l^2/3 + m*l^2*{}]", "mass matrix"),
    ],
)
def test_what_is_judged_at_all_states_is_not_refuted_where(right: str, about: str | None) -> None:
    everywhere = right.format("0")
    assert mechanics.check(ROD, everywhere, about=about, where="sin(theta) > 0").ok
    text = right.format(BRANCH)
    assert mechanics.check(ROD, text, about=about, blame=False).verdict.name == "REFUTED"
    (entry,) = mechanics.check(ROD, text, about=about, where="sin(theta) > 0").judged
    assert entry.finding.verdict.name == "UNDECIDED"
    assert "judged at all states" in entry.finding.evidence


@pytest.mark.parametrize(
    "where", ["m > 1", "l > m", "m > 0", "1 < l", "theta > max(1, 2)", "l > m, m > 1 and theta < 2"]
)
def test_parameters_have_conditions_too(where: str) -> None:
    text = "m*l^2/3*theta'' - m*g*l/2*sin(theta) = u + {}*theta"
    assert mechanics.check(ROD, text.format("0"), where=where).ok
    assert mechanics.check(ROD, text.format("1"), where=where).verdict.name == "REFUTED"


def test_a_condition_on_a_parameter_is_met() -> None:
    root = "(sqrt((m - l)^2) - {}*(m - l))*theta"
    text = "m*l^2/3*theta'' - m*g*l/2*sin(theta) = u + "
    for sign, where in (("1", "m > l"), ("(-1)", "l > m")):
        other = "l > m" if where == "m > l" else "m > l"
        assert mechanics.check(ROD, text + root.format(sign), where=where).ok
        found = mechanics.check(ROD, text + root.format(sign), where=other)
        assert found.verdict.name == "REFUTED"


@pytest.mark.parametrize(
    "where",
    ["theta > pi", "theta < -100", "sin(theta) > 0.999999", "theta > 2 and theta < 2.00001",
     "theta > pi and sin(theta) < -0.99999 and l > 10"],
)  # fmt: skip
def test_where_hardly_any_state_is_drawn(where: str) -> None:
    text = "m*l^2/3*theta'' - m*g*l/2*sin(theta) = u + {}"
    assert mechanics.check(ROD, text.format("0"), where=where).ok
    (entry,) = mechanics.check(ROD, text.format("theta"), where=where).judged
    assert entry.finding.verdict.name == "REFUTED" and where in entry.finding.evidence
    state = dict((*entry.finding.witness.state, *entry.finding.witness.solved))
    at = {one: Rational(state[one.name]) for one in ROD.scene.q}
    assert all(sympify(part, {"theta": at[ROD.scene.q[0]]}) for part in where.split(" and ")[:2])


def test_right_where_hardly_any_state_is_drawn_is_shown() -> None:
    text = "m*l^2/3*theta'' - m*g*l/2*sin(theta) = u + sqrt((theta - pi)^2) - theta + pi"
    for where, verdict in (("theta > pi", "CERTIFIED"), ("theta < -100", "REFUTED")):
        (entry,) = mechanics.check(ROD, text, where=where).judged
        assert entry.finding.verdict.name == verdict
    assert (
        "acceleration"
        not in mechanics.check(ROD, text, where="theta > pi").judged[0].finding.evidence
    )


@pytest.mark.parametrize("where", ["sin(theta) > 1", "theta > 1 and theta < 1", "m < 0"])
def test_what_holds_nowhere_is_refused(where: str) -> None:
    with pytest.raises(InputError, match="no state of rod pendulum was found"):
        mechanics.check(ROD, "theta'' = 0", where=where)


def test_a_reaction_where_hardly_any_state_is_drawn_is_undecided_or_right() -> None:
    found = mechanics.check(ROD, "X = 0", where="theta > pi")
    assert found.verdict.name in ("REFUTED", "UNDECIDED")


def parabola() -> Scene:
    """A bead on x = -1 - y^2: x is negative everywhere."""
    ground, origin = ReferenceFrame("N"), Point("O")
    centre = origin.locatenew("B", x * ground.x + y * ground.y)
    outwards = (ground.x + 2 * y * ground.y) / sqrt(1 + 4 * y**2)
    return Scene(
        "parabola", ground, origin, coordinates=(x, y), bodies=(Particle("bead", centre, m),),
        loads=(gravity(-g * ground.y),),
        reactions=(reaction("S", at=centre, on="bead", by=None, along=outwards),),
        constraints=(holonomic("curve", x + 1 + y**2, "S"),),
    )  # fmt: skip


def test_a_branch_that_no_state_is_on_is_not_told() -> None:
    """What is right where x > 0 is right nowhere."""
    (entry,) = mechanics.check(derived(parabola()), "abs(x) = x", blame=False).judged
    assert entry.finding.verdict.name == "REFUTED" and entry.right_if == ()
