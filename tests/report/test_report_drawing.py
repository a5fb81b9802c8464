"""A drawing of every system, from its geometry alone."""

import dataclasses
import importlib
import pkgutil
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from types import ModuleType

import numpy as np
import pytest
from sympy import Symbol, cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

import systems
from mechanics.errors import SceneError
from mechanics.report.animation import moving_picture
from mechanics.report.charts import Axis, bar, line_chart, round_step
from mechanics.report.coordinate_drawings import coordinate_drawings
from mechanics.report.drawing import CORNER, HEIGHT, WIDTH, drawing, outline, paper_for, shape_words
from mechanics.report.projection import View, closed
from mechanics.scene import (
    Outline,
    Particle,
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    parameters,
    pin,
    position,
    reaction,
    rope,
    slide,
    spring,
)
from mechanics.scene.json import from_json, to_json
from mechanics.scene.loads import Spring
from systems import gyroscope, half_car, humanoid, quadrotor


def scenes() -> dict[str, Callable[[], Scene]]:
    found = {}
    for module in pkgutil.iter_modules(systems.__path__):
        scene = getattr(importlib.import_module(f"systems.{module.name}"), "scene", None)
        if scene is not None and scene.__module__ == f"systems.{module.name}":
            found[module.name] = scene
    return found


SCENES = scenes()
LARGE = ("andrews", "arm_puma560", "arm_seven_joints", "bicycle", "humanoid")
NAMES = [
    pytest.param(name, marks=pytest.mark.campaign) if name in LARGE else name
    for name in sorted(SCENES)
]


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NAMES)
def test_every_system_is_drawn_inside_its_frame(name: str) -> None:
    scene = SCENES[name]()
    text = drawing(scene, scene.example)
    root = ElementTree.fromstring(text)
    assert root.get("role") == "img"
    assert scene.name in str(root.get("aria-label"))
    assert "nan" not in text
    points = [
        tuple(map(float, pair.split(",")))
        for node in root.iter()
        for pair in node.get("points", "").split()
    ]
    x, y = np.array(points).T
    assert min(x) >= 0
    assert max(x) <= WIDTH
    assert min(y) >= 0
    assert max(y) <= HEIGHT
    # Every body is seen.
    assert len(re.findall(r'class="(?:body(?: inferred)?|rod|rim|mass)"', text)) >= len(
        scene.bodies
    )


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NAMES)
def test_words_name_the_bodies_whose_shape_is_that_of_their_inertia(name: str) -> None:
    """With another inertia they are drawn in another shape, and no others are."""
    scene = SCENES[name]()
    view = View(scene, closed(scene, scene.example))
    words = shape_words(scene)
    for body in scene.bodies:
        if isinstance(body, RigidBody):
            heavier = outline(view, dataclasses.replace(body, inertia=body.inertia * 1.3))
            as_is = outline(view, body)
            other = len(as_is) != len(heavier) or not np.allclose(as_is, heavier)
            assert other == (body.name.replace("_", " ") in words)
            assert not (other and body.outlines)
    dashed = drawing(scene, scene.example).count('class="body inferred"')
    assert dashed == sum(len(outline(view, b)) > 20 and not b.outlines for b in scene.bodies
                         if isinstance(b, RigidBody))  # fmt: skip


def test_a_scene_that_holds_the_time_is_drawn_at_its_start() -> None:
    ground, origin, shift = ReferenceFrame("N"), Point("O"), dynamicsymbols("x")
    time = dynamicsymbols._t
    tip = origin.locatenew("P", (shift + 3 * cos(time)) * ground.x)
    (m,) = parameters("m", units="kg", typical="1")
    scene = Scene("shaken", ground, origin, coordinates=(shift,), bodies=(Particle("b", tip, m),))
    assert np.allclose(View(scene, {"x": 1.0}).point(tip), (4, 0))


def test_a_rod_and_a_rolling_body_have_their_size() -> None:
    pendulum = SCENES["elastic_pendulum"]()
    view = View(pendulum, {"theta": 0.0})
    ends = outline(view, pendulum.body("pendulum"))
    assert np.allclose(ends[0], (0, 0)) or np.allclose(ends[-1], (0, 0))
    assert np.isclose(np.hypot(*(ends[0] - ends[-1])), 1.0)
    rocker = SCENES["rocker"]()
    lowest = min(p[1] for p in outline(View(rocker, {}), rocker.body("rocker")))
    assert abs(lowest) < 1e-9


def test_the_rocker_is_one_shape_that_stays_the_same_as_it_rolls() -> None:
    """Two half discs with a rectangle between them, 3 R long and 2 R wide."""
    rocker = SCENES["rocker"]()
    for theta in (0.0, 0.7, 1.5):
        view = View(rocker, {"theta": theta})
        corners = np.array(outline(view, rocker.body("rocker")))
        along = np.array([np.sin(theta), np.cos(theta)])
        assert np.ptp(corners @ along) == pytest.approx(0.3, abs=1e-3)
        assert np.ptp(corners @ [along[1], -along[0]]) == pytest.approx(0.2, abs=1e-3)
        assert drawing(rocker, {"theta": theta}).count('class="body"') == 1


def test_a_disc_in_space_is_seen_with_its_radius() -> None:
    scene = SCENES["rolling_disc"]()
    edge = outline(View(scene, {}), scene.body("disc"))
    centre = View(scene, {}).point(scene.body("disc").centre)
    # Isometric lengths along the axes are sqrt(2/3) of the true ones; z is among them here.
    assert np.isclose(
        max(p[1] - centre[1] for p in edge), 0.5 * np.hypot(0.8165, 0.4082), atol=2e-3
    )


@pytest.mark.parametrize("span", [1e-9, 0.3, 7.0, 2.5e6])
def test_ticks_are_round_and_inside(span: float) -> None:
    axis = Axis(-0.4 * span, 0.6 * span, 0.0, 100.0)
    assert 3 <= len(axis.ticks) <= 8
    assert all(axis.low - 1e-9 * span <= tick <= axis.high + 1e-9 * span for tick in axis.ticks)
    mantissa = round_step(span / 5)
    assert f"{mantissa:.3e}"[0] in "125"


def test_a_constant_curve_has_an_axis() -> None:
    chart = line_chart("constant", [0.0, 1.0], {"x": [2.0, 2.0]}, "m")
    assert "nan" not in chart
    assert chart.count("<polyline") == 1


def test_samples_that_are_not_finite_are_left_out() -> None:
    chart = line_chart("gap", [0.0, 1.0, 2.0], {"x": [0.0, float("nan"), 1.0]}, "m")
    (points,) = re.findall(r'<polyline[^>]*points="([^"]*)"', chart)
    assert len(points.split()) == 2


def test_a_bar_is_never_invisible() -> None:
    assert 'width="0.8"' in bar(0.0)
    assert 'width="50.0"' in bar(0.5)


def strokes(text: str, style: str = "line") -> list[np.ndarray]:
    return [
        np.array([list(map(float, pair.split(","))) for pair in found.split()])
        for found in re.findall(rf'<polyline class="{style}" points="([^"]*)"', text)
    ]


def test_a_spring_and_a_damper_stand_side_by_side_and_end_at_what_they_hold() -> None:
    """Both between the same points; another damper ends at the mass centre of a rod."""
    x, theta = dynamicsymbols("x theta")
    m, L, k, c, g = parameters("m L k c g", units="kg m N/m N*s/m m/s^2", typical="1 1 1 1 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    pivot = origin.locatenew("B", x * ground.x)
    centre = pivot.locatenew("C", -L / 2 * rod.y)
    scene = Scene(
        "damped", ground, origin, coordinates=(x, theta),
        bodies=(Particle("cart", pivot, m), RigidBody("rod", centre, rod, m, m * L**2 / 12)),
        loads=(
            gravity(-g * ground.y),
            spring("k", origin, pivot, k, along=ground.x),
            damper("c", origin, pivot, c, along=ground.x),
            damper("d", origin, centre, c, along=ground.x),
        ),
        reactions=(
            reaction("T", at=pivot, on="cart", by="rod", along=ground.x),
            reaction("N", at=pivot, on="rod", by="cart", along=ground.y),
            reaction("N1", at=pivot, on="cart", by=None, along=ground.y),
        ),
    )  # fmt: skip
    text = drawing(scene, {"theta": 0.5})
    (coil,) = (line for line in strokes(text) if len(line) > 10)
    ends = [line[-1] for line in strokes(text) if len(line) == 2]
    joint = re.search(r'class="joint" cx="([\d.]+)" cy="([\d.]+)"', text)
    assert joint is not None
    # At the edge of the cart, a block of 54 pixels, and clear of the coil, which is 7 wide.
    (held,) = (end for end in ends if abs(float(joint[1]) - end[0] - 27) < 0.2)
    assert abs(coil[-1, 1] - held[1]) > 2 * 7 + 2
    dots = re.findall(r'class="ink" cx="([\d.]+)" cy="([\d.]+)"', text)
    assert any(np.allclose(end, np.array(dots[-1], dtype=float), atol=0.1) for end in ends)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", NAMES)
def test_axes_and_gravity_stand_where_nothing_else_is(name: str) -> None:
    drawn, corner, _ = re.split(
        r'<g transform="translate\(([\d ]+)\)">', drawing(SCENES[name](), SCENES[name]().example)
    )
    low = np.array(corner.split(), dtype=float)
    found = strokes(drawn, "(?:line|body|rod|rim|motion|force)")
    assert not any(np.any(np.all((line > low) & (line < low + CORNER), axis=1)) for line in found)


@pytest.mark.parametrize("side", [1, -1])
def test_friction_points_against_the_sliding(side: int) -> None:
    text = drawing(SCENES["cartpole_friction"](), {"x_dot": side, "theta": 0.1})
    # Gravity is vertical; the arrow of the friction is the one that is 40 pixels long.
    arrows = [line for line in strokes(text, "force") if len(line) == 2]
    (arrow,) = (line for line in arrows if abs(abs(line[1, 0] - line[0, 0]) - 40) < 0.2)
    assert np.sign(arrow[1, 0] - arrow[0, 0]) == -side
    assert arrow[0, 1] == pytest.approx(arrow[1, 1])


def test_coordinates_of_one_body_stand_clear_of_each_other() -> None:
    """A load on a rope: its length moves it down, its angle to the side."""
    length, angle = dynamicsymbols("l theta")
    ground = ReferenceFrame("N")
    rope = ground.orientnew("A", "Axis", (angle, ground.z))
    origin = Point("O")
    load = origin.locatenew("P", -length * rope.y)
    (m,) = parameters("m", units="kg", typical="1")
    scene = Scene(
        "load", ground, origin, coordinates=(length, angle), bodies=(Particle("load", load, m),)
    )
    text = drawing(scene, {"l": 3.0})
    names = re.findall(r'<text class="motion-name" x="([-\d.]+)" y="([-\d.]+)"', text)
    assert len(names) == 2
    (one, two) = (np.array(list(map(float, name))) for name in names)
    assert np.hypot(*(one - two)) > 16
    assert all(0 < y < HEIGHT for _, y in (one, two))


@pytest.mark.parametrize("system", [quadrotor, gyroscope, half_car, humanoid])
def test_a_drawing_is_filled_by_its_bodies(system: ModuleType) -> None:
    """Whatever is far away, or of no size in the equations."""
    scene = system.scene()
    view = View(scene, closed(scene, scene.example))
    paper = paper_for([view])
    corners = [paper.place(c) for body in scene.bodies for c in outline(view, body)]
    assert max(np.ptp(corners, axis=0) / (WIDTH, HEIGHT)) > 0.4


def test_springs_that_the_scene_gives_no_length_are_drawn_with_one() -> None:
    scene = half_car.scene()
    view = View(scene, scene.example)
    springs = [load for load in scene.loads if isinstance(load, Spring)]
    lengths = [np.hypot(*(view.point(s.second) - view.point(s.first))) for s in springs]
    assert len(lengths) == 4 and min(lengths) > 0.2


def test_an_outline_moves_with_its_body_and_knows_no_stranger() -> None:
    ground, origin, q = ReferenceFrame("N"), Point("O"), dynamicsymbols("q")
    joint = pin("pin", None, "disc", at=origin, axis=ground.z, angle=q)

    def scene(*outlines: Outline) -> Scene:
        body = RigidBody("disc", origin, joint.frame, 1, inertia(joint.frame, 1, 1, 2), outlines)
        return Scene("disc", ground, origin, bodies=(body,), joints=(joint,))

    with pytest.raises(SceneError, match="body disc: an outline is along N: write it along"):
        scene(Outline(ground.x))
    with pytest.raises(SceneError, match="body disc: an outline depends on R"):
        scene(Outline(Symbol("R") * joint.frame.x))
    drawn = scene(Outline(joint.frame.x, 2 * joint.frame.y, filled=True), Outline(joint.frame.y))
    view = View(drawn, {"q": np.pi / 2})
    ends, P = view.outlines(drawn.bodies[0]), view.projection
    assert np.allclose(ends[1], [[-1, 0, 0], [1, 0, 0]] @ P.T)
    assert to_json(from_json(to_json(drawn))) == to_json(drawn)


def puck_on_table() -> Scene:
    """A puck on a table, on a string through a hole, and the weight that hangs below."""
    r, theta, z = dynamicsymbols("r theta z")
    m, l, g = parameters("m l g", units="kg m m/s^2", typical="1 1.5 9.81")
    ground, hole = ReferenceFrame("N"), Point("O")
    turned = ground.orientnew("A", "Axis", (theta, ground.z))
    puck, weight = hole.locatenew("P", r * turned.x), hole.locatenew("Q", -z * ground.z)
    ends = (("puck", puck), (None, hole), ("weight", weight))
    return Scene(
        "puck", ground, hole, coordinates=(r, theta, z),
        bodies=(Particle("puck", puck, m), Particle("weight", weight, m)),
        loads=(gravity(-g * ground.z),),
        joints=(rope("T", *ends, length=l, along=(-turned.x, -ground.z)),),
        reactions=(
            reaction("n", at=puck, on="puck", by=None, along=ground.z),
            reaction("gx", at=weight, on="weight", by=None, along=ground.x),
            reaction("gy", at=weight, on="weight", by=None, along=ground.y),
        ),
        example={"r": 0.5, "z": 1.0},
    )  # fmt: skip


def test_particles_in_space_are_dots_and_a_plane_does_not_hide_what_is_below_it() -> None:
    scene = puck_on_table()
    pictures = [drawing(scene, scene.example)]
    pictures += [svg for _, svg in coordinate_drawings(scene, scene.example)]
    assert len(pictures) == 4
    for text in pictures:
        assert text.count('class="mass"') == 2
        assert 'class="body"' not in text
        assert text.count('class="plane open"') == 1
    assert 'class="plane"' in drawing(SCENES["rolling_disc"](), SCENES["rolling_disc"]().example)


def test_the_way_of_a_particle_is_as_smooth_as_its_motion() -> None:
    """Ten turns in 500 samples: a circle of 0.5 m, and no corner of more than its samples have."""
    scene = puck_on_table()
    angle = np.linspace(0, 20 * np.pi, 501)
    motion = {"r": 0.5 + 0 * angle, "theta": angle, "z": 1.0 + 0 * angle}
    way = View(scene, scene.example, motion=motion).way(scene.bodies[0].centre)
    chords = np.diff(way, axis=0)
    turned = np.abs(np.diff(np.unwrap(np.arctan2(chords[:, 1], chords[:, 0]))))
    assert len(way) > 400
    # An ellipse of axes 1 : 0.58 turns at its ends 1.7 times as fast as the circle.
    assert turned.max() < 2 * 1.8 * 20 * np.pi / 500


def test_the_arrow_of_a_coordinate_that_is_zero_is_short() -> None:
    scene = puck_on_table()
    arrows = dict(coordinate_drawings(scene, scene.example))
    (path,) = re.findall(r'<polyline class="motion" points="([^"]*)"', arrows[("theta",)])
    corners = np.array([[float(v) for v in pair.split(",")] for pair in path.split()])
    assert np.hypot(*np.diff(corners, axis=0).T).sum() < 24


def test_a_particle_that_is_held_from_afar_is_no_rod() -> None:
    """A string that pulls from the pivot: the bob is a dot with its path."""
    theta, (m, l) = dynamicsymbols("theta"), parameters("m l", units="kg m", typical="1 1")
    ground, pivot = ReferenceFrame("N"), Point("O")
    string = ground.orientnew("A", "Axis", (theta, ground.z))
    bob = pivot.locatenew("P", -l * string.y)
    pull = reaction("S", at=pivot, on="bob", by=None, along=string.y)
    scene = Scene(
        "bob", ground, pivot, coordinates=(theta,), bodies=(Particle("bob", bob, m),),
        reactions=(pull,),
    )  # fmt: skip
    svg = drawing(scene, {"theta": 0.7})
    assert 'class="rod"' not in svg
    assert 'class="mass"' in svg and 'class="trace"' in svg


def cart_with_rod() -> tuple[Scene, Point]:
    """A cart on a rail, pushed by F, and a rod on a hinge whose inertia is no uniform rod's."""
    x, phi, push = dynamicsymbols("x phi F")
    m, l, g = parameters("m l g", units="kg m m/s^2", typical="1 0.8 9.81")
    ground, origin = ReferenceFrame("N"), Point("O")
    rail = slide("rail", None, "cart", at=origin, axis=ground.x, distance=x)
    hinge = pin("hinge", "cart", "rod", at=rail.point, axis=ground.z, angle=phi)
    centre, tip = (
        hinge.point.locatenew(n, -k * l * hinge.frame.y) for n, k in (("G", 0.5), ("E", 1))
    )
    return Scene(
        "cart with rod", ground, origin, plane=ground.z,
        bodies=(
            RigidBody("cart", rail.point, rail.frame, m, 0),
            RigidBody("rod", centre, hinge.frame, m, m * l**2 / 9),
        ),
        joints=(rail, hinge), inputs=(push,), outputs={"tip": position(tip)},
        loads=(gravity(-g * ground.y), force("F", rail.point, push * ground.x, on="cart", by=None)),
        example={"phi": 1.0},
    ), tip  # fmt: skip


def test_a_rod_is_a_bar_from_its_hinge_to_the_point_that_it_carries() -> None:
    scene, tip = cart_with_rod()
    view = View(scene, scene.example)
    corners = outline(view, scene.body("rod"))
    np.testing.assert_allclose(corners[1:], [view.point(scene.bodies[0].centre), view.point(tip)])
    # The cart, which slides without turning, is a block: the one closed shape.
    assert drawing(scene, scene.example).count('class="body"') == 1


def test_a_force_that_is_zero_has_no_arrow_in_a_motion() -> None:
    scene, _ = cart_with_rod()
    times = np.linspace(0, 1, 11)
    still = {"x": 0 * times, "phi": 1 + 0 * times}
    name = '<text class="force-name"'
    # Gravity has its arrow; that of F is there where F is.
    without, pushed = (
        moving_picture(scene, times, {**still, "F": size + 0 * times}).count(name)
        for size in (0.0, 1.0)
    )
    assert (without, drawing(scene, scene.example).count(name)) == (1, 2)
    assert pushed > without
