"""Pictures of coordinates are true: an arc begins at q = 0 and ends where the body is."""

import re

import numpy as np
import pytest
from particles import pendulum
from shared_scenes import MANY_COORDINATES
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.report.coordinate_drawings import SIZE, coordinate_drawings
from mechanics.report.coordinates import (
    coordinate_picture,
    coordinate_words,
    moved,
    set_to,
    trace,
    turn_of,
)
from mechanics.report.drawing import drawing, paper_for
from mechanics.report.projection import View, closed
from mechanics.report.sections import symbol_rows
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    gravity,
    parameters,
    quaternion,
)
from systems import EVERY, acrobot, cartpole, elastic_pendulum, slider_crank, spinning_top

FEW = [system for system in EVERY if system.name not in MANY_COORDINATES]


def strokes(text: str, style: str) -> list[np.ndarray]:
    """Corners of the lines of a style, in pixels."""
    return [
        np.array([list(map(float, pair.split(","))) for pair in points.split()])
        for points in re.findall(rf'<polyline class="{style}" points="([^"]*)"', text)
    ]


def direction(line: np.ndarray) -> np.ndarray:
    """From the first corner to the last, with length 1."""
    way = line[-1] - line[0]
    return way / np.hypot(*way)


@pytest.mark.sample(4)
@pytest.mark.parametrize("system", FEW, ids=lambda system: system.name)
def test_an_angle_is_drawn_from_zero_to_the_body(system) -> None:
    scene = system.scene()
    state = {q.name: 0.4 + 0.3 * k for k, q in enumerate(scene.q)}
    view = View(scene, state)
    for q in scene.q:
        body = moved(view, q)
        turn = None if body is None else turn_of(view, body, q)
        if body is None or turn is None or turn.reach < 1e-9:
            continue
        if np.allclose(turn.centre, view.place(body.centre), atol=1e-9):
            continue  # about its own centre, where its place says nothing
        # What is said of the angle gives the place of the body at every value of it.
        for value in (0.0, state[q.name], 2.0, -7.0):
            place = set_to(view, q, value).place(body.centre)
            assert np.allclose(turn.at(value, turn.reach), place, atol=1e-9)


@pytest.mark.parametrize("angle", [2.5, -1.0, 9.0])
def test_the_arc_ends_on_the_body_and_begins_on_the_dashed_line(angle: float) -> None:
    view = View(pendulum(typical="1 0.5 9.81"), {"theta": angle})
    paper = paper_for([view])
    text = coordinate_picture(view, paper, view.scene.q[0])
    (arc,), (zero,), (arm,) = (strokes(text, style) for style in ("motion", "zero", "arm"))
    assert np.allclose(direction(zero), (0, 1))  # hanging straight down
    bob = paper.place(view.point(view.scene.bodies[0].centre))
    assert np.allclose(arm[-1], bob, atol=0.1)
    centre = zero[0]
    assert direction(np.array([centre, arc[0]])) == pytest.approx((0, 1), abs=1e-2)
    assert direction(np.array([centre, arc[-1]])) == pytest.approx(direction(arm), abs=1e-2)
    # It goes the whole way, and does not stop at full turns.
    ways = np.unwrap([np.arctan2(-(y - centre[1]), x - centre[0]) for x, y in arc])
    assert ways[-1] - ways[0] == pytest.approx(angle, abs=0.05)


def test_a_point_mass_is_a_dot_on_its_circle_and_no_block() -> None:
    view = View(pendulum(typical="1 0.5 9.81"), {"theta": 1.0})
    circle = trace(view, view.scene.bodies[0])
    assert circle is not None
    assert np.allclose(np.hypot(*circle.T), 0.5)


@pytest.mark.parametrize(
    ("scene", "name", "words"),
    [
        (elastic_pendulum, "x", "displacement of the carriage along x"),
        (
            elastic_pendulum,
            "theta",
            "angle of the pendulum from hanging straight down, counterclockwise",
        ),
        # Its pole stands at zero, and leans to the right for a positive angle.
        (cartpole, "theta", "angle of the pole from the upright, clockwise"),
        # The second angle of the acrobot is counted from the first link.
        (acrobot, "theta2", "angle of link2 relative to what carries it, counterclockwise"),
        (spinning_top, "phi", "angle of the top from the direction of −y, about z"),
    ],
)
def test_a_coordinate_is_explained_from_the_frames(scene, name: str, words: str) -> None:
    declared = scene.scene()
    (coordinate,) = (q for q in declared.q if q.name == name)
    assert coordinate_words(View(declared, declared.example), coordinate) == words


@pytest.mark.parametrize(("sign", "way"), [(1, "up a slope"), (-1, "down a slope")])
def test_a_displacement_on_a_slope_says_from_where_and_which_way(sign: int, way: str) -> None:
    x, (m, alpha, g) = (
        dynamicsymbols("x"),
        parameters("m alpha g", units="kg rad m/s^2", typical="1 0.4 9.81"),
    )
    ground, origin = ReferenceFrame("N"), Point("O")
    slope = ground.orientnew("A", "Axis", (alpha, ground.z))
    centre = origin.locatenew("P", sign * x * slope.x)
    block, down = Particle("block", centre, m), gravity(-g * ground.y)
    scene = Scene("slope", ground, origin, coordinates=(x,), bodies=(block,), loads=(down,))
    words = f"displacement of the block from where it is at x = 0, {way}"
    assert coordinate_words(View(scene, {"x": 0.5}), scene.q[0]) == words


def test_an_angle_of_a_point_mass_is_in_rad() -> None:
    (row,) = (
        row
        for row in symbol_rows(pendulum(typical="1 0.5 9.81"), {"theta": 2.0})
        if row.name == "theta"
    )
    assert row.value == "2\u00a0rad"


def _turned_body(*parts: float) -> Scene:
    ground, origin = ReferenceFrame("N"), Point("O")
    spin = quaternion("e0 e1 e2 e3", "wx wy wz")
    frame = spin.orient("A", ground)
    (m, i) = parameters("m i", "kg kg*m^2", "1 0.1")
    body = RigidBody("plate", origin, frame, m, inertia(frame, i, i, 2 * i))
    return Scene("turned", ground, origin, (), (body,), rotations=(spin,))


def test_a_quaternion_is_the_arc_of_its_turn_about_its_axis() -> None:
    scene = _turned_body()
    half = 0.6
    state = {"e0": np.cos(half), "e3": np.sin(half)}
    ((names, svg),) = coordinate_drawings(scene, state)
    assert names == ("e0", "e1", "e2", "e3")
    view = View(scene, state)
    (arc,) = re.findall(r'<polyline class="motion" points="([^"]*)"/>(?=<polygon)', svg)[-1:]
    corners = np.array([list(map(float, pair.split(","))) for pair in arc.split()])
    middle = corners[0] * 0 + np.array(SIZE) / 2
    flat = np.linalg.solve(view.projection[:, :2], ((corners - middle) * [1, -1]).T)
    turned = np.unwrap(np.arctan2(flat[1], flat[0]))
    assert np.isclose(turned[-1] - turned[0], 2 * half, atol=0.02)
    words = [coordinate_words(view, q) for q in scene.q]
    assert words[0].endswith("turns the plate: cosine of half the angle")
    assert words[3].endswith("z of the axis times its sine")


@pytest.mark.campaign
def test_gravity_points_down_on_paper_in_every_scene() -> None:
    for system in EVERY:
        made = system.scene()
        view = View(getattr(made, "scene", made), {})
        if view.down is not None:
            assert view.down[1] < 0, system.name
        # Seen from in front: no mirror.
        across = np.cross(*view.projection)
        assert np.allclose(view.projection @ across, 0, atol=1e-9)
        assert np.linalg.det(np.vstack([view.projection, across])) > 0


def test_a_drawing_closes_the_loops_and_keeps_what_is_named() -> None:
    scene = slider_crank.scene()
    state = closed(scene, {"theta": 0.5})
    view = View(scene, state)
    assert state["theta"] == 0.5
    assert all(abs(view.number(c.expression)) < 1e-9 for c in scene.constraints)
    assert state["x"] > 0


def test_a_point_of_several_coordinates_shows_its_way() -> None:
    ground, origin, x, y = ReferenceFrame("N"), Point("O"), *dynamicsymbols("x y")
    (m,) = parameters("m", "kg", "1")
    place = origin.locatenew("P", x * ground.x + y * ground.y)
    scene = Scene("stone", ground, origin, (x, y), (Particle("stone", place, m),))
    times = np.linspace(0, 1, 50)
    motion = {"x": times, "y": times - times**2}
    assert 'class="trace"' not in drawing(scene, {})
    assert 'class="trace"' in drawing(scene, {}, motion)
    way = trace(View(scene, {}, motion=motion), scene.bodies[0])
    assert np.allclose(way, np.column_stack([times, times - times**2]))
