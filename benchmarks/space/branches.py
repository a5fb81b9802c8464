"""Rows of four-bars on another branch: loops crossed where the row still closes.

    B + b e = D + c f,      C the intersection of two circles, on one side of BD or on the other

Depth first over both sides, the one first on which the coupler crosses the ground.
"""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from math import atan2, cos, sin, sqrt

from sympy import Expr

from mechanics.scene import Scene
from systems import four_bar_chain

CLOSE = 1e-3
"""Square of the least distance of C from BD: beside it bars are in line."""


def crossed(loops: int, length: Callable[[str, int], Expr], start: float = 1.0) -> Scene:
    """A row whose example has crossed loops.

    Parameters
    ----------
    length : callable
        As of `systems.four_bar_chain.scene`; numbers.
    start : float
        Angle of the first crank.

    Raises
    ------
    ValueError
        When no choice of sides closes the row.
    """
    # For each loop the angle of its crank, and what is left to be tried: coupler and rocker.
    angles, waiting = [start], [_ways(length, 0, start)]
    chosen: list[tuple[float, float]] = []
    while waiting and len(chosen) < loops:
        if waiting[-1]:
            coupler, rocker = waiting[-1].pop(0)
            chosen.append((coupler, rocker))
            angles.append(rocker)
            waiting.append(_ways(length, len(chosen), rocker))
        else:
            waiting.pop()
            angles.pop()
            chosen = chosen[: len(waiting) - 1]
    if len(chosen) < loops:
        raise ValueError(f"no row of {loops} four-bars closes from {start}")
    example = {"q0": start}
    for k, (coupler, rocker) in enumerate(chosen):
        example |= {f"q{2 * k + 1}": coupler, f"q{2 * k + 2}": rocker}
    return replace(four_bar_chain.scene(loops, length), example=example)


def count_crossed(scene: Scene) -> int:
    """Loops of which crank and rocker are on different sides of the ground."""
    cranks = [sin(scene.example[f"q{k}"]) for k in range(0, len(scene.q), 2)]
    return sum(one * two < 0 for one, two in pairwise(cranks))


def _ways(
    length: Callable[[str, int], Expr], k: int, crank: float
) -> list[tuple[float, float]]:  # fmt: skip
    """Coupler and rocker at an angle of the crank, crossed first; none where the loop is open."""
    kinds = ("crank", k), ("coupler", k), ("crank", k + 1), ("ground", k)
    a, b, c, d = (float(length(*kind)) for kind in kinds)
    x, y = a * cos(crank), a * sin(crank)
    r = sqrt((d - x) ** 2 + y**2)
    along = (r**2 + b**2 - c**2) / (2 * r)
    square = b**2 - along**2
    if square < CLOSE:
        return []
    e = (d - x) / r, -y / r
    found = []
    for side in (1, -1):
        across = side * sqrt(square)
        u, v = along * e[0] - across * e[1], along * e[1] + across * e[0]
        found.append((v + y, atan2(v, u), atan2(v + y, u + x - d)))
    found.sort(key=lambda way: way[0] * y)
    return [(coupler, rocker) for _, coupler, rocker in found]
