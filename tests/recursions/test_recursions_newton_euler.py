"""Newton and Euler's recursion has Kane's rows, on every system and on random trees."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from benchmarks.space import scenes
from benchmarks.space.counting import count
from benchmarks.space.random_trees import build, numbers, state, trees
from benchmarks.space.scenes import Joint
from benchmarks.space.textbook import inverse_dynamics
from mechanics.mechanism import Mechanism, Mixed, lower
from mechanics.program import Builder, interpret
from mechanics.program.interpret import include
from mechanics.program.numpy_domain import Arrays
from mechanics.program.residues import Residues
from mechanics.program.vectors import times, transpose
from mechanics.recursions import newton_euler
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes import kane
from mechanics.routes.rows import substitute
from systems import ALL, VARIANTS

PHASES = (Phase.explicit, Phase.generate)
"""Trees are small already, and shrinking builds hundreds of scenes."""
MOMENTS = (moments, grouped)


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", [*ALL, *VARIANTS], ids=lambda system: system.name)
@pytest.mark.parametrize("masses", MOMENTS)
def test_the_rows_are_kanes(system, masses) -> None:
    mechanism = lower(system.scene(), Builder())
    filter_ = Residues(mechanism.builder)
    rows = newton_euler.rows(mechanism, masses(mechanism))
    right = kane.derive(mechanism)
    # The recursion's rows hold the reactions that press; Kane's say what these are.
    pressing = {mechanism.builder.input(name): value for name, value in right.reactions.items()}
    rows = substitute(mechanism.builder, rows, pressing)
    assert len(rows) == len(mechanism.u)
    differences = [a - b for a, b in zip(rows, right.values, strict=True)]
    assert [filter_.is_zero(entry) for entry in differences] == [True] * len(rows)


@pytest.mark.campaign
@settings(max_examples=20, deadline=None, derandomize=True, phases=PHASES)
@given(trees(), st.integers(0, 2**32))
def test_random_trees_have_kanes_rows_and_the_textbooks_torques(
    joints: tuple[Joint, ...], seed: int
) -> None:
    mechanism = lower(build(joints), Builder())
    filter_ = Residues(mechanism.builder)
    right = kane.derive(mechanism).values
    links, values = numbers(joints, seed)
    q, qd, qdd, at = state(len(joints), seed + 1)
    tau = inverse_dynamics(links, q, qd, qdd, values["g"])
    sizes = inverse_dynamics(links, q, qd, qdd, values["g"], sizes=True)
    for masses in MOMENTS:
        rows = newton_euler.rows(mechanism, masses(mechanism))
        assert all(filter_.is_zero(a - b) for a, b in zip(rows, right, strict=True))
        program = mechanism.builder.program({"tau": rows})
        (found,) = interpret(program, Arrays(), values | at).values()
        np.testing.assert_array_less(
            np.abs(np.array(found, dtype=float) - tau), 64 * np.finfo(float).eps * sizes + 1e-300
        )


def operations(mechanism: Mechanism) -> tuple[int, int]:
    rows = newton_euler.rows(mechanism, grouped(mechanism))
    program = mechanism.builder.program({"tau": rows})
    state = {f"q{i}{dots}" for i in range(1, 8) for dots in ("", "_dot", "_ddot")}
    found = count(program, {*program.inputs} - state)
    return found.multiplications, found.additions


def test_arms_cost_no_more_than_symbolic_packages_say() -> None:
    """SymPyBotics takes 345 + 296 for the first and 415 + 354 for the second."""
    first = operations(lower(scenes.puma560(), Builder()))
    assert first[0] <= 300 and first[1] <= 260
    second = operations(lower(scenes.panda(), Builder()))
    assert second[0] <= 380 and second[1] <= 330


@pytest.mark.campaign
def test_a_chain_costs_no_more_than_its_recursion() -> None:
    mechanism = lower(scenes.chain(10), Builder())
    rows = newton_euler.rows(mechanism, moments(mechanism))
    assert mechanism.builder.program({"tau": rows}).count <= 293


@pytest.mark.campaign
@settings(max_examples=10, deadline=None, derandomize=True, phases=PHASES)
@given(trees(), st.integers(0, 2**32), st.data())
def test_numbers_for_symbols_make_no_count_larger(
    joints: tuple[Joint, ...], seed: int, data: st.DataObject
) -> None:
    """Some lengths, masses and moments as numbers, the rest as symbols."""
    mechanism = lower(build(joints), Builder())
    rows = newton_euler.rows(mechanism, grouped(mechanism))
    symbols = mechanism.builder.program({"tau": rows})
    _, values = numbers(joints, seed)
    names = sorted(values.keys() & {*symbols.inputs})
    bound = data.draw(st.sets(st.sampled_from(names)) if names else st.just(set()))
    other = Builder()
    given = {name: other.constant(values[name]) for name in bound}
    figures = other.program(include(other, symbols, given))
    free, less = count(symbols, values), count(figures, values)
    assert less.total <= free.total
    assert less.total + less.parameters <= free.total + free.parameters


def test_steps_in_the_frames_at_hand_cost_the_same() -> None:
    """x in the frame of the link, the rest in one that is fixed in it: the same arm."""
    plain = lower(scenes.puma560(), Builder())
    fixed = {frame.parent: i for i, frame in enumerate(plain.frames) if frame.turn is None}

    def split(step: Mixed) -> Mixed:
        found: list = []
        for frame, (x, y, z) in step:
            zero = plain.builder.zero
            if frame not in fixed:
                return step
            back = transpose(plain.frames[fixed[frame]].rotation)
            found += [(frame, (x, zero, zero)), (fixed[frame], times(back, (zero, y, z)))]
        return tuple(found)

    points = [replace(place, step=split(place.step)) for place in plain.points]
    mixed = replace(plain, points=tuple(points))
    assert mixed.points != plain.points
    filter_ = Residues(plain.builder)
    one, two = (newton_euler.rows(m, grouped(m)) for m in (plain, mixed))
    assert all(filter_.is_zero(a - b) for a, b in zip(one, two, strict=True))
    assert operations(mixed) == operations(plain)
