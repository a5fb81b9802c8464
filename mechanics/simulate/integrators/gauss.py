"""Gauss's implicit Runge-Kutta methods with fixed steps in C, solved by iteration.

    k_i = f(y + h sum_j a_ij k_j)    until nothing changes;    y(t + h) = y + h sum_i b_i k_i

Symmetric, and symplectic in canonical variables: over long times energy errors stay bounded.
Hairer, Lubich and Wanner, Geometric Numerical Integration, II.1.3 and VIII.6: start values from the
polynomial of the step before, iteration down to rounding. It converges while h times the fastest
rate is below about one, so a stiff problem is none for it.
"""

import math
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from mechanics.compiled.c.source import literal
from mechanics.simulate.integrators.compiled_loop import call_inner, compiled_march
from mechanics.simulate.integrators.loop import refused
from mechanics.simulate.integrators.problem import Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.stiffness import rates_at_start

Array = NDArray[np.float64]

SWEEPS, PATIENT = 100, 20
# Changes, in units of epsilon, at which an iteration that no longer converges has arrived. Entries
# that are nothing but rounding never do: after PATIENT sweeps the largest entry is the measure.
ARRIVED = 1000
# What an iteration takes about, for the budget.
TYPICAL = 8

BODY = """
    enum {{ N = SIZE, S = {stages} }};
    static const @ A[S][S] = {a}, B[S] = {b}, C[S] = {c}, E[S][S] = {e};
    @ k[S][N], last[S][N], at[N], found[N], held = h;
    long long spent = 1;
    TIME(t);
    {first};
    for (int s = 0; s < S; ++s)
        for (int n = 0; n < N; ++n)
            last[s][n] = found[n];
    for (long long i = 0; i < count; ++i) {{
        for (int s = 0; s < S; ++s)
            for (int n = 0; n < N; ++n) {{
                k[s][n] = 0;
                for (int j = 0; j < S; ++j)
                    k[s][n] += E[s][j] * last[j][n];
            }}
        @ before = INFINITY;
        int arrived = 0;
        for (int sweep = 0; sweep < {sweeps} && !arrived; ++sweep) {{
            @ change = 0, most = 0, largest = 0;
            for (int s = 0; s < S; ++s) {{
                for (int n = 0; n < N; ++n) {{
                    @ sum = 0;
                    for (int j = 0; j < S; ++j)
                        sum += A[s][j] * k[j][n];
                    at[n] = y[n] + held * sum;
                }}
                TIME(t + ((@)i + C[s]) * h);
                {call};
                ++spent;
                for (int n = 0; n < N; ++n) {{
                    const @ size = fabs(y[n]) + fabs(held * found[n]);
                    const @ moved = fabs(held * (found[n] - k[s][n]));
                    if (!(moved <= change * size))
                        change = moved / size;
                    most = moved > most ? moved : most;
                    largest = size > largest ? size : largest;
                    k[s][n] = found[n];
                }}
            }}
            arrived = change == 0 || (change <= {arrived} && !(change < before))
                || (sweep >= {patient} && most <= {arrived} * largest);
            before = change;
            if (!(most < INFINITY))
                return -spent;
        }}
        if (!arrived)
            return -spent;
        for (int n = 0; n < N; ++n) {{
            @ sum = 0;
            for (int s = 0; s < S; ++s)
                sum += B[s] * k[s][n];
            y[n] += held * sum;
            for (int s = 0; s < S; ++s)
                last[s][n] = k[s][n];
        }}
    }}
    return spent;"""


def coefficients(stages: int) -> tuple[Array, Array, Array, Array]:
    """(A, b, c) of the method with so many stages, of order twice that, and E.

    E takes the slopes of a step to those that its polynomial predicts for the next one.
    """
    nodes, weights = leggauss(stages)
    c, b = (nodes + 1) / 2, weights / 2
    others = [np.delete(c, j) for j in range(stages)]
    basis = [
        math.prod((Polynomial([-x, 1]) / (c[j] - x) for x in others[j]), start=Polynomial([1]))
        for j in range(stages)
    ]
    a = np.array([[polynomial.integ()(x) for polynomial in basis] for x in c])
    e = np.array([[polynomial(1 + x) for polynomial in basis] for x in c])
    return a, b, c, e


def _suits(stages: int, problem: Problem, setting: Setting) -> str:
    if problem.model.compiler is None:
        return "a C compiler is needed, and the model runs on CasADi's virtual machine"
    if why := refused(problem, setting, TYPICAL * stages):
        return why
    factor = float(np.max(np.abs(np.linalg.eigvals(coefficients(stages)[0]))))
    fastest = float(np.max(np.abs(rates_at_start(problem))))
    if (contraction := factor * fastest * (setting.step or 0.0)) > 1:
        return (
            f"the iteration for the stages diverges at the start: a step of {setting.step:g} s is"
            f" {contraction:.2g} times too long, since the fastest motion has {fastest:.3g} rad/s"
        )
    return ""


def _prepare(stages: int, problem: Problem, setting: Setting) -> Callable[[], Outcome]:
    kind, code = setting.kind, problem.model.right_hand_side.rate
    real = "float" if kind is np.float32 else "double"
    a, b, c, e = (_written(values, real) for values in coefficients(stages))
    groups = {"inputs": "inputs", "p": "p", "yd": "found"}
    body = BODY.format(
        stages=stages, a=a, b=b, c=c, e=e, sweeps=SWEEPS, patient=PATIENT,
        arrived=literal(ARRIVED * float(np.finfo(kind).eps), real),
        first=call_inner(code.routine, y="y", **groups),
        call=call_inner(code.routine, y="at", **groups),
    )  # fmt: skip
    words = "the iteration for the stages does not converge: the step is too long for it"
    return compiled_march(f"C Gauss{2 * stages}", problem, setting, code, body, words)


def _written(values: Array, real: str) -> str:
    if values.ndim == 1:
        return f"{{{', '.join(literal(value, real) for value in values.tolist())}}}"
    return f"{{{', '.join(_written(row, real) for row in values)}}}"


def _member(stages: int) -> Integrator:
    return Integrator(
        f"C Gauss{2 * stages}",
        "C",
        False,
        str,
        partial(_suits, stages),
        partial(_prepare, stages),
    )


MEMBERS = tuple(_member(stages) for stages in (1, 3))
