"""Coordinates that are the length of a spring: where they are positive nothing is lost.

    |r e(theta)| = |r|        r e(theta) = (-r) e(theta + pi)        r e(w t) = (-r) e(w (t + pi/w))

A person writes r for the length of the spring. Each place that a negative r names is named by a
positive one, too, at an angle that is half a turn further, or half a turn of the frame later; so
what is compared has r, as for r > 0.
"""

from dataclasses import replace

from sympy import Expr, Matrix, Symbol, cos, pi, sin

from mechanics.scene import Scene
from mechanics.scene.loads import Load, Spring
from mechanics.scene.symbols import TIME
from mechanics.symbolic import is_zero


def with_positive_radii(scene: Scene) -> tuple[Scene, tuple[str, ...]]:
    """The scene with springs along their radius, and what is to be said of each."""
    loads: list[Load] = []
    told: list[str] = []
    for load in scene.loads:
        found = _radius(scene, load) if isinstance(load, Spring) else None
        if found is not None and isinstance(load, Spring):
            radius, turned = found
            place = list(scene.q).index(radius)
            span = load.second.pos_from(load.first)
            load = replace(load, along=span / scene.coordinates[place])
            told.append(
                f"{radius} is the length of {load.name}, and positive: -{radius} at {turned} is the"
                " same place"
            )
        loads.append(load)
    return (replace(scene, loads=tuple(loads)) if told else scene), tuple(told)


def _radius(scene: Scene, load: Spring) -> tuple[Symbol, Expr] | None:
    """The coordinate that is the length of a spring but for its sign, and half a turn further."""
    if load.along is not None:
        return None
    span = scene.position(load.second) - scene.position(load.first)
    square = sum(entry**2 for entry in span)
    for radius in sorted(square.free_symbols & {*scene.q}, key=str):
        if not is_zero(square - radius**2) or scene.example.get(radius.name, 1) < 0:
            continue
        angles = [(angle, angle + pi) for angle in scene.q if angle != radius]
        for angle, turned in (*angles, *((TIME, TIME + pi / rate) for rate in _rates(span))):
            if _same_places(scene, {radius: -radius, angle: turned}):
                return radius, turned
    return None


def _rates(span: Matrix) -> list[Expr]:
    """Of frames that turn by themselves: w of sin(w t)."""
    rates = {wave.args[0].diff(TIME) for wave in span.atoms(sin, cos)}
    return sorted((rate for rate in rates if rate and not rate.has(TIME)), key=str)


def _same_places(scene: Scene, change: dict[Symbol, Expr]) -> bool:
    """Whether all bodies are where they were, and turned as they were."""

    def same(entry: Matrix) -> bool:
        return all(e.subs(change, simultaneous=True).expand() == e.expand() for e in entry)

    return all(same(scene.position(body.centre)) for body in scene.bodies) and all(
        same(scene.rotation(body.frame)) for body in scene.bodies if hasattr(body, "frame")
    )
