"""Free-body diagrams: what acts on a body that is cut free, and nothing else."""

import re

import numpy as np
import pytest
from particles import on_a_spring
from sympy import Symbol

from mechanics.equations import Diagram, Equations
from mechanics.report.free_body import Arrow, arrows, free_body_diagram
from mechanics.report.projection import View
from mechanics.routes.derivation import by_route, steps_of
from systems import acrobot, atwood, double_pendulum, elastic_pendulum, four_bar, rocker

SCENES = (elastic_pendulum, rocker, acrobot, double_pendulum, four_bar)


def drawn(make) -> tuple[Equations, View, tuple[tuple[Arrow, ...], ...]]:
    scene = make.scene()
    equations = by_route("free_body", scene)
    view = View(scene, scene.example)
    return equations, view, arrows(equations, view)


@pytest.mark.parametrize("make", SCENES, ids=lambda make: make.__name__)
def test_a_pair_is_equal_and_opposite_and_of_one_colour(make) -> None:
    equations, _, found = drawn(make)
    between = {r.name for r in equations.scene.reactions if r.by is not None}
    pairs = [group for group in found if group[0].source in between]
    assert len(pairs) == len(between)
    for one, other in pairs:
        assert np.allclose(one.force, -other.force)
        assert np.allclose(one.couple, -other.couple)
        assert one.colour == other.colour
        assert one.body != other.body


@pytest.mark.parametrize("make", SCENES, ids=lambda make: make.__name__)
def test_a_reaction_points_as_it_is_declared(make) -> None:
    equations, view, found = drawn(make)
    scene = equations.scene
    for reaction in scene.reactions:
        own = next(a for g in found for a in g if a.source == reaction.name)
        declared = view.numbers(scene.vector(reaction.along)).ravel()
        at = own.force if reaction.at is not None else own.couple
        assert np.allclose(at, declared)
        assert scene.bodies[own.body].name == reaction.on


def test_the_arrows_on_all_bodies_sum_to_the_rates_of_momentum() -> None:
    """Newton's law for each body, with what is drawn: reactions and loads times their arrows."""
    equations, view, found = drawn(elastic_pendulum)
    scene = equations.scene
    accelerations = equations.mass.LUsolve(equations.forcing)
    motion = dict(zip(scene.ud, accelerations, strict=True))
    sizes = {str(s): view.number(e.xreplace(motion)) for s, e in equations.reactions}
    steps = steps_of(equations)
    lines = [
        line
        for step in steps
        if step.title == "Free bodies"
        for line in step.lines
        if line.between and "p" in line.between
    ]
    for line in lines:
        body = next(k for k, b in enumerate(scene.bodies) if line.label.startswith(b.name))
        axis = "xyz".index(line.label[-1])
        acting = [a for group in found for a in group if a.body == body]
        total = sum(sizes.get(a.source, 1.0) * a.force[axis] for a in acting)
        assert total == pytest.approx(view.number(line.right.xreplace(motion)), abs=1e-12)


def test_what_balances_inside_of_the_free_body_is_not_drawn() -> None:
    equations, view, found = drawn(elastic_pendulum)
    whole = free_body_diagram(equations, view, found, Diagram((0, 1), "whole system"))
    assert set(re.findall(r'class="of-(\w+) arrow', whole)) == {"N1", "k", "gravity"}
    one = free_body_diagram(equations, view, found, Diagram((1,), "pendulum"))
    assert set(re.findall(r'class="of-(\w+) arrow', one)) == {"T", "N", "gravity"}
    assert 'aria-label="Free-body diagram: pendulum, with gravity, ' in one


def test_the_moment_centre_is_marked_where_it_is() -> None:
    equations = by_route("moving_point", rocker.scene())
    view = View(equations.scene, equations.scene.example)
    (step,) = (s for s in steps_of(equations) if s.diagrams)
    (diagram,) = step.diagrams
    assert diagram.centre == "B"
    picture = free_body_diagram(equations, view, arrows(equations, view), diagram)
    (ring,) = re.findall(r'class="centre" cx="([\d.]+)" cy="([\d.]+)"', picture)
    pushing = re.search(
        r'of-N arrow r1"><polyline class="own" points="\S+ ([\d.]+),([\d.]+)"', picture
    )
    assert pushing is not None
    assert ring == pushing.groups()


def test_a_load_has_its_size_where_that_is_short() -> None:
    _, _, found = drawn(elastic_pendulum)
    labels = {a.source: re.sub(r"<[^>]*>", "", a.label) for group in found for a in group}
    assert labels["k"] == "2kx"
    assert {re.sub(r"<[^>]*>", "", a.label) for a in found[0]} <= {"mg", "Mg"}
    assert Symbol(labels["T"]).name == "T"


@pytest.mark.parametrize("body", range(4))
def test_arrows_on_a_body_that_is_drawn_aside_are_on_it(body: int) -> None:
    """All masses of Atwood's machine are declared on one line, and drawn beside each other."""
    equations, view, found = drawn(atwood)
    name = equations.scene.bodies[body].name
    picture = free_body_diagram(equations, view, found, Diagram((body,), name))
    arrows = re.findall(r'class="own" points="(\S+),(\S+) (\S+),(\S+)"', picture)
    assert len(arrows) == 2
    ball = re.search(r'class="mass" cx="(\S+)" cy="(\S+)"', picture)
    block = re.search(r'class="body" points="([^"]*)"', picture)
    corners = [pair.split(",") for pair in block[1].split()] if block else [ball.groups()]
    centre = np.array(corners, dtype=float).mean(axis=0)
    for arrow in arrows:
        start, end = np.array(arrow, dtype=float).reshape(2, 2)
        assert min(np.hypot(*(start - centre)), np.hypot(*(end - centre))) < 1


def test_a_spring_without_length_has_an_arrow_where_it_has_some() -> None:
    equations = by_route("free_body", on_a_spring())
    for group in arrows(equations, View(equations.scene, equations.scene.example)):
        assert all(np.isfinite(arrow.force).all() and arrow.force.any() for arrow in group)
