"""Forms of forward dynamics: all proved to be the equations, and what each of them is for."""

import numpy as np
import pytest
import sympy

from mechanics.compiled import FORMS, compile, prove_graph
from mechanics.compiled.forms.leading_minors import trailing_minors, without_subtraction
from mechanics.compiled.forms.primitive import common_factor, primitive
from mechanics.errors import InputError
from mechanics.routes.derivation import by_route
from systems import pendulum_chain

pytestmark = pytest.mark.campaign

SYSTEMS = ["elastic_pendulum", "rocker", "two_mass_chain", "pendulum_chain", "rolling_disc"]
ROUTES = ["free_body", "kane", "lagrange"]
NAMES = [form.name for form in FORMS]


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("route", ROUTES)
def test_every_form_is_the_equations(derived, system: str, route: str) -> None:
    equations = derived(system, route)
    suited = [form for form in FORMS if not form.unsuited(equations)]
    assert len(suited) >= 3
    for form in suited:
        model = compile(equations, form=form.name, compiler=None)
        assert model.form == form.name
        assert prove_graph("forward_dynamics", model.casadi).shown


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", SYSTEMS)
def test_forms_give_the_same_numbers(derived, system: str) -> None:
    equations = derived(system, "kane")
    random = np.random.default_rng(3)
    models = [
        compile(equations, form=form.name, compiler=None)
        for form in FORMS
        if not form.unsuited(equations)
    ]
    known = models[0].quantities
    q, u = random.uniform(0.2, 1.2, (2, 10, len(known.q)))
    inputs = random.uniform(0, 1, (10, len(known.inputs)))
    values = [m.forward_dynamics(q, u, inputs=inputs) for m in models]
    for other in values[1:]:
        assert np.allclose(other, values[0], rtol=1e-11, atol=1e-11)


def test_a_form_that_does_not_suit_is_refused(derived) -> None:
    with pytest.raises(InputError, match="form 'rearranged': 4 unknowns, at most 3"):
        compile(derived("pendulum_chain", "kane"), form="rearranged")
    with pytest.raises(InputError, match=f"form 'fast': the forms are auto, {', '.join(NAMES)}"):
        compile(derived("rocker", "kane"), form="fast")


def test_common_factors_of_rows_and_columns_are_gone(derived) -> None:
    """The rows of the pendulum divided by 1/2 and L M/6, the second unknown is L theta''."""
    equations = derived("elastic_pendulum", "kane")
    found = primitive(*equations.system)
    named = {symbol.name: symbol for symbol in equations.scene.parameters}
    theta = equations.scene.q[1]
    M, m = named["M"], named["m"]
    expected = [[2 * (M + m), M * sympy.cos(theta)], [3 * sympy.cos(theta), 2]]
    assert (found.left - sympy.Matrix(expected)).applyfunc(sympy.expand).is_zero_matrix
    assert found.scale == (1, named["L"])


def test_a_common_factor_divides_every_term() -> None:
    a, b = sympy.symbols("a b", positive=True)
    x = sympy.Symbol("x", real=True)
    assert common_factor([4 * a**2 * b * x, 6 * a * b * x + 2 * a * b]) == (2, a * b)
    assert common_factor([x / a, b / a**2]) == (1, a**-2)
    # What may vanish stays.
    assert common_factor([x, x**2]) == (1, 1)


def test_minors_are_written_without_subtraction() -> None:
    M, m = sympy.symbols("M m", positive=True)
    theta = sympy.Symbol("theta", real=True)
    c, s = sympy.cos(theta), sympy.sin(theta)
    assert without_subtraction((M + m) * m - (m * c) ** 2) == sympy.expand(M * m + m**2 * s**2)
    minors = trailing_minors(sympy.Matrix([[M + m, m * c], [m * c, m]]))
    assert minors == (sympy.expand(M * m + m**2 * s**2), m, 1)


@pytest.mark.parametrize("share", [1e-9, 1e-13, 1e-17])
def test_rearranged_pivots_keep_what_a_difference_loses(share: float) -> None:
    """Cart of mass m0 << m1 under a pendulum that nearly stands: m0 + m1 - m1 cos^2 q1."""
    equations = by_route("kane", pendulum_chain.scene(1))
    p = {"m0": share, "m1": 1.0, "l0": 1.0, "g": 9.81}
    q, u, angle = [0.0, 2.0**-14], [0.0, 0.0], 2.0**-14
    # From rest without a force the cart has |x''| = m1 g s c / (m0 + m1 s^2).
    s, c = np.sin(angle), np.cos(angle)
    true = 9.81 * s * c / (share + s**2)
    errors = {}
    for form in ("elimination", "rearranged"):
        model = compile(equations, form=form, compiler=None)
        found = model.forward_dynamics(q, u, inputs=[0.0], p=p)[0]
        errors[form] = abs(abs(found) - true) / true
    assert errors["rearranged"] < 1e-15
    assert errors["elimination"] > 1e-12
