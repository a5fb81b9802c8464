"""Rates that are spelled with letters.

thetadd, theta_acc, th1_ddot, ddtheta, xDDot    ->    theta, theta, th1, theta, x    order 2
"""

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache

SPELLINGS = (
    (2, ("ddot", "dotdot", "dd", "2dot", "accel", "acc"), ("dd", "d2")),
    (1, ("dot", "d", "vel"), ("d",)),
)
"""Orders, and what stands behind or before the name of what is differentiated."""
_ORDERS = {end: order for order, ends, _ in SPELLINGS for end in ends if end.isalpha()}
NUMBERED = re.compile(
    rf"(?P<name>[^\W\d_]+?)(?P<rate>{'|'.join(sorted(_ORDERS, key=len, reverse=True))})"
    r"(?P<number>\d{1,2})"
)
"""The rate of a letter, and then its number: qdot1, thdd2."""

CAPITALS = re.compile(r"(?<=[a-z\d])(?:DD?ot|Dot[Dd]ot|Ddot|Accel|Acc|Vel)$")
"""Ends of names that are told apart by capitals: thetaDot, xDDot."""
KEPT = 4096
"""Names that are remembered: a page asks for each of its own many times."""
VARIANT = re.compile(
    r"var(?=phi|theta|epsilon|rho|sigma|kappa|pi)|^el(?=l\d*(?:d{1,2}|dot|ddot)?$)"
)
"""What stands before a letter in another shape."""


@lru_cache(maxsize=KEPT)
def key(name: str) -> str:
    """What two names have in common when they are the same: varphi_1 is phi1, ell is l."""
    return VARIANT.sub("", name.replace("_", ""))


@lru_cache(maxsize=KEPT)
def bases(name: str) -> tuple[tuple[str, int], ...]:
    """Keys of names whose rate a name may be, each with the order."""
    return tuple(_bases(name))


def _bases(name: str) -> Iterator[tuple[str, int]]:
    bare = CAPITALS.sub(lambda end: end[0].lower(), key(name))
    for order, ends, starts in SPELLINGS:
        for end in ends:
            if end == "d" and name.endswith("_d"):
                continue  # theta_d is rather a desired angle
            if bare.endswith(end) and bare != end:
                yield bare.removesuffix(end), order
        for start in starts:
            if bare.startswith(start) and bare != start:
                yield bare.removeprefix(start), order
    if part := NUMBERED.fullmatch(bare):
        yield part["name"] + part["number"], _ORDERS[part["rate"]]


def families(names: Iterable[str]) -> dict[str, str]:
    """Names that are rates of another, and of which: a base with a second derivative.

    ``m`` and ``md`` are two masses; ``th``, ``thd`` and ``thdd`` are an angle and its rates. The
    base need not be among the names.
    """
    written = {key(name): name for name in names}
    members: dict[str, dict[str, int]] = {}
    for name in written.values():
        for base, order in bases(name):
            members.setdefault(base, {})[name] = order
    found: dict[str, str] = {}
    for base, rates in members.items():
        if 2 in rates.values() and (base in written or 1 in rates.values()):
            for name in rates:
                found.setdefault(name, written.get(base, base))
    return found
