"""Ropes as their author named them: one length, and one tension that pulls both ends of each part.

sum of d_k = length                d_k = |r_{k+1} - r_k|, or along_k . (r_{k+1} - r_k)      (1)
T pulls the body at r_k towards r_{k+1}, and that one back, as a force on each body         (2)
power of T = 0                     on velocities that the scene admits                      (3)
"""

from collections.abc import Iterator
from itertools import pairwise

from flint import arb, arb_mat

from mechanics.checks.as_declared import Motion, Wrench, cross, dot
from mechanics.checks.joint_rows import NONE, number, place, same, unit
from mechanics.checks.virtual_power import Row
from mechanics.scene import Rope


def rope_rows(motion: Motion, rope: Rope) -> Iterator[Row]:
    """Statements (1) to (3) of one rope at one virtual motion that the scene admits."""
    ends, along = rope.given["ends"], rope.given["along"]
    parts = [(one, two) for one, two in pairwise(ends) if one[0] != two[0]]
    length = arb(0)
    pulls: list[tuple[str | None, arb_mat, arb_mat]] = []
    for k, ((one, first), (two, second)) in enumerate(parts):
        here, there = place(motion, first), place(motion, second)
        span = there - here
        if along is None or along[k] is None:
            distance = dot(span, span).sqrt()
            direction = span * (1 / distance)
        else:
            direction = unit(motion, along[k])
            distance = dot(span, direction)
            yield from same(f"{rope.name}: a straight part", cross(span, direction), NONE)
        length += distance
        pulls += [(one, here, direction), (two, there, -direction)]
    yield f"{rope.name}: its length", length, number(motion, rope.given["length"])
    pulling = [Wrench(body, at, pull, NONE) for body, at, pull in pulls if body is not None]
    acting = [own for name, own in motion.reactions() if name == rope.name]
    for body in sorted({wrench.body for wrench in (*pulling, *acting)}):
        words = f"{rope.name}: what it does to {body}"
        for one, two in zip(_sum(acting, body), _sum(pulling, body), strict=True):
            yield from same(words, one, two)
    power = sum((motion.power(wrench) for wrench in pulling), arb(0))
    yield f"{rope.name}: power of the tension", power, arb(0)


def _sum(wrenches: list[Wrench], body: str) -> tuple[arb_mat, arb_mat]:
    """Force, and moment about the origin."""
    own = [wrench for wrench in wrenches if wrench.body == body]
    force = sum((wrench.force for wrench in own), NONE)
    return force, sum((w.couple + cross(w.at, w.force) for w in own), NONE)
