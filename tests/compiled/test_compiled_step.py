"""The Runge-Kutta step: composed of the functions that are proved, of the order that it claims."""

import math
from fractions import Fraction

import casadi as ca
import numpy as np
import pytest
from flint import arb

from mechanics.compiled.step import RK4, Tableau, runge_kutta
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.compiled.translation_validation.code import as_written
from mechanics.kernel.balls import Balls, ball, precision
from mechanics.program import interpret
from mechanics.program.casadi_reader import read_routine

SYSTEMS = [("elastic_pendulum", "kane"), ("rocker", "free_body"), ("rolling_disc", "free_body"),
           ("four_bar", "lagrange")]  # fmt: skip


def balls(function: ca.Function, inputs: list[list[arb]]) -> list[list[arb]]:
    """Outputs of a function at balls, at the precision that is set."""
    written = read_routine(function)
    state = {
        f"{name}[{k}]": value
        for (name, _), values in zip(written.inputs, inputs, strict=True)
        for k, value in enumerate(values)
    }
    found = interpret(as_written(written), Balls(), state)
    return [list(found[name]) for name, _ in written.shapes]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("system", "route"), SYSTEMS)
def test_step_is_the_classical_formula_in_balls(modelled, system: str, route: str) -> None:
    """k1 to k4 one after the other, each by the functions themselves, at 300 bits."""
    graphs, random = modelled(system, route).casadi, np.random.default_rng(7)
    step = graphs["step"]
    sizes = [step.numel_in(i) for i in range(4)]
    n = sizes[0]

    def rate(y: list[arb], rest: list[list[arb]]) -> list[arb]:
        qd, *_ = balls(graphs["coordinate_rates"], [y[:n], y[n:], *rest])
        ud, *_ = balls(graphs["forward_dynamics"], [y[:n], y[n:], *rest])
        return [*qd, *ud]

    with precision(300):
        q, u, *rest = ([arb(x) for x in random.uniform(0.3, 1.3, size).tolist()] for size in sizes)
        h, y = arb(0.01), [*q, *u]
        k1 = rate(y, rest)
        k2 = rate([a + h / 2 * k for a, k in zip(y, k1, strict=True)], rest)
        k3 = rate([a + h / 2 * k for a, k in zip(y, k2, strict=True)], rest)
        k4 = rate([a + h * k for a, k in zip(y, k3, strict=True)], rest)
        found = balls(step, [q, u, *rest, [h]])
        for value, start, *k in zip([*found[0], *found[1]], y, k1, k2, k3, k4, strict=True):
            expected = start + h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3])
            assert (value - expected).contains(0) and (value - expected).rad() < 1e-70


@pytest.mark.campaign
@pytest.mark.parametrize("tableau", TABLEAUX, ids=lambda tableau: tableau.name)
def test_error_of_a_step_falls_with_the_order_it_claims(tableau: Tableau) -> None:
    """Error of a step on y' = (y2, -y1 y1), whose stages are not all alike, by Richardson."""
    y, h = ca.SX.sym("y", 2), ca.SX.sym("h")
    graph = runge_kutta(tableau, lambda at, _: ca.vertcat(at[1], -at[0] * at[0]), y, h)
    step = ca.Function("step", [y, h], [graph])

    def after(size: Fraction, count: int) -> list[arb]:
        state = [arb(1), arb(0.5)]
        for _ in range(count):
            given = [state, [ball(size)]]
            state = balls(step, given)[0]
        return state

    with precision(400):
        # A step and 64 times as many: what the long one leaves is its own error.
        errors = []
        for size in (Fraction(1, 4), Fraction(1, 8)):
            rough, fine = after(size, 1), after(size / 64, 64)
            errors.append(max(abs(float(a - b)) for a, b in zip(rough, fine, strict=True)))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(tableau.order + 1, abs=0.45)


def test_coefficients_are_those_of_kutta() -> None:
    assert RK4.b == (Fraction(1, 6), Fraction(1, 3), Fraction(1, 3), Fraction(1, 6))
    assert [sum(row) for row in RK4.a] == [0, Fraction(1, 2), Fraction(1, 2), 1]
