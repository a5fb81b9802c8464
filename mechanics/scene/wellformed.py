"""Whether a scene is made of the right things: types of fields, names, symbols.

field of a part       has the type that its dataclass declares
name of a parameter   differs from x, x_dot, x_ddot, speeds, inputs, reactions and t
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import fields
from types import GenericAlias, UnionType
from typing import Any, get_args

from sympy import Symbol
from sympy.physics.vector import Point, ReferenceFrame, Vector, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene.bodies import Particle, RigidBody
from mechanics.scene.conditions import Condition
from mechanics.scene.declaration import DROP, REFUSE, Declaration
from mechanics.scene.declared import kind_of
from mechanics.scene.joints.argument_types import check_given
from mechanics.scene.joints.joint import Joint
from mechanics.scene.joints.rope import Rope
from mechanics.scene.loads import Load
from mechanics.scene.outputs import Output
from mechanics.scene.reactions import Constraint, Reaction
from mechanics.scene.rotations import Rotation
from mechanics.scene.symbols import DOTS, name_of

PARTS: tuple[tuple[str, str, tuple[Any, ...]], ...] = (
    ("bodies", "body", (Particle, RigidBody)),
    ("loads", "load", get_args(Load)),
    ("reactions", "reaction", (Reaction,)),
    ("constraints", "constraint", (Constraint,)),
    ("conditions", "condition", (Condition,)),
    ("rotations", "rotation", (Rotation,)),
    ("joints", "joint", (Joint, Rope)),
)


def check_types(scene: Declaration) -> None:
    """Every field of the scene and of its parts is what it has to be.

    Raises
    ------
    SceneError
        Names the field, what was found and what is expected.
    """
    for title, expected in (("frame", ReferenceFrame), ("origin", Point), ("name", str)):
        _expect(f"scene {scene.name}: {title}", getattr(scene, title), expected)
    for title in ("coordinates", "inputs", "speeds", *(title for title, _, _ in PARTS)):
        if not isinstance(getattr(scene, title), tuple | list):
            raise SceneError(
                f"{scene.name}: {title} is {kind_of(getattr(scene, title))}: give a tuple, as in"
                f" {title}=(first, second) or {title}=(only,)"
            )
    for title, kind, classes in PARTS:
        for part in getattr(scene, title):
            if not isinstance(part, classes):
                raise SceneError(
                    f"{scene.name}: {title} holds {kind_of(part)}: it has to be a"
                    f" {' or '.join(c.__name__ for c in classes)}"
                )
            for field in fields(part):
                what = f"{kind} {part.name}: {field.name}"
                _expect(what, getattr(part, field.name), field.type)
            if not part.name:
                raise SceneError(f"{scene.name}: a {kind} has an empty name: name it")
            if isinstance(part, Joint | Rope):
                check_given(part)
    for pair in scene.speeds:
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise SceneError(
                f"{scene.name}: speeds holds {kind_of(pair)}: it has to be a pair"
                " (dynamic symbol, definition)"
            )
    _expect(f"{scene.name}: plane", scene.plane, Vector | None)
    if scene.redundant not in (REFUSE, DROP):
        raise SceneError(
            f"{scene.name}: redundant is {scene.redundant!r}: it has to be {REFUSE!r} or {DROP!r}"
        )
    for title in ("definitions", "example", "outputs"):
        _expect(f"{scene.name}: {title}", getattr(scene, title), Mapping)
    for name, output in scene.outputs.items():
        _expect(f"{scene.name}: the name {name!r} of an output", name, str)
        _expect(f"output {name}", output, Output)
        for field in fields(output):
            _expect(f"output {name}: {field.name}", getattr(output, field.name), field.type)


def _expect(what: str, value: Any, expected: Any) -> None:
    choices = get_args(expected) if isinstance(expected, UnionType) else (expected,)
    # tuple[str, ...] is checked as a tuple; who uses it looks into it.
    plain: Any = tuple(c.__origin__ if isinstance(c, GenericAlias) else c for c in choices)
    if not isinstance(value, plain):
        names = " or ".join("None" if c is type(None) else c.__name__ for c in plain)
        raise SceneError(f"{what} is {kind_of(value)}: it has to be a {names}")


def check_names(scene: Declaration) -> None:
    """Names differ, also from those that derivatives and time get.

    Raises
    ------
    SceneError
        Names what collides.
    """
    given = [name_of(f) for f in (*scene.coordinates, *scene.inputs)]
    given += [name_of(u) for u, _ in scene.speeds]
    for kind, names in (
        ("body", [body.name for body in scene.bodies]),
        ("load", [load.name for load in scene.loads]),
        ("joint", [joint.name for joint in scene.joints]),
        ("constraint", [constraint.name for constraint in scene.constraints]),
        ("condition", [condition.name for condition in scene.conditions]),
        ("coordinate, speed, input or reaction", [*given, *(r.name for r in scene.reactions)]),
    ):
        for name, count in Counter(names).items():
            if count > 1:
                raise SceneError(
                    f"{scene.name}: {count} times a {kind} named {name!r}: names must differ"
                )
    rates = rate_names(scene)
    for name in (*given, *(reaction.name for reaction in scene.reactions)):
        if name in rates:
            raise SceneError(f"{scene.name}: {name!r} is also the name of {rates[name]}: rename it")


def check_symbols(scene: Declaration) -> None:
    """No parameter has the name of something else.

    Raises
    ------
    SceneError
        Names the symbol and where it stands.
    """
    taken = rate_names(scene)
    taken |= {name_of(f): "a coordinate or an input" for f in (*scene.coordinates, *scene.inputs)}
    taken |= {name_of(u): "a speed" for u, _ in scene.speeds}
    words = "a reaction, on which a load cannot depend, but friction by coulomb(...)"
    taken |= {reaction.name: words for reaction in scene.reactions}
    seen: dict[str, Symbol] = {}
    for where, expression in scene.typed:
        for symbol in expression.free_symbols - {dynamicsymbols._t}:
            if symbol.name in taken:
                raise SceneError(
                    f"{where}: the symbol {symbol} has the name of {taken[symbol.name]}: write the"
                    " dynamic symbol if it is meant, or rename the parameter"
                )
            if seen.setdefault(symbol.name, symbol) != symbol:
                raise SceneError(
                    f"{where}: there are two different parameters named {symbol}: declare it once,"
                    " with the same assumptions everywhere"
                )


def rate_names(scene: Declaration) -> dict[str, str]:
    """Names that derivatives get, and what they are."""
    found = {dynamicsymbols._t.name: "time"}
    moving = [(q, 3) for q in scene.coordinates] + [(f, len(DOTS)) for f in scene.inputs]
    moving += [(u, 2) for u, _ in scene.speeds]
    for function, count in moving:
        for dots in DOTS[1:count]:
            found[name_of(function) + dots] = f"a derivative of {name_of(function)}"
    # With declared speeds the rates of coordinates are symbols only inside: u may be named x_dot.
    for u, _ in scene.speeds:
        found.pop(name_of(u), None)
    return found
