"""Scenes that cannot be right are refused: bodies, coordinates, speeds, names, symbols."""

from collections.abc import Callable
from typing import Any

import pytest
from sympy import Function, I, Matrix, Rational, Symbol, cos, eye, oo, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.errors import SceneError
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    spring,
)

t = dynamicsymbols._t
x, theta, y, u, v = dynamicsymbols("x theta y u v")
m, M, L, k, g = parameters("m M L k g")


def body(make: Callable[[Any], Any]) -> Callable[[Any], dict[str, Any]]:
    return lambda p: {"bodies": make(p)}


def carriage(**changes: Any) -> Callable[[Any], dict[str, Any]]:
    """The carriage with another mass or centre."""
    return lambda p: {
        "bodies": (
            Particle(**{"name": "carriage", "centre": p.B, "mass": m} | changes),
            p.bodies[1],
        )
    }


def rod(make: Callable[[Any], dict[str, Any]]) -> Callable[[Any], dict[str, Any]]:
    """The rod with another mass, centre, frame or inertia."""

    def change(p: Any) -> dict[str, Any]:
        given = {"name": "rod", "centre": p.C, "frame": p.A, "mass": M, "inertia": M * L**2 / 12}
        return {"bodies": (p.bodies[0], RigidBody(**given | make(p)))}

    return change


def fields(**changes: Any) -> Callable[[Any], dict[str, Any]]:
    return lambda p: changes


def stretched(p: Any) -> ReferenceFrame:
    frame = ReferenceFrame("S")
    frame.orient_explicit(p.N, Matrix([[2 * cos(theta), 0, 0], [0, 1, 0], [0, 0, 1]]))
    return frame


def mirrored(p: Any) -> ReferenceFrame:
    frame = ReferenceFrame("S")
    c, s = cos(theta), sin(theta)
    frame.orient_explicit(p.N, Matrix([[-c, s, 0], [s, c, 0], [0, 0, 1]]))
    return frame


BODIES = {
    "body placed by nothing": (rod(lambda p: {"centre": Point("Q")}),
        "body rod point Q not placed relative to O locatenew"),
    "frame oriented by nothing": (rod(lambda p: {"frame": ReferenceFrame("Q")}),
        "body rod frame Q not oriented relative to N orientnew"),
    "no coordinate moves it": (body(lambda p: (*p.bodies, Particle("stone", p.O, m))),
        "body stone no coordinate moves it"),
    "missing inertia": (rod(lambda p: {"inertia": None}),
        "body rod inertia about the mass centre is missing Dyadic Particle"),
    "missing mass": (carriage(mass=None), "body carriage mass is missing"),
    "negative mass": (carriage(mass=-m), "body carriage mass -m is negative"),
    "negative number": (carriage(mass=-2), "body carriage mass -2 is negative"),
    "mass as text": (carriage(mass="heavy"), "body carriage mass 'heavy' str give a number"),
    "mass as text of a symbol": (carriage(mass="m"), "body carriage mass 'm' str"),
    "mass nan": (carriage(mass=float("nan")), "body carriage mass nan finite"),
    "mass infinite": (carriage(mass=oo), "body carriage mass oo finite"),
    "mass imaginary": (carriage(mass=I * m), "body carriage mass I*m real"),
    "mass of time": (carriage(mass=m * (1 + t)), "body carriage mass changes constant"),
    "mass a function": (carriage(mass=dynamicsymbols("mu")), "body carriage mass mu(t) constant"),
    "mass of a coordinate": (carriage(mass=m * (1 + x**2)), "body carriage mass constant"),
    "all masses zero": (
        lambda p: {"bodies": (Particle("carriage", p.B, 0), RigidBody("rod", p.C, p.A, 0, 0))},
        "pendulum mass matrix is singular x_dot zero"),
    "inertia negative": (rod(lambda p: {"inertia": -M * L**2}), "body rod inertia negative"),
    "inertia as text": (rod(lambda p: {"inertia": "I C"}), "body rod inertia 'I C' str"),
    "inertia a matrix": (rod(lambda p: {"inertia": eye(3)}), "body rod inertia Matrix"),
    "inertia as SymPy's pair": (rod(lambda p: {"inertia": (inertia(p.A, m, m, m), p.C)}),
        "body rod inertia tuple"),
    "inertia of a coordinate": (rod(lambda p: {"inertia": M * x**2}),
        "body rod inertia changes body's frame A constant"),
    "dyadic fixed in the ground": (rod(lambda p: {"inertia": inertia(p.N, 0, m, m)}),
        "body rod inertia changes give it in A"),
    "dyadic not symmetric": (rod(lambda p: {"inertia": m * (p.A.x | p.A.y)}),
        "body rod inertia not symmetric"),
    "dyadic negative": (rod(lambda p: {"inertia": inertia(p.A, -m, m, m)}),
        "body rod inertia negative"),
    "scalar inertia in space": (lambda p: {"loads": (gravity(-g * p.N.z),)},
        "body rod scalar leaves its plane Dyadic"),
    "centre as text": (carriage(centre="B"), "body carriage centre 'B' str Point"),
    "frame missing": (rod(lambda p: {"frame": None}), "body rod frame None ReferenceFrame"),
    "stretched frame": (rod(lambda p: {"frame": stretched(p)}), "frame S no rotation orientnew"),
    "load along a stretched frame": (
        lambda p: {"loads": (force("F", p.B, g * stretched(p).x, on="carriage"),)},
        "frame S no rotation orientnew"),
    "mirrored frame": (rod(lambda p: {"frame": mirrored(p)}), "frame S no rotation det"),
    "body twice": (body(lambda p: (*p.bodies, p.bodies[0])), "2 times a body 'carriage' differ"),
    "empty name": (carriage(name=""), "body empty name"),
    "name missing": (carriage(name=None), "body name None str"),
    "no bodies": (fields(bodies=()), "pendulum no bodies"),
    "one body, no tuple": (body(lambda p: p.bodies[0]), "pendulum bodies give a tuple bodies=("),
    "a word as body": (fields(bodies=("rod",)), "pendulum bodies 'rod' Particle RigidBody"),
}  # fmt: skip

COORDINATES = {
    "none": (fields(coordinates=()), "pendulum no coordinates"),
    "None": (fields(coordinates=None), "pendulum coordinates None tuple"),
    "no tuple": (fields(coordinates=x), "pendulum coordinates x(t) tuple coordinates=("),
    "a plain symbol": (fields(coordinates=(Symbol("x"), theta)), "x dynamicsymbols"),
    "text": (fields(coordinates=("x", theta)), "x dynamicsymbols"),
    "a rate": (fields(coordinates=(x.diff(), theta)), "Derivative dynamicsymbols"),
    "a function of something else": (fields(coordinates=(x, theta, Function("z")(Symbol("s")))),
        "z(s) dynamicsymbols"),
    "twice": (fields(coordinates=(x, x, theta)), "2 times a coordinate 'x' differ"),
    "unused": (fields(coordinates=(x, theta, y)), "coordinate y no body uses it remove it"),
    "forgotten": (fields(coordinates=(x,)), "theta(t) neither a coordinate coordinates="),
    "called t": (fields(inputs=(dynamicsymbols("t"),)), "'t' name of time rename"),
    "named like a rate": (fields(coordinates=(x, theta, dynamicsymbols("x_dot"))),
        "'x_dot' a derivative of x rename"),
    "input named like a coordinate": (fields(inputs=(x,)), "2 times 'x'"),
    "input no function": (fields(inputs=(Symbol("f"),)), "f dynamicsymbols"),
}  # fmt: skip

SPEEDS = {
    "too few": (fields(speeds=((u, x.diff()),)), "1 speeds for 2 coordinates as many"),
    "not linear": (fields(speeds=((u, x.diff() ** 2), (v, theta.diff()))), "speed u not linear"),
    "of accelerations": (fields(speeds=((u, x.diff(t, 2)), (v, theta.diff()))),
        "speed u not linear"),
    "twice the same": (fields(speeds=((u, x.diff()), (v, 2 * x.diff()))), "determine v follows"),
    "without rates": (fields(speeds=((u, x.diff()), (v, theta))), "determine v follows"),
    "no pairs": (fields(speeds=(u, v)), "speeds u(t) pair"),
    "a dict": (fields(speeds={u: x.diff(), v: theta.diff()}), "speeds dict tuple"),
    "named like a coordinate": (fields(speeds=((x, x.diff()), (v, theta.diff()))), "2 times 'x'"),
    "definition as text": (fields(speeds=((u, "x'"), (v, theta.diff()))), "speed u definition str"),
}  # fmt: skip


def stiffness(symbol: Symbol) -> Callable[[Any], dict[str, Any]]:
    return lambda p: {"loads": (spring("k", p.O, p.B, symbol, along=p.N.x),)}


SYMBOLS = {
    "like a coordinate": (stiffness(Symbol("x", real=True)), "load k x a coordinate rename"),
    "like a rate": (stiffness(Symbol("x_dot", positive=True)), "load k x_dot a derivative of x"),
    "like a reaction": (stiffness(Symbol("T", positive=True)), "load k T a reaction"),
    "like time": (stiffness(Symbol("t", positive=True)), "load k t time"),
    "two of one name": (lambda p: {"loads": (*p.loads, force("F", p.B, Symbol("k") * p.N.x))},
        "load F two different parameters named k"),
    "reaction like a rate": (
        lambda p: {"reactions": (*p.reactions[:2],
                                 reaction("x_dot", p.B, "carriage", None, p.N.y))},
        "'x_dot' derivative of x rename"),
    "example of nothing": (fields(example={"thta": 1.0}), "example 'thta' names are theta"),
    "example no number": (fields(example={"x": "one"}), "example x 'one' number"),
    "example None": (fields(example=None), "example None Mapping"),
    "definitions None": (fields(definitions=None), "definitions None Mapping"),
    "definition circular": (fields(definitions={M: m, m: M}), "definition M circular"),
    "definition by text": (fields(definitions={"M": m}), "definition 'M' parameter"),
    "definition of a coordinate": (fields(definitions={M: m * x}), "definition M coordinates"),
    "frame None": (fields(frame=None), "frame None ReferenceFrame"),
    "origin None": (fields(origin=None), "origin None Point"),
    "name None": (fields(name=None), "name None str"),
}  # fmt: skip

TABLE = {
    f"{kind}: {title}": row
    for kind, rows in (("body", BODIES), ("coordinates", COORDINATES), ("speeds", SPEEDS),
                       ("symbol", SYMBOLS))
    for title, row in rows.items()
}  # fmt: skip


@pytest.mark.parametrize(("change", "words"), TABLE.values(), ids=TABLE.keys())
def test_a_scene_that_cannot_be_right_is_refused(make: Any, change: Any, words: str) -> None:
    with pytest.raises(SceneError) as caught:
        make(change)
    message = str(caught.value)
    assert "\n" not in message
    for word in words.split():
        assert word in message, message


def test_the_scene_that_is_changed_is_right(make: Callable[..., Scene]) -> None:
    assert make().degrees_of_freedom == 2


def test_lists_and_a_massless_carriage_are_right(make: Any) -> None:
    scene = make(lambda p: {"coordinates": [x, theta], "reactions": list(p.reactions)})
    assert [q.name for q in scene.q] == ["x", "theta"]
    assert make(carriage(mass=0)).body("carriage").mass == 0


def test_a_decimal_is_the_fraction_that_it_prints(make: Any) -> None:
    scene = make(rod(lambda p: {"mass": 0.3, "inertia": 0.1 * L**2}))
    assert scene.body("rod").mass == Rational(3, 10)
    assert scene.body("rod").inertia == L**2 / 10
