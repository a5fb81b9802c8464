"""Natural frequencies where they nearly vanish or nearly coincide, against enclosed roots."""

import functools

import numpy as np
import pytest
from flint import fmpq, fmpq_poly
from sympy import Poly, Rational

from mechanics.compiled import compile
from mechanics.errors import InputError
from mechanics.extremes.points import walks
from mechanics.linear import Linear, characteristic, linearize, numeric_modes, numeric_poles
from mechanics.linear.modes import EIGENVALUE
from mechanics.routes.derivation import by_route
from systems import rocker, two_mass_chain

CASES = {
    "unequal": (two_mass_chain.unequal, two_mass_chain.TOWARDS_EQUAL_FREQUENCIES),
    "controlled": (rocker.controlled, rocker.AT_CRITICAL_GAIN),
}
AT = {"unequal": {"x1": 0, "x2": 0}, "controlled": {"theta": 0}}


@functools.cache
def case(name: str) -> tuple[Linear, list[dict[str, float]]]:
    """Linear equations, and parameter values along the path."""
    scene, path = CASES[name]
    equations = by_route("kane", scene())
    known = compile(equations, compiler=None).quantities
    (walk,) = (w for w in walks(known, (path,), 1) if w.kind == "path")
    names = [entry.name for entry in known.p]
    return linearize(equations, AT[name]), [
        dict(zip(names, row[-len(names) :], strict=True)) for row in walk.points.tolist()
    ]


def enclosed(linear: Linear, values: dict[str, float]) -> list:
    """Roots of the characteristic polynomial, rising: its coefficients are exact rationals."""
    polynomial = characteristic(linear)
    table = {
        s: Rational(*values[s.name].as_integer_ratio())
        for s in polynomial.free_symbols
        if s.name in values
    }
    rows = Poly(polynomial.xreplace(table), EIGENVALUE).all_coeffs()
    exact = fmpq_poly([fmpq(int(c.p), int(c.q)) for c in reversed(rows)])
    return sorted((root.real for root, _ in exact.numer().complex_roots()), key=float)


@pytest.mark.parametrize("name", CASES)
def test_eigenvalues_are_right_to_the_last_digits_along_the_path(name: str) -> None:
    linear, points = case(name)
    for values in points:
        found = numeric_modes(linear, values).eigenvalues
        for value, true in zip(found, enclosed(linear, values), strict=True):
            assert abs(float((value - true) / true)) < 4 * 2.0**-52


def test_poles_beside_the_critical_gain_tell_on_which_side_it_is() -> None:
    linear, points = case("controlled")
    for values in points:
        poles = numeric_poles(linear, values)
        (true,) = enclosed(linear, values)
        assert (true > 0) == (values["K"] > float(values["M"] * values["g"] / 3))
        # Above the gain the rocker swings, below it falls away.
        assert np.allclose(np.sort_complex(poles**2), -float(true), rtol=1e-12)
        assert (np.abs(poles.imag).max() > 0) == bool(true > 0)


@pytest.mark.parametrize("seed", range(5))
def test_frequencies_approach_each_other_only_as_k2_over_k1_vanishes(seed: int) -> None:
    """Lambda_2/Lambda_1 + Lambda_1/Lambda_2 + 2 >= 4 (1 + k2/k1), equal for m1/m2 = 1 + k1/k2."""
    linear, _ = case("unequal")
    m1, m2, k1, k2 = (10.0 ** np.random.default_rng(seed).uniform(-3, 3, 4)).tolist()
    for masses, best in (((m1, m2), False), ((m2 * (1 + k1 / k2), m2), True)):
        values = {"m1": masses[0], "m2": masses[1], "k1": k1, "k2": k2}
        one, two = numeric_modes(linear, values).eigenvalues
        closeness = two / one + one / two + 2
        least = 4 * (1 + k2 / k1)
        assert closeness >= least * (1 - 1e-12)
        if best:
            assert closeness == pytest.approx(least, rel=1e-9)


def test_what_is_no_number_is_refused() -> None:
    linear, points = case("controlled")
    with pytest.raises(InputError, match="parameter K: the value inf is no finite number"):
        numeric_modes(linear, points[0] | {"K": float("inf")})
