"""Compiled graphs are proved against the derived equations, and a changed graph is refuted."""

from fractions import Fraction
from pathlib import Path

import casadi as ca
import pytest

from mechanics import derive, from_mjcf
from mechanics.compiled import compile, prove_compiled, prove_graph
from mechanics.compiled.graphs import Graphs
from mechanics.errors import InputError
from mechanics.kernel import Verdict

SEEDS = ("elastic_pendulum", "rocker", "two_mass_chain")
ROUTES = ("free_body", "moving_point", "kane", "lagrange")


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize("system", SEEDS)
def test_every_function_of_the_seeds_systems_is_proved(modelled, system: str, route: str) -> None:
    model = modelled(system, route)
    # A step is composed of functions that are proved: tests/compiled/test_compiled_step.py.
    functions = [name for name in model.casadi if name != "step"]
    findings = prove_compiled(model, functions)
    assert len(findings) == len(functions)
    assert {f.subject: f.verdict for f in findings if f.verdict is not Verdict.PROVED} == {}
    assert all(route in f.subject for f in findings)


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ["rolling_disc", "four_bar"])
@pytest.mark.parametrize("route", ["free_body", "kane"])
def test_constrained_systems_are_shown(modelled, system: str, route: str) -> None:
    findings = prove_compiled(modelled(system, route))
    assert {f.subject: f.evidence for f in findings if not f.shown} == {}


def mutated(graphs: Graphs, name: str, entry: int) -> ca.Function:
    """The function with the sign of one entry of its first output that has entries changed."""
    function, _ = graphs.exact(name)
    inputs = function.sx_in()
    outputs = function.call(inputs)
    changed = next(i for i, out in enumerate(outputs) if out.numel())
    outputs[changed][entry] = -outputs[changed][entry]
    names = [function.name_out(i) for i in range(function.n_out())]
    return ca.Function(
        name, inputs, outputs, [function.name_in(i) for i in range(len(inputs))], names
    )


@pytest.mark.parametrize(
    "name",
    [
        "forward_dynamics", "mass_matrix", "forcing", "residual", "inverse_dynamics", "energy",
        "momenta", "coordinate_rates", "reactions", "jacobians",
    ],
)  # fmt: skip
def test_a_changed_sign_is_refuted_with_a_witness(modelled, name: str) -> None:
    graphs = modelled("elastic_pendulum", "free_body").casadi
    finding = prove_graph(name, graphs, mutated(graphs, name, 0))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None


def test_the_graph_that_is_evaluated_is_the_one_that_is_proved_with_numbers_bound(modelled) -> None:
    for system in SEEDS:
        graphs = modelled(system, "kane").casadi
        for name in graphs:
            exact, constants = graphs.exact(name)
            numbers = [float(constant) for constant in constants]
            given = [
                [0.3 + 0.1 * i for i in range(exact.numel_in(k))] for k in range(exact.n_in() - 1)
            ]
            proved, evaluated = exact.call([*given, numbers]), graphs[name].call(given)
            for p, e in zip(proved, evaluated, strict=True):
                assert ca.norm_inf(p - e) <= 1e-14 * (1 + ca.norm_inf(p)) if p.numel() else True


def test_an_unknown_function_is_named(modelled) -> None:
    with pytest.raises(InputError, match="function 'speed'"):
        prove_graph("speed", modelled("rocker", "kane").casadi)


def with_a_stage_of_a_third(graphs: Graphs) -> ca.Function:
    """A step whose second stage is taken after a third of its time, where a half is right."""
    rates, _ = graphs.exact_rates()
    function, _ = graphs.exact("step")
    q, u, inputs, p, h, constants = function.sx_in()

    def rate(y: ca.SX) -> ca.SX:
        n = q.numel()
        return ca.vertcat(*rates(y[:n], y[n:], inputs, p, constants)[:2])

    y = ca.vertcat(q, u)
    k = [rate(y)]
    for share in (Fraction(1, 3), Fraction(1, 2), Fraction(1)):
        k.append(rate(y + h * share.numerator * k[-1] / share.denominator))
    end = y + h * (k[0] + 2 * k[1] + 2 * k[2] + k[3]) / 6
    names = [function.name_in(i) for i in range(function.n_in())]
    return ca.Function("step", function.sx_in(), [end[: q.numel()], end[q.numel() :]], names,
                       ["q_next", "u_next"])  # fmt: skip


@pytest.mark.campaign
def test_a_step_is_shown_stage_by_stage_and_a_wrong_stage_is_refuted(modelled) -> None:
    """A slope of a wrong stage is found nowhere: what is left uncut is told by numbers."""
    graphs = modelled("elastic_pendulum", "free_body").casadi
    assert prove_graph("step", graphs).shown
    finding = prove_graph("step", graphs, with_a_stage_of_a_third(graphs))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None


@pytest.mark.campaign
def test_a_step_of_eight_freedoms_is_shown() -> None:
    """Its degree is above 10^250: no prime is long enough without the cuts."""
    pytest.importorskip("mujoco")
    scene = from_mjcf(Path(__file__).parents[1] / "models" / "pendulums.xml")
    assert prove_graph("step", compile(derive(scene)).casadi).shown
