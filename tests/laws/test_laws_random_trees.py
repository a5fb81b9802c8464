"""Random planar trees of bodies: four routes agree, and energy is accounted for."""

from dataclasses import dataclass

import pytest
from every_route import derive_with
from hypothesis import given, seed, settings
from hypothesis import strategies as st
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.compiled import compile, prove_graph
from mechanics.crosscheck.programs import check_laws, check_textbook, derive_rows
from mechanics.routes.derivation import by_route
from mechanics.scene import (
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torsion_spring,
)


@dataclass(frozen=True)
class Link:
    """One body: its parent (0 is the ground), its joint, the axes of its reactions, its load."""

    parent: int
    pivot: bool
    turned: bool
    load: str


LOADS = ("nothing", "spring", "rail spring", "damper", "torsion spring", "follower force")


@st.composite
def trees(draw: st.DrawFn) -> tuple[Link, ...]:
    return tuple(
        Link(
            draw(st.integers(0, i)),
            draw(st.booleans()),
            draw(st.booleans()),
            draw(st.sampled_from(LOADS)),
        )
        for i in range(draw(st.integers(2, 4)))
    )


def build(links: tuple[Link, ...]) -> Scene:
    N, O = ReferenceFrame("N"), Point("O")
    (g,) = parameters("g")
    frames, points, names, turns = [N], [O], [None], [False]
    q = dynamicsymbols(f"q1:{len(links) + 1}")
    bodies, reactions, loads = [], [], [gravity(-g * N.y)]
    for i, link in enumerate(links, start=1):
        m, I, a, l, k = parameters(f"m{i} I{i} a{i} l{i} k{i}")
        outer, name = frames[link.parent], f"body{i}"
        joint = points[link.parent].locatenew(f"J{i}", a * outer.x)
        if link.pivot:
            frame = outer.orientnew(f"A{i}", "Axis", (q[i - 1], N.z))
            centre = joint.locatenew(f"C{i}", -l * frame.y)
        else:
            frame, centre = outer, joint.locatenew(f"C{i}", q[i - 1] * outer.x)
        held = [outer.x, outer.y] if link.pivot else [outer.y]
        if link.pivot and link.turned:
            held = [frame.x, frame.y]
        at = joint if link.pivot else centre
        inner = names[link.parent]
        for axis, along in zip("XY", held, strict=False):
            reactions.append(reaction(f"{axis}{i}", at, name, inner, along))
        turns.append(turns[link.parent] or link.pivot)
        if not link.pivot and turns[-1]:
            reactions.append(reaction_couple(f"Q{i}", name, inner, N.z))
        bodies.append(RigidBody(name, centre, frame, m, I))
        if link.load == "spring":
            loads.append(spring(f"s{i}", O.locatenew(f"W{i}", a * N.y), centre, k, length=l))
        elif link.load == "rail spring":
            loads.append(spring(f"s{i}", O, centre, k, along=N.x))
        elif link.load == "damper":
            loads.append(damper(f"d{i}", O, centre, k, along=N.y))
        elif link.load == "torsion spring" and link.pivot:
            loads.append(torsion_spring(f"t{i}", q[i - 1], N.z, k, name, inner))
        elif link.load == "follower force":
            loads.append(force(f"f{i}", joint, k * frame.x, name, inner))
        frames.append(frame)
        points.append(centre)
        names.append(name)
    return Scene("tree", N, O, tuple(q), tuple(bodies), tuple(loads), tuple(reactions))


@pytest.mark.sample(1)
@pytest.mark.parametrize("part", range(5))
def test_random_trees(part: int) -> None:
    @seed(part)
    @settings(max_examples=4)
    @given(trees())
    def assert_routes_agree(links: tuple[Link, ...]) -> None:
        scene = build(links)
        routes = derive_with(scene)
        programs = derive_rows(check_scene(scene), tuple(routes))
        findings = [*compare_pairs(programs.routes).values(), *check_laws(programs)]
        findings += check_textbook(programs, routes)
        assert not [finding for finding in findings if not finding.shown]

    assert_routes_agree()


@pytest.mark.campaign
@settings(max_examples=8)
@given(trees())
def test_forward_dynamics_from_the_bodies_is_what_was_derived(links: tuple[Link, ...]) -> None:
    model = compile(by_route("free_body", build(links)), form="recursive", compiler=None)
    finding = prove_graph("forward_dynamics", model.casadi, try_normal=False)
    assert finding.shown, finding
