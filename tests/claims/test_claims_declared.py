"""What is declared: several choices at once, statements in doubt, scenes that no name fits."""

from dataclasses import replace

import pytest
from sympy import Eq, Expr, S, cos, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.blame.derivation import Derivation
from mechanics.claims.angle_directions import directed, is_another
from mechanics.claims.conventions import conventions
from mechanics.claims.declared_conventions import read_declared
from mechanics.claims.directions import counted
from mechanics.claims.statement import Statement
from mechanics.errors import InputError
from mechanics.judge.check import derived
from mechanics.judge.declared_convention import judge_under
from mechanics.judge.other_reading import other_readings
from mechanics.judge.readers import read
from mechanics.scene import Particle, RigidBody, Scene, force, gravity, reaction
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from systems import acrobot, elastic_pendulum, rod_pendulum

PENDULUM = derived(elastic_pendulum.scene())
ACROBOT = derived(acrobot.scene())
ROD = derived(rod_pendulum.scene())
RIGHT = "M*L^2/3*theta'' - M*L/2*x''*sin(theta) + M*g*L/2*cos(theta) = 0"
HEIGHTS = "V = m1*g*{}*sin(theta1) + m2*g*({}*sin(theta1) + {}*sin({}))"
theta, y, X = dynamicsymbols("theta y X")
m, l, g = rod_pendulum.m, rod_pendulum.l, rod_pendulum.g


# ----------------------------------------------------------------------------- statements in doubt


@pytest.mark.parametrize("declared", ["right horizontal ccw", "from the horizontal"])
def test_what_is_in_doubt_stays_so_and_spoils_no_other(declared: str) -> None:
    """A name that nothing explains is told, not what its convention would be."""
    found = mechanics.check(PENDULUM, f"{RIGHT}\nM*x'' + zz*pp = 0", convention=declared)
    first, second = found.judged
    assert second.finding.verdict.name == "UNDECIDED"
    assert "the scene has no such name" in second.finding.evidence
    assert not any("not all right" in remark for remark in found.remarks)
    if declared == "right horizontal ccw":
        assert first.finding.shown


@pytest.mark.parametrize("declared", ["other sign of angles", "from the horizontal"])
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[1, zz]", "zz: the scene has no such name"), ("[1, m]", "has 2 rows and 2 columns"),
        ("[M, m; m, M; 1, 1]", "has 2 rows and 2 columns"),
    ],
)  # fmt: skip
def test_a_mass_matrix_of_another_shape_is_none(text: str, words: str, declared: str) -> None:
    found = mechanics.check(PENDULUM, text, about="mass matrix", convention=declared)
    (entry,) = found.judged
    assert entry.finding.verdict.name == "UNDECIDED"
    assert words in entry.finding.evidence


def test_a_mass_matrix_of_another_shape_beside_a_wrong_one() -> None:
    """What would help the wrong one is looked for."""
    pair = ["[1, m]", "[M, 1; 2, M]"]
    found = mechanics.check(PENDULUM, pair, about="mass matrix", blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == ["UNDECIDED", "REFUTED"]


def test_the_doubt_is_told_before_what_cannot_be_counted_otherwise() -> None:
    row = published("1", EquationOfMotion(), dynamicsymbols("zz").diff(), 0, label="zz")
    statement = Statement(row, "zz' = 0", "1", doubt="nothing explains zz")
    ((entry,), _) = judge_under(PENDULUM, [statement], read_declared(["other vertical"]))
    assert entry.finding.evidence.startswith("nothing explains zz")


# ------------------------------------------------------------------------------- several choices


def test_too_many_choices_are_refused() -> None:
    text = HEIGHTS.format("lc1", "l1", "lc2", "theta1 + theta2")
    many = "from the horizontal, half-length, twice the length"
    with pytest.raises(InputError, match="they can mean 64 things: say which"):
        mechanics.check(ACROBOT, text, convention=many)
    few = mechanics.check(ACROBOT, text, convention="from the horizontal, half-length")
    assert "it can mean 16 things" in few.remarks[0]


def test_all_lengths_together_are_one_choice() -> None:
    text = HEIGHTS.format("2*lc1", "2*l1", "2*lc2", "theta1 + theta2")
    (entry,) = mechanics.check(ACROBOT, text, convention="right horizontal ccw, half-length").judged
    assert entry.finding.verdict.name == "UNDECIDED"
    every = "half-length of l1, half-length of lc1, half-length of lc2"
    assert all(name in entry.finding.evidence for name in every.split(", "))
    assert mechanics.check(ACROBOT, text, convention=f"right horizontal ccw, {every}").ok


def test_the_order_of_what_is_declared_is_none() -> None:
    """An angle from the right horizontal, and the second link's the same way."""
    text = HEIGHTS.format("lc1", "l1", "lc2", "theta2")
    for declared in ("absolute angles, right horizontal ccw",
                     "right horizontal ccw, absolute angles"):  # fmt: skip
        assert mechanics.check(ACROBOT, text, convention=declared).ok, declared
    wrong = HEIGHTS.format("lc1", "l1", "lc2", "theta1 + theta2")
    declared = "right horizontal ccw, absolute angles"
    assert mechanics.check(ACROBOT, wrong, convention=declared).verdict.name == "REFUTED"


# ------------------------------------------------------------------------------------ directions


def pendulum(angle: Expr, *, right: Expr = S.Zero, up: Expr = -g, wind: Expr = S.Zero) -> Scene:
    """A point mass on a massless rod, at `angle` from the first axis, in a field of gravity."""
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (angle, ground.z))
    bob = origin.locatenew("P", l * rod.x)
    return Scene(
        "pendulum", ground, origin, coordinates=(theta,),
        bodies=(RigidBody("bob", bob, rod, m, 0),),
        loads=(gravity(right * ground.x + up * ground.y),
               force("w", bob, wind * ground.x, on="bob")),
        reactions=(reaction("X", at=origin, on="bob", by=None, along=ground.x),
                   reaction("Y", at=origin, on="bob", by=None, along=ground.y)),
    )  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("declared", "angle"),
    [
        ("above the right horizontal", theta),
        ("below the right horizontal", -theta),
        ("above the left horizontal", pi - theta),
        ("below the left horizontal", pi + theta),
    ],
)
def test_left_and_right_above_and_below_are_what_they_say(declared: str, angle: Expr) -> None:
    """A wind tells left from right."""
    rows = [
        Eq(row.value, 0)
        for row in Derivation(derived(pendulum(angle, wind=m * g))).generalized_rows
    ]
    hanging = derived(pendulum(theta - pi / 2, wind=m * g))
    for side in ("above", "below"):
        for way in ("right", "left"):
            name = f"{side} the {way} horizontal"
            found = mechanics.check(hanging, rows, convention=name, blame=False)
            assert found.ok == (name == declared), name


def test_gravity_upwards_turns_the_view_round() -> None:
    (heavy,), (light,) = counted(pendulum(theta)), counted(pendulum(theta, up=g))
    assert (heavy.quarter, heavy.sense) == (0, 1)
    assert (light.quarter, light.sense) == (0, -1)
    raised = theta + pi / 2
    assert [counted(pendulum(raised, up=up))[0].quarter for up in (-g, g)] == [1, 3]


def test_gravity_askew_has_no_vertical() -> None:
    scene = pendulum(theta, right=g, up=-g)
    assert not any(angle.fixed for angle in counted(scene))
    assert directed(scene, counted(scene)) == []
    declared = "right horizontal ccw"
    found = mechanics.check(scene, "theta'' = 0", convention=declared, blame=False)
    assert found.verdict.name == "UNDECIDED"


def test_a_direction_between_the_axes_is_no_quarter() -> None:
    scene = pendulum(theta + pi / 3)
    (angle,) = counted(scene)
    assert (angle.quarter, angle.sense, angle.fixed) == (None, 1, True)
    assert directed(scene, counted(scene)) == []


def test_a_place_that_swings_along_a_line_turns_no_way() -> None:
    """x = l cos(theta) is where a piston is that a crank drives: its side is not told."""
    ground, origin = ReferenceFrame("N"), Point("O")
    bob = origin.locatenew("P", l * cos(theta) * ground.x + y * ground.y)
    scene = Scene(
        "on a line", ground, origin, coordinates=(theta, y), bodies=(Particle("bob", bob, m),),
        loads=(gravity(-g * ground.y),), reactions=(),
    )  # fmt: skip
    (angle,) = counted(scene)
    assert (angle.quarter, angle.sense, angle.fixed) == (0, 0, True)
    assert directed(scene, counted(scene)) == []


@pytest.mark.parametrize("sense", [1, -1])
def test_a_wheel_tells_its_sense_by_turning(sense: int) -> None:
    """Its centre stays where it is."""
    ground, origin = ReferenceFrame("N"), Point("O")
    turned = ground.orientnew("A", "Axis", (sense * theta, ground.z))
    slid = origin.locatenew("C", y * ground.y)
    slider = origin.locatenew("S", X * ground.x)
    scene = Scene(
        "wheel", ground, origin, coordinates=(theta, y, X),
        bodies=(RigidBody("wheel", slid, turned, m, m * l**2), Particle("slider", slider, m)),
        loads=(gravity(-g * ground.y),),
        reactions=(reaction("A", at=slid, on="wheel", by=None, along=ground.x),
                   reaction("B", at=slider, on="slider", by=None, along=ground.y)),
    )  # fmt: skip
    (angle,) = counted(scene)
    assert (angle.sense, angle.fixed) == (sense, False)


def test_only_quarter_turns_are_looked_for_beside_the_other_changes() -> None:
    """Counted from the upward vertical is the other vertical, which is looked for already."""
    scene = PENDULUM.scene
    places = {
        place: is_another(c)
        for *place, c in directed(scene, counted(scene))
        for place in [tuple(place)]
    }
    assert places == {(k, s): k in (0, 2) for k in range(4) for s in (1, -1)}
    level = [c for change in conventions(scene) for c in change if c.kind == "direction"]
    assert len(level) == 4


# --------------------------------------------------------------------------------- other readings


def test_a_reading_without_a_dimension_is_none() -> None:
    text = r"\ddot\theta + 3\ddot x\cos\theta/2L + 3 g\sin\theta/2L = 0"
    (entry,) = mechanics.check(PENDULUM, text).judged
    assert entry.finding.shown
    assert any(note.startswith("/2L is /(2L)") for note in entry.statement.notes)
    (wrong,) = mechanics.check(PENDULUM, text.replace("3 g", "g")).judged
    assert wrong.verdict.name == "REFUTED"
    assert wrong.blame is not None
    assert wrong.blame.repairs


def test_another_reading_with_a_name_of_nothing_is_none() -> None:
    (entry,) = mechanics.check(ROD, "theta'' = 0", blame=False).judged
    right = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    for more, told in (("", ["as meant"]), (" + zz - zz", [])):
        reading = read(ROD.scene, right + more, {}, "text", None)
        trees = reading.statements[0].written.sides
        statement = replace(entry.statement, others=(("as meant", trees),))
        assert [other.words for other in other_readings(ROD, [statement])] == told
