"""Loads, reactions and constraints that cannot be right are refused."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from linkages import slider_crank
from sympy import Eq, Symbol, cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from mechanics.scene import (
    Force,
    Spring,
    damper,
    force,
    gravity,
    holonomic,
    nonholonomic,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torque,
    torsion_spring,
)

t = dynamicsymbols._t
x, theta, y = dynamicsymbols("x theta y")
k, c, L = parameters("k c L")
Change = Callable[[Any], dict[str, Any]]


def load(make: Callable[[Any], Any]) -> Change:
    """One more load."""
    return lambda p: {"loads": (*p.loads, make(p))}


def support(**changes: Any) -> Change:
    """The rail's reaction N1 with something changed."""
    return lambda p: {
        "reactions": (
            *p.reactions[:2],
            reaction(**{"name": "N1", "at": p.B, "on": "carriage", "by": None, "along": p.N.y}
                     | {key: f(p) if callable(f) else f for key, f in changes.items()}),
        )
    }  # fmt: skip


def more(make: Callable[[Any], Any]) -> Change:
    """One more reaction."""
    return lambda p: {"reactions": (*p.reactions, make(p))}


def held(*constraints: Any) -> Change:
    """Constraints, and a reaction W that stops the carriage."""
    return lambda p: {
        "reactions": (*p.reactions, reaction("W", p.B, "carriage", None, p.N.x)),
        "constraints": constraints,
    }


def tip(p: Any) -> Point:
    return p.B.locatenew("tip", -L * p.A.y)


LOADS = {
    "point not in the scene": (load(lambda p: spring("s", Point("Q"), p.B, k)),
        "load s point not in the scene Q locatenew"),
    "force there": (load(lambda p: force("F", Point("Q"), k * p.N.x, on="rod")),
        "load F point not in the scene Q"),
    "carrier not told": (load(lambda p: force("F", tip(p), k * p.N.x)),
        "load F which body carries point tip on="),
    "force on the ground": (load(lambda p: force("F", p.O, k * p.N.x)), "force F ground nothing"),
    "spring on the ground": (load(lambda p: spring("s", p.O, p.O.locatenew("W", L * p.N.x), k)),
        "load s both ends ground first_on= second_on="),
    "spring from a point to itself": (load(lambda p: spring("s", p.B, p.B, k)),
        "load s both ends point B two points"),
    "spring whose ends are exchanged": (
        load(lambda p: spring("s", p.B, tip(p), k, first_on="rod", second_on="carriage")),
        "load s first_on 'rod' point B centre of carriage: write first_on='carriage'"),
    "spring on another body": (
        load(lambda p: spring("s", p.O, tip(p), k, second_on="carriage")),
        "load s second_on 'carriage' point tip moves against carriage by theta: it is a point of"
        " rod, write second_on='rod'"),
    "damper on the ground": (
        load(lambda p: damper("d", p.O.locatenew("W", L * p.N.y), p.B, c, first_on="carriage")),
        "load d first_on 'carriage' point W moves against carriage by x: point of the ground,"
        " leave first_on out"),
    "spring on no body": (
        load(lambda p: spring("s", p.O, p.B.locatenew("S", theta * p.N.y), k, second_on="rod")),
        "load s second_on 'rod' point S moves against rod by theta: take a point of rod"),
    "spring on a body that is not told": (load(lambda p: spring("s", p.B, tip(p), k)),
        "load s which body carries point tip second_on="),
    "spring on one line": (load(lambda p: spring("s", p.O, p.B, k, length=L)),
        "load s one line along="),
    "unknown body": (load(lambda p: force("F", p.B, k * p.N.x, on="cart")),
        "load F no body 'cart' carriage, rod"),
    "by alone": (load(lambda p: force("F", p.B, k * p.N.x, by="rod")), "load F by= without on="),
    "acting on itself": (load(lambda p: force("F", p.B, k * p.N.x, on="rod", by="rod")),
        "load F 'rod' acts on itself"),
    "torque on none": (load(lambda p: torque("Q", k * p.N.z, on=None)), "load Q on None str"),
    "torque on a particle": (load(lambda p: torque("Q", k * p.N.z, on="carriage")),
        "load Q 'carriage' particle RigidBody"),
    "vector missing": (load(lambda p: force("F", p.B, None)), "load F vector None Vector"),
    "vector a scalar": (load(lambda p: force("F", p.B, k)), "load F vector k Vector"),
    "gravity a scalar": (lambda p: {"loads": (gravity(k),)}, "gravity k vector ground.y"),
    "stiffness as text": (load(lambda p: spring("s", p.O, p.B, "k k")),
        "load s stiffness 'k k' str"),
    "stiffness missing": (load(lambda p: spring("s", p.O, p.B, None)), "load s stiffness None"),
    "coefficient as text": (load(lambda p: damper("d", p.O, p.B, "c")), "load d coefficient 'c'"),
    "length as text": (load(lambda p: spring("s", p.O, p.B, k, length="L")), "load s length 'L'"),
    "torsion angle as text": (load(lambda p: torsion_spring("s", "a", p.N.z, k, "rod")),
        "load s angle 'a'"),
    "along not of length one": (load(lambda p: spring("s", p.O, p.B, k, along=2 * p.N.x)),
        "load s length sqrt(4) unit vector"),
    "along turning": (load(lambda p: spring("s", p.O, p.C, k, along=p.A.x)),
        "load s turns fixed in N"),
    "damper along turning": (load(lambda p: damper("d", p.O, p.C, c, along=p.A.x)),
        "load d turns fixed in N"),
    "gravity turning": (lambda p: {"loads": (gravity(-k * p.A.y),)}, "load gravity turns fixed"),
    "stiffness of a coordinate": (load(lambda p: spring("s", p.O, p.C, k * x**2)),
        "load s depends on coordinates declare it as a force"),
    "length of a coordinate": (load(lambda p: spring("s", p.O, p.C, k, length=x)),
        "load s x(t) depends on coordinates"),
    "torsion spring about the other axis": (
        load(lambda p: torsion_spring("s", theta, -p.N.z, k, "rod")),
        "load s angle theta(t) 'rod' turns ground sign"),
    "torsion spring with another angle": (
        load(lambda p: torsion_spring("s", x, p.N.z, k, "rod")), "load s angle x(t) turns"),
    "torsion axis not of length one": (
        load(lambda p: torsion_spring("s", theta, 2 * p.N.z, k, "rod")), "load s unit vector"),
    "of accelerations": (load(lambda p: force("F", p.B, k * x.diff(t, 2) * p.N.x, on="rod")),
        "load F depends on the acceleration x_ddot"),
    "of an unknown function": (load(lambda p: force("F", p.B, y * p.N.x, on="rod")),
        "load F y(t) inputs="),
    "of a reaction": (load(lambda p: force("F", p.B, Symbol("R", real=True) * p.N.x, on="rod")),
        "load F R a reaction cannot depend"),
    "two fields of gravity": (lambda p: {"loads": (gravity(-k * p.N.y),) * 2},
        "2 times a load 'gravity'"),
    "no tuple": (lambda p: {"loads": p.loads[0]}, "loads tuple loads=("),
    "None": (lambda p: {"loads": None}, "loads None tuple"),
    "a word": (lambda p: {"loads": ("gravity",)}, "loads 'gravity' Spring"),
}  # fmt: skip

REACTIONS = {
    "does work": (more(lambda p: reaction("W", p.B, "carriage", None, p.N.x)),
        "reaction W does work load"),
    "at a wrong point": (lambda p: {"reactions": (
        reaction("T", p.C, "carriage", "rod", p.N.x), *p.reactions[1:])},
        "reaction T does work point"),
    "forgotten": (lambda p: {"reactions": p.reactions[1:]},
        "incomplete 2 of 3 nothing holds body carriage translation along x declare"),
    "none at all": (lambda p: {"reactions": ()}, "incomplete 0 of 3 nothing holds body"),
    "twice": (more(lambda p: reaction("W", p.B, "carriage", None, p.N.y)),
        "reactions W follow from the others remove"),
    "couple on a particle": (more(lambda p: reaction_couple("Q", "carriage", None, p.N.z)),
        "reactions Q follow from the others"),
    "unknown body": (support(on="cart"), "reaction N1 no body 'cart' carriage, rod"),
    "on itself": (support(by="carriage"), "reaction N1 'carriage' acts on itself"),
    "on nothing": (support(on=None), "reaction N1 on None str"),
    "by alone": (support(on=None, by="carriage"), "reaction N1 on None str"),
    "direction missing": (support(along=None), "reaction N1 along None Vector"),
    "direction as text": (support(along="y"), "reaction N1 along 'y' Vector"),
    "direction zero": (support(along=lambda p: 0 * p.N.y), "reaction N1 sqrt(0) unit vector"),
    "direction of length two": (support(along=lambda p: 2 * p.N.y), "reaction N1 unit vector"),
    "direction of length two, turned": (support(along=lambda p: 2 * p.A.y),
        "reaction N1 sqrt(4) unit vector"),
    "direction of nowhere": (support(along=ReferenceFrame("Q").y), "Q not oriented relative to N"),
    "point of nowhere": (support(at=Point("Q")), "reaction N1 point not in the scene Q"),
    "point as text": (support(at="B"), "reaction N1 at 'B' Point None"),
    "named like a coordinate": (support(name="x"), "2 times reaction 'x'"),
    "named like a parameter": (support(name="M"), "symbol M a reaction rename"),
    "without name": (support(name=None), "reaction None name str"),
    "None": (lambda p: {"reactions": None}, "reactions None tuple"),
}  # fmt: skip

CONSTRAINTS = {
    "redundant": (lambda p: {
        "coordinates": (x, theta, y),
        "bodies": (*p.bodies, type(p.bodies[0])("bead", p.O.locatenew("D", y * p.N.x), k)),
        "reactions": (*p.reactions, reaction("W", p.B, "carriage", None, p.N.x),
                      reaction("V", p.B, "carriage", None, (p.N.x + p.N.y) / sqrt(2))),
        "constraints": (holonomic("one", x - L, "W"), holonomic("two", 2 * x - 2 * L, "V")),
        }, "redundant constraints two follow from one remove"),
    "identity": (held(holonomic("c", x - x, "W")), "constraint c restricts no speed identity"),
    "of parameters": (held(holonomic("c", L - k, "W")), "constraint c restricts no speed"),
    "no reaction": (held(holonomic("c", x - L)), "constraint c names no reaction declare"),
    "unknown reaction": (held(holonomic("c", x - L, "V")),
        "constraint c no reaction 'V' N1, R, T, W"),
    "a reaction that does not": (held(holonomic("c", x - L, "N1")),
        "constraint c reaction N1 does not maintain it"),
    "two reactions": (held(holonomic("c", x - L, "W", "T")), "constraint c one reaction W, T"),
    "a reaction used twice": (held(holonomic("c", x - L, "W"), holonomic("d", theta, "W")),
        "reaction W named by the constraints c and d"),
    "nothing left": (held(holonomic("c", x - L, "W"), holonomic("d", theta, "T")),
        "2 constraints on 2 speeds nothing to move"),
    "quadratic in rates": (held(nonholonomic("c", x.diff() ** 2 - L, "W")),
        "constraint c not linear in the speeds"),
    "of accelerations": (held(nonholonomic("c", x.diff(t, 2), "W")), "constraint c accelerations"),
    "holonomic with speeds": (held(holonomic("c", x.diff(), "W")),
        "constraint c nonholonomic(...)"),
    "of an unknown function": (held(holonomic("c", x - y, "W")), "constraint c y(t) coordinates="),
    "an expression alone": (held(x - L), "constraints Constraint"),
}  # fmt: skip

TABLE = {
    f"{kind}: {title}": row
    for kind, rows in (("load", LOADS), ("reaction", REACTIONS), ("constraint", CONSTRAINTS))
    for title, row in rows.items()
}


@pytest.mark.sample(2)
@pytest.mark.parametrize(("change", "words"), TABLE.values(), ids=TABLE.keys())
def test_what_cannot_be_right_is_refused(make: Any, change: Any, words: str) -> None:
    with pytest.raises(SceneError) as caught:
        make(change)
    message = str(caught.value)
    assert "\n" not in message
    for word in words.split():
        assert word in message, message


@pytest.mark.parametrize("expression", [None, "x x", Eq(x, L)], ids=str)
def test_a_constraint_is_an_expression(expression: Any) -> None:
    with pytest.raises(
        SceneError, match=r"constraint c is .*: give a number or a SymPy expression"
    ):
        holonomic("c", expression, "W")


def test_decimals_in_loads_are_fractions(make: Any) -> None:
    scene = make(lambda p: {"loads": (spring("s", p.O, p.B, 0.1, along=p.N.x, length=0.3),)})
    (load_,) = scene.loads
    assert isinstance(load_, Spring)
    assert [str(load_.stiffness), str(load_.length)] == ["1/10", "3/10"]
    scene = make(load(lambda p: force("F", p.B, 0.1 * p.N.x, on="rod")))
    assert str(scene.vector(scene.loads[-1].vector)[0]) == "1/10"


def test_a_gradient_may_be_the_direction_of_a_constraint_reaction(make: Any) -> None:
    scene = make(lambda p: {
        "reactions": (*p.reactions, reaction("W", p.B, "carriage", None, x / L * p.N.x)),
        "constraints": (holonomic("c", x**2 - L**2, "W"),),
    })  # fmt: skip
    assert scene.degrees_of_freedom == 1


def test_a_point_may_be_placed_by_other_frames_than_those_of_its_body(make: Any) -> None:
    """The frame that turns with the rod is another object; the point of the rod is the same."""

    def attached(p: Any) -> dict[str, Any]:
        same = p.N.orientnew("S", "Axis", (theta, p.N.z))
        way = p.O.locatenew("away", theta * p.N.z).locatenew("back", x * p.N.x - theta * p.N.z)
        end = way.locatenew("end", -L * same.y)
        return {"loads": (spring("s", p.O, end, k, second_on="rod"),)}

    assert make(attached).loads[0].second_on == "rod"


def test_loads_of_time_and_inputs_are_right(make: Any) -> None:
    scene = make(lambda p: {
        "inputs": (y,),
        "loads": (gravity(-k * cos(t) * p.N.y), force("F", p.B, (y + sin(t)) * p.N.x, on="rod"),
                  spring("s", p.O, p.C, k, length=L + y)),
    })  # fmt: skip
    assert isinstance(scene.loads[1], Force)
    assert [f.name for f in scene.input_symbols] == ["y"]


@pytest.mark.parametrize("forgotten", ["W", "Py"])
def test_a_reaction_that_is_missing_in_a_loop_is_told(forgotten: str) -> None:
    scene = slider_crank("slider")
    others = tuple(one for one in scene.reactions if one.name != forgotten)
    with pytest.raises(SceneError, match=r"incomplete \(6 of 7\): nothing holds body"):
        check_scene(replace(scene, reactions=others))
