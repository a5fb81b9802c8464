"""What roundings add up to: more than they do, less than intervals say, known for long chains."""

from fractions import Fraction

import casadi as ca
import numpy as np
import pytest

from mechanics.cli.load import load
from mechanics.compiled import compile as compile_model
from mechanics.compiled.translation_validation.code import as_written
from mechanics.crosscheck import derive
from mechanics.export.roundings import first_order
from mechanics.export.vectors import ROOM, enclosed, vectors
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import run

pytestmark = pytest.mark.campaign


def test_a_sum_of_products_by_hand() -> None:
    x = ca.SX.sym("x", 3)
    function = ca.Function("f", [x], [x[0] * x[1] + x[2], x[0] / x[1]])
    found = first_order(read_routine(function), [[3.0, 5.0, -7.0]], 53)
    # The product, 15, and the sum, 8; the quotient.
    assert found == [[(15 + 8) * 2.0**-53], [0.6 * 2.0**-53]]


@pytest.mark.parametrize("system", ["elastic_pendulum", "rocker", "four_bar"])
@pytest.mark.parametrize("digits", [53, 24])
def test_between_what_happens_and_what_intervals_say(modelled, system: str, digits: int) -> None:
    model = modelled(system, "kane")
    function = model.casadi["forward_dynamics"]
    kind = np.float64 if digits == 53 else np.float32
    happened = 0.0
    for vector in vectors(model, "forward_dynamics", digits):
        written = read_routine(function)
        bounds = first_order(written, vector.inputs, digits)
        found = run(written, vector.inputs, kind)
        balls = enclosed(written, as_written(written), vector.inputs, digits)
        for values, exact, limits, wide in zip(found, vector.expected, bounds, balls, strict=True):
            for value, expected, limit, enclosure in zip(values, exact, limits, wide, strict=True):
                error = abs(Fraction(float(value)) - Fraction(expected))
                # The library's sines are off by up to a unit, not half of one.
                assert error <= 2 * limit
                happened = max(happened, float(error) / limit if limit else 0.0)
                assert limit <= 2 * float(enclosure.rad())
    assert happened > 0.01


def test_a_long_chain_has_vectors() -> None:
    """Intervals say nothing about twenty links in single precision; what is expected is told."""
    model = compile_model(derive(load("pendulum_chain(20)").scene(), "free_body"), compiler=None)
    (vector, *_) = vectors(model, "forward_dynamics", 24)
    written = read_routine(model.casadi["forward_dynamics"])
    balls = enclosed(written, as_written(written), vector.inputs, 24)
    sizes = [max(map(abs, expected), default=0.0) for expected in vector.expected]
    wide = [float(b.rad()) for b in balls[0]]
    assert not max(wide) <= 2.0**-12 * sizes[0]
    found = run(model.program("forward_dynamics"), vector.inputs, np.float32)
    for values, expected, room, size in zip(
        found, vector.expected, vector.tolerance, sizes, strict=True
    ):
        assert (np.abs(np.array(values, dtype=float) - expected) <= room).all()
        assert (np.array(room) <= 2 * ROOM * 2.0**-12 * size).all()
