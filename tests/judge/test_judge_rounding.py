"""Numbers that code has rounded by its own sums and products, where parameters have values."""

import numpy as np

import mechanics
from mechanics.claims.code.constants import constant_of
from systems import rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
VALUES = {"m": 0.127, "l": 0.337, "g": 9.81}
LONG = {"m": 0.12345, "l": 0.67891, "g": 9.80665}


def _verdict(code, values) -> str:
    return mechanics.check(ROD, code, values=values, blame=False).verdict.name


def test_a_product_of_short_decimals_is_the_decimal_that_it_rounds() -> None:
    for below, verdict in ((3, "PROVED"), (12, "REFUTED")):

        def rate(theta, u, below=below):
            mass, length = 0.1 + 0.027, 0.3 + 0.037
            inertia = mass * length * length / below
            return mass * 9.81 * length / 2 / inertia * np.sin(theta) + u / inertia

        assert _verdict(rate, VALUES) == verdict


def test_a_number_of_many_digits_is_in_doubt_by_its_rounding_and_refuted_beyond() -> None:
    for factor, verdict in ((1, "UNDECIDED"), (1 + 1e-11, "REFUTED"), (-1, "REFUTED")):

        def rate(theta, u, factor=factor):
            mass, length = 0.12345, 0.67891
            inertia = mass * length * length / 3
            return mass * 9.80665 * length / 2 / inertia * np.sin(theta) + factor * u / inertia

        assert _verdict(rate, LONG) == verdict


def test_random_doubles_are_next_to_no_short_number() -> None:
    source = np.random.default_rng(0)
    numbers = [float(x) for x in source.uniform(0.1, 10, 3000)]
    assert all("the double that it is" in constant_of(number)[1] for number in numbers)
