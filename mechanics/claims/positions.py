"""Cartesian coordinates of bodies by names of the author's own, which a text may never use again.

x = L sin(phi)    y = -L cos(phi)    dx = der(x)    V = m g y, where nothing says what y is
"""

import re
from collections.abc import Iterator, Sequence

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.claims.definitions import definitions, used
from mechanics.claims.from_sympy import Untreeable, tree_of
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import COMPOSED, Name
from mechanics.scene import Scene
from mechanics.scene.rates import rate_table
from mechanics.symbolic import is_zero, operations

LARGEST = 60
"""Operations of an expression that is compared."""
CARTESIAN = re.compile(r"([xyz])_?([1-9]?)")


def places_of(lines: Sequence[Entry], naming: Naming) -> dict[str, Line]:
    """What x, y_1, ... are that nothing explains: coordinates of the only body, or the first one.

    It is a guess, as nobody says from where they count.
    """
    defined = definitions(lines, naming)
    scene = naming.vocabulary.scene
    unknown = dict.fromkeys(
        n.name for n in used(lines)
        if n.name not in defined and naming.target(n.name) is None and CARTESIAN.fullmatch(n.name)
    )  # fmt: skip
    if not unknown:
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


def body_at(scene: Scene, value: Expr | MatrixBase) -> str:
    """The body of whose centre a value is a coordinate or its rate, up to its sign and a constant.

    Empty where it is that of none.
    """
    if isinstance(value, MatrixBase) or operations(value) > LARGEST:
        return ""
    moving = {*scene.q, *scene.u}
    if not value.free_symbols & moving or value.free_symbols & {*scene.ud}:
        return ""
    for name, component in _components(scene):
        for other in (component, -component):
            if all(is_zero((value - other).diff(symbol)) for symbol in moving):
                return name
    return ""


def _components(scene: Scene) -> Iterator[tuple[str, Expr]]:
    """Coordinates of the centres of all bodies, and their rates."""
    table = rate_table(scene)
    for body in scene.bodies:
        for component in scene.position(body.centre):
            if component.free_symbols & {*scene.q}:
                yield body.name, component
                yield body.name, sum(component.diff(q) * table[q] for q in scene.q)
