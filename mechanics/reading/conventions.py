"""Changes of convention, under which wrong equations may be right ones.

    angle from the other vertical    q -> q + pi        the other sign     q -> -q
    angle from the horizontal        q -> pi/2 - q, ...
    relative joint angles            q2 -> q2 - q1      half-length        L -> L / 2, L -> 2 L

Each is a substitution in the person's equations, the same in all of them.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise, product

from sympy import Expr, Symbol, pi

from mechanics.reading.kinds import angular
from mechanics.scene import Gravity, Scene
from mechanics.scene.symbols import plain_symbol

Table = dict[Symbol, Expr]


@dataclass(frozen=True)
class Convention:
    """One change of convention.

    Attributes
    ----------
    name : str
        As a person declares it: ``"other vertical"``.
    words : str
        What has to be so for the equations to be right.
    table : dict of Symbol to Expr
        What stands for the person's symbols.
    """

    name: str
    words: str
    table: Table


NAMES = (
    "other vertical", "other sign of angles", "other sign of displacements",
    "other sign of inputs", "relative angles", "absolute angles", "half-length",
    "twice the length", "point mass", "from the horizontal",
)  # fmt: skip
"""What may be declared; they may be combined with a comma."""


def conventions(scene: Scene) -> list[tuple[Convention, ...]]:
    """Single changes first, then those that people combine."""
    angles = [q for q in scene.q if q in angular(scene)]
    others = [q for q in scene.q if q not in angles]
    turned = _some(
        Convention("other vertical", _about(angles, f"counted from the {_opposite(scene)}"),
                   {q: q + pi for q in angles}) if angles else None,
    )  # fmt: skip
    signed = _some(
        Convention("other sign of angles", _about(angles, "counted the other way round"),
                   _negative(scene, angles)) if angles else None,
    )  # fmt: skip
    moved = _some(
        Convention("other sign of displacements", _about(others, "counted the other way"),
                   _negative(scene, others)) if others else None,
    )  # fmt: skip
    pushed = _some(
        Convention("other sign of inputs", _about(scene.input_symbols, "counted the other way"),
                   {f: -f for f in scene.input_symbols}) if scene.input_symbols else None,
    )  # fmt: skip
    joints = list(_joints(scene, angles))
    sizes = list(_lengths(scene))
    groups = (turned, signed, moved, pushed)
    singles = [(c,) for group in groups for c in group]
    singles += [(c,) for c in (*_level(scene, angles), *joints, *sizes)]
    combined = [
        tuple(c for group in chosen for c in group)
        for count in (2, 3, 4)
        for chosen in combinations([g for g in groups if g], count)
    ]
    mixed = [
        (*base, extra)
        for base, extra in product([(c,) for g in groups for c in g], (*joints, *sizes))
    ]
    return [*singles, *combined, *mixed]


def _opposite(scene: Scene) -> str:
    heavy = any(isinstance(load, Gravity) for load in scene.loads)
    return "other vertical" if heavy else "opposite direction"


def _level(scene: Scene, angles: list[Symbol]) -> Iterator[Convention]:
    """Angles counted from a quarter turn away, either way round."""
    for sense, start in product((-1, 1), (1, -1)) if angles else ():
        table = _negative(scene, angles) if sense < 0 else {}
        table |= {q: sense * q + start * pi / 2 for q in angles}
        quarter = "pi/2" if start > 0 else "-pi/2"
        told = f"{quarter} minus the scene's" if sense < 0 else f"{quarter} plus the scene's"
        words = f"counted from a quarter turn away, such as the horizontal: {told}"
        yield Convention("from the horizontal", _about(angles, words), table)


def _some(convention: Convention | None) -> tuple[Convention, ...]:
    return () if convention is None else (convention,)


def _about(symbols: list[Symbol] | tuple[Symbol, ...], words: str) -> str:
    return f"{', '.join(s.name for s in symbols)} {'is' if len(symbols) == 1 else 'are'} {words}"


def _negative(scene: Scene, symbols: list[Symbol]) -> Table:
    found: Table = {}
    for function in scene.coordinates:
        if plain_symbol(function) in symbols:
            for order in range(3):
                symbol = plain_symbol(function, order)
                found[symbol] = -symbol
    return found


def _joints(scene: Scene, angles: list[Symbol]) -> Iterator[Convention]:
    """Angles of a chain counted from the link before, or from what is fixed."""
    if len(angles) < 2 or scene.speeds:
        return
    functions = [f for f in scene.coordinates if plain_symbol(f) in angles]
    relative: Table = {}
    absolute: Table = {}
    for order in range(3):
        symbols = [plain_symbol(f, order) for f in functions]
        total: Expr = symbols[0]
        for before, symbol in pairwise(symbols):
            relative[symbol] = symbol - before
            total = total + symbol
            absolute[symbol] = total
    names = ", ".join(angle.name for angle in angles[1:])
    yield Convention("relative angles", f"{names} are counted from the link before", relative)
    yield Convention("absolute angles", f"{names} are counted from the fixed direction", absolute)


def _lengths(scene: Scene) -> Iterator[Convention]:
    for symbol in scene.parameters:
        if getattr(symbol, "unit", "") != "m":
            continue
        yield Convention(
            "half-length",
            f"{symbol.name} is half of the scene's {symbol.name}",
            {symbol: symbol / 2},
        )
        yield Convention(
            "twice the length", f"{symbol.name} is twice the scene's {symbol.name}",
            {symbol: 2 * symbol},
        )  # fmt: skip


def combined_table(conventions: tuple[Convention, ...]) -> Table:
    """One substitution for all changes, the last applied to what the first gives."""
    found: Table = {}
    for convention in conventions:
        found = {symbol: value.xreplace(convention.table) for symbol, value in found.items()}
        for symbol, value in convention.table.items():
            found.setdefault(symbol, value)
    return found
