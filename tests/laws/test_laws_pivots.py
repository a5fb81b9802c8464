"""Accelerations of constrained scenes keep their digits at every regular state.

    [[M, -A^T], [A, 0]] (u', mu) = (f, b)        exact at the state of doubles, in balls

A pivot that was chosen in advance may vanish where the system is regular: where a crank stands
upright, or a rod and a crank are in line. States are closed exactly from drawn ones in which a
coordinate is there, or next to it.
"""

from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import pytest
import shared_scenes

import mechanics
from mechanics.checks.admissible import check_scene
from mechanics.closure import closed_state
from mechanics.crosscheck.routes import named_routes
from mechanics.kernel import enclose
from mechanics.mechanism import Mechanism, name_of
from mechanics.program import Program
from mechanics.routes import kane
from mechanics.routes.rows import acceleration_forms, coefficients, remainder, velocity_forms
from systems import EVERY, four_bar_chain

CONSTRAINED = {s.name: s for s in EVERY if s.name in shared_scenes.CONSTRAINED}
LONG = {"andrews", "bicycle"}
BITS = 300
EPS = float(np.finfo(float).eps)
OFFSETS = (0.0, 1e-12, 1e-9, 1e-6, 1e-3)
LOST = 1e4
"""Roundings, times the condition: rows of one route may be scaled worse than those of K."""
SINGULAR = 1e7
"""Condition from which a state counts as singular."""


def states(mechanism: Mechanism) -> Iterator[dict[str, Fraction]]:
    """Closed states beside those in which one coordinate is a multiple of a right angle."""
    build, closure, random = mechanism.builder, mechanism.closure, np.random.default_rng(3)
    names = [*map(name_of, mechanism.u), *mechanism.signs, *map(name_of, mechanism.q)]
    for moved in mechanism.q:
        others = [q for q in mechanism.q if q != moved]
        for quarter in range(-1, 3):
            offset = float(random.choice(OFFSETS)) * float(random.choice((-1, 1)))
            start = {name: Fraction(float(random.uniform(0.5, 1))) for name in names}
            start |= closure.start
            start |= {name_of(q): Fraction(float(random.uniform(-1, 1))) for q in others}
            start[name_of(moved)] = Fraction(quarter * np.pi / 2 + offset)
            found = closed_state(build, closure.configuration, others, start)
            if found:
                closed = {name: Fraction(float(value)) for name, value in found.items()}
                yield closed | admissible_speeds(mechanism, closed)


def admissible_speeds(mechanism: Mechanism, state: dict[str, Fraction]) -> dict[str, Fraction]:
    """The speeds nearest to those of a state that the constraints admit."""
    forms = velocity_forms(mechanism)
    rows = [e for row in coefficients(forms, mechanism.u) for e in row]
    program = mechanism.builder.program({"A": rows, "off": forms})
    found = enclose(program, {name: state.get(name, Fraction(1)) for name in program.inputs}, BITS)
    off = np.array([float(entry) for entry in found["off"]])
    matrix = np.array([float(entry) for entry in found["A"]]).reshape(len(off), -1)
    change = np.linalg.lstsq(matrix, off, rcond=None)[0]
    names = map(name_of, mechanism.u)
    return {n: state[n] - Fraction(float(d)) for n, d in zip(names, change, strict=True)}


def system(mechanism: Mechanism) -> Program:
    """K, and x of K x = k."""
    rows = kane.derive(mechanism)
    unknowns = (*mechanism.ud, *rows.multipliers)
    every = [*rows.values, *acceleration_forms(mechanism)]
    matrix = coefficients(every, unknowns)
    right = [-entry for entry in remainder(mechanism.builder, every, unknowns)]
    solution = mechanism.builder.solve(matrix, right)
    return mechanism.builder.program({"K": [e for row in matrix for e in row], "x": solution})


@pytest.mark.campaign
@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=pytest.mark.long) if n in LONG else n for n in CONSTRAINED],
)
def test_accelerations_keep_their_digits_at_every_regular_state(name: str) -> None:
    scene = CONSTRAINED[name].scene()
    mechanism = check_scene(scene)
    program, regular = system(mechanism), 0
    models = {
        route.name: mechanics.compile(route.equations(scene, mechanism, route.rows(mechanism)))
        for route in named_routes(())
    }
    for state in states(mechanism):
        given = {name: state.get(name, Fraction(1)) for name in program.inputs}
        found = enclose(program, given, BITS)
        n = int(len(found["K"]) ** 0.5)
        matrix = np.array([float(entry) for entry in found["K"]]).reshape(n, n)
        condition = float(np.linalg.cond(matrix))
        if condition > SINGULAR:
            continue
        regular += 1
        right = np.array([float(entry) for entry in found["x"]])[: len(mechanism.u)]
        size = np.abs(right).max() + 1
        for route, model in models.items():
            known = model.quantities
            q, u, inputs, p = (
                [float(state.get(entry.name, Fraction(1))) for entry in group]
                for group in (known.q, known.u, known.inputs, known.p)
            )
            own = np.array(model.casadi["forward_dynamics"](q, u, inputs, p)[0]).ravel()
            error = np.abs(own - right).max() / size
            assert error < LOST * condition * EPS, (route, {k: float(v) for k, v in given.items()})
    assert regular


@pytest.mark.campaign
def test_states_at_which_an_entry_has_no_value_choose_no_pivot() -> None:
    """A warning would be an error: ten loops have entries that are quotients."""
    model = mechanics.compile(
        mechanics.derive(four_bar_chain.scene(10), "free_body"), compiler=None
    )
    assert model.program("forward_dynamics").operations > 0
