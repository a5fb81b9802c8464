"""Ropes over massless pulleys: accelerations and tensions of textbooks, by all routes."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

import mechanics
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.errors import SceneError
from mechanics.routes.derivation import ROUTES
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    free,
    gravity,
    parameters,
    pin,
    reaction,
    rope,
)

x, y, z, w, a, b = dynamicsymbols("x y z w a b")
m1, m2, m3, L, L2, g, r, h, J = parameters(
    "m1 m2 m3 L L2 g r h J", typical="1 2 3 4 5 981/100 1/10 1 1/2"
)
N, O = ReferenceFrame("N"), Point("O")
G = 9.81


def hung(name: str, depth: Any, mass: Any, aside: Any = 0) -> Particle:
    return Particle(name, O.locatenew(name, aside * N.x - depth * N.y), mass)


def made(name: str, bodies: tuple[Any, ...], *joints: Any, **fields: Any) -> Scene:
    return Scene(name, N, O, bodies=bodies, joints=joints, loads=(gravity(-g * N.y),), **fields)


def atwood() -> Scene:
    """A fixed pulley of radius r."""
    one, two = hung("one", x, m1, -r), hung("two", y, m2, r)
    rim = O.locatenew("P", -r * N.x), O.locatenew("Q", r * N.x)
    line = rope("T", ("one", one.centre), (None, rim[0]), (None, rim[1]), ("two", two.centre),
                length=L, along=(N.y, -N.y))  # fmt: skip
    return made("atwood", (one, two), line, coordinates=(x, y), example={"x": 1, "y": 3})


def tackle() -> Scene:
    """From the ceiling around a pulley on the load, over a fixed one to a mass."""
    one, two = hung("one", x, m1, 2 * r), hung("two", y, m2)
    rim = [two.centre.locatenew(f"E{k}", k * r * N.x) for k in (-1, 1)]
    line = rope(
        "T", (None, O.locatenew("C", -r * N.x)), ("two", rim[0]), ("two", rim[1]),
        (None, O.locatenew("P", r * N.x)), (None, O.locatenew("Q", 2 * r * N.x)),
        ("one", one.centre), length=L, along=(-N.y, N.y, -N.y),
    )  # fmt: skip
    return made("tackle", (one, two), line, coordinates=(x, y), example={"x": 2, "y": 1})


def double_atwood() -> Scene:
    """A massless pulley hangs on the first rope and carries the second."""
    one, two, three = hung("one", x, m1), hung("two", y, m2), hung("three", z, m3)
    pulley = hung("pulley", w, 0)
    first = rope("T1", ("one", one.centre), (None, O), ("pulley", pulley.centre), length=L,
                 along=(N.y, -N.y))  # fmt: skip
    second = rope("T2", ("two", two.centre), ("pulley", pulley.centre), ("three", three.centre),
                  length=L2, along=(N.y, -N.y))  # fmt: skip
    return made("double atwood", (one, two, three, pulley), first, second,
                coordinates=(x, y, z, w), example={"x": 2, "w": 2, "y": 4, "z": 5})  # fmt: skip


def swinging_atwood() -> Scene:
    """The second mass swings: a from the vertical, b from the pulley."""
    F = N.orientnew("F", "Axis", (a, N.z))
    one, two = hung("one", x, m1), Particle("two", O.locatenew("two", -b * F.y), m2)
    guide = reaction("guide", one.centre, "one", None, N.x)
    line = rope("T", ("one", one.centre), (None, O), ("two", two.centre), length=L,
                along=(N.y, -F.y))  # fmt: skip
    return made("swinging atwood", (one, two), line, coordinates=(x, a, b), reactions=(guide,),
                example={"x": 2, "b": 2})  # fmt: skip


def crane() -> Scene:
    """From a wall over the tip of a beam, which it lifts, to a mass that swings in space."""
    hinge = pin("H", None, "beam", at=O, axis=N.z, angle=a)
    F = hinge.frame
    beam = RigidBody("beam", O.locatenew("C", h * F.x), F, m1, inertia(F, J, J, J))
    tip = O.locatenew("tip", 2 * h * F.x + r * F.y)
    load = free("load", "two", at=O, frame=N, coordinates=(x, y, z))
    line = rope("T", (None, O.locatenew("W", -h * N.x + 3 * h * N.y)), ("beam", tip),
                ("two", load.point), length=L + L2)  # fmt: skip
    return made("crane", (beam, Particle("two", load.point, m2)), hinge, load, line,
                example={"x": 2, "y": -1})  # fmt: skip


SCENES: Mapping[str, Callable[[], Scene]] = {
    "atwood": atwood, "tackle": tackle, "double atwood": double_atwood,
    "swinging atwood": swinging_atwood, "crane": crane,
}  # fmt: skip


@pytest.mark.parametrize("kind", [*list(SCENES)[:4], pytest.param("crane",
                                  marks=pytest.mark.campaign)])  # fmt: skip
def test_all_routes_agree_and_all_laws_hold(kind: str) -> None:
    programs = derive_rows(check_scene(SCENES[kind]()), [route.name for route in ROUTES])
    pairs = compare_pairs(programs.routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    assert all(finding.shown for finding in check_laws(programs))


def motion(
    scene: Scene, q: Mapping[str, float], u: Mapping[str, float]
) -> tuple[dict[str, float], dict[str, float]]:
    """Accelerations and tensions at a state, m1 = 1, m2 = 2, m3 = 3."""
    model = mechanics.compile(mechanics.derive(scene, "free_body"), compiler=None)
    known = model.quantities
    given = [[values.get(e.name, 0.0) for e in group] for values, group in
             ((q, known.q), (u, known.u))]  # fmt: skip
    ud, tension = model.forward_dynamics(*given), model.multipliers(*given)
    return tuple(
        dict(zip((e.name for e in group), found, strict=True))
        for group, found in ((known.ud, ud), (known.multipliers, tension))
    )


def test_atwoods_machine() -> None:
    """x'' = g (m1 - m2)/(m1 + m2),  T = 2 m1 m2 g/(m1 + m2)."""
    ud, tension = motion(atwood(), {"x": 1, "y": 3}, {})
    assert ud["x_ddot"] == pytest.approx(-G / 3, rel=1e-14)
    assert tension["T"] == pytest.approx(4 * G / 3, rel=1e-14)


def test_a_tackle_halves_the_load() -> None:
    """x'' = 2 g (2 m1 - m2)/(4 m1 + m2) = -2 y'',  T = 3 m1 m2 g/(4 m1 + m2)."""
    ud, tension = motion(tackle(), {"x": 2, "y": 1}, {})
    assert ud["x_ddot"] == pytest.approx(0, abs=1e-14)
    assert ud["y_ddot"] == pytest.approx(0, abs=1e-14)
    assert tension["T"] == pytest.approx(G, rel=1e-14)


def test_atwoods_machine_on_a_massless_pulley() -> None:
    """Morin, Introduction to Classical Mechanics, section 3.2:

    x'' = g (m1 (m2 + m3) - 4 m2 m3)/(m1 (m2 + m3) + 4 m2 m3),  T1 = 2 T2.
    """
    ud, tension = motion(double_atwood(), {"x": 2, "w": 2, "y": 4, "z": 5}, {})
    assert ud["x_ddot"] == pytest.approx(G * (5 - 24) / (5 + 24), rel=1e-13)
    assert tension["T1"] == pytest.approx(2 * tension["T2"], rel=1e-13)
    assert tension["T1"] == pytest.approx(G - ud["x_ddot"], rel=1e-13)


def test_a_swinging_atwood_machine_has_the_published_motion() -> None:
    """Tufillaro, Abbott and Griffiths, Am. J. Phys. 52, 1984: with M = m1, m = m2

    (M + m) b'' = m b a'^2 + m g cos(a) - M g,   b a'' = -2 b' a' - g sin(a).
    """
    q, u = {"x": 2.5, "a": 0.6, "b": 1.5}, {"x_dot": -0.4, "a_dot": 1.1, "b_dot": 0.4}
    ud, _ = motion(swinging_atwood(), q, u)
    assert ud["b_ddot"] == pytest.approx((2 * 1.5 * 1.21 + 2 * G * np.cos(0.6) - G) / 3, rel=1e-13)
    assert ud["a_ddot"] == pytest.approx((-2 * 0.4 * 1.1 - G * np.sin(0.6)) / 1.5, rel=1e-13)


@pytest.mark.campaign
def test_a_report_shows_ropes() -> None:
    found = mechanics.crosscheck(tackle())
    assert found.ok
    assert "<svg" in mechanics.to_html([found])


def refused(*ends: Any, **fields: Any) -> Any:
    one, two = hung("one", x, m1), hung("two", y, m2)
    given = ends or (("one", one.centre), (None, O), ("two", two.centre))
    line = rope("T", *given, **{"length": L, "along": (N.y, -N.y), **fields})
    return made("atwood", (one, two), line, coordinates=(x, y))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: refused(along=None), "rope T: one and O stay on one line: give the direction"),
        (lambda: refused(along=(N.y,)), "rope T: 1 directions for 2 straight parts"),
        (lambda: refused(along=(2 * N.y, -N.y)), "reaction T: the direction 2*N.y has the length"),
        (lambda: refused((None, O), (None, Point("P"))), "rope T: it ties no two bodies"),
        (lambda: refused("one", O), "'one', a str is no end: give a body and a point of it"),
        (lambda: refused((None, O), ("one", Point("Q")), along=None), "rope T: nothing places Q"),
        (lambda: refused((None, O), ("hand", O.locatenew("P", x * N.x - L * N.y)), along=None),
         "there is no body 'hand'"),
        (lambda: refused((None, O), ("one", O.locatenew("P", y * N.x - L * N.y)), along=None),
         "rope T: its point P moves against one by x, y"),
        (lambda: refused(length="L"), "rope T: the length is 'L'"),
    ],
)  # fmt: skip
def test_what_is_no_rope_is_refused(make: Callable[[], Any], words: str) -> None:
    with pytest.raises(SceneError) as caught:
        make()
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)
