"""Canaries: what is known beforehand is asked first, so that a checker that is wrong shows it.

    decisions        statements known to be true are proved, statements known to be false refuted
    numbers          a scalar is read as it was typed, a decimal as the fraction that it prints
    declarations     bodies, loads, reactions and constraints keep what was given
    shapes           mass, centroid and inertia of a body cut from all shapes are integrals over it

    integral of r dr dphi over a sector, of dx dy over a rectangle, of ds over a curve       (1)

(1) by Gauss and Legendre: exact in lengths with three nodes, within 10^-30 in angles with 24.
What the canaries say is evidence about the program, not about a scene: SUPPORTED, or REFUTED.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from flint import arb
from sympy import (
    Abs,
    Expr,
    Float,
    Integer,
    Rational,
    Symbol,
    cos,
    pi,
    sin,
    sqrt,
    srepr,
    symbols,
    tan,
)
from sympy.physics.vector import Point, ReferenceFrame

from mechanics.checks.jets import Instant, precision
from mechanics.checks.route_canaries import known_findings
from mechanics.kernel import Finding, Verdict, refuted, supported
from mechanics.scene.bodies import Particle, RigidBody
from mechanics.scene.composite import composite, part
from mechanics.scene.declared import scalar
from mechanics.scene.loads import (
    coulomb,
    damper,
    force,
    gravity,
    spring,
    torque,
    torsion_spring,
)
from mechanics.scene.reactions import holonomic, nonholonomic, reaction, reaction_couple
from mechanics.scene.shapes import Disc, Rectangle, Ring, Rod, Semidisc
from mechanics.symbolic import prove_equal

BITS = 100
CLOSE = arb(2) ** -50


@dataclass(frozen=True)
class Known:
    """What is known beforehand, what the program says of it, and words for where that differs."""

    words: str
    known: Any
    value: Any


Element = tuple[arb, arb, arb]
"""Size, x and y."""

_x, _y = symbols("x y", real=True)
_p = Symbol("p", positive=True)

TRUE: tuple[tuple[Any, Any], ...] = (
    (sin(_x) ** 2 + cos(_x) ** 2, 1),
    (sin(_x + _y), sin(_x) * cos(_y) + cos(_x) * sin(_y)),
    (sin(3 * _x / 2), 3 * sin(_x / 2) - 4 * sin(_x / 2) ** 3),
    (tan(_x) * cos(_x), sin(_x)),
    ((_x**2 - _y**2) / (_x - _y), _x + _y),
    (1 / _x + 1 / _y, (_x + _y) / (_x * _y)),
    (sqrt(_p * _x**2), sqrt(_p) * Abs(_x)),
    ([_x, (_x + _y) ** 3], [_x, _x**3 + 3 * _x**2 * _y + 3 * _x * _y**2 + _y**3]),
)
FALSE: tuple[tuple[Any, Any], ...] = (
    (sin(_x), cos(_x)),
    (sin(_x) ** 2, cos(_x) ** 2 - 1),
    (sin(_x + _y), sin(_x) + sin(_y)),
    (sin(_x / 2), sin(_x) / 2),
    (cos(2 * _x), 1),
    (cos(_x), 1),
    (_x / (1 + _y**2), _x),
    (_x * _y, _x + _y),
    (_x / _y, _x * _y),
    (1 / (_x + _y), 1 / _x),
    (_x, _y),
    (_x, 1),
    (_x**3, _x**2),
    (sqrt(_x**2), _x),
    (sqrt(2), Rational(14142135, 10**7)),
    ([_x, _x], [_x, _x * (1 + Rational(1, 10**6))]),
    ([_x, _y], [_y, _y]),
)
TYPED: tuple[tuple[Any, Expr], ...] = (
    (3, Integer(3)),
    (0.1, Rational(1, 10)),
    (Float("2.5") * _p, Rational(5, 2) * _p),
    (Rational(3, 7) * _p, Rational(3, 7) * _p),
    (-_x, -_x),
)


def check_canaries() -> tuple[Finding, ...]:
    """All canaries; the scene does not matter."""
    return (
        _finding("decisions", _decided()),
        _finding("numbers as they are typed", _read()),
        _finding("declarations keep what is given", _kept()),
        _finding("shapes against integrals", _integrated()),
        _finding("routes and laws", _compared()),
    )


def _finding(what: str, asked: Iterable[Known]) -> Finding:
    subject, rows = f"canaries: {what}", [*asked]
    found = [supported(subject, [(row.known, row.value)], "") for row in rows]
    wrong = [r for r, one in zip(rows, found, strict=True) if one.verdict is not Verdict.SUPPORTED]
    if wrong:
        words = f"do not trust this program: {'; '.join(row.words for row in wrong)}"
        return refuted(subject, words, wrong[0].known, wrong[0].value)
    samples = [(row.known, row.value) for row in rows]
    return supported(subject, samples, f"all {len(rows)} known answers come out")


def _compared() -> Iterator[Known]:
    """Routes and laws that are known to be right, and to be wrong."""
    for words, true, finding in known_findings():
        name = finding.verdict.name
        known = name if true and finding.shown else "PROVED" if true else "REFUTED"
        yield Known(f"{words}: {name}", known, name)


def _decided() -> Iterator[Known]:
    for pairs, verdict in ((TRUE, Verdict.PROVED), (FALSE, Verdict.REFUTED)):
        for left, right in pairs:
            found = prove_equal("canary", left, right).verdict
            words = f"{left} = {right} is not {verdict.name.lower()}"
            yield Known(words, verdict.name, found.name)


def _read() -> Iterator[Known]:
    for typed, meant in TYPED:
        found = scalar(typed, "canary")
        yield Known(f"{typed} is read as {found}", srepr(meant), srepr(found))


def _kept() -> Iterator[Known]:
    N, P, Q = ReferenceFrame("N"), Point("P"), Point("Q")
    a, b = symbols("a b", positive=True)
    ends: dict[str, Any] = {"on": "one", "by": "two"}
    line: dict[str, Any] = {"first": P, "second": Q, "along": N.x,
                            "first_on": "one", "second_on": "two"}  # fmt: skip
    makers: tuple[tuple[Callable[..., Any], dict[str, Any]], ...] = (
        (Particle, {"centre": P, "mass": a}),
        (RigidBody, {"centre": P, "frame": N, "mass": a, "inertia": b}),
        (spring, {"stiffness": a, "length": b, **line}),
        (damper, {"coefficient": a, **line}),
        (force, {"at": P, "vector": a * N.x, **ends}),
        (torque, {"vector": a * N.x, **ends}),
        (torsion_spring, {"angle": b, "axis": N.x, "stiffness": a, **ends}),
        (coulomb, {"normal": "R", "along": N.x, "sliding": b, "coefficient": a}),
        (reaction, {"at": P, "along": N.x, **ends}),
        (reaction_couple, {"along": N.x, **ends}),
    )
    parts = [(make("part", **given), given) for make, given in makers]
    parts += [
        (gravity(a * N.x), {"field": a * N.x}),
        (
            holonomic("part", a - b, "R"),
            {"expression": a - b, "reactions": ("R",), "holonomic": True},
        ),
        (
            nonholonomic("part", a - b, "R"),
            {"expression": a - b, "reactions": ("R",), "holonomic": False},
        ),
    ]
    for made, given in parts:
        kept = {name: getattr(made, name) for name in given}
        words = ", ".join(
            f"{name} {given[name]} is kept as {kept[name]}"
            for name in given
            if given[name] != kept[name]
        )
        values = tuple(map(str, given.values())), tuple(map(str, kept.values()))
        yield Known(f"{type(made).__name__}: {words}", *values)


def _integrated() -> Iterator[Known]:
    body = composite(
        (
            part(Rectangle(2, 1), density=3, at=(1, 0), angle=pi / 6),
            part(Disc(1), density=1, at=(0, Rational(1, 2))),
            part(Semidisc(2), density=2, at=(1, 1), angle=pi / 3),
            part(Ring(Rational(1, 2)), density=5),
            part(Rod(3), mass=2, at=(0, -1), angle=pi / 4),
        )
    )
    with precision(BITS):
        turn, half = 2 * arb.pi(), arb(1) / 2
        elements = [
            *_placed(3, (1, 0), arb.pi() / 6, _box((-1, 1), (-half, half))),
            *_placed(1, (0, half), arb(0), _sector(1, turn)),
            *_placed(2, (1, 1), arb.pi() / 3, _sector(2, turn / 2)),
            *_placed(5, (0, 0), arb(0), _arc(half, turn)),
            *_placed(arb(2) / 3, (0, -1), arb.pi() / 4, _box((-3 * half, 3 * half), None)),
        ]
        mass = sum(dm for dm, _, _ in elements)
        c = [arb(1), *(sum(e[0] * e[k] for e in elements) / mass for k in (1, 2))]
        xx, yy, xy = (
            sum(e[0] * (e[i] - c[i]) * (e[k] - c[k]) for e in elements)
            for i, k in ((1, 1), (2, 2), (1, 2))
        )
        there = Instant({}, lambda symbol: arb.nan())
        for name, wanted, found in (
            ("mass", mass, body.mass),
            ("centroid", c[1], body.centroid[0]),
            ("centroid", c[2], body.centroid[1]),
            ("second moment xx", xx, body.second_moment[0, 0]),
            ("second moment yy", yy, body.second_moment[1, 1]),
            ("second moment xy", xy, body.second_moment[0, 1]),
            ("moment of inertia", xx + yy, body.inertia),
        ):
            words = f"the {name} of a body cut from all shapes is {found}"
            yield Known(words, arb(wanted.mid(), CLOSE), there.value(found))


def _placed(density: Any, at: tuple[Any, Any], angle: arb, region: Iterator[Element]) -> Iterator:
    """Elements (dm, x, y) of a shape in the body's axes."""
    c, s = angle.cos(), angle.sin()
    for size, x, y in region:
        yield density * size, at[0] + c * x - s * y, at[1] + s * x + c * y


def _box(width: tuple[Any, Any], height: tuple[Any, Any] | None) -> Iterator[Element]:
    """dx dy over a rectangle; dx over a rod, which has no height."""
    for one, x in _nodes(*width, 3):
        for two, y in [(arb(1), arb(0))] if height is None else _nodes(*height, 3):
            yield one * two, x, y


def _sector(radius: int, angle: arb) -> Iterator[Element]:
    """r dr dphi."""
    for one, r in _nodes(arb(0), radius, 3):
        for two, x, y in _arc(r, angle):
            yield one * two, x, y


def _arc(radius: Any, angle: arb) -> Iterator[Element]:
    """r dphi."""
    for weight, phi in _nodes(arb(0), angle, 24):
        yield weight * radius, radius * phi.cos(), radius * phi.sin()


def _nodes(low: Any, high: Any, count: int) -> Iterator[tuple[arb, arb]]:
    """Weights and places of Gauss and Legendre between two limits."""
    for k in range(count):
        place, weight = arb.legendre_p_root(count, k, True)
        yield weight * (high - low) / 2, low + (place + 1) * (high - low) / 2
