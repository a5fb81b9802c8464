"""Cartesian coordinates of bodies by names of the author's own, which a text may never use again.

x = L sin(phi)    y = -L cos(phi)    dx = der(x)    V = m g y, where nothing says what y is
"""

import re
from collections.abc import Iterator, Sequence

from sympy import Expr, Heaviside, S, sign, zeros
from sympy.matrices import MatrixBase

from mechanics.claims.definitions import definitions, used
from mechanics.claims.from_sympy import Untreeable, tree_of
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import COMPOSED, Name
from mechanics.scene import Force, Scene, Torque
from mechanics.scene.generalized_forces import turning
from mechanics.scene.rates import rate_table
from mechanics.symbolic import is_zero, operations

LARGEST = 60
"""Operations of an expression that is compared."""
CARTESIAN = re.compile(r"([xyz])_?([1-9]?)")


def places_of(lines: Sequence[Entry], naming: Naming, text: str) -> dict[str, Line]:
    """What x, y_1, ... are that nothing explains: coordinates of the only body, or the first one.

    It is a guess, as nobody says from where they count; where the text speaks of one there is none.
    """
    defined = definitions(lines, naming)
    scene = naming.vocabulary.scene
    unknown = dict.fromkeys(
        n.name for n in used(lines)
        if n.name not in defined and naming.target(n.name) is None and CARTESIAN.fullmatch(n.name)
    )  # fmt: skip
    if not unknown or any(_is_told(name, text) for name in unknown):
        return {}
    places = [(body.name, scene.position(body.centre)) for body in scene.bodies]
    moving = [(n, place) for n, place in places if any(e.free_symbols & {*scene.q} for e in place)]
    found: dict[str, Line] = {}
    for name in unknown:
        axis, number = CARTESIAN.fullmatch(name).groups()  # type: ignore[union-attr]
        if (int(number) > len(moving)) if number else (len(moving) != 1):
            return {}
        body, place = moving[int(number or 1) - 1]
        value = place["xyz".index(axis)]
        try:
            tree = tree_of(value, lambda symbol: Name(COMPOSED, symbol.name))
        except Untreeable:
            return {}
        words = f"{name} is read as a coordinate of {body}"
        found[name] = Line((Name(COMPOSED, name), tree), "", 0, f"{name} = {value}", (words,))
    return found


def _is_told(name: str, text: str) -> bool:
    """Whether prose speaks of a name, or of an axis of its letter: it may count from anywhere."""
    alone = rf"{name[0]}[_{{}} ]*{name[1:].strip('_')}[ }}]*"
    said = rf"(?:\$|\\\(|`){alone}(?:\$|\\\)|`)|(?<![^\s.,;(]){alone}(?::| is\b| denotes\b)"
    axis = rf"(?<!\w){name[0]}\$?[ -]?(?:axis|direction|coordinate)|\baxes\b"
    return re.search(f"{said}|{axis}", text, re.MULTILINE) is not None


def body_at(scene: Scene, value: Expr | MatrixBase) -> str:
    """The body of whose centre a value is a coordinate or its rate, up to its sign and a constant.

    Empty where it is that of none.
    """
    if isinstance(value, MatrixBase) or operations(value) > LARGEST:
        return ""
    moving = {*scene.q, *scene.u}
    if not value.free_symbols & moving or value.free_symbols & {*scene.ud}:
        return ""
    if value.has(sign, Heaviside):  # their rates are no functions
        return ""
    for name, component in _components(scene):
        for other in (component, -component):
            if all(is_zero((value - other).diff(symbol)) for symbol in moving):
                return name
    return ""


def momentum_of_body(scene: Scene, value: Expr) -> str:
    """The body of whose momentum a value is a component, up to its sign; empty for none."""
    plain = scene.plain(value)
    if not is_zero(plain.xreplace(dict.fromkeys((*scene.u, *scene.qd), S.Zero))):
        return ""
    heavy = (b for b in scene.bodies if b.mass != 0)
    names = (b.name for b in heavy if body_at(scene, plain / b.mass) == b.name)
    return next(names, "")


def as_scene_has(scene: Scene, value: Expr | MatrixBase) -> str:
    """What a value is up to its sign, in words: a speed of a body, or a load; empty for neither."""
    if isinstance(value, MatrixBase) or value.count_ops() > LARGEST:
        return ""
    if not scene.plain(value).free_symbols & {*scene.q, *scene.u, *scene.qd}:
        return ""
    for words, square in _squares(scene):
        if square != 0 and is_zero(scene.plain(value) ** 2 - square):
            return words
    return ""


def _squares(scene: Scene) -> Iterator[tuple[str, Expr]]:
    """Squares of speeds and of declared loads, and what they are of."""
    rates = rate_table(scene)
    for load in scene.loads:
        if isinstance(load, Force | Torque):
            vector = scene.vector(load.vector, load.name)
            yield f"the load {load.name!r}", vector.dot(vector)
    for body in scene.bodies:
        place = scene.position(body.centre)
        v = sum((place.diff(q) * rates[q] for q in scene.q), zeros(3, 1))
        yield f"the speed of {body.name}", v.dot(v)
        turns = turning(scene, body.name)
        w = sum((turn * rates[q] for q, turn in zip(scene.q, turns, strict=True)), zeros(3, 1))
        yield f"the angular speed of {body.name}", w.dot(w)


def _components(scene: Scene) -> Iterator[tuple[str, Expr]]:
    """Coordinates of the centres of all bodies, and their rates."""
    table = rate_table(scene)
    for body in scene.bodies:
        for component in scene.position(body.centre):
            if component.free_symbols & {*scene.q}:
                yield body.name, component
                yield body.name, sum(component.diff(q) * table[q] for q in scene.q)
