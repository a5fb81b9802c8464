"""Compiled accelerations against the seed's equations of motion, typed here once more."""

import numpy as np
import pytest
import sympy
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, cos, sin

from mechanics.compiled import Model, residuals
from mechanics.compiled import compile as compile_model
from mechanics.compiled.residuals import _columns, _symbols
from mechanics.compiled.sampling import sample
from mechanics.compiled.terms import BITS, read_terms, typed_terms
from mechanics.errors import ExpressionError, InputError
from mechanics.kernel.balls import precision
from mechanics.symbolic import enclose

GOAL = 16.0
ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def typed(model: Model) -> tuple[tuple[str, sympy.Expr, sympy.Expr], ...]:
    """Equations (6), (7) and rocker (7) as the seed prints them, and both of problem 3."""
    scene = model.equations.scene
    q, u, ud = scene.q, scene.u, scene.ud
    p = {entry.name: entry.symbol for entry in model.quantities.p}
    if scene.name.startswith("pendulum"):
        M, m, L, k, g = (p[name] for name in ("M", "m", "L", "k", "g"))
        (x, theta), (_, w), (a, alpha) = q, u, ud
        half = M * L / 2
        return (
            ("(6)", (M + m) * a + 2 * k * x + half * alpha * cos(theta)
             - half * w**2 * sin(theta), sympy.S.Zero),
            ("(7)", half * a * cos(theta) + M * L**2 / 3 * alpha + g * half * sin(theta),
             sympy.S.Zero),
        )  # fmt: skip
    if scene.name.startswith("rocker"):
        M, I_C, R, g = (p[name] for name in ("M", "I_C", "R", "g"))
        (theta,), (w,), (alpha,), (f,) = q, u, ud, scene.input_symbols
        left = (
            (I_C + M * R**2 * (Rational(5, 4) + cos(theta))) * alpha
            - M * R**2 / 2 * w**2 * sin(theta)
            - M * g * R / 2 * sin(theta)
        )
        return (("(7)", left, f * (R + R / 2 * cos(theta))),)
    m, k, (x1, x2), (a1, a2) = p["m"], p["k"], q, ud
    return (
        ("3m", -k * x1 + k * (x2 - x1), 3 * m * a1),
        ("2m", -k * (x2 - x1), 2 * m * a2),
    )


@pytest.mark.campaign
@pytest.mark.parametrize("system", ["elastic_pendulum", "rocker", "two_mass_chain"])
@pytest.mark.parametrize("states", [2000, pytest.param(100_000, marks=pytest.mark.campaign)])
def test_every_route_stays_within_a_few_roundings(modelled, system: str, states: int) -> None:
    models = [modelled(system, route) for route in ROUTES]
    found = residuals(models, typed(models[0]), states=states)
    assert len(found) == 4 * 2 * len(typed(models[0]))
    assert {r.subject: r.max_eps for r in found if not r.max_eps < GOAL} == {}
    assert all(r.states == states and r.max_eps > 0 for r in found)


def test_a_moment_equation_with_uncancelled_products_loses_its_digits(derived) -> None:
    equations = derived("elastic_pendulum", "moving_point")
    model = compile_model(equations)
    p = {entry.name: entry.symbol for entry in model.quantities.p}
    M, L, g = p["M"], p["L"], p["g"]
    scene = equations.scene
    (_, theta), (v, w) = scene.q, scene.u
    # dH_B/dt + v_B x P: what the first puts in, the second takes out again.
    moment = -M * L / 2 * (g - v * w) * sin(theta) - v * (M * L / 2 * w * sin(theta))
    broken = equations.with_matrices(forcing=Matrix([equations.forcing[0], moment]))
    forms = [compile_model(broken, form=form) for form in ("elimination", "fewest")]
    options = {"states": 2000, "precisions": [np.float64]}
    found = residuals(forms[:1], typed(model), **options)
    assert found[1].max_eps > 1e6
    # Polynomials in normal form have cancelled what cancels.
    assert max(r.max_eps for r in residuals(forms[1:], typed(model), **options)) < 16
    state = dict(found[1].worst)
    assert abs(state["x_dot"] * state["theta_dot"]) > state["g"]


def test_a_wrong_equation_has_a_large_residual(modelled) -> None:
    model = modelled("elastic_pendulum", "kane")
    tag, left, right = typed(model)[0]
    x = model.equations.scene.q[0]
    (found,) = residuals(
        [model], [(tag, left.subs(x, -x), right)], states=500, precisions=[np.float64]
    )
    assert found.max_eps > 1e12


@pytest.mark.parametrize("system", ["elastic_pendulum", "rocker"])
def test_screening_finds_what_arb_finds_everywhere(modelled, system: str) -> None:
    model = modelled(system, "lagrange")
    drawn = sample(model.quantities, 3000, 1)
    columns = _columns(model, drawn, np.float64)
    found = residuals([model], typed(model), states=3000, precisions=[np.float64])
    for (_, left, right), residual in zip(typed(model), found, strict=True):
        routine = read_terms(typed_terms(left, right), _symbols(model))
        with precision(BITS):
            ratios = [routine.ratio(c.tolist(), 2.0**-52) for c in columns.T]
        largest = max(float(ratio.mid()) for ratio in ratios)
        assert residual.max_eps == pytest.approx(largest, rel=1e-15)
        assert residual.max_eps >= largest
        assert residual.confirmed < 100
        screened = read_terms(typed_terms(left, right), _symbols(model))
        low, high = screened.bounds(list(columns), 2.0**-52)
        middle = np.array([float(r.mid()) for r in ratios])
        assert (low <= middle * (1 + 1e-15)).all() and (middle <= high * (1 + 1e-15)).all()
        assert np.abs(high - low).max() < 0.5


def test_where_the_screening_has_no_bound_a_state_is_left_to_arb() -> None:
    terms = (sympy.sqrt(y * y - x * x), y)
    low, high = read_terms(terms, [x, y]).bounds([np.array([1.1, 1.1]), np.array([1.1, 3])], 1)
    assert low[0] == 0 and np.isinf(high[0])
    assert 0 < low[1] <= high[1] < low[1] * (1 + 1e-15)


def test_tangents_are_screened_like_the_rest(modelled) -> None:
    model = modelled("elastic_pendulum", "kane")
    tag, left, right = typed(model)[0]
    theta = model.equations.scene.q[1]
    t = sympy.tan(theta / 2)
    hidden = left.subs(sin(theta), 2 * t / (1 + t**2))
    (found,) = residuals([model], [(tag, hidden, right)], states=3000, precisions=[np.float64])
    assert found.confirmed < 300
    assert found.max_eps < GOAL


def test_sums_inside_sines_are_screened_like_the_rest(modelled) -> None:
    model = modelled("elastic_pendulum", "kane")
    tag, left, right = typed(model)[0]
    theta = model.equations.scene.q[1]
    hidden = left.subs(cos(theta), sin(theta + sympy.pi / 2, evaluate=False))
    (found,) = residuals([model], [(tag, hidden, right)], states=3000, precisions=[np.float64])
    assert found.confirmed < 300
    assert found.max_eps < GOAL


x, y = sympy.symbols("x y", real=True)


@settings(max_examples=40, deadline=None)
@given(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6))
def test_arb_routine_encloses_the_typed_expression(first: float, second: float) -> None:
    left, right = (x + sympy.pi * y) ** 2 * sin(x) / 3, sympy.sqrt(y) * cos(x) - abs(x) / y**2
    terms = typed_terms(left, right)
    values = {x: arb(first), y: arb(second)}
    total = enclose(abs(left - right), values, BITS)
    size = enclose(sum(abs(term) for term in terms), values, BITS)
    with precision(BITS):
        ratio = read_terms(terms, [x, y]).ratio([first, second], 1.0)
        assert (ratio * size).overlaps(total)


def test_terms_are_those_of_each_side_multiplied_out() -> None:
    assert set(typed_terms(x * (y + 2), y * x)) == {x * y, 2 * x, -x * y}


def test_states_are_reproducible_wide_and_beside_quarter_turns(modelled) -> None:
    known = modelled("elastic_pendulum", "kane").quantities
    first, second = sample(known, 20_000, 7), sample(known, 20_000, 7)
    assert all(np.array_equal(a, b) for a, b in zip(first.groups, second.groups, strict=True))
    assert (first.p > 0).all()
    assert first.p.min() < 1e-5 and first.p.max() > 1e5
    assert (first.q[:, 0] < 0).mean() == pytest.approx(0.5, abs=0.02)
    beside = np.abs(np.cos(first.q[:, 1]) * np.sin(first.q[:, 1]))
    assert 0.1 < (beside < 1e-6).mean() < 0.5


def test_unknown_symbols_and_equations_without_accelerations_are_refused(modelled) -> None:
    model = modelled("elastic_pendulum", "kane")
    scene = model.equations.scene
    with pytest.raises(InputError, match=r"equation \(9\), double: x is neither"):
        residuals([model], [("(9)", sympy.Symbol("x") + scene.ud[0], sympy.S.Zero)], states=2)
    with pytest.raises(InputError, match="no acceleration"):
        residuals([model], [("(9)", scene.q[0], sympy.S.Zero)], states=2)
    with pytest.raises(ExpressionError, match="gamma"):
        residuals([model], [("(9)", sympy.gamma(scene.ud[0]), sympy.S.Zero)], states=2)
    with pytest.raises(InputError, match="at least 1"):
        residuals([model], typed(model), states=0)
