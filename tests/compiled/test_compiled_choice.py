"""Which form of forward dynamics is taken: by counted operations, among what rounds well."""

import dataclasses
from types import SimpleNamespace
from typing import Any

import casadi as ca
import numpy as np
import pytest

from mechanics.compiled import compile, prove_graph
from mechanics.compiled.forms.choice import full
from mechanics.compiled.forms.factor import solve_symmetric
from mechanics.compiled.forms.operations import operations
from mechanics.compiled.forms.weigh import MOST, ROUNDINGS, digits_lost, lightest
from mechanics.compiled.sampling import ordinary
from mechanics.compiled.translate import Translator
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import run
from mechanics.routes.derivation import by_route
from systems import SEED, pendulum_chain, quadrotor, spinning_top

pytestmark = pytest.mark.campaign

EXACT = Translator({}).exact

PEERS = {10: 595, 20: 1215, 50: 3075}
"""Instructions of the articulated-body algorithm for the cart with that many links."""


def chain(links: int) -> Any:
    equations = by_route("free_body", pendulum_chain.scene(links))
    return compile(equations, compiler=None, outputs=("forward_dynamics",))


def instructions(links: int) -> int:
    return int(chain(links).casadi["forward_dynamics"].n_instructions())


def test_operations_grow_linearly_with_the_links() -> None:
    """Every link takes the same number of instructions, so what 50 take follows from 10 and 11."""
    counts = {links: instructions(links) for links in (8, 9, 10, 11, 20)}
    link = counts[11] - counts[10]
    assert link <= 49
    assert counts[9] - counts[8] == counts[10] - counts[9] == link
    assert counts[20] == counts[10] + 10 * link
    for links, peer in PEERS.items():
        count = counts[10] + (links - 10) * link
        assert count <= 62 * links
        assert count <= 0.8 * peer


def test_fifty_links_are_derived_compiled_and_certified(unwritten: None) -> None:
    model = chain(50)
    assert model.form == "recursive"
    assert model.casadi["forward_dynamics"].n_instructions() <= 62 * 50
    found = prove_graph("forward_dynamics", model.casadi, try_normal=False)
    assert found.verdict is Verdict.CERTIFIED
    assert found.error_bound < 2.0**-80


def test_twenty_links_are_certified_and_never_written_out(unwritten: None) -> None:
    model = chain(20)
    assert model.form == "recursive"
    found = prove_graph("forward_dynamics", model.casadi, try_normal=False)
    assert found.verdict is Verdict.CERTIFIED


def test_the_seed_keeps_its_kernels() -> None:
    counts = {}
    for system in SEED:
        model = compile(by_route("kane", system.scene()), outputs=("forward_dynamics",))
        counts[system.name] = (model.form, model.program("forward_dynamics").operations)
    assert counts == {
        "elastic_pendulum": ("fewest", 22),
        "rocker": ("fewest", 18),
        "two_mass_chain": ("fewest", 7),
    }


@pytest.mark.sample(2)
@pytest.mark.parametrize("links", [3, 5, 8])
def test_what_is_taken_weighs_least(links: int) -> None:
    equations = by_route("kane", pendulum_chain.scene(links))
    models = {
        form: compile(equations, form=form, compiler=None).casadi
        for form in ("auto", "recursive", "elimination")
    }
    weights = {
        name: operations(known._solution) * 2 ** digits_lost(known.system.error(known._solution))
        for name, known in ((name, graphs.source.matrices) for name, graphs in models.items())
    }
    assert models["auto"].form == "recursive"
    assert weights["auto"] <= weights["recursive"] < weights["elimination"]


def test_the_size_of_a_full_system_is_what_elimination_takes() -> None:
    for n in (1, 2, 5, 9):
        entries = ca.SX.sym("a", n * (n + 1) // 2)
        matrix, k = ca.SX(n, n), 0
        for i in range(n):
            for j in range(i + 1):
                matrix[i, j] = matrix[j, i] = entries[k]
                k += 1
        assert operations(solve_symmetric(matrix, ca.SX.sym("b", n), EXACT)) == full(n)


def test_a_digit_lost_weighs_as_twice_the_operations() -> None:
    assert [digits_lost(error * ROUNDINGS) for error in (0.1, 1.0, 1.1, 10.0, 11.0, 1e30)] == [
        0, 0, 1, 1, 2, MOST,
    ]  # fmt: skip
    assert digits_lost(np.inf) == np.inf
    x = ca.SX.sym("x", 2)
    short, long = x[0] * x[1] + x[0], ca.sin(x[0]) * x[1] + x[0] * x[0]
    given = by_route("kane", SEED[2].scene())

    def choose(errors: dict[int, float]) -> Any:
        system = SimpleNamespace(
            equations=given, small=True, error=lambda graph: errors[operations(graph)]
        )
        return lightest(system, [long, short])

    counts = operations(short), operations(long)
    assert choose(dict(zip(counts, (1.0, 1.0), strict=True))) is short
    assert choose(dict(zip(counts, (5 * ROUNDINGS, 1.0), strict=True))) is short
    assert choose(dict(zip(counts, (50 * ROUNDINGS, 1.0), strict=True))) is long


def test_equations_that_are_not_the_bodies_own_are_solved_as_they_are() -> None:
    equations = by_route("kane", pendulum_chain.scene(5))
    simplified = dataclasses.replace(equations, mechanism=None, rows=None)
    assert compile(equations, compiler=None).form == "recursive"
    assert compile(simplified, compiler=None).form != "recursive"
    with pytest.raises(InputError, match="form 'recursive': the equations by kane are not those"):
        compile(simplified, form="recursive")


@pytest.mark.parametrize(("system", "most"), [(spinning_top, 70), (quadrotor, 90)])
def test_a_body_that_turns_freely_is_not_eliminated(system: Any, most: int) -> None:
    """Where elimination takes four times as many operations, and loses digits at poses."""
    equations = by_route("kane", system.scene())
    models = [compile(equations, form=form, compiler=None) for form in ("auto", "elimination")]
    assert [model.form for model in models] == ["recursive", "elimination"]
    least, many = (m.casadi["forward_dynamics"].n_instructions() for m in models)
    assert 3 * least < many
    assert models[0].right_hand_side.rate.routine.operations < most
    states = [[*group.T] for group in ordinary(models[0].quantities, 500, 3).groups]
    worst = []
    for model in models:
        code = read_routine(model.casadi["forward_dynamics"])
        exact = run(code, [[e.astype(np.longdouble) for e in g] for g in states], np.longdouble)
        ud, right = (np.array(rows[0]) for rows in (run(code, states, np.float64), exact))
        worst.append(np.max(np.abs(ud - right) / np.max(np.abs(right), axis=0)))
    assert worst[0] < 1e-13 < 1e-12 < worst[1]


def test_states_of_ordinary_size_are_solved_as_accurately_as_by_elimination() -> None:
    equations = by_route("kane", pendulum_chain.scene(5))
    models = [compile(equations, form=form, compiler=None) for form in ("recursive", "elimination")]
    random = np.random.default_rng(7)
    q, u = random.uniform(-3, 3, (2, 200, 6))
    p = random.uniform(0.5, 2, (200, len(models[0].quantities.p)))
    one, two = (m.forward_dynamics(q, u, inputs=np.zeros((200, 1)), p=p) for m in models)
    assert np.abs(one - two).max() < 1e-11 * np.abs(two).max()


@pytest.mark.parametrize("route", ["free_body", "kane"])
def test_a_chain_of_ten_as_compiled_costs_no_more_than_its_closed_form(route: str) -> None:
    """Closed form of M: 382 operations; Newton and Euler's recursion: 293."""
    model = compile(by_route(route, pendulum_chain.scene(10)), compiler=None)
    assert model.program("mass_matrix").operations <= 382
    assert model.program("inverse_dynamics").operations <= 293
