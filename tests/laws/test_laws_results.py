"""What a derivation ends with: M u' = f + B lambda and A u' = b, and the multipliers solved."""

import pytest
import shared_scenes
from sympy import Add, Expr, Matrix, Rational, S, ordered

import mechanics
from mechanics.checks.manifold import project
from mechanics.checks.solution import solve
from mechanics.crosscheck import ROUTES, Route
from mechanics.equations import Side
from mechanics.routes.derivation import by_route, steps_of
from mechanics.routes.multipliers import multipliers_of
from mechanics.scene.system import System
from mechanics.symbolic import Arithmetic, Number, decide
from systems import ALL, SEED

CONSTRAINED = [system for system in ALL if system.name in shared_scenes.CONSTRAINED]


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("route", ROUTES, ids=lambda route: route.name)
@pytest.mark.parametrize("system", CONSTRAINED, ids=lambda system: system.name)
def test_the_last_step_states_all_equations(system: System, route: Route) -> None:
    equations = route.derive(system.scene())
    step = steps_of(equations)[-1]
    # Rows of the method or combinations of them: as many, constraints included, independent.
    differences = [_sum(line.left) - _sum(line.right) for line in step.lines]
    lagrange = by_route("lagrange", system.scene())
    unknown = lagrange.unknowns
    matrix = Matrix(differences).jacobian(unknown)
    drawn = {s: Rational(k + 2, 7) for k, s in enumerate(ordered(matrix.free_symbols))}
    assert len(differences) == matrix.subs(drawn).evalf(30).rank() == len(unknown)

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project(a, equations.kinematics)
        # The multipliers that all routes end with are Lagrange's; the motion is the route's own.
        numbers = zip(unknown, solve(a, lagrange), strict=True)
        own = dict(zip(equations.unknowns, solve(a, equations), strict=True))
        for symbol, number in numbers:
            a.assign(symbol, own.get(symbol, number))
        return [(a.value(difference), a.value(S.Zero)) for difference in differences]

    assert decide("lines", experiment, try_normal=False).shown
    named = [line.label for line in step.lines if line.label]
    assert named == [constraint.name for constraint in equations.scene.constraints]
    held = set().union(*(_sum(line.right).free_symbols for line in step.lines))
    assert held.issuperset(lagrange.multipliers)


def _sum(side: Side) -> Expr:
    """The value of a side that is stated term by term."""
    return Add(*(term.value for term in side)) if isinstance(side, tuple) else side


@pytest.mark.parametrize("system", CONSTRAINED, ids=lambda system: system.name)
def test_multipliers_are_given_by_the_motion(system: System) -> None:
    scene = system.scene()
    equations = by_route("free_body", scene)

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project(a, equations.kinematics)
        for unknown, number in zip(equations.unknowns, solve(a, equations), strict=True):
            a.assign(unknown, number)
        return [(a.value(symbol), a.value(value)) for symbol, value in multipliers_of(equations)]

    assert {symbol for symbol, _ in multipliers_of(equations)} == set(equations.multipliers)
    assert decide("multipliers", experiment, try_normal=False).shown


@pytest.mark.campaign
def test_what_is_made_of_a_scene_says_in_one_short_line_what_it_is() -> None:
    system = SEED[0]
    scene = system.scene()
    equations = mechanics.derive(scene, "kane")
    result = mechanics.crosscheck(scene, mechanics.CrossCheck(states=0))
    for thing in (system, scene, equations, mechanics.compile(equations), result):
        assert len(repr(thing)) < 120 and "\n" not in repr(thing)
        assert scene.name in repr(thing) or system.name in repr(thing)
