"""What rolls: against equations that others published, and against itself in other words."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from sympy import Expr, Rational, Symbol, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia
from whipple_bicycle import whipple_bicycle

import mechanics
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.compiled import Model
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.errors import SceneError
from mechanics.routes.derivation import ROUTES
from mechanics.scene import (
    RigidBody,
    Scene,
    euler,
    free,
    gravity,
    parameters,
    pin,
    position,
    quaternion,
    roll,
    velocity,
)
from systems import bicycle

t = dynamicsymbols._t
x, y, z, yaw, lean, spin, phi, theta = dynamicsymbols("x y z yaw lean spin phi theta")
wheel_rate, ahead, across = dynamicsymbols("wheel_rate ahead across")
m, R, r, g, a, b, c, A, B, C, Omega = parameters(
    "m R r g a b c A B C Omega", typical="2 1 3/10 981/100 1/5 3/10 2/5 1/10 1/5 1/4 3/2"
)
NUMBERS = {"m": 2.0, "R": 1.0, "r": 0.3, "g": 9.81, "a": 0.2, "b": 0.3, "c": 0.4, "A": 0.1,
           "B": 0.2, "C": 0.25, "Omega": 1.5}  # fmt: skip


def disc(*speeds: Expr) -> Scene:
    """A thin uniform disc on a horizontal plane."""
    N, O = ReferenceFrame("N"), Point("O")
    joint = roll("disc", None, "disc", at=O, normal=N.z, radius=R, coordinates=(x, y),
                 angles=(yaw, lean, spin), speeds=speeds)  # fmt: skip
    F, one = joint.frame, m * R**2 / 4
    return Scene("disc", N, O, bodies=(RigidBody("disc", joint.point, F, m,
                 inertia(F, one, 2 * one, one)),), joints=(joint,),
                 loads=(gravity(-g * N.z),), example={"lean": 0.2},
                 outputs={"slip": velocity(joint.contact, on="disc")})  # fmt: skip


def cylinder(**where: Expr) -> Scene:
    """A uniform cylinder in a ring, hanging down, or on top of one."""
    N, O = ReferenceFrame("N"), Point("O")
    joint = roll("C", None, "cylinder", at=O, normal=-N.y if "inside" in where else N.y,
                 axis=N.z, radius=r, angles=(phi, theta), **where)  # fmt: skip
    body = RigidBody("cylinder", joint.point, joint.frame, m, m * r**2 / 2)
    return Scene("cylinder", N, O, bodies=(body,), joints=(joint,), loads=(gravity(-g * N.y),),
                 plane=N.z)  # fmt: skip


def ring_that_turns() -> Scene:
    """A cylinder in a ring that is a body of its own, on a hinge."""
    N, O = ReferenceFrame("N"), Point("O")
    hinge = pin("H", None, "ring", at=O, axis=N.z, angle=x)
    F = hinge.frame
    joint = roll("C", "ring", "cylinder", at=O, normal=-F.y, axis=F.z, inside=R, radius=r,
                 angles=(phi, theta))  # fmt: skip
    bodies = (RigidBody("ring", O, F, m, A),
              RigidBody("cylinder", joint.point, joint.frame, m, B))  # fmt: skip
    return Scene("ring that turns", N, O, bodies=bodies, joints=(hinge, joint), plane=N.z,
                 loads=(gravity(-g * N.y),))  # fmt: skip


def incline(space: bool = False) -> Scene:
    """A wheel that rolls down a plane inclined by 30 degrees; it stays upright."""
    N, O = ReferenceFrame("N"), Point("O")
    joint = roll("W", None, "wheel", at=O, normal=N.y, axis=N.z, radius=r, coordinates=(x,),
                 angles=(theta,))  # fmt: skip
    moment: Any = inertia(joint.frame, A, A, m * r**2 / 2) if space else m * r**2 / 2
    body = RigidBody("wheel", joint.point, joint.frame, m, moment)
    return Scene("incline", N, O, bodies=(body,), joints=(joint,), plane=None if space else N.z,
                 loads=(gravity(g * N.x / 2 - g * pi / 4 * N.y),))  # fmt: skip


def carried(radius: Any, moments: tuple[Expr, ...], rotation: Any, turn: Expr | int = 0) -> Scene:
    """A free body that touches a table, which may turn."""
    N, O = ReferenceFrame("N"), Point("O")
    table = N.orientnew("T", "Axis", (turn, N.z)) if turn != 0 else N
    joint = free("F", "body", at=O, frame=N, coordinates=(x, y, z), rotation=rotation)
    F = joint.frame
    axis = {"axis": F.y} if radius == "wheel" else {}
    touch = roll("K", None, "body", at=O, normal=table.z, radius=R if axis else radius,
                 onto=(joint.point, F), **axis)  # fmt: skip
    return Scene("carried", N, O, bodies=(RigidBody("body", joint.point, F, m,
                 inertia(F, *moments)),), joints=(joint, touch), loads=(gravity(-g * N.z),),
                 example={"z": 0.3},
                 outputs={"slip": velocity(touch.contact, on="body"),
                          "contact": position(touch.contact)})  # fmt: skip


def angles() -> Any:
    return euler("zxy", yaw, lean, spin)


def parts() -> Any:
    return quaternion("e0 e1 e2 e3", "wx wy wz")


def model_of(scene: Scene) -> Model:
    """In the form that is found at once; the cheapest of an ellipsoid takes some seconds."""
    return mechanics.compile(mechanics.derive(scene, "kane"), compiler=None, form="elimination")


def numbers(model: Model) -> list[float]:
    return [NUMBERS[entry.name] for entry in model.quantities.p]


def named(model: Model, group: str, values: Mapping[str, float]) -> list[float]:
    return [values[entry.name] for entry in getattr(model.quantities, group)]


SCENES: Mapping[str, Callable[[], Scene]] = {
    "disc": disc,
    "disc by its total spin rate": lambda: disc(wheel_rate),
    "disc by all three": lambda: disc(wheel_rate, ahead, across),
    "in a ring": lambda: cylinder(inside=R),
    "on a ring": lambda: cylinder(outside=R),
    "in a ring that turns": ring_that_turns,
    "incline": incline,
    "incline in space": lambda: incline(space=True),
    "ball": lambda: carried(r, (A, A, A), angles()),
    "ball on a table that turns": lambda: carried(r, (A, A, A), parts(), Omega * t),
    "wheel of another joint": lambda: carried("wheel", (A, B, A), angles()),
    "wheel, quaternion": lambda: carried("wheel", (A, B, A), parts()),
    "ellipsoid": lambda: carried((a, b, c), (A, B, C), angles()),
    "ellipsoid, quaternion": lambda: carried((a, b, c), (A, B, C), parts()),
}
QUICK = ("in a ring", "incline")


@pytest.mark.parametrize(
    "kind", [pytest.param(k, marks=[pytest.mark.campaign] * (k not in QUICK)) for k in SCENES]
)
def test_all_routes_agree_and_all_laws_hold(kind: str) -> None:
    programs = derive_rows(check_scene(SCENES[kind]()), [route.name for route in ROUTES])
    pairs = compare_pairs(programs.routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    assert all(finding.shown for finding in check_laws(programs))


DISC = {"x": 0.3, "y": -0.2, "yaw": 0.7, "lean": 0.4, "spin": 0.9}
RATES = {"yaw_dot": 0.8, "lean_dot": -0.6, "spin_dot": 5.0}


def disc_state(yaw_angle: float) -> tuple[dict[str, float], dict[str, float]]:
    """Coordinates, and speeds of every kind, of a disc that rolls."""
    q = {**DISC, "yaw": yaw_angle}
    v = NUMBERS["R"] * RATES["spin_dot"]
    total = RATES["spin_dot"] + RATES["yaw_dot"] * np.sin(q["lean"])
    u = {**RATES, "x_dot": v * np.cos(yaw_angle), "y_dot": v * np.sin(yaw_angle),
         "wheel_rate": total, "ahead": v, "across": 0.0}  # fmt: skip
    return q, u


HEADINGS = [0.0, 0.7, np.pi / 2, -3.0]


@pytest.mark.parametrize(
    ("count", "heading"),
    [pytest.param(count, heading, marks=[pytest.mark.campaign] * (
        count == 1 or heading != np.pi / 2)) for count in (0, 1, 3) for heading in HEADINGS],
)  # fmt: skip
def test_a_disc_has_the_published_accelerations_at_every_heading(
    count: int, heading: float
) -> None:
    """SymPy's documentation, "A rolling disc using Kane's Method", printed for a uniform disc:

    5 R u1' = 4 g sin(lean) + 6 R u2 u3 - R u3^2 tan(lean),   u2' = -2 u1 u3/3,
    u3' = (-2 u2 + u3 tan(lean)) u1,      u1 = lean', u2 the total spin rate, u3 = yaw' cos(lean).
    """
    model = model_of(disc(*(wheel_rate, ahead, across)[:count]))
    q, u = disc_state(heading)
    found = model.forward_dynamics(named(model, "q", q), named(model, "u", u), numbers(model))
    ud = {e.name.removesuffix("dot") if e.name.endswith("_ddot") else e.name: v
          for e, v in zip(model.quantities.ud, found, strict=True)}  # fmt: skip
    s, co, R_, g_ = np.sin(q["lean"]), np.cos(q["lean"]), NUMBERS["R"], NUMBERS["g"]
    u1, u2, u3 = u["lean_dot"], u["wheel_rate"], u["yaw_dot"] * co
    u1d = (4 * g_ * s + 6 * R_ * u2 * u3 - R_ * u3**2 * s / co) / (5 * R_)
    u2d, u3d = -2 * u1 * u3 / 3, (-2 * u2 + u3 * s / co) * u1
    assert ud["lean_d"] == pytest.approx(u1d, rel=1e-12)
    assert ud["yaw_d"] * co - u["yaw_dot"] * u1 * s == pytest.approx(u3d, rel=1e-12)
    total = ud["wheel_rate_dot"] if count else (
        ud["spin_d"] + ud["yaw_d"] * s + u["yaw_dot"] * u1 * co)  # fmt: skip
    assert total == pytest.approx(u2d, rel=1e-11)
    slip = model.slip(named(model, "q", q), named(model, "u", u), numbers(model))
    np.testing.assert_allclose(slip, 0, atol=1e-14)


@pytest.mark.campaign
def test_a_disc_that_rolls_fast_stays_upright() -> None:
    """v^2 > g R/3: Routh, Dynamics of a System of Rigid Bodies, advanced part."""
    v = Symbol("v", positive=True)
    linear = mechanics.linearize(
        mechanics.derive(disc(wheel_rate), "kane"), at={"lean": 0}, speeds={"wheel_rate": v / R}
    )
    s = Symbol("s")
    wanted = s**2 * (s**2 + (12 * v**2 - 4 * R * g) / (5 * R**2))
    assert (linear.A.charpoly(s).as_expr() - wanted).expand() == 0


def test_a_cylinder_in_a_cylinder_swings_as_published() -> None:
    """Landau and Lifshitz, Mechanics, section 32, problem 7: 3 (R - r) phi'' = -2 g sin(phi)."""
    model = model_of(cylinder(inside=R))
    q, gap = {"phi": 0.7, "theta": 0.1}, NUMBERS["R"] - NUMBERS["r"]
    u = {"phi_dot": 1.3, "theta_dot": -1.3 * gap / NUMBERS["r"]}
    found = model.forward_dynamics(named(model, "q", q), named(model, "u", u), numbers(model))
    assert found[0] == pytest.approx(-2 * 9.81 * np.sin(0.7) / (3 * gap), rel=1e-13)
    assert found[1] == pytest.approx(-gap / NUMBERS["r"] * found[0], rel=1e-13)
    linear = mechanics.linearize(
        mechanics.derive(cylinder(inside=R), "kane"), at={"phi": 0, "theta": 0}
    )
    s = Symbol("s")
    wanted = s**2 + Rational(2, 3) * g / (R - r)
    assert (linear.A.charpoly(s).as_expr() - wanted).cancel() == 0


def test_a_cylinder_rolls_off_another() -> None:
    """3 (R + r) phi'' = 2 g sin(phi), the angle from the top."""
    model = model_of(cylinder(outside=R))
    q, gap = {"phi": 0.4, "theta": 0.1}, NUMBERS["R"] + NUMBERS["r"]
    u = {"phi_dot": 0.5, "theta_dot": 0.5 * gap / NUMBERS["r"]}
    found = model.forward_dynamics(named(model, "q", q), named(model, "u", u), numbers(model))
    assert found[0] == pytest.approx(2 * 9.81 * np.sin(0.4) / (3 * gap), rel=1e-13)


@pytest.mark.parametrize("space", [False, True])
def test_a_wheel_rolls_down_with_two_thirds_of_the_slope(space: bool) -> None:
    model = model_of(incline(space))
    u = {"x_dot": 1.2, "theta_dot": -4.0}
    found = model.forward_dynamics([0.3, 0.1], named(model, "u", u), numbers(model))
    assert found[0] == pytest.approx(9.81 / 3, rel=1e-13)
    assert found[1] == pytest.approx(-9.81 / 3 / 0.3, rel=1e-13)


@pytest.mark.campaign
def test_a_ball_on_a_table_that_turns_goes_in_circles() -> None:
    """Milne, Vectorial Mechanics, 1948: r'' = (2/7) Omega x r' for a uniform ball."""
    model = model_of(carried(r, (2 * m * r**2 / 5,) * 3, parts(), Omega * t))
    radius, rate = NUMBERS["r"], NUMBERS["Omega"]
    q = {"x": 0.5, "y": -0.3, "z": radius, "e0": 0.5, "e1": 0.5, "e2": -0.5, "e3": 0.5}
    # omega = (wx, wy, wz) in the body's frame; R takes x to z, y to -x and z to -y.
    v = np.array([0.4, 0.7])
    relative = v - rate * np.array([0.3, 0.5])  # against the table: v - Omega x r
    # No slip: v = Omega x r + omega x (r z) of components in the ground.
    omega = np.array([-relative[1], relative[0], 0.9]) / [radius, radius, 1]
    e0, e = q["e0"], np.array([q["e1"], q["e2"], q["e3"]])
    skew = np.array([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]])
    turned = np.eye(3) + 2 * (e0 * skew + skew @ skew)
    w = turned.T @ omega
    u = {"x_dot": v[0], "y_dot": v[1], "z_dot": 0.0, "wx": w[0], "wy": w[1], "wz": w[2]}
    found = model.forward_dynamics(
        named(model, "q", q), named(model, "u", u), numbers(model), inputs=[0.2]
    )
    ud = dict(zip((e.name for e in model.quantities.ud), found, strict=True))
    assert ud["x_ddot"] == pytest.approx(-2 * rate * v[1] / 7, rel=1e-12)
    assert ud["y_ddot"] == pytest.approx(2 * rate * v[0] / 7, rel=1e-12)
    assert ud["z_ddot"] == pytest.approx(0, abs=1e-12)


@pytest.mark.campaign
def test_a_ball_and_a_wheel_are_ellipsoids() -> None:
    """With equal semi-axes, and with one of length zero."""
    q = {"x": 0.1, "y": 0.2, "z": 0.0, "yaw": 0.7, "lean": 0.4, "spin": 0.3}
    turning = {"yaw_dot": 0.3, "lean_dot": 0.4, "spin_dot": 2.0}
    for radius, axes, moments in ((r, (r, r, r), (A, B, C)), ("wheel", (R, 0, R), (A, B, A))):
        found = []
        for kind in (radius, axes):
            model = model_of(carried(kind, moments, angles()))
            p, still = numbers(model), dict.fromkeys(("x_dot", "y_dot", "z_dot"), 0.0)
            at = {**q, "z": -model.contact(named(model, "q", q), p=p)[2]}
            u = named(model, "u", {**turning, **still})
            slip = model.slip(named(model, "q", at), u, p)
            u = named(model, "u", {**turning, **dict(zip(still, -slip, strict=True))})
            found.append(model.forward_dynamics(named(model, "q", at), u, p))
        np.testing.assert_allclose(found[0], found[1], rtol=1e-11)


@pytest.mark.campaign
def test_an_ellipsoid_rocks_as_its_curvature_says() -> None:
    """About y, on its axis c: (B + m c^2) theta'' = -m g (a^2/c - c) theta for small angles."""
    model = model_of(carried((a, b, c), (A, B, C), euler("zxy", yaw, lean, spin)))
    n = NUMBERS
    tilt = 1e-7
    q = {"x": 0.0, "y": 0.0, "z": n["c"], "yaw": 0.0, "lean": 0.0, "spin": tilt}
    u = dict.fromkeys(("x_dot", "y_dot", "z_dot", "yaw_dot", "lean_dot", "spin_dot"), 0.0)
    found = model.forward_dynamics(named(model, "q", q), named(model, "u", u), numbers(model))
    ud = dict(zip((e.name for e in model.quantities.ud), found, strict=True))
    stiff = n["m"] * n["g"] * (n["a"] ** 2 / n["c"] - n["c"])
    wanted = -stiff * tilt / (n["B"] + n["m"] * n["c"] ** 2)
    assert ud["spin_ddot"] == pytest.approx(wanted, rel=1e-9)


@pytest.mark.campaign
def test_a_bicycle_of_joints_is_the_one_that_was_typed() -> None:
    """Its spin is that of the wheel against the hub, there against the frame."""
    one, two = model_of(bicycle.scene()), model_of(whipple_bicycle())
    values = {name: float(value) for text in bicycle.TYPICAL.values() for name, value in
              (pair.split() for pair in text.split(","))}  # fmt: skip
    start = {"x": 0.1, "y": 0.2, "yaw": 2.1, "lean": 0.1, "steer": 0.3, "tR": 0.4, "tF": 0.5}
    motion = mechanics.simulate(two, 0.05, samples=2, initial={**start, "tR_dot": -10.0,
                                "lean_dot": 0.2, "steer_dot": 0.3})  # fmt: skip
    q = {name: column[-1] for name, column in motion.coordinates.items()}
    u = {name: column[-1] for name, column in motion.speeds.items()}
    found = []
    for model, share in ((one, 1.0), (two, 0.0)):
        own_q = {**q, "tR": q["tR"] + share * q["pitch"]}
        own_u = {**u, "tR_dot": u["tR_dot"] + share * u["pitch_dot"]}
        ud = model.forward_dynamics(
            named(model, "q", own_q), named(model, "u", own_u), [values[e.name] for e in
            model.quantities.p])  # fmt: skip
        table = dict(zip((e.name for e in model.quantities.ud), ud, strict=True))
        table["tR_ddot"] -= share * table["pitch_ddot"]
        found.append([table[f"{name}_ddot"] for name in sorted(q)])
    np.testing.assert_allclose(found[0], found[1], rtol=1e-9, atol=1e-9)


def refused(**changes: Any) -> Any:
    N, O = ReferenceFrame("N"), Point("O")
    fields = {"at": O, "normal": N.z, "radius": R, "coordinates": (x, y),
              "angles": (yaw, lean, spin)}  # fmt: skip
    given = {key: value(N, O) if callable(value) else value for key, value in changes.items()}
    return roll("W", None, "wheel", **{**fields, **given})


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"normal": None}, "joint W: normal is None, a NoneType: give a vector"),
        ({"normal": lambda N, O: N.x + N.z}, "is along no axis of N: orient a frame"),
        ({"coordinates": (x,)}, "joint W: 1 coordinates: give two, of the contact"),
        ({"angles": (yaw, lean)}, "joint W: 2 angles: give three: yaw, lean and spin"),
        ({"speeds": (x, y, z, phi)}, "joint W: 4 speeds: give at most three"),
        ({"radius": "R"}, "joint W: the radius is 'R'"),
        ({"axis": lambda N, O: N.z, "coordinates": (x,), "angles": (spin,)}, "is not across"),
        ({"axis": lambda N, O: N.x, "inside": R, "outside": r}, "it rolls on one side"),
        ({"axis": lambda N, O: N.x, "inside": R}, "3 angles: give two"),
        ({"onto": lambda N, O: (O, N)}, "it has onto= and x(t), a x: what closes"),
        ({"onto": lambda N, O: (O, N), "coordinates": (), "angles": (), "radius": (a, b)},
         "2 radii: give one, or the three semi-axes"),
        ({"onto": lambda N, O: O, "coordinates": (), "angles": ()}, "frame, as in onto=(C, frame)"),
    ],
)  # fmt: skip
def test_what_cannot_roll_is_refused(changes: Mapping[str, Any], words: str) -> None:
    with pytest.raises(SceneError) as caught:
        refused(**changes)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)
