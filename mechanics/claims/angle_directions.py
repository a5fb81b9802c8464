"""Angles counted from a definite direction, clockwise or counterclockwise.

alpha = z pi/2 + s q  =  Z pi/2 + S phi        phi = S (z - Z) pi/2 + S s q

alpha is the direction of a rod from the right horizontal, counterclockwise; z and s are how the
scene counts, Z and S how the person does. The angle of a joint has no z: phi = S s q. Up or down
settles the sign of gravity, left or right that of what drives the scene sideways.
"""

from collections.abc import Sequence
from itertools import product

from sympy import Expr, Symbol, pi

from mechanics.claims.convention import Convention, Table, about, negative
from mechanics.claims.directions import DIRECTIONS, Counted
from mechanics.scene import Scene

SENSES = {1: "counterclockwise", -1: "clockwise"}
SIDES = {1: "above the horizontal", -1: "below the horizontal"}

Directed = tuple[int | None, int, Convention]


def directed(scene: Scene, angles: Sequence[Counted], only: str = "") -> list[Directed]:
    """How angles can be counted: place of the direction in `DIRECTIONS`, sense, and convention.

    In space there is neither right nor left: the place is None, and the sense 1 above the
    horizontal, -1 below it. Nothing where a scene does not tell how it counts itself.

    Parameters
    ----------
    scene : Scene
    angles : sequence of Counted
        How it counts them.
    only : str
        One angle; all of them when not given.
    """
    known = [c for c in angles if only in ("", c.symbol.name)]
    fixed = [c for c in known if c.fixed]
    if not fixed or any(c.quarter is None for c in fixed):
        return []
    if not any(c.planar for c in fixed):
        return [(None, side, _from_the_pole(scene, fixed, side, only)) for side in (1, -1)]
    if any(c.sense == 0 for c in fixed):
        return []
    return [
        (quarter, sense, _from(scene, known, quarter, sense, only))
        for quarter, sense in product(range(len(DIRECTIONS)), SENSES)
    ]


def is_another(convention: Convention) -> bool:
    """Whether angles are a quarter turn away from the scene's: no other change says the same."""
    return any(value.coeff(pi).is_integer is False for value in convention.table.values())


def _from(
    scene: Scene, known: list[Counted], quarter: int, sense: int, only: str
) -> Convention:  # fmt: skip
    table: Table = {}
    for angle in known:
        q, same = angle.symbol, angle.sense * sense
        if same < 0:
            table |= negative(scene, [q])
        if angle.quarter is not None:
            turns = (sense * (angle.quarter - quarter) + 1) % 4 - 1
            table |= {q: table.get(q, q) + turns * pi / 2} if turns else {}
    fixed = [angle.symbol for angle in known if angle.fixed]
    name = f"{DIRECTIONS[quarter]} {SENSES[sense]}"
    words = f"counted from the {DIRECTIONS[quarter]}, {SENSES[sense]}"
    return Convention(_of(name, only), _told(scene, fixed, words, table), table, "direction")


def _from_the_pole(scene: Scene, fixed: list[Counted], side: int, only: str) -> Convention:
    table: Table = {}
    for angle in fixed:
        q = angle.symbol
        below = side * (1 if angle.quarter == 1 else -1)
        value: Expr = pi / 2 - q if below > 0 else q - pi / 2
        table |= ({} if below < 0 else negative(scene, [q])) | {q: value}
    words = f"counted from the horizontal, growing {'upwards' if side > 0 else 'downwards'}"
    symbols = [angle.symbol for angle in fixed]
    return Convention(
        _of(SIDES[side], only), _told(scene, symbols, words, table), table, "direction"
    )


def _told(scene: Scene, symbols: list[Symbol], words: str, table: Table) -> str:
    """What the angles are, and what that is in the scene's."""
    seen = [_sum(q, table.get(q, q)) for q in scene.q if q in table or q in symbols]
    return f"{about(symbols, words)} ({', '.join(seen)} of the scene)"


def _sum(q: Symbol, value: Expr) -> str:
    """``pi/2 - theta``, ``theta - pi/2``."""
    turned = value.coeff(pi) * pi
    return f"{turned} - {q}" if turned and value.coeff(q) == -1 else str(value)


def _of(name: str, only: str) -> str:
    return f"{name} of {only}" if only else name
