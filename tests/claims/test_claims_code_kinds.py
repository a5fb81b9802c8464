"""Code that asks of what kind a number is, or makes it one of a kind."""

import math
import numbers
from collections.abc import Callable

import numpy as np
import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()


def law(theta, u, m, l, g, sine=np.sin):  # type: ignore[no-untyped-def]
    return 3 * g / (2 * l) * sine(theta) + 3 * u / (m * l**2)


def either(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
    if isinstance(theta, (float, np.floating)):
        return law(theta, u, m, l, g, math.sin)
    return law(theta, 2 * u, m, l, g)


def of_a_union(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(theta, u if isinstance(theta, float | int) else 2 * u, m, l, g)


def of_python(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
    if not isinstance(theta, numbers.Real):
        raise TypeError("theta is a number")
    return law(float(theta), np.float64(u), m, l, g)


def of_an_array(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
    if l < np.finfo(float).eps:
        raise ValueError("l is positive")
    found = np.zeros(1, float)
    found[0] = law(theta, u, m, l, g)
    return found.astype(float)


@pytest.mark.parametrize("function", [either, of_a_union, of_python, of_an_array])
def test_a_number_is_a_float(function: Callable) -> None:
    assert check(SCENE, function, blame=False).verdict is Verdict.PROVED
