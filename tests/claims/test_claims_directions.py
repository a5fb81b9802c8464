"""Definite directions of angles: what is right under one is wrong under any other."""

from dataclasses import replace

import pytest
from sympy import Eq, Expr, Matrix, S, Symbol, cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.claims.declared_conventions import DEFINITE
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.scene import Particle, RigidBody, Scene, gravity, reaction, spring
from systems import (
    acrobot,
    double_pendulum,
    elastic_pendulum,
    pendulum_chain,
    rod_pendulum,
    rolling_disc,
)

PENDULUM = derived(elastic_pendulum.scene())
CART = derived(pendulum_chain.scene(1))
HORIZONTAL = "M*L^2/3*theta'' - M*L/2*x''*sin(theta) {} M*g*L/2*cos(theta) = 0"
ACROBOT = derived(acrobot.scene())
HEIGHTS = "V = m1*g*{}*sin(theta1) + m2*g*(l1*sin(theta1) + lc2*sin({}))"


@pytest.mark.campaign
@pytest.mark.parametrize(("sign", "growing"), [("+", "counterclockwise"), ("-", "clockwise")])
def test_an_angle_from_the_horizontal(sign: str, growing: str) -> None:
    """Upwards and downwards are different equations: which is meant has to be said."""
    text = HORIZONTAL.format(sign)
    (entry,) = mechanics.check(PENDULUM, text).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert len(entry.right_if) == 1
    assert f"counted from the right horizontal, {growing}" in entry.right_if[0]
    (entry,) = mechanics.check(PENDULUM, text, convention="from the horizontal").judged
    assert entry.finding.verdict.name == "UNDECIDED"
    assert f"--convention 'right horizontal {growing}'" in entry.finding.evidence
    for sense in ("clockwise", "counterclockwise"):
        declared = f"from the right horizontal, {sense}"
        found = mechanics.check(PENDULUM, text, convention=declared)
        alone = mechanics.check(PENDULUM, text, convention=declared.split(","))
        assert alone.verdict is found.verdict and alone.remarks == found.remarks
        assert found.verdict.name == ("PROVED" if sense == growing else "REFUTED")
        assert f"right horizontal, {sense}" in found.remarks[0]


def test_above_the_horizontal_is_enough_where_left_and_right_are_alike() -> None:
    heavy = rod_pendulum.scene()
    alone = replace(heavy, loads=heavy.loads[:1], inputs=())
    for sign, side, verdict in (
        ("+", "above", "PROVED"), ("-", "below", "PROVED"),
        ("+", "below", "REFUTED"), ("-", "above", "REFUTED"),
    ):  # fmt: skip
        text = f"l/3*theta'' {sign} g/2*cos(theta) = 0"
        found = mechanics.check(alone, text, convention=f"{side} the horizontal")
        assert found.verdict.name == verdict, (sign, side)


def test_all_equations_share_one_choice() -> None:
    """Each is right under a choice of its own, and no choice serves both."""
    one, other = (HORIZONTAL.format(sign) for sign in "+-")
    found = mechanics.check(PENDULUM, f"{one}\n{other}", convention="from the horizontal")
    assert sorted(e.finding.verdict.name for e in found.judged) == ["REFUTED", "UNDECIDED"]


def test_half_of_which_length_is_to_be_said() -> None:
    """A factor of two at one term is half of a length that nobody halved."""
    text = HEIGHTS.format("2*lc1", "theta1 + theta2")
    for name, verdict in (
        ("half-length", "UNDECIDED"), ("half-length of lc1", "PROVED"),
        ("half-length of lc2", "REFUTED"),
    ):  # fmt: skip
        both = ("right horizontal counterclockwise", name)
        assert mechanics.check(ACROBOT, text, convention=both).verdict.name == verdict


def test_only_directions_are_turned_and_joints_are_between_them() -> None:
    absolute = "absolute angles, right horizontal ccw"
    assert mechanics.check(ACROBOT, HEIGHTS.format("lc1", "theta2"), convention=absolute).ok
    text = HEIGHTS.format("lc1", "theta1 + theta2")
    assert mechanics.check(ACROBOT, text, convention="right horizontal ccw").ok
    assert not mechanics.check(ACROBOT, text, convention=absolute).ok


def test_momenta_and_mass_matrices_belong_to_the_coordinates() -> None:
    declared = "other sign of angles"
    right = "p_theta = M*L^2/3*theta' - M*L/2*x'*cos(theta)"
    assert mechanics.check(PENDULUM, right, convention=declared).ok
    wrong = "p_theta = -M*L^2/3*theta' + M*L/2*x'*cos(theta)"
    assert mechanics.check(PENDULUM, wrong, convention=declared).verdict.name == "REFUTED"
    heavy, light, length, theta = map(Symbol, ("M", "m", "L", "theta"))
    for sign, verdict in ((-1, "PROVED"), (1, "REFUTED")):
        beside = sign * heavy * length / 2 * cos(theta)
        mass = Matrix([[heavy + light, beside], [beside, heavy * length**2 / 3]])
        found = mechanics.check(PENDULUM, mass, about="mass matrix", convention=declared)
        assert found.verdict.name == verdict


def test_rates_are_counted_as_the_coordinates_where_speeds_are_others() -> None:
    disc = derived(rolling_disc.scene())
    for sign, verdict in (("-", "PROVED"), ("", "REFUTED")):
        found = mechanics.check(disc, f"lean' = {sign}u1", convention="other sign of angles")
        assert found.verdict.name == verdict


@pytest.mark.parametrize("text", ["0 = 0", "theta''' = 3*g/(2*l)*cos(theta)*theta'"])
def test_what_says_nothing_is_undecided_under_a_convention_too(text: str) -> None:
    found = mechanics.check(rod_pendulum.scene(), text, convention="other vertical")
    assert found.verdict.name == "UNDECIDED"


def test_a_convention_may_be_the_scene_s_own_or_make_no_difference() -> None:
    text = "(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)) = 0"
    assert mechanics.check(PENDULUM, text, convention="hanging, counterclockwise").ok
    second = "q0''*cos(q1) - l0*q1'' + g*sin(q1) = 0"
    found = mechanics.check(CART, second, convention="other sign of inputs")
    assert found.ok
    assert any("makes no difference" in remark for remark in found.remarks)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("declared", "words"),
    [
        ("other vertical, below the horizontal", "contradict each other"),
        ("relative angles, other sign of phi2", "contradict each other"),
        ("half-length of phi1", "phi1 is an angle of .* and cannot have it: l1, l2 can$"),
        ("half-length of m1", "m1 is a parameter in kg of .*: l1, l2 can$"),
        ("half-length of nothing", "nothing is no name of .*: l1, l2 can$"),
        ("other sign of l1", "l1 is a parameter in m of .*: phi1, phi2 can$"),
        ("below horizontal of l1", "l1 is a parameter in m of .*: phi1, phi2 can$"),
        ("half-length of", "did you mean 'half-length'"),
        (" , ", "convention ' , ': the conventions are other vertical"),
        (["other vertical", " "], "convention ' ': the conventions are other vertical"),
        (
            ["other vertical", "counterclockwise"],
            "mean 'downward vertical counterclockwise'",
        ),
    ],
)
def test_conventions_that_cannot_be_are_refused(declared: str | list[str], words: str) -> None:
    with pytest.raises(InputError, match=words):
        mechanics.check(double_pendulum.scene(), "phi1'' = 0", convention=declared)


def pointing(quarter: int, sense: int) -> Scene:
    """The pendulum with its angle from another direction, by geometry alone."""
    heavy = elastic_pendulum
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (quarter * pi / 2 + sense * heavy.theta, ground.z))
    pivot = origin.locatenew("B", heavy.x * ground.x)
    centre = pivot.locatenew("C", heavy.L / 2 * rod.x)
    scene = heavy.scene()
    carriage, pendulum = scene.bodies
    on_rail = spring("k", origin, pivot, 2 * heavy.k, along=ground.x)
    return Scene(
        "turned", ground, origin, coordinates=scene.coordinates,
        bodies=(Particle("carriage", pivot, carriage.mass),
                RigidBody("pendulum", centre, rod, pendulum.mass, heavy.PENDULUM.inertia)),
        loads=(gravity(-heavy.g * ground.y), on_rail),
        reactions=(reaction("T", at=pivot, on="carriage", by="pendulum", along=ground.x),
                   reaction("N", at=pivot, on="pendulum", by="carriage", along=ground.y),
                   reaction("N1", at=pivot, on="carriage", by=None, along=ground.y)),
    )  # fmt: skip


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("place", range(8))
def test_a_direction_is_what_it_says(place: int) -> None:
    """Equations of a scene that is built so are right under that name, and under no other."""
    built = [(quarter, sense) for quarter in range(4) for sense in (1, -1)]
    rows = [
        Eq(row.value, 0) for row in Derivation(derived(pointing(*built[place]))).generalized_rows
    ]
    for other in (place, place ^ 1, (place + 2) % 8, (place + 4) % 8):
        found = mechanics.check(PENDULUM, rows, convention=DEFINITE[other], blame=False)
        assert found.verdict.name == ("PROVED" if other == place else "REFUTED"), DEFINITE[other]


def test_a_sign_that_is_left_besides_is_told() -> None:
    """The torque grows with the angle, as people take it."""
    text = "m*l^2/3*theta'' - m*g*l/2*cos(theta) = u"
    rod = derived(rod_pendulum.scene())
    (entry,) = mechanics.check(rod, text, convention="right horizontal clockwise").judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.right_if == (
        "u is counted the other way as well (--convention 'other sign of inputs' besides)",
    )
    both = "right horizontal clockwise, other sign of inputs"
    assert mechanics.check(rod, text, convention=both).ok


def test_a_convention_is_of_the_person_s_own_name() -> None:
    text = "m*l^2/3*a'' + m*g*l/2*cos(a) = u"
    rod = derived(rod_pendulum.scene())
    declared = "right horizontal counterclockwise of a"
    assert mechanics.check(rod, text, names={"a": "theta"}, convention=declared).ok


def test_a_black_box_has_no_convention() -> None:
    box = mechanics.BlackBox(lambda state: state)
    with pytest.raises(InputError, match="a black box is only called"):
        mechanics.check(PENDULUM, box, convention="other vertical")


def sphere(height: Expr, reach: Expr) -> Scene:
    """A bob on a rod of length 1 about a fixed point, in space."""
    ground, origin = ReferenceFrame("N"), Point("O")
    around = ground.orientnew("A", "Axis", (AZIMUTH, ground.z))
    rod = reach * around.x + height * ground.z
    bob = origin.locatenew("P", rod)
    m, g = elastic_pendulum.m, elastic_pendulum.g
    return Scene(
        "bob in space", ground, origin, coordinates=(AZIMUTH, elastic_pendulum.theta),
        bodies=(Particle("bob", bob, m),), loads=(gravity(-g * ground.z),),
        reactions=(reaction("S", at=bob, on="bob", by=None, along=rod),),
    )  # fmt: skip


AZIMUTH, POLAR = dynamicsymbols("phi theta")


@pytest.mark.parametrize(
    ("name", "height", "reach"),
    [
        ("above the horizontal", sin(POLAR), cos(POLAR)),
        ("below the horizontal", -sin(POLAR), cos(POLAR)),
        ("other vertical", cos(POLAR), sin(POLAR)),
    ],
)
def test_in_space_the_height_tells(name: str, height: Expr, reach: Expr) -> None:
    hanging = derived(sphere(-cos(POLAR), sin(POLAR)))
    rows = [Eq(row.value, 0) for row in Derivation(derived(sphere(height, reach))).generalized_rows]
    for other in ("above the horizontal", "below the horizontal", "other vertical"):
        found = mechanics.check(hanging, rows, convention=other, blame=False)
        assert found.ok == (other == name), other
    found = mechanics.check(hanging, rows, convention="right horizontal clockwise", blame=False)
    assert found.verdict.name == "UNDECIDED"  # in space there is no right


def hung(rod_angle: Expr, lift: Expr = S.Zero) -> Scene:
    """A point mass on a massless rod of length l below a pivot that is lifted."""
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (rod_angle, ground.z))
    pivot = origin.locatenew("B", lift * ground.y)
    bob = pivot.locatenew("P", -rod_pendulum.l * rod.y)
    return Scene(
        "pendulum", ground, origin, coordinates=(POLAR,),
        bodies=(RigidBody("bob", bob, rod, rod_pendulum.m, 0),),
        loads=(gravity(-rod_pendulum.g * ground.y),), inputs=(lift,) if lift else (),
        reactions=(reaction("X", at=pivot, on="bob", by=None, along=ground.x),
                   reaction("Y", at=pivot, on="bob", by=None, along=ground.y)),
    )  # fmt: skip


def test_rates_of_inputs_have_the_sign_of_the_inputs() -> None:
    lifted = derived(hung(POLAR, dynamicsymbols("h")))
    for sign, plain, declared in (("+", "PROVED", "REFUTED"), ("-", "UNDECIDED", "PROVED")):
        text = f"l*theta'' + (g {sign} h'')*sin(theta) = 0"
        assert mechanics.check(lifted, text, blame=False).verdict.name == plain
        found = mechanics.check(lifted, text, convention="other sign of inputs")
        assert found.verdict.name == declared


def test_a_multiple_of_an_angle_has_no_direction() -> None:
    """theta is half of the rod's angle: a quarter turn of one is none of the other."""
    halved = derived(hung(2 * POLAR))
    found = mechanics.check(halved, "2*l*theta'' - g*cos(2*theta) = 0", convention=DEFINITE[1])
    assert found.verdict.name == "UNDECIDED"
