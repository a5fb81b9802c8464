"""Accelerations from compiled code, put into equations of motion as their source prints them.

    ratio = |lhs - rhs| / (eps * sum of the magnitudes of the terms)

at many random states and parameters. All states are screened in extended precision with a bound of
the error at each; those that may hold the largest ratio are evaluated again as Arb balls, so the
reported maximum is an upper bound over all states. Where no bound is known, a state is evaluated in
Arb. States at which an acceleration is no number have no ratio: `mechanics.compiled.finite` counts
them, and says why.
"""

import os
from collections import deque
from collections.abc import Callable, Hashable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import inf, nextafter

import numpy as np
from flint import arb
from numpy.typing import NDArray
from sympy import Expr, Symbol

from mechanics.compiled.calls.functions import MANY
from mechanics.compiled.model import Model
from mechanics.compiled.sampling import States, sample
from mechanics.compiled.terms import BITS, Terms, read_terms, typed_terms
from mechanics.errors import InputError
from mechanics.kernel.balls import precision

STATES = 100_000
SEED = 1
PRECISIONS: tuple[type[np.floating], ...] = (np.float64, np.float32)
NAMES = {np.float64: "double", np.float32: "single"}

Columns = NDArray[np.float64]
Draw = Callable[[Model, int, int], States]


def random_states(model: Model, count: int, seed: int) -> States:
    """States anywhere."""
    return sample(model.quantities, count, seed)


@dataclass(frozen=True)
class Residual:
    """The largest residual of one published equation at the accelerations of one route.

    Attributes
    ----------
    subject : str
        ``"kane: equation (6), double"``.
    max_eps : float
        Upper bound of the ratio over all states at which the accelerations are finite; infinite
        where there is none.
    states : int
    worst : tuple of (str, float)
        The state, parameters and accelerations at the largest ratio.
    confirmed : int
        How many of the states were evaluated in Arb.
    """

    subject: str
    max_eps: float
    states: int
    worst: tuple[tuple[str, float], ...]
    confirmed: int


def residuals(
    models: Sequence[Model],
    published: Sequence[tuple[str, Expr, Expr]],
    *,
    states: int = STATES,
    seed: int = SEED,
    precisions: Sequence[type[np.floating]] = PRECISIONS,
    draw: Draw = random_states,
) -> tuple[Residual, ...]:
    """Residuals of published equations at the accelerations of each model.

    Parameters
    ----------
    models : sequence of Model
        Of one scene, one a route.
    published : sequence of (tag, lhs, rhs)
        Equations of motion in the plain symbols q, u, u', inputs and parameters of the scene.
    states : int
        Number of random states; the same ones for every route.
    seed : int
    precisions : sequence of numpy.float64, numpy.float32
        Of the compiled functions; states are rounded to it first.
    draw : callable
        Of (model, states, seed): the states, where they have to satisfy constraints.

    Raises
    ------
    InputError
        If an equation holds a symbol that the scene does not know; it is named.
    ExpressionError
        If it holds an operation that cannot be evaluated; it is named.
    """
    if states < 1:
        raise InputError(f"states: {states} found, at least 1 expected")
    terms = [typed_terms(left, right) for _, left, right in published]
    # Routes whose accelerations are one graph have one code, and so one residual.
    codes = [_code(model) for model in models]
    distinct = dict(zip(codes, models, strict=True))
    if states >= MANY:
        # The compiler is a process of its own: two of them, while this one waits.
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            pairs = [(model, kind) for kind in precisions for model in distinct.values()]
            deque(pool.map(_build, pairs), maxlen=0)
    measured: dict[Hashable, list[Residual]] = {}
    for code, model in distinct.items():
        drawn = draw(model, states, seed)
        measured[code] = []
        for kind in precisions:
            columns = _columns(model, drawn.rounded(kind), kind)
            for (tag, _, _), typed in zip(published, terms, strict=True):
                subject = f"equation {tag}, {NAMES[kind]}"
                measured[code].append(_residual(subject, model, columns, typed, kind))
    return tuple(
        replace(entry, subject=f"{model.equations.route}: {entry.subject}")
        for code, model in zip(codes, models, strict=True)
        for entry in measured[code]
    )


def _code(model: Model) -> Hashable:
    """What the accelerations of a model are computed by."""
    function = model.casadi["forward_dynamics"].serialize({})
    return function, model.quantities.p, model.compiler, model.flags


def _build(pair: tuple[Model, type[np.floating]]) -> None:
    """Compile the code that `_columns` calls."""
    model, kind = pair
    model.batch_kernel("forward_dynamics", kind, shared=())


def _columns(model: Model, states: States, kind: type[np.floating]) -> Columns:
    """Values of q, u, inputs, p and u' by symbol: symbols x states."""
    q, u, inputs, p = states.groups
    with np.errstate(over="ignore"):
        solved = model.evaluate("forward_dynamics", kind, q=q, u=u, inputs=inputs, p=p)
    return np.hstack([*states.groups, solved["ud"].astype(np.float64)]).T


def _symbols(model: Model) -> list[Symbol]:
    known = model.quantities
    return [e.symbol for e in (*known.q, *known.u, *known.inputs, *known.p, *known.ud)]


def _residual(
    subject: str,
    model: Model,
    columns: Columns,
    terms: Sequence[Expr],
    kind: type[np.floating],
) -> Residual:
    symbols = _symbols(model)
    _check(subject, model, terms, symbols)
    epsilon = float(np.finfo(kind).eps)
    used = [i for i, s in enumerate(symbols) if any(s in t.free_symbols for t in terms)]
    chosen = [symbols[i] for i in used]
    read = read_terms(terms, chosen)
    rows = columns[used]
    numbers = np.flatnonzero(np.isfinite(rows).all(axis=0))
    if not len(numbers):
        return Residual(subject, inf, columns.shape[1], _state(symbols, columns[:, 0]), 0)
    low, high = read.bounds(list(rows[:, numbers]), epsilon)
    # Elsewhere the true ratio is below the one at the state with the largest lower bound.
    candidates = numbers[high >= low.max()]
    worst, largest = _largest(read, rows, candidates, epsilon)
    state = _state(symbols, columns[:, worst])
    return Residual(subject, largest, columns.shape[1], state, len(candidates))


def _state(symbols: Sequence[Symbol], column: Columns) -> tuple[tuple[str, float], ...]:
    return tuple(zip((s.name for s in symbols), map(float, column), strict=True))


def _largest(
    terms: Terms, rows: Columns, candidates: NDArray[np.intp], epsilon: float
) -> tuple[int, float]:
    """The candidate with the largest ratio, and that ratio from above, by Arb."""
    worst, largest = int(candidates[0]), 0.0
    with precision(BITS):
        for index in candidates:
            ratio = terms.ratio(rows[:, index].tolist(), epsilon)
            upper = _above(ratio)
            if upper > largest:
                worst, largest = int(index), upper
    return worst, largest


def _above(ratio: arb) -> float:
    """A double that is not below any value in the ball."""
    if ratio.is_zero():
        return 0.0
    return nextafter(float(ratio.upper()), inf) if ratio.is_finite() else inf


def _check(subject: str, model: Model, terms: Sequence[Expr], symbols: Sequence[Symbol]) -> None:
    used = set().union(*(term.free_symbols for term in terms)) if terms else set()
    if unknown := sorted(map(str, used - set(symbols))):
        raise InputError(
            f"{subject}: {', '.join(unknown)} is neither a coordinate, speed, input nor parameter"
            f" of {model.equations.scene.name!r}: write the equation in the scene's symbols"
        )
    if not used & {entry.symbol for entry in model.quantities.ud}:
        raise InputError(
            f"{subject}: the equation holds no acceleration, so it cannot check the compiled"
            " dynamics"
        )
