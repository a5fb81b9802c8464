"""Robots in URDF: what they move like, and what is refused."""

from pathlib import Path

import numpy as np
import pytest
from importers.by_pinocchio import peer
from sympy import Matrix, Rational, eye, pi, sympify

import mechanics
from mechanics.cli.load import is_file, load
from mechanics.compiled import prove_compiled
from mechanics.errors import InputError
from mechanics.importers.decimals import Notes, angle, exact
from mechanics.importers.rotations import from_doubles, roll_pitch_yaw, towards

MODELS = Path(__file__).parents[1] / "models"
ROOTS = {"two_link": "fixed", "ur5": "fixed", "panda": "fixed", "scara": "fixed",
         "quadruped": "free", "humanoid": "free"}  # fmt: skip
QUICK = ("scara",)
EVERY = [n if n in QUICK else pytest.param(n, marks=pytest.mark.campaign) for n in ROOTS]

MOMENTS = '<mass value="1"/><inertia ixx="1" iyy="1" izz="1"/>'
LINK = f'<link name="{{}}"><inertial>{MOMENTS}</inertial></link>'
JOINT = '<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/>{}</joint>'


def write(folder, *parts, name="robot"):
    file = folder / "robot.urdf"
    file.write_text(f'<robot name="{name}">{"".join(parts)}</robot>', encoding="utf-8")
    return file


def numbers(scene, rng):
    q = rng.uniform(-1.5, 1.5, len(scene.q))
    if scene.rotations:
        q[-4:] /= np.linalg.norm(q[-4:])
    return q, *rng.uniform(-2, 2, (2, len(scene.u)))


# ---------------------------------------------------------------------- numbers


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.57", pi / 2), ("1.5708", pi / 2), ("-3.1416", -pi), ("0.7853981633974483", pi / 4),
        ("2.0944e0", 2 * pi / 3), ("6.2832", 2 * pi),
        # Not rounded: the last digit is another.
        ("1.5707", Rational("1.5707")), ("1.5707970", Rational("1.5707970")),
        # Public descriptions of arms have this.
        ("1.570796325", pi / 2),
        # Nobody means pi/6 by 0.5.
        ("0.5", Rational(1, 2)), ("3", 3), ("0.00", 0),
    ],
)  # fmt: skip
def test_angles_are_multiples_of_pi_to_the_digits_that_they_have(text, value):
    notes = Notes()
    assert angle(text, "joint elbow: rpy", notes) == value
    assert any("joint elbow" in line for line in notes.lines()) == sympify(value).has(pi)
    full = text == "0.7853981633974483"
    assert angle(text, "", Notes(), multiples=False) == (pi / 4 if full else Rational(text))


@pytest.mark.parametrize(
    "text", ["nan", "inf", "-inf", "1e999", "1e99999999", "0x10", "1_0", "", "1,5", "9" * 500, "٣"]
)
def test_what_is_no_finite_number_is_refused(text):
    with pytest.raises(InputError, match="link arm: its mass is"):
        exact(text, "link arm: its mass")


def test_fixed_turns_are_rotations_exactly():
    angles = [Rational("0.3"), Rational("-2.9"), Rational("1.570796325")]
    R = roll_pitch_yaw(angles)
    assert eye(3) == R.T * R
    assert R.det() == 1
    (c1, s1), (c2, s2), (c3, s3) = ((np.cos(float(a)), np.sin(float(a))) for a in angles)
    X = np.array([[1, 0, 0], [0, c1, -s1], [0, s1, c1]])
    Y = np.array([[c2, 0, s2], [0, 1, 0], [-s2, 0, c2]])
    Z = np.array([[c3, -s3, 0], [s3, c3, 0], [0, 0, 1]])
    assert np.abs(np.array(R, float) - Z @ Y @ X).max() < 1e-15


@pytest.mark.parametrize("axis", [(0, 0, -3), (1, 2, 3), (-1, 1, -5), (0, 1, 1)])
def test_axes_are_met_by_a_rotation(axis):
    R, k, sign = towards([Rational(e) for e in axis])
    assert eye(3) == R.T * R
    along = np.array(R, float)[:, k] * sign
    assert np.abs(along - np.array(axis) / np.linalg.norm(axis)).max() < 1e-15


def test_quaternions_in_doubles_become_rotations_exactly():
    R, words = from_doubles([0.7071067811865476, 0.0, 0.7071067811865475, 0.0])
    assert Matrix([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]) == R
    assert words == "pi/2 about y"
    R, words = from_doubles([0.5, -0.5, 0.5, -0.5])
    assert eye(3) == R.T * R
    assert {*R} == {0, 1, -1} or {*R} <= {0, 1, -1}


# ---------------------------------------------------------------------- motion


def test_two_links_have_the_published_equations():
    # Siciliano, Sciavicco, Villani, Oriolo (2009), equation (7.82), without motors.
    scene = mechanics.from_urdf(MODELS / "two_link.urdf", symbolic=())
    model = mechanics.compile(mechanics.derive(scene), outputs=["inverse_dynamics"])
    rng, (a, l, m, I, g) = np.random.default_rng(0), (1, 0.5, 50, 10, 9.81)
    (q1, q2), (u1, u2), (w1, w2) = rng.uniform(-2, 2, (3, 2))
    b22 = I + m * l**2
    b12 = b22 + m * a * l * np.cos(q2)
    b11 = I + m * l**2 + I + m * (a**2 + l**2 + 2 * a * l * np.cos(q2))
    h = -m * a * l * np.sin(q2)
    g2 = m * l * g * np.cos(q1 + q2)
    g1 = (m * l + m * a) * g * np.cos(q1) + g2
    wanted = [
        b11 * w1 + b12 * w2 + h * u2 * (2 * u1 + u2) + g1,
        b12 * w1 + b22 * w2 - h * u1**2 + g2,
    ]
    found = model.inverse_dynamics([q1, q2], [u1, u2], [w1, w2], inputs=[0, 0], p=[g])
    assert found == pytest.approx(wanted, rel=1e-13)


@pytest.mark.campaign
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in ("two_link", "scara") else pytest.mark.campaign)
        for name in ROOTS
    ],
)
def test_motion_is_that_of_pinocchio(name):
    path, root = MODELS / f"{name}.urdf", ROOTS[name]
    scene = mechanics.from_urdf(path, root, symbolic=(), multiples=False)
    names = tuple(str(motor.func).removeprefix("tau_") for motor in scene.inputs)
    own, other = mechanics.compile(mechanics.derive(scene)), peer(path, names, root == "free")
    q, u, ud = numbers(scene, np.random.default_rng(1))
    damping = np.array([0.8, 0.4, 25, 0.05]) * u if name == "scara" else 0
    found = own.inverse_dynamics(q, u, ud, inputs=np.zeros(len(scene.inputs)))
    wanted = other.inverse_dynamics(q, u, ud) + damping
    assert np.abs(found - wanted).max() < 1e-13 * np.abs(wanted).max()
    for output in scene.outputs:
        if link := output.removesuffix("_position") if output.endswith("_position") else "":
            jacobian = np.vstack([own.output(f"{link}_{what}_jacobian", q)
                                  for what in ("position", "orientation")])  # fmt: skip
            assert np.abs(jacobian - other.jacobian(link, q)).max() < 1e-14


@pytest.mark.campaign
@pytest.mark.parametrize(
    "name", ["scara", *(pytest.param(n, marks=pytest.mark.long) for n in ("panda", "quadruped"))]
)
def test_routes_agree(name):
    scene = mechanics.from_urdf(MODELS / f"{name}.urdf", ROOTS[name])
    assert mechanics.crosscheck(scene).ok


def test_limits_friction_and_damping_come_with_a_joint(tmp_path):
    more = (
        '<origin xyz="0 0 1" rpy="0.1 0.2 1.5708"/><axis xyz="1 0 1"/>'
        '<limit lower="1" upper="2" effort="5" velocity="3"/>'
        '<dynamics damping="0.3" friction="0.2"/>'
    )
    file = write(tmp_path, LINK.format("base"), LINK.format("arm link"),
                 JOINT.format("q-1", "revolute", "base", "arm link", more))  # fmt: skip
    scene = mechanics.from_urdf(file)
    assert [c.text for c in scene.conditions] == [
        "|tau_q_1| <= 5", "q_1 >= 1", "q_1 <= 2", "|q_1'| <= 3"
    ]  # fmt: skip
    assert dict(scene.example) == {"q_1": 1.5}
    assert scene.notes == ("read 1.5708 as pi/2: joint q-1: rpy of its origin",)
    model = mechanics.compile(mechanics.derive(scene))
    fast, slow = (model.forward_dynamics([0.1], [u], inputs=[0.0])[0] for u in (0.5, -0.5))
    inertia = model.mass_matrix([0.1], [0.0], inputs=[0.0])[0, 0]
    assert inertia * (slow - fast) == pytest.approx(2 * (0.3 * 0.5 + 0.2))


def test_names_of_parameters_give_way_to_those_of_joints(tmp_path):
    parts = [LINK.format(name) for name in ("base", "x", "a")]
    there = '<origin xyz="1 0 0"/>' + '<axis xyz="0 0 1"/>'
    joints = [
        JOINT.format("x", "continuous", "base", "x", there),
        JOINT.format("x_x", "continuous", "x", "a", there),
    ]
    scene = mechanics.from_urdf(write(tmp_path, *parts, *joints))
    assert [str(q.func) for q in scene.coordinates] == ["x", "x_x_n2"]
    assert {"x_x_x_n2", "m_x", "m_a"} <= {symbol.name for symbol in scene.parameters}


def test_a_joint_that_mimics_is_constrained(tmp_path):
    parts = [LINK.format(name) for name in ("base", "left", "right")]
    left = JOINT.format("a", "continuous", "base", "left", '<axis xyz="0 1 0"/>')
    tie = '<axis xyz="1 0 0"/><mimic joint="a" multiplier="-2" offset="0.5"/>'
    right = JOINT.format("b", "prismatic", "left", "right", tie)
    scene = mechanics.from_urdf(write(tmp_path, *parts, left, right), symbolic=())
    ((constraint,), (_, b)) = scene.constraints, scene.coordinates
    assert constraint.expression == b + 2 * scene.coordinates[0] - Rational(1, 2)
    assert [motor.func.__name__ for motor in scene.inputs] == ["tau_a"]
    model = mechanics.compile(mechanics.derive(scene))
    (a, b) = model.forward_dynamics([0.1, 0.3], [0.4, -0.8], inputs=[1.0])
    assert b == pytest.approx(-2 * a)
    # Energy: the power of the motor is the rate of the energy, the tie has none.
    q, u, h = np.array([0.1, 0.3]), np.array([0.4, -0.8]), 1e-6
    total = [model.energy(q + s * h * u, u + s * h * np.array([a, b]), inputs=[1.0])["total"]
             for s in (-1, 1)]  # fmt: skip
    assert (total[1] - total[0]) / (2 * h) == pytest.approx(0.4, rel=1e-6)


def test_what_is_fixed_to_the_ground_is_the_ground(tmp_path):
    parts = [LINK.format(name) for name in ("world", "table", "arm", "load")]
    joints = [
        JOINT.format("stand", "fixed", "world", "table", '<origin xyz="0 0 1"/>'),
        JOINT.format("q", "continuous", "table", "arm", '<axis xyz="0 0 2"/>'),
        JOINT.format("grip", "fixed", "arm", "load", '<origin xyz="1 0 0"/>'),
    ]
    scene = mechanics.from_urdf(write(tmp_path, *parts, *joints), symbolic=())
    assert [body.name for body in scene.bodies] == ["arm", "load"]
    assert [joint.name for joint in scene.joints] == ["q", "grip"]
    model = mechanics.compile(mechanics.derive(scene))
    assert model.mass_matrix([0.3], [0.0], inputs=[0.0]) == pytest.approx(3.0)
    assert model.output("load_position", [0.0]) == pytest.approx([1, 0, 1])


def test_planar_joints_move_in_the_plane_across_their_axis(tmp_path):
    file = write(tmp_path, LINK.format("base"), LINK.format("puck"),
                 JOINT.format("p", "planar", "base", "puck", '<axis xyz="0 -1 0"/>'))  # fmt: skip
    scene = mechanics.from_urdf(file, symbolic=())
    model = mechanics.compile(mechanics.derive(scene))
    places = np.array([model.output("puck_position", [x, y, 0.3]) for x, y in ((1, 0), (0, 1))])
    assert places[:, 1] == pytest.approx([0, 0])
    assert np.cross(*places) == pytest.approx([0, -1, 0])
    turned = model.output("puck_orientation", [0, 0, 0.3])
    assert turned[:, 1] == pytest.approx([0, 1, 0])
    assert turned[0, 2] == pytest.approx(-np.sin(0.3))


# ---------------------------------------------------------------------- hostile files

BASE, ARM = LINK.format("base"), LINK.format("arm")
SWAPPED = '<limit lower="2" upper="1"/>'
AXIS = '<axis xyz="0 0 1"/>'
LAUGHS = (
    '<!DOCTYPE robot [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'
    '<robot name="&b;"><link name="base"/></robot>'
)


def turning(name="q", parent="base", child="arm", more=AXIS, kind="continuous"):
    return JOINT.format(name, kind, parent, child, more)


def massed(mass="1", ixx="1", ixy="0"):
    moments = f'<inertia ixx="{ixx}" iyy="1" izz="1" ixy="{ixy}"/>'
    return f'<link name="arm"><inertial><mass value="{mass}"/>{moments}</inertial></link>'


@pytest.mark.parametrize(
    ("parts", "words"),
    [
        ((BASE, ARM, turning(more="")), None),
        ((BASE, ARM, turning(more='<axis xyz="0 0 0"/>')), "joint q: its axis is 0 0 0"),
        ((BASE, massed("NaN"), turning()), "link arm: its mass is 'NaN'"),
        ((BASE, massed("-1"), turning()), "link arm: its mass -1 is negative"),
        ((BASE, massed(ixx="-1"), turning()), "link arm: its inertia has a negative principal"),
        ((BASE, massed(ixy="2"), turning()), "link arm: its inertia has a negative principal"),
        ((BASE, ARM, turning(parent="arm"),), "'base', 'arm'|go round in a circle|no parent"),
        ((BASE, ARM, turning(), turning("p", "arm", "base")), "in a circle: .*arm"),
        ((BASE, ARM, turning(), turning("p")), "joints q and p both carry link 'arm'"),
        ((BASE, ARM, turning(child="leg")), "joint q: there is no link 'leg', its child"),
        ((BASE, ARM, ARM, turning()), "two links are named 'arm'"),
        ((BASE, ARM), "links 'base', 'arm' have no parent"),
        ((BASE, ARM, turning(kind="hinge")), "joint q: its type is 'hinge'"),
        ((BASE, ARM, turning(more='<origin rpy="0 0"/>')), "rpy of its origin has 2 numbers"),
        ((BASE, ARM, turning(kind="fixed")), "no joint moves anything"),
        ((BASE, ARM, turning(more=SWAPPED, kind="revolute")), "its lower limit 2 is above"),
        ((BASE, ARM, turning(more=AXIS + '<mimic joint="x"/>')), "joint q: it is tied to 'x'"),
        ((BASE, ARM, turning(more=AXIS + '<mimic joint="q"/>')), "joint q: it mimics itself"),
        ((BASE, '<link name="arm"/>', turning()), None),
        ((), "it has no link"),
        (tuple(LINK.format(f"l{i}") for i in range(10_000)), "10000 links: at most 400"),
    ],
)  # fmt: skip
def test_hostile_robots_get_one_line(tmp_path, parts, words):
    file = write(tmp_path, *parts)
    if words is None:
        assert mechanics.from_urdf(file).coordinates
        return
    with pytest.raises(mechanics.MechanicsError, match=words) as error:
        mechanics.from_urdf(file)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (LAUGHS, "DOCTYPE"),
        ("<robot><link", "no XML"),
        ("", "no XML"),
        ("<mujoco/>", "begins with <mujoco>"),
        (
            '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="m"/></robot>',
            "it is xacro: expand it first",
        ),
        ("\x00", "no XML"),
    ],
)
def test_hostile_files_get_one_line(tmp_path, text, words):
    file = tmp_path / "robot.urdf"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words) as error:
        mechanics.from_urdf(file)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("options", [{"root": "up"}, {"symbolic": "mass"}, {"symbolic": ("g",)}])
def test_options_that_there_are_not_are_refused(options):
    with pytest.raises(InputError, match=next(iter(options))):
        mechanics.from_urdf(MODELS / "two_link.urdf", **options)


def test_no_file_is_told(tmp_path):
    with pytest.raises(InputError, match="there is no such file"):
        mechanics.from_urdf(tmp_path / "none.urdf")


def test_commands_take_a_robot_and_tell_what_was_read(tmp_path, capsys):
    file = write(tmp_path, BASE, ARM, turning(more='<origin rpy="0 1.57 0"/>' + AXIS), name="b ot")
    scene = load(f"{file}:free").scene()
    assert scene.name == "b_ot"
    assert [str(q.func) for q in scene.coordinates[:4]] == ["base_x", "base_y", "base_z", "q"]
    assert "read 1.57 as pi/2: joint q" in capsys.readouterr().err
    assert is_file(str(file))


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("name", "route", "symbolic"),
    [("two_link", "kane", ()), ("scara", "free_body", ("mass", "com", "inertia"))],
)
def test_numbers_stay_exact_in_what_is_compiled(name, route, symbolic):
    # Constant pivots, and dampings such as 1/20: CasADi would fold reciprocals into doubles.
    scene = mechanics.from_urdf(MODELS / f"{name}.urdf", symbolic=symbolic)
    model = mechanics.compile(mechanics.derive(scene, route), outputs=["jacobians"])
    assert all(finding.shown for finding in prove_compiled(model))
