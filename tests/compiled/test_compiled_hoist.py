"""Forward dynamics in two parts: what depends on parameters only, and the rest."""

import casadi as ca
import numpy as np
import pytest

from mechanics.compiled import compile
from mechanics.compiled.programs.hoist import hoisted
from mechanics.compiled.sampling import sample
from mechanics.program.casadi_reader import read_routine
from mechanics.program.operations import INPUT
from mechanics.program.routine import Routine, routine, run

SYSTEMS = [
    ("elastic_pendulum", "kane"), ("rocker", "moving_point"), ("two_mass_chain", "free_body"),
    ("rolling_disc", "free_body"), ("four_bar", "kane"), ("pendulum_chain", "free_body"),
]  # fmt: skip
by_system = pytest.mark.parametrize(("system", "route"), SYSTEMS, ids=lambda x: x)


def inputs_of(code: Routine) -> set[int]:
    return {node.operands[0] for node in code.nodes if node.operation == INPUT}


@pytest.mark.sample(2)
@by_system
def test_the_parts_one_after_the_other_are_the_whole(modelled, system: str, route: str) -> None:
    model = modelled(system, route)
    q, u, inputs, p = sample(model.quantities, 200, seed=4, decades=1.0).groups
    state = {"q": q, "u": u, "inputs": inputs}
    truth = model.evaluate("forward_dynamics", p=p, **state)
    for kind, rtol in ((np.float64, 1e-9), (np.float32, 1e-5)):
        c = model.evaluate("prepare", kind, p=p)["c"]
        assert c.shape == (200, len(model.programs.constants)) and c.dtype == kind
        found = model.evaluate("forward_dynamics_prepared", kind, c=c, **state)
        whole = model.evaluate("forward_dynamics", kind, p=p, **state)
        for out, values in truth.items():
            if not values.size:
                continue
            size = np.abs(values).max(axis=1, initial=1e-30, keepdims=True)
            there = np.isfinite(whole[out]).all(axis=1)
            assert there.mean() > 0.9 and np.array_equal(there, np.isfinite(found[out]).all(axis=1))
            # Beside a disc that lies flat, single precision may give what double cannot.
            there &= np.isfinite(values).all(axis=1)
            errors = [
                np.quantile((np.abs(f[out] - values) / size)[there], 0.9) for f in (found, whole)
            ]
            # Where a state is nearly singular both lose digits, not the same ones.
            assert errors[0] <= 4 * errors[1] + rtol


@pytest.mark.sample(3)
@by_system
def test_where_nothing_is_divided_by_a_parameter_the_bits_are_the_same(
    modelled, system: str, route: str
) -> None:
    model = modelled(system, route)
    parts = model.programs.hoisted
    if parts.prepared.divisions < model.program("forward_dynamics").divisions:
        return
    q, u, inputs, p = sample(model.quantities, 50, seed=4, decades=1.0).groups
    c = model.evaluate("prepare", p=p)["c"]
    found = model.evaluate("forward_dynamics_prepared", q=q, u=u, inputs=inputs, c=c)
    whole = model.evaluate("forward_dynamics", q=q, u=u, inputs=inputs, p=p)
    for out, values in whole.items():
        np.testing.assert_array_equal(found[out], values)


@by_system
def test_all_that_can_be_hoisted_is(modelled, system: str, route: str) -> None:
    model = modelled(system, route)
    parts, whole = model.programs.hoisted, model.program("forward_dynamics")
    assert inputs_of(parts.prepare) == {0}
    assert parts.prepare.inputs[0] == ("p", len(model.entries["p"]))
    assert parts.prepared.operations <= whole.operations
    assert len(parts.names) == len(set(parts.names))
    # Constants in place of parameters: there is nothing left that depends on them only.
    groups = tuple(
        ("p", size) if name == "c" else (name, size) for name, size in parts.prepared.inputs
    )
    renamed = routine(
        "again", parts.prepared.nodes, parts.prepared.outputs, groups, parts.prepared.shapes
    )
    again = hoisted(renamed, {"p": parts.names})
    assert again.prepare.operations == 0
    assert len(again.names) == len(parts.names)


def test_what_is_divided_by_is_held_as_its_reciprocal() -> None:
    q, p = ca.SX.sym("q", 1), ca.SX.sym("p", 3)
    whole = ca.vertcat(q / (p[0] + p[1]), p[0] + p[1] + q, q / p[2], p[0] / p[1])
    code = read_routine(ca.Function("f", [q, p], [whole], ["q", "p"], ["out"]))
    parts = hoisted(code, {"q": ("x",), "p": ("a", "b", "c")})
    assert parts.prepared.divisions == 0 and parts.prepare.divisions == 3
    assert "over_c" in parts.names and "c" not in parts.names
    states = [[np.array(1.75)], [np.array(v) for v in (3.0, 0.25, 8.0)]]
    (c,) = run(parts.prepare, states[1:], np.float64)
    (found,) = run(parts.prepared, [states[0], c], np.float64)
    (expected,) = run(code, states, np.float64)
    np.testing.assert_allclose(np.array(found), np.array(expected), rtol=2**-51)


def test_without_parameters_there_are_no_parts(derived) -> None:
    equations = derived("two_mass_chain", "kane")
    model = compile(equations, fixed={"m": 1, "k": 1}, outputs=("forward_dynamics",))
    assert model.programs.constants == ()
    assert model.programs.written() == ("forward_dynamics",)


def test_both_parts_are_written_or_none(modelled) -> None:
    programs = modelled("elastic_pendulum", "kane").programs
    parts = ("prepare", "forward_dynamics_prepared")
    assert programs.written()[-2:] == parts and "energy" in programs.written()
    assert programs.written(["energy"]) == ("energy",)
    assert programs.written(["prepare", "energy"]) == ("energy", *parts)
    assert programs.written(["forward_dynamics"]) == ("forward_dynamics",)
