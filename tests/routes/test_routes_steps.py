"""Derivations for people: each line states what its heading says, whatever the route."""

import re
from dataclasses import replace
from itertools import pairwise

import pytest
from linkages import slider_crank
from serial_arms import serial_arm
from sympy import Add, Expr, Matrix, Symbol, cos, expand, simplify
from sympy import symbols as symbols_

from mechanics.equations import Term
from mechanics.errors import SingularError
from mechanics.kinematics.printer import Printer, symbols
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.report.projection import View, closed
from mechanics.routes import free_body, kane
from mechanics.routes.derivation import ROUTES, by_route, goal_of, is_written_out, steps_of
from mechanics.routes.multipliers import meanings
from mechanics.routes.steps.writer import Writer, combination, multiplied_out
from mechanics.scene import Scene, reaction
from mechanics.symbolic.decide import prove_zero
from systems import (
    ALL,
    atwood,
    cartpole_friction,
    elastic_pendulum,
    four_bar,
    rocker,
    rod_pendulum,
    rolling_disc,
    two_mass_chain,
)

SMALL = (elastic_pendulum.scene, rocker.scene, rod_pendulum.scene, two_mass_chain.scene)
REFERENCE = re.compile(r"\(([A-Z]\d+)\)")


def value(side: object) -> Expr:
    return Add(*(term.value for term in side)) if isinstance(side, tuple) else side


def on_the_motion(scene: Scene) -> dict[Symbol, Expr]:
    """Accelerations, and reactions with these put in, by a route of another kind."""
    lagrange, bodies = by_route("lagrange", scene), by_route("free_body", scene)
    table = dict(zip(scene.ud, lagrange.mass.LUsolve(lagrange.forcing), strict=True))
    return table | {symbol: e.xreplace(table) for symbol, e in bodies.reactions}


@pytest.mark.sample(4)
@pytest.mark.parametrize("make", SMALL, ids=lambda make: make().name)
@pytest.mark.parametrize("route", ROUTES, ids=lambda route: route.name)
def test_every_equation_of_a_derivation_holds_along_every_motion(route, make) -> None:
    scene = make()
    motion = on_the_motion(scene)
    lines = [line for step in steps_of(route.derive(scene)) for line in step.lines]
    stated = [line for line in lines if not isinstance(line.left, str)]
    assert stated
    for line in stated:
        left, right = (value(side).xreplace(motion) for side in (line.left, line.right))
        assert prove_zero(line.number, left - right).shown, (line.number, line.label)


@pytest.mark.campaign
def test_lagrange_with_declared_speeds_has_no_gap() -> None:
    """The rolling disc: each line holds along the motion, and the last row is (E1) itself."""
    scene = rolling_disc.scene()
    equations = by_route("lagrange", scene)
    rates = dict(scene.coordinate_rates)
    matrix = Matrix(list(rates.values()))
    turned = matrix.jacobian(scene.q) * matrix + matrix.jacobian(scene.u) * Matrix(scene.ud)
    table = rates | {
        Symbol(rate.name.replace("_dot", "_ddot"), real=True): value
        for rate, value in zip(rates, turned, strict=True)
    }
    steps = steps_of(equations)
    lines = [line for step in steps for line in step.lines]
    for line in lines:
        if not isinstance(line.left, str | tuple) and line.left in table:
            assert simplify(table[line.left] - line.right.xreplace(rates)) == 0
    (row,) = next(step for step in steps if step.title == "Lagrange's equations").lines
    first = steps[-1].lines[0]
    assert simplify(value(row.left) - value(first.left) + value(first.right)) == 0
    assert "(E1) is (L18)" in steps[-1].text
    by_lean, growth, slope = lines[4:7]
    moving = by_lean.right.diff
    total = sum(
        moving(q) * rate + moving(rate) * Symbol(rate.name.replace("_dot", "_ddot"), real=True)
        for q, rate in zip(scene.q, rates, strict=True)
    )
    assert simplify(total - growth.right) == 0
    energy = value(lines[1].right) - lines[2].right
    assert simplify(energy.diff(scene.q[3]) - slope.right) == 0


CONSTRAINED = (four_bar.scene, cartpole_friction.scene)


@pytest.mark.parametrize(
    "make",
    [*SMALL, *(pytest.param(make, marks=pytest.mark.campaign) for make in CONSTRAINED)],
    ids=lambda make: make().name,
)
def test_all_routes_end_in_one_form_and_say_how(make) -> None:
    scene = make()
    derived = [route.derive(scene) for route in ROUTES]
    goal = goal_of(derived)
    for equations in derived:
        last = steps_of(equations, goal)[-1]
        assert last.lines == goal
        derived_here = goal[: len(goal) - len(scene.constraints)]
        assert {line.number for line in derived_here} <= set(REFERENCE.findall(last.text))


def test_a_rate_is_shown_by_the_chain_rule_before_it_is_collected() -> None:
    scene = rocker.scene()
    lines = [x for s in steps_of(by_route("moving_point", scene)) for x in s.lines]
    spin, *_ = [x for x in lines if x.left == "H_{B}" and "collected" in x.label]
    assert spin.label == r"collected; $\sin^{2} <<theta>> + \cos^{2} <<theta>> = 1$"
    first, second = [x for x in lines if x.left == r"\dot{H}_{B}"]
    (theta,), (rate,), (acceleration,) = scene.q, scene.qd, scene.ud
    by_hand = spin.right.diff(theta) * rate + spin.right.diff(rate) * acceleration
    assert expand(value(first.right) - by_hand) == 0
    assert expand(value(second.right) - by_hand) == 0
    (crossed,) = [x for x in lines if x.between]
    assert crossed.between == "v_{B,{x}} p_{y} - v_{B,{y}} p_{x}"


@pytest.mark.parametrize("make", SMALL, ids=lambda make: make().name)
@pytest.mark.parametrize("route", ["moving_point", "kane"])
def test_what_loads_do_is_a_product_before_it_is_multiplied_out(route, make) -> None:
    lines = [x for step in steps_of(by_route(route, make())) for x in step.lines]
    pairs = [
        (one, two)
        for one, two in pairwise(lines)
        if isinstance(one.left, str) and one.left == two.left and "multiplied" in two.label
    ]
    for one, two in pairs:
        assert expand(value(one.right) - value(two.right)) == 0
        assert [t.source for t in one.right] == [t.source for t in two.right]
    assert len(pairs) == (make is not two_mass_chain.scene)  # which has no moments


@pytest.mark.sample(4)
@pytest.mark.parametrize("make", SMALL, ids=lambda make: make().name)
@pytest.mark.parametrize("route", ROUTES, ids=lambda route: route.name)
def test_a_reference_leads_back(route, make) -> None:
    steps = steps_of(route.derive(make()))
    before: set[str] = set()
    for step in steps[:-1]:
        for line in step.lines:
            assert set(REFERENCE.findall(line.label)) <= before
            assert line.number not in before
            before.add(line.number)
    said = set(REFERENCE.findall(steps[-1].text))
    assert said - {line.number for line in steps[-1].lines} <= before


@pytest.mark.sample(4)
@pytest.mark.parametrize("make", SMALL, ids=lambda make: make().name)
@pytest.mark.parametrize("route", ROUTES, ids=lambda route: route.name)
def test_no_letter_stands_for_two_things(route, make) -> None:
    scene = make()
    taken = set(symbols(scene))
    for step in steps_of(route.derive(scene)):
        for line in step.lines:
            if isinstance(line.left, str):
                assert line.left not in taken
                assert re.sub(r"[_^].*", "", line.left) not in taken - {"f"}


@pytest.mark.campaign
def test_a_point_whose_name_is_words_has_a_letter_in_formulas() -> None:
    """The pins of a four-bar linkage, by the reactions in them."""
    lines = [x for step in steps_of(by_route("free_body", four_bar.scene())) for x in step.lines]
    arms = {line.left: line.label for line in lines if str(line.left).startswith(r"\vec{r}_{G")}
    assert arms[r"\vec{r}_{GB}"] == "from $G$ to $B$, the end of the crank"
    assert not any(" of " in str(line.left) for line in lines)


def test_accelerations_lead_with_plus_and_inputs_stand_on_the_right() -> None:
    scene = rocker.scene()
    (line,) = goal_of([by_route("free_body", scene)])
    (theta,), (acceleration,), (force,) = scene.q, scene.ud, scene.input_symbols
    first, *others = line.left
    assert first.value.coeff(acceleration).subs(theta, 0).is_positive
    assert expand(value(line.right) - rocker.R * (1 + cos(theta) / 2) * force) == 0
    assert not any(term.value.has(force, acceleration) for term in others)


def test_what_cancels_is_nothing_and_the_rest_is_all() -> None:
    x, y = symbols_("x y")
    terms = (Term(x * (x + y), "one"), Term(-x * y + y), Term(2 * y))
    products = multiplied_out(terms)
    assert Add(*(t.value for t in products if t.cancels)) == 0
    assert {t.value for t in products if t.cancels} == {x * y, -x * y}
    assert expand(value(products) - value(terms)) == 0
    assert products[0].source == "one"


def test_a_row_that_is_no_combination_is_not_called_one() -> None:
    scene = elastic_pendulum.scene()
    equations = by_route("lagrange", scene)
    goal = goal_of([equations])
    writer = Writer(Printer(scene, equations.mechanism), equations.mechanism, goal, {})
    rows = [value(line.left) - value(line.right) for line in goal]
    mixed = [rows[0] - 2 * rows[1], rows[1]]
    assert combination(rows, mixed, writer) == [[1, 2], [0, 1]]
    assert combination(rows, [rows[0] + scene.q[0], rows[1]], writer) is None
    assert combination(rows, [rows[0], cos(scene.q[1]) * rows[1]], writer) is None


@pytest.mark.campaign
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_every_system_that_is_written_out_has_its_steps(system) -> None:
    scene = getattr(system.scene(), "scene", system.scene())
    if not is_written_out(lower(scene, Builder())):
        pytest.skip("too large to be written out")
    for route in ROUTES:
        steps = steps_of(route.derive(scene))
        assert len(steps) > 1
        assert steps[-1].title == "Equations of motion"


def test_energies_of_a_rod_on_a_pivot() -> None:
    scene = rod_pendulum.scene()
    energies, *_ = steps_of(by_route("lagrange", scene))
    kinetic, stored = (
        value(line.right) for line in energies.lines if line.label.endswith("energy")
    )
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


def test_mass_centres_without_a_letter_get_a_free_one() -> None:
    """The names of joints are words: no mass centre is called 1."""
    scene = slider_crank("slider")
    printer = Printer(scene, mechanism := lower(scene, Builder()))
    writer = Writer(printer, mechanism, (), {})
    labels = [writer.centre(index) for index in range(len(mechanism.bodies))]
    assert len(set(labels)) == len(labels)
    assert not any(label.isdigit() for label in labels)
    points = {point.name for point in mechanism.points}
    own = [mechanism.points[body.centre].name for body in mechanism.bodies]
    assert all(
        label == name or label not in points for label, name in zip(labels, own, strict=True)
    )


@pytest.mark.parametrize("scene", [four_bar.scene(), rolling_disc.scene(), atwood.scene()])
def test_a_multiplier_is_the_reaction_that_it_is_said_to_be(scene: Scene) -> None:
    """The rows of Lagrange and those of the moving point give both: they agree on the motion."""
    said = meanings(lower(scene, Builder()))
    assert len(said) == len(scene.constraints)
    start, values = View(scene, closed(scene, scene.example)).values, {}
    for route in ("lagrange", "moving_point"):
        equations = by_route(route, scene)
        left, right = (side.subs(start).evalf() for side in equations.system)
        solved = left.LUsolve(right)
        values |= {s.name: v for s, v in zip(equations.unknowns, solved, strict=True)}
    for name, (sign, force, _) in said.items():
        assert abs(values[name] - sign * values[force]) < 1e-9 * (1 + abs(values[force]))


def test_a_multiplier_keeps_its_meaning_where_points_meet_only_in_a_closed_loop() -> None:
    said = meanings(lower(slider_crank("slider"), Builder()))
    assert {name: force for name, (_, force, _) in said.items()} == {
        "lambda1": "Qx", "lambda2": "Qy",
    }  # fmt: skip
