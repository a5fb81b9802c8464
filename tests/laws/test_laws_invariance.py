"""The motion does not depend on coordinates, units, axes, names, or how reactions are split."""

from collections.abc import Mapping
from typing import Any

import pytest
from shared_scenes import CONSTRAINED
from sympy import Expr, Matrix, Rational, Symbol, eye, pi
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import systems
from mechanics.checks.manifold import project
from mechanics.checks.solution import solve
from mechanics.crosscheck import ROUTES, derive
from mechanics.equations import Equations
from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction, spring
from mechanics.symbolic import decide

NAMES = [route.name for route in ROUTES]
x, theta = dynamicsymbols("x theta")
M, m, L, k, g = parameters("M m L k g")
Table = Mapping[Symbol, Expr]


def pendulum(
    turn: Matrix | None = None,
    along_rod: bool = False,
    q: tuple[Expr, Expr] = (x, theta),
    angle: Expr | None = None,
    names: tuple[Symbol, ...] = (M, m, L, k, g),
) -> Scene:
    """The pendulum on an elastic support, in axes turned by a constant matrix."""
    M, m, L, k, g = names
    N = ReferenceFrame("N")
    rail = ReferenceFrame("G")
    rail.orient_explicit(N, turn if turn is not None else eye(3))
    rod = rail.orientnew("A", "Axis", (q[1] if angle is None else angle, rail.z))
    O = Point("O")
    B = O.locatenew("B", q[0] * rail.x)
    C = B.locatenew("C", -L / 2 * rod.y)
    axes = rod if along_rod else rail
    return Scene(
        "pendulum", N, O, coordinates=q,
        bodies=(Particle("carriage", B, m), RigidBody("rod", C, rod, M, M * L**2 / 12)),
        loads=(gravity(-g * rail.y), spring("k", O, B, 2 * k, along=rail.x)),
        reactions=(
            reaction("T", at=B, on="carriage", by="rod", along=axes.x),
            reaction("R", at=B, on="rod", by="carriage", along=axes.y),
            reaction("S", at=B, on="carriage", by=None, along=rail.y),
        ),
    )  # fmt: skip


def assert_same_motion(old: Equations, new: Equations, table: Table) -> None:
    """The rows of `new`, written in the old symbols, hold for the accelerations of `old`."""

    def experiment(a: Any) -> list:
        project(a, old.kinematics)
        for symbol, number in zip(old.unknowns, solve(a, old), strict=True):
            a.assign(symbol, number)
        rows = [row.xreplace(dict(table)) for row in new.residual]
        return [(a.value(row), a.rational(0)) for row in rows]

    finding = decide("the same motion", experiment)
    assert finding.shown, finding


def rates(scene: Scene, values: Mapping[str, Expr]) -> dict[Symbol, Expr]:
    """Plain symbols of a scene by name."""
    known = {s.name: s for s in (*scene.q, *scene.u, *scene.ud, *scene.parameters)}
    return {known[name]: value for name, value in values.items()}


@pytest.mark.parametrize("route", NAMES)
def test_angle_from_another_direction(route: str) -> None:
    old, alpha = derive(pendulum(), route), dynamicsymbols("alpha")
    new = derive(pendulum(q=(x, alpha), angle=pi / 2 - alpha), route)
    q, u, ud = (group[1] for group in (old.scene.q, old.scene.u, old.scene.ud))
    table = {"alpha": pi / 2 - q, "alpha_dot": -u, "alpha_ddot": -ud}
    assert_same_motion(old, new, rates(new.scene, table))


def chain(relative: bool) -> Scene:
    """Two rods on a pivot, angles from the vertical or from the rod before."""
    a, b = dynamicsymbols("a b")
    N, O = ReferenceFrame("N"), Point("O")
    first = N.orientnew("A", "Axis", (a, N.z))
    second = (first if relative else N).orientnew("B", "Axis", (b, N.z))
    C1 = O.locatenew("C1", -L / 2 * first.y)
    P = O.locatenew("P", -L * first.y)
    C2 = P.locatenew("C2", -L / 2 * second.y)
    return Scene(
        "two rods", N, O, coordinates=(a, b), loads=(gravity(-g * N.y),),
        bodies=(RigidBody("one", C1, first, M, M * L**2 / 12),
                RigidBody("two", C2, second, m, m * L**2 / 12)),
        reactions=(reaction("X1", O, "one", None, N.x), reaction("Y1", O, "one", None, N.y),
                   reaction("X2", P, "two", "one", N.x), reaction("Y2", P, "two", "one", N.y)),
    )  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", NAMES)
def test_relative_angles(route: str) -> None:
    old, new = derive(chain(relative=False), route), derive(chain(relative=True), route)
    table = {}
    for group in ("q", "u", "ud"):
        (a, b), (_, change) = getattr(old.scene, group), getattr(new.scene, group)
        table[change] = b - a
    assert_same_motion(old, new, table)


TURNS = {
    "x-z plane": Matrix([[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
    "y-z plane": Matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]]),
    "turned in its plane": Matrix([[Rational(3, 5), -Rational(4, 5), 0],
                                   [Rational(4, 5), Rational(3, 5), 0], [0, 0, 1]]),
}  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", NAMES)
@pytest.mark.parametrize("turn", TURNS)
def test_inertial_axes(route: str, turn: str) -> None:
    old, new = derive(pendulum(), route), derive(pendulum(TURNS[turn]), route)
    assert_same_motion(old, new, {})
    assert_same_motion(new, old, {})


@pytest.mark.parametrize("route", NAMES)
def test_reactions_along_the_rod(route: str) -> None:
    old, new = derive(pendulum(), route), derive(pendulum(along_rod=True), route)
    assert_same_motion(old, new, {})


def test_reactions_along_the_rod_are_the_same_force() -> None:
    """T' A.x on the carriage is T N.x - R N.y, with R on the rod."""
    old, new = (derive(pendulum(along_rod=flag)) for flag in (False, True))
    one, two = dict(old.reactions), dict(new.reactions)
    T, R, S = (Symbol(name, real=True) for name in "TRS")
    turn = old.scene.rotation(old.scene.body("rod").frame)

    def experiment(a: Any) -> list:
        for symbol, number in zip(old.unknowns, solve(a, old), strict=True):
            a.assign(symbol, number)
        wanted = turn * Matrix([two[T], -two[R], 0])
        pairs = [(one[T], wanted[0]), (-one[R], wanted[1]), (one[S], two[S])]
        return [(a.value(left), a.value(right)) for left, right in pairs]

    assert decide("the same force", experiment).shown


@pytest.mark.parametrize("route", NAMES)
def test_names(route: str) -> None:
    old = derive(pendulum(), route)
    q = dynamicsymbols("lambda lam1")
    new = derive(pendulum(q=q, names=parameters("lam2 I N S_1 E")), route)
    by_name = {"lam2": M, "I": m, "N": L, "S_1": k, "E": g}
    table = {symbol: by_name[symbol.name] for symbol in new.scene.parameters}
    for group in ("q", "u", "ud"):
        table |= dict(zip(getattr(new.scene, group), getattr(old.scene, group), strict=True))
    assert_same_motion(old, new, table)


METRES = {
    "elastic_pendulum": {"x": 1}, "two_mass_chain": {"x1": 1, "x2": 1}, "pendulum_chain": {"q0": 1},
    "cartpole": {"x": 1}, "cartpole_friction": {"x": 1}, "double_inverted_pendulum": {"x": 1},
}  # fmt: skip
"""Coordinates that are lengths; the others are angles."""
INPUTS = {"f": "N", "F": "N", "tau": "N*m", "u": "N"}
TORQUES = {"rod_pendulum": ("u",)}
"""Inputs that are torques where others of their name are forces."""
UNITS = {"1": (0, 0, 0), "kg": (1, 0, 0), "m": (0, 1, 0), "s": (0, 0, 1), "N": (1, 1, -2)}
mass, metre, second = (Symbol(name, positive=True) for name in ("k_mass", "k_metre", "k_second"))


def scale(unit: str) -> Expr:
    """What a number is multiplied with when the units of mass, length and time change."""
    factor: Expr = Rational(1)
    for i, part in enumerate(unit.split("/")):
        for name in part.split("*"):
            base, _, power = name.partition("^")
            a, b, c = (int(power or 1) * (-1 if i else 1) * e for e in UNITS[base])
            factor *= mass**a * metre**b * second**c
    return factor


FREE = [system for system in systems.ALL if system.name not in CONSTRAINED]
"""Multipliers of Lagrange's method have units of their own."""


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", FREE, ids=lambda system: system.name)
@pytest.mark.parametrize("route", NAMES)
def test_units(derived: Any, system: Any, route: str) -> None:
    equations = derived(system.name)[route]
    scene = equations.scene
    table = {p: p * scale(p.unit) for p in scene.parameters}
    torques = dict.fromkeys(TORQUES.get(system.name, ()), "N*m")
    table |= {f: f * scale((INPUTS | torques)[f.name]) for f in scene.input_symbols}
    lengths = METRES.get(system.name, {})
    for q, u, ud in zip(scene.q, scene.u, scene.ud, strict=True):
        size = metre ** lengths.get(q.name, 0)
        table |= {q: q * size, u: u * size / second, ud: ud * size / second**2}
    assert_same_motion(equations, equations, table)
