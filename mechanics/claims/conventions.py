"""Changes of convention, under which wrong equations may be right ones.

    angle from the other vertical    q -> q + pi        the other sign     q -> -q
    relative joint angles            q2 -> q2 - q1      half-length        L -> L / 2, L -> 2 L
    from a definite direction        q -> q - pi/2, ...

Each is a substitution in the person's equations, the same in all of them. Generalized speeds that
are no rates are the scene's own under all of them.
"""

from collections.abc import Sequence
from itertools import combinations, pairwise, product

from sympy import Expr, Symbol, pi

from mechanics.claims.angle_directions import directed, is_another
from mechanics.claims.convention import (
    Change,
    Convention,
    Table,
    about,
    combined_table,
    negative,
)
from mechanics.claims.directions import Counted, counted
from mechanics.claims.kinds import angular
from mechanics.scene import Gravity, Scene
from mechanics.scene.symbols import DOTS, plain_symbol

__all__ = [
    "combined_table", "conventions", "joints", "lengths", "other_sign", "other_signs",
    "other_vertical",
]  # fmt: skip


def conventions(scene: Scene) -> list[Change]:
    """Single changes first, then those that people combine."""
    angles = counted(scene)
    turned = other_vertical(scene, angles)
    groups = [[turned] if turned else [], *([c] for c in other_signs(scene))]
    level = [c for _, _, c in directed(scene, angles) if is_another(c)]
    sizes = lengths(scene)
    before = joints(scene, angles)
    singles = [(c,) for group in groups for c in group]
    singles += [(c,) for c in (*level, *before, *sizes)]
    every = [tuple(sizes[k::2]) for k in (0, 1)] if len(sizes) > 2 else []
    combined = [
        tuple(c for group in chosen for c in group)
        for count in (2, 3, 4)
        for chosen in combinations([g for g in groups if g], count)
    ]
    # Joints first: a person's joint angle is between the person's own directions.
    mixed = [
        (extra, *base)
        for base, extra in product([(c,) for g in groups for c in g], (*before, *sizes))
    ]
    return [*singles, *every, *combined, *mixed]


def other_vertical(
    scene: Scene, angles: Sequence[Counted], only: str = ""
) -> Convention | None:  # fmt: skip
    """Angles from a fixed direction counted from the opposite one; in space, from the other pole.

    Parameters
    ----------
    scene : Scene
    angles : sequence of Counted
        How it counts them.
    only : str
        One angle; all of them when not given.
    """
    turned = [c for c in angles if c.fixed and only in ("", c.symbol.name)]
    table: Table = {}
    for angle in turned:
        q = angle.symbol
        table |= {q: q + pi} if angle.planar else negative(scene, [q]) | {q: pi - q}
    if not turned:
        return None
    words = about([c.symbol for c in turned], f"counted from the {_opposite(scene)}")
    name = f"other vertical of {only}" if only else "other vertical"
    return Convention(name, words, table, "turn")


def other_signs(scene: Scene) -> list[Convention]:
    """All angles, all displacements or all inputs with the other sign."""
    angles = [q for q in scene.q if q in angular(scene)]
    others = [q for q in scene.q if q not in angles]
    kinds = (("angles", angles), ("displacements", others), ("inputs", scene.input_symbols))
    return [other_sign(scene, symbols, name) for name, symbols in kinds if symbols]


def other_sign(scene: Scene, symbols: Sequence[Symbol], name: str) -> Convention:
    """Coordinates or inputs with the other sign."""
    way = "the other way round" if set(symbols) <= angular(scene) else "the other way"
    table = negative(scene, symbols)
    for function in scene.inputs:
        if plain_symbol(function) in symbols:
            rates = [plain_symbol(function, order) for order in range(len(DOTS))]
            table |= {symbol: -symbol for symbol in rates}
    return Convention(f"other sign of {name}", about(symbols, f"counted {way}"), table, "sign")


def joints(scene: Scene, known: Sequence[Counted]) -> list[Convention]:
    """Angles of a chain counted from the link before, or from what is fixed.

    Only what the scene does not do itself; all of its angles have to grow the same way.
    """
    if len(known) < 2 or scene.speeds or len({c.sense for c in known} | {0}) != 2:
        return []
    functions = [f for f in scene.coordinates if plain_symbol(f) in {c.symbol for c in known}]
    names = ", ".join(c.symbol.name for c in known[1:])
    if all(c.fixed for c in known):
        if len({c.quarter for c in known}) > 1:
            return []
        relative: Table = {}
        for order in range(3):
            symbols = [plain_symbol(f, order) for f in functions]
            relative |= {symbol: symbol - before for before, symbol in pairwise(symbols)}
        words = f"{names} are counted from the link before"
        return [Convention("relative angles", _one(words, known), relative, "joints")]
    if not known[0].fixed or any(c.fixed for c in known[1:]):
        return []
    absolute: Table = {}
    for order in range(3):
        total: Expr = plain_symbol(functions[0], order)
        for function in functions[1:]:
            symbol = plain_symbol(function, order)
            total = total + symbol
            absolute[symbol] = total
    words = f"{names} are counted from the fixed direction"
    return [Convention("absolute angles", _one(words, known), absolute, "joints")]


def lengths(scene: Scene) -> list[Convention]:
    """Half of each length, and twice it."""
    found = []
    for symbol in scene.parameters:
        if getattr(symbol, "unit", "") == "m":
            half = f"{symbol.name} is half of the scene's {symbol.name}"
            twice = f"{symbol.name} is twice the scene's {symbol.name}"
            found += [
                Convention(f"half-length of {symbol.name}", half, {symbol: symbol / 2}, "size"),
                Convention(
                    f"twice the length of {symbol.name}", twice, {symbol: 2 * symbol}, "size"
                ),
            ]
    return found


def _opposite(scene: Scene) -> str:
    heavy = any(isinstance(load, Gravity) for load in scene.loads)
    return "other vertical" if heavy else "opposite direction"


def _one(words: str, known: Sequence[object]) -> str:
    return words.replace(" are ", " is ") if len(known) == 2 else words
