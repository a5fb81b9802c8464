"""What sentences say of the geometry of a scene, beside its springs, inertias and axes.

r is the extension of the spring           its length where r = 0 is the natural one
the y axis points downwards                against gravity, or not
The pulley is a thin hoop.                 its inertia is M R^2
I is the inertia about the centre of mass  a body has I there
a rod of mass m and length l               its inertia is m l^2/12
"""

import re
from collections.abc import Iterator

from sympy import Expr, Rational, S, Symbol

from mechanics.judge.scene_facts import SceneFacts
from mechanics.scene import Gravity, Particle, RigidBody
from mechanics.scene.loads import Spring
from mechanics.scene.symbols import TIME
from mechanics.symbolic import is_zero

SHAPES: tuple[tuple[str, Expr], ...] = (
    ("hoop|ring|thin-walled (?:cylinder|tube|pipe)|hollow cylinder|cylindrical shell", S.One),
    ("dis[ck]|solid cylinder|homogeneous cylinder|uniform cylinder", Rational(1, 2)),
    ("spherical shell|hollow (?:sphere|ball)", Rational(2, 3)),
    ("(?:solid |uniform |homogeneous )(?:sphere|ball)", Rational(2, 5)),
)
"""Bodies of radius R and their inertias over m R^2 about their axes of symmetry."""
LONG = re.compile(r"\b(?:cylind\w+|tube|pipe)\b")
AXES = "xyz"


def elongates(facts: SceneFacts, name: str) -> bool | None:
    """Whether a coordinate is the elongation of a spring, and not its length; None: of no spring.

    Parameters
    ----------
    facts : SceneFacts
    name : str
        Of a coordinate.
    """
    symbol = facts.coordinates.get(name)
    if symbol is None:
        return None
    kinds = set(_kinds(facts, symbol))
    return kinds.pop() if len(kinds) == 1 else None


def _kinds(facts: SceneFacts, symbol: Symbol) -> Iterator[bool]:
    """Of springs whose length a coordinate changes: by itself it is the elongation, or not."""
    scene = facts.scene
    for load in scene.loads:
        if not isinstance(load, Spring):
            continue
        span = scene.position(load.second) - scene.position(load.first)
        if load.along is not None:
            square = span.dot(scene.vector(load.along, load.name)) ** 2
        else:
            square = span.dot(span)
        slack = scene.plain(load.length, load.name)
        if square.has(symbol) and not is_zero(slack):
            at_zero = square.subs(symbol, 0)
            if is_zero(at_zero) or is_zero(at_zero - slack**2):
                yield not is_zero(at_zero)


def upward(facts: SceneFacts, name: str) -> int:
    """1 where a coordinate, or an axis of the inertial frame, counts against gravity; -1 along it.

    0 where that is not known.

    Parameters
    ----------
    facts : SceneFacts
    name : str
        Of a coordinate, or ``x``, ``y``, ``z``.
    """
    scene = facts.scene
    fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
    if len(fields) != 1:
        return 0
    (field,) = fields
    symbol = facts.coordinates.get(name)
    if symbol is not None:
        slopes = [field.dot(scene.position(body.centre)).diff(symbol) for body in scene.bodies]
        falls = {_sign(slope) for slope in slopes if slope != 0}
        return -falls.pop() if len(falls) == 1 else 0
    if name not in AXES or sum(entry != 0 for entry in field) != 1:
        return 0
    return -_sign(field[AXES.index(name)])


def moves_with_time(facts: SceneFacts, *, vertical: bool) -> bool | None:
    """Whether what time alone moves goes along gravity, or across; None where that is not known.

    Parameters
    ----------
    facts : SceneFacts
    vertical : bool
        Along gravity, not across.
    """
    scene = facts.scene
    fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
    rates = [scene.position(body.centre).diff(TIME) for body in scene.bodies]
    moving = [rate for rate in rates if any(not is_zero(entry) for entry in rate)]
    if len(fields) != 1 or not moving or any(r.free_symbols & {*scene.q} for r in moving):
        return None
    (field,) = fields
    along = [all(is_zero(entry) for entry in field.cross(rate)) for rate in moving]
    across = [is_zero(field.dot(rate)) for rate in moving]
    if not (all(along) or all(across)):
        return None
    return all(along) if vertical else all(across)


def _sign(value: Expr) -> int:
    return 1 if value.is_positive else -1 if value.is_negative else 0


def other_shape(facts: SceneFacts, bodies: list[Particle | RigidBody], shape: str) -> bool:
    """Whether bodies of a shape have another inertia, of a radius that is a parameter.

    Parameters
    ----------
    bodies : list of Particle or RigidBody
    shape : str
        In words; an unknown one is no other.
    """
    said = next((size for words, size in SHAPES if re.search(rf"\b(?:{words})\b", shape)), None)
    if said is None:
        return False
    sizes = {size for body in bodies for size in _sizes(facts, body)}
    if LONG.search(shape):  # a length is no radius: a tube of length l has m l^2/12, too
        sizes &= {size for _, size in SHAPES}
    return bool(sizes) and said not in sizes


def _sizes(facts: SceneFacts, body: Particle | RigidBody) -> Iterator[Expr]:
    """Numbers k with the inertia k m R^2 of a body, R a length of the scene."""
    if not isinstance(body, RigidBody) or not isinstance(body.inertia, Expr):
        return
    inertia, mass = facts.scene.plain(body.inertia), facts.scene.plain(body.mass)
    for name, symbol in facts.parameters.items():
        if facts.unit(name) == "m" and mass != 0:
            size = (inertia / (mass * symbol**2)).cancel()
            if size.is_Rational and size > 0:
                yield size


def about_centre(facts: SceneFacts, name: str) -> bool | None:
    """Whether an inertia is that of a body about its mass centre; None: of no body in the plane.

    False where a body's is another one that holds it, as ``I - m h**2``.

    Parameters
    ----------
    name : str
        Of a parameter.
    """
    symbol = facts.parameters.get(name)
    bodies = [b for b in facts.scene.bodies if isinstance(b, RigidBody)]
    inertias = [facts.scene.plain(b.inertia) for b in bodies if isinstance(b.inertia, Expr)]
    held = [inertia for inertia in inertias if symbol is not None and inertia.has(symbol)]
    if any(is_zero(inertia - symbol) for inertia in held):
        return True
    return False if held else None


def has_rod_twice_as_long(facts: SceneFacts, name: str) -> bool:
    """Whether a uniform rod of the scene is twice as long as a parameter.

    Parameters
    ----------
    name : str
        Of a parameter.
    """
    symbol = facts.parameters.get(name)
    if symbol is None or facts.unit(name) != "m":
        return False
    rods = [b for b in facts.scene.bodies if isinstance(b, RigidBody)]
    plain = facts.scene.plain
    return any(
        isinstance(b.inertia, Expr)
        and is_zero(plain(b.inertia) - plain(b.mass) * (2 * symbol) ** 2 / 12)
        for b in rods
    )
