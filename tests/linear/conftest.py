"""Small scenes whose linear equations are in every textbook."""

from collections.abc import Callable
from functools import cache

import pytest
from sympy import symbols
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.equations import Equations
from mechanics.linear import Linear, linearize
from mechanics.routes.derivation import by_route
from mechanics.scene import Particle, Scene, damper, force, parameters, spring


@cache
def oscillators(masses: tuple, stiffnesses: tuple, dampings: tuple) -> Equations:
    """A row of masses from a wall: spring and damper before each, a force F on the last.

    One more spring than masses ties the last mass to a second wall.
    """
    n = len(masses)
    ground, wall = ReferenceFrame("N"), Point("O")
    coordinates = dynamicsymbols(f"x1:{n + 1}")
    given = dynamicsymbols("F")
    at = [wall.locatenew(f"P{i}", x * ground.x) for i, x in enumerate(coordinates, 1)]
    ends = [wall, *at, wall]
    loads = [
        spring(f"k{i}", ends[i], ends[i + 1], k, along=ground.x)
        for i, k in enumerate(stiffnesses)
        if k
    ]
    loads += [
        damper(f"c{i}", ends[i], ends[i + 1], c, along=ground.x)
        for i, c in enumerate(dampings)
        if c
    ]
    scene = Scene(
        "row of masses",
        ground,
        wall,
        coordinates=tuple(coordinates),
        bodies=tuple(Particle(f"m{i}", p, m) for i, (p, m) in enumerate(zip(at, masses))),  # noqa: B905
        loads=(*loads, force("F", at[-1], given * ground.x, on=f"m{n - 1}")),
        inputs=(given,),
    )
    return by_route("lagrange", scene)


@pytest.fixture
def row() -> Callable[..., Linear]:
    """Linear equations of a row of masses about rest."""

    def make(masses: tuple, stiffnesses: tuple, dampings: tuple = ()) -> Linear:
        equations = oscillators(tuple(masses), tuple(stiffnesses), tuple(dampings))
        return linearize(equations, {q.name: 0 for q in equations.scene.q}, {"F": 0})

    return make


@pytest.fixture
def constants() -> tuple:
    """m, k, c with typical values."""
    return parameters("m k c", units="kg N/m N*s/m", typical="2 3 1/5")


@pytest.fixture
def gain() -> tuple:
    """A gain that may have any sign, and a reference."""
    return symbols("K r", real=True)
