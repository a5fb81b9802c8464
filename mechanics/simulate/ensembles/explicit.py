"""Explicit Runge-Kutta methods over lanes as C: the batch kernel of the right-hand side, and sums.

    k_i = f(y + h sum_j a_ij k_j)        y(t + h) = y + h sum_i b_i k_i

DOP853 (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.5) has an
error estimate of order 5 and 3 beside its order 8, and three more stages for what is between the
ends of a step. The coefficients are SciPy's.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from scipy.integrate import DOP853

from mechanics.compiled.c.batch import batch_source
from mechanics.compiled.c.sine import sine_source
from mechanics.compiled.c.source import function_source, literal, signature
from mechanics.compiled.right_hand_side import Held
from mechanics.compiled.step import Tableau
from mechanics.program.routine import Routine
from mechanics.simulate.ensembles.text import text

RATE = "mechanics_rate"
Row = Sequence[Fraction | float]


@lru_cache(maxsize=16)
def rate_source(code: Routine) -> str:
    """``rate(y, held, yd)`` of a block of lanes, by the batch text of the program."""
    entries = {name: tuple(f"{name}{k}" for k in range(size)) for name, size in code.inputs}
    scalar = f"{RATE}_one"
    return "\n".join([
        sine_source("double"),
        function_source(code, entries, "double", f"static {signature(code, 'double', scalar)}"),
        batch_source(code, entries, "double", RATE, scalar=scalar, shared=()),
        "static void rate(const L *y, const L *held, L *yd)",
        "{",
        "    (void)held;",
        f"    {RATE}(LANES, LANES, {_arrays(code)});",
        "}",
        "",
    ])  # fmt: skip


def _arrays(code: Routine) -> str:
    given = [f"(const double *){name}" for name, size in code.inputs if size]
    return ", ".join([*given, "(double *)yd"])


def dop853_source(of: Held) -> str:
    """Steps of DOP853, each lane with its own control."""
    stages, more = len(DOP853.B), len(DOP853.A_EXTRA)
    rows = [*DOP853.A[1:].tolist(), DOP853.B.tolist()]
    extra = [row[: stages + 1 + i] for i, row in enumerate(DOP853.A_EXTRA.tolist())]
    dense = ",\n".join(f"    {{{', '.join(map(_number, row))}}}" for row in DOP853.D.tolist())
    return "\n".join([
        rate_source(of.routine),
        f"enum {{ STAGES = {stages}, MORE = {more}, DENSE = {len(DOP853.D)} }};",
        "typedef struct {",
        "    L slopes[STAGES + 1 + MORE][SIZE], terms[SIZE][3 + DENSE];",
        "    L old[SIZE], length, careful;",
        "} Work;",
        text("block.h"),
        f"static const double dense[DENSE][STAGES + 1 + MORE] = {{\n{dense}\n}};",
        "",
        _stages("stages", rows, 1),
        _stages("more_stages", extra, stages + 1),
        _sum("fifth", DOP853.E5.tolist()),
        _sum("third", DOP853.E3.tolist()),
        text("dop853.c"),
        text("march.c"),
    ])  # fmt: skip


def fixed_source(of: Held, tableau: Tableau) -> str:
    """Steps of one length for all."""
    return "\n".join([
        rate_source(of.routine),
        f"enum {{ STAGES = {len(tableau.a)} }};",
        _stages("stages", tableau.a[1:], 1),
        _sum("slope", tableau.b),
        text("fixed.c"),
    ])  # fmt: skip


def _stages(name: str, rows: Sequence[Row], first: int) -> str:
    """Slopes from number `first` on, and the state where the last of them stands."""
    lines = []
    for i, row in enumerate(rows, first):
        lines += [
            "    for (int n = 0; n < SIZE; ++n)",
            f"        at[n] = fused(h, {_weighted(row)}, y[n]);",
            f"    rate(at, held, k[{i}]);",
        ]
    return "\n".join([
        f"static void {name}(const L *y, const L *held, L h, L (*restrict k)[SIZE], L *at)",
        "{",
        *lines,
        "}",
        "",
    ])  # fmt: skip


def _sum(name: str, weights: Row) -> str:
    return "\n".join([
        f"static inline L {name}(L (*k)[SIZE], int n)",
        "{",
        f"    return {_weighted(weights)};",
        "}",
        "",
    ])  # fmt: skip


def _weighted(weights: Row) -> str:
    """Sum of weights times slopes, from the last to the first."""
    found = ""
    for j, weight in reversed([*enumerate(weights)]):
        if weight and found:
            found = f"fused(all({_number(weight)}), k[{j}][n],\n            {found})"
        elif weight:
            found = f"mul(all({_number(weight)}), k[{j}][n])"
    return found


def _number(value: Fraction | float) -> str:
    return literal(float(value), "double")
