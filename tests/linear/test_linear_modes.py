"""Natural modes: orthogonality, determinants, conventions, symbolic against numeric."""

import numpy as np
import pytest
from sympy import Matrix, Rational, Symbol, factor_list, prod, sqrt

from mechanics.errors import ExpressionError, InputError, ValueMissingError
from mechanics.kernel import Verdict
from mechanics.linear import (
    Convention,
    characteristic,
    characteristic_factors,
    dimensionless,
    linearize,
    modes,
    numeric_modes,
)
from mechanics.routes.derivation import by_route
from mechanics.scene import parameters
from mechanics.symbolic import prove_equal, prove_zero
from systems import two_mass_chain

Lambda = Symbol("Lambda")
# Masses and stiffnesses in units of m and k whose characteristic polynomials factor.
FACTORED = {
    "seed": ((3, 2), (1, 1)),
    "equal masses between walls": ((1, 1), (1, 1, 1)),
    "one mass": ((5,), (7,)),
    "free row": ((1, 1), (0, 1)),
    "three masses": ((1, 1, 1), (0, 1, 1)),
    "uncoupled, repeated": ((1, 1), (1, 0, 1)),
}


@pytest.fixture(params=FACTORED.values(), ids=FACTORED.keys())
def linear(request, row, constants):
    m, k, _ = constants
    masses, stiffnesses = request.param
    return row([m * c for c in masses], [k * c for c in stiffnesses])


def test_modes_are_orthogonal_in_mass_and_stiffness(linear) -> None:
    found = modes(linear)
    n = len(found.eigenvalues)
    for matrix in (linear.mass, linear.stiffness):
        weights = found.shapes.T * matrix * found.shapes
        off = [weights[i, j] for i in range(n) for j in range(n) if i != j]
        if off:
            assert prove_zero("off the diagonal", off).verdict is Verdict.PROVED
    ratio = [
        (found.shapes.T * linear.stiffness * found.shapes)[i, i]
        / (found.shapes.T * linear.mass * found.shapes)[i, i]
        for i in range(n)
    ]
    finding = prove_equal("Rayleigh quotient", ratio, list(found.eigenvalues))
    assert finding.verdict is Verdict.PROVED


def test_characteristic_polynomial_is_the_determinant_and_its_factors_multiply(linear) -> None:
    polynomial = characteristic(linear, Lambda)
    exact = (linear.stiffness - Lambda * linear.mass).det(method="bareiss")
    assert prove_equal("det", polynomial, exact).verdict is Verdict.PROVED
    constant = factor_list(polynomial)[0] * prod(
        f**power for f, power in factor_list(polynomial)[1] if not f.has(Lambda)
    )
    product = constant * prod(f**power for f, power in characteristic_factors(linear, Lambda))
    assert prove_equal("factors", product, polynomial).verdict is Verdict.PROVED


def test_symbolic_modes_have_the_numeric_values(linear) -> None:
    exact, numeric = modes(linear), numeric_modes(linear)
    m, k = linear.scene.parameters[::-1][0], linear.scene.parameters[0]
    typical = {k: k.typical, m: m.typical}
    values = [float(value.subs(typical)) for value in exact.eigenvalues]
    np.testing.assert_allclose(numeric.eigenvalues, values, rtol=1e-12, atol=1e-12)
    if len(set(exact.eigenvalues)) == len(values):
        shapes = np.array(exact.shapes.tolist(), dtype=float)
        np.testing.assert_allclose(numeric.shapes, shapes, atol=1e-9)


def test_conventions_differ_in_order_and_scaling(linear) -> None:
    engineering, matlab = modes(linear), modes(linear, Convention.MATLAB)
    assert matlab.eigenvalues == engineering.eigenvalues[::-1]
    for j in range(matlab.shapes.cols):
        squares = sum(entry**2 for entry in matlab.shapes.col(j))
        assert prove_equal("squares", squares, 1).verdict is Verdict.PROVED
        assert max(abs(entry) for entry in engineering.shapes.col(j)) == 1
        assert 1 in engineering.shapes.col(j)
    numeric = numeric_modes(linear, convention=Convention.MATLAB)
    assert np.all(np.diff(numeric.eigenvalues) <= 0)
    np.testing.assert_allclose(np.linalg.norm(numeric.shapes, axis=0), 1)


def test_seed_modes() -> None:
    equations = by_route("lagrange", two_mass_chain.scene())
    linear = linearize(equations, {"x1": 0, "x2": 0})
    k, m = two_mass_chain.k, two_mass_chain.m
    found = modes(linear)
    assert found.eigenvalues == (k / (6 * m), k / m)
    assert found.shapes == Matrix([[Rational(2, 3), -1], [1, 1]])
    matlab = modes(linear, Convention.MATLAB).shapes
    assert matlab[:, 0] == Matrix([-sqrt(2) / 2, sqrt(2) / 2])


@pytest.mark.parametrize("route", ["kane", "moving_point"])
def test_modes_do_not_depend_on_the_route(route: str) -> None:
    linear = linearize(by_route(route, two_mass_chain.scene()), {"x1": 0, "x2": 0})
    k, m = two_mass_chain.k, two_mass_chain.m
    assert modes(linear).eigenvalues == (k / (6 * m), k / m)
    assert dimensionless(linear).group == m / k


def test_dimensionless_form_is_found(row, constants) -> None:
    m, k, _ = constants
    form = dimensionless(row((3 * m, m / 2), (k, 2 * k / 3)))
    assert form.stiffness == Matrix([[5, -2], [-2, 2]])
    assert form.mass == Matrix([[6, 0], [0, 1]])
    omega = Symbol("omega")
    assert form.parameter(omega) == Rational(3, 2) * m * omega**2 / k


def test_no_single_dimensionless_parameter_is_an_error(row) -> None:
    m, k1, k2 = parameters("m k1 k2")
    with pytest.raises(ExpressionError, match="no single dimensionless parameter"):
        dimensionless(row((m, m), (k1, k2)))


def test_irreducible_polynomial_is_left_to_numbers(row) -> None:
    m1, m2, k = parameters("m1 m2 k", typical="1 2 3")
    linear = row((m1, m2), (k, k))
    with pytest.raises(ExpressionError, match=r"have no formula in the parameters.*numeric_modes"):
        modes(linear)
    found = numeric_modes(linear, {"m1": 3.0})
    assert found.eigenvalues == pytest.approx([0.5, 3.0])


def test_order_by_typical_values(row) -> None:
    m1, m2, k = parameters("m1 m2 k", typical="1 2 3")
    assert modes(row((m1, m2), (k, 0, k))).eigenvalues == (k / m2, k / m1)
    m3, m4, k3 = parameters("m3 m4 k3")
    with pytest.raises(ValueMissingError, match="has no value"):
        modes(row((m3, m4), (k3, 0, k3)))


def test_damped_equations_have_no_natural_modes(row, constants) -> None:
    m, k, c = constants
    with pytest.raises(InputError, match="damped"):
        modes(row((m,), (k,), (c,)))
    with pytest.raises(InputError, match="damped"):
        numeric_modes(row((m,), (k,), (c,)))
