"""Derivations for people: each line states what its heading says, whatever the route."""

from dataclasses import replace

import pytest
from linkages import slider_crank
from serial_arms import serial_arm
from sympy import Expr, Symbol, cos, expand, simplify

from mechanics.errors import SingularError
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes import free_body, kane
from mechanics.routes.derivation import ROUTES, by_route, is_written_out, steps_of
from mechanics.scene import Scene, reaction
from mechanics.scene.rates import rate_table
from systems import elastic_pendulum, four_bar, rod_pendulum


def rate(scene: Scene, e: Expr) -> Expr:
    return sum(e.diff(symbol) * change for symbol, change in rate_table(scene).items())


@pytest.mark.parametrize("route", ROUTES, ids=lambda route: route.name)
def test_a_route_shows_its_steps_and_then_the_result(route) -> None:
    equations = route.derive(rod_pendulum.scene())
    *before, last = steps_of(equations)
    assert before
    assert all(step.lines for step in before if step.title != "Free bodies and moment centres")
    assert last == equations.result
    told = replace(equations, mechanism=None, rows=None)
    assert steps_of(told) == (told.result,)


@pytest.mark.campaign
def test_each_reaction_is_eliminated_once_and_told_by_others() -> None:
    equations = by_route("free_body", elastic_pendulum.scene())
    (step,) = (step for step in steps_of(equations) if step.title == "Elimination")
    lefts = [line.left for line in step.lines]
    assert all(isinstance(left, Symbol) for left in lefts)
    assert {str(left) for left in lefts} == {r.name for r in equations.scene.reactions}
    assert len(set(lefts)) == len(lefts)
    assert all(line.left not in line.right.free_symbols for line in step.lines)


@pytest.mark.parametrize("make", [elastic_pendulum.scene, rod_pendulum.scene])
def test_rates_of_momenta_are_their_derivatives(make) -> None:
    scene = make()
    (_, terms, _) = steps_of(by_route("moving_point", scene))
    names = {"P": r"\dot P", "H_B": r"\dot H_B"}
    pairs = [
        (one, two)
        for one, two in zip(terms.lines, terms.lines[1:], strict=False)
        if one.left in names
    ]
    assert len(pairs) == len(scene.u)
    for momentum, change in pairs:
        assert change.left == names[momentum.left]
        assert simplify(rate(scene, momentum.right) - change.right) == 0


def test_energies_of_a_rod_on_a_pivot() -> None:
    scene = rod_pendulum.scene()
    (energies, _) = steps_of(by_route("lagrange", scene))
    kinetic, stored = (line.right for line in energies.lines)
    m, l, g = rod_pendulum.m, rod_pendulum.l, rod_pendulum.g
    (theta,), (theta_dot,) = scene.q, scene.qd
    assert expand(simplify(kinetic - m * l**2 * theta_dot**2 / 6)) == 0
    assert expand(stored - m * g * l / 2 * cos(theta)) == 0


@pytest.mark.parametrize(
    ("make", "speeds"),
    [(four_bar.scene, ("q2_dot", "q3_dot")), (lambda: slider_crank("slider"), ("b_dot", "x_dot"))],
)
def test_the_last_speeds_are_those_that_depend_on_the_others(make, speeds) -> None:
    mechanism = lower(make(), Builder())
    own = kane.with_dependent_speeds(mechanism, kane.derive(mechanism))
    assert own.chosen == tuple(f"dependent speed {name}" for name in speeds)
    assert len(own.values) == len(mechanism.u) - len(mechanism.constraints)
    assert own.multipliers == ()


def test_a_reaction_that_no_row_determines_is_named() -> None:
    scene = rod_pendulum.scene()
    twice = reaction("Z", at=scene.origin, on="rod", by=None, along=scene.frame.x)
    redundant = replace(scene, reactions=(*scene.reactions, twice))
    with pytest.raises(SingularError, match=r"reactions Z: no momentum equation determines them"):
        free_body.derive(lower(redundant, Builder()))


@pytest.mark.parametrize(("count", "readable"), [(1, True), (3, True), (4, False)])
def test_up_to_three_bodies_in_space_are_written_out(count: int, readable: bool) -> None:
    assert is_written_out(lower(serial_arm(count).scene, Builder())) is readable
