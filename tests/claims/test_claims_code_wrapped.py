"""Functions in what wraps them, and numbers in dictionaries, objects and classes of the file."""

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()


@functools.lru_cache(maxsize=8)
def inertia(m, l):  # type: ignore[no-untyped-def]
    return m * l**2 / 3


def plain(t, y, u, m, l, g):  # type: ignore[no-untyped-def]
    return [y[1], (m * g * l / 2 * math.sin(y[0]) + u) / inertia(m, l)]


def last(m, l, g, t, y, u):  # type: ignore[no-untyped-def]
    return plain(t, y, u, m, l, g)


@functools.lru_cache
def theta_ddot(theta, u, m, l, g):  # type: ignore[no-untyped-def]
    return 3 * g / (2 * l) * np.sin(theta) + u / inertia(m, l)


@dataclass(frozen=True)
class Parameters:
    m: float = 1.0
    l: float = 2.0
    g: float = 9.81

    @functools.cached_property
    def inertia(self):  # type: ignore[no-untyped-def]
        return self.m * self.l**2 / 3


class Numbers:
    m, l, g = 1.0, 2.0, 9.81


OBJECT = Parameters()
TABLE = {"m": 1.0, "l": 2.0, "g": 9.81}


def by_object(t, y, u):  # type: ignore[no-untyped-def]
    return [y[1], (OBJECT.m * OBJECT.g * OBJECT.l / 2 * math.sin(y[0]) + u) / OBJECT.inertia]


def by_table(t, y, u):  # type: ignore[no-untyped-def]
    return plain(t, y, u, TABLE["m"], TABLE["l"], TABLE["g"])


def by_class(t, y, u):  # type: ignore[no-untyped-def]
    return plain(t, y, u, Numbers.m, Numbers.l, Numbers.g)


class Simulator:
    def __init__(self) -> None:
        self.p = Parameters()

    def rates(self, t, y, u):  # type: ignore[no-untyped-def]
        return plain(t, y, u, self.p.m, self.p.l, self.p.g)


class Compiled:
    """As numba has it: the function stands in an attribute, and is called with numbers."""

    __module__ = "numba.core.registry"

    def __init__(self, function: Callable) -> None:
        self.py_func = function

    def __call__(self, *numbers: float) -> Any:
        return self.py_func(*map(float, numbers))


class Odd:
    """An object that answers no question about its attributes."""

    def __getattr__(self, name: str) -> object:
        raise RuntimeError(name)

    def __call__(self, number: Any) -> Any:
        return number


ODD, INERTIA = Odd(), Compiled(lambda m, l: m * l**2 / 3)


def by_odd_things(t, y, u, m, l, g):  # type: ignore[no-untyped-def]
    return [y[1], ODD(m * g * l / 2 * math.sin(y[0]) + u) / INERTIA(m, l)]


RIGHT = [
    functools.partial(plain, m=1.0, l=2.0, g=9.81), functools.partial(last, 1.0, 2.0, 9.81),
    Compiled(plain), by_odd_things, theta_ddot, by_object, by_table, by_class, Simulator().rates,
]  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("function", RIGHT)
def test_what_is_inside_is_proved(function: Callable) -> None:
    assert check(SCENE, function, blame=False).verdict is Verdict.PROVED
    assert (OBJECT, TABLE, Numbers.m) == (Parameters(), {"m": 1.0, "l": 2.0, "g": 9.81}, 1.0)


def test_an_attribute_of_numba_s_name_is_none_of_numba_s() -> None:
    class Own(Compiled):
        __module__ = "mine"

        def __call__(self, *numbers: float) -> Any:
            return [0.0, 0.0]

    assert check(SCENE, Own(plain), blame=False).verdict is Verdict.REFUTED


def test_numbers_that_are_found_are_told() -> None:
    found = check(SCENE, by_table, blame=False)
    assert "m = 1.0, l = 2.0, g = 9.81 of the code: read as" in " ".join(found.remarks)


def test_a_name_with_two_values_is_refused() -> None:
    m = 3.0

    def two(t, y, u):  # type: ignore[no-untyped-def]
        return plain(t, y, u, m, TABLE["l"], TABLE["g"] * TABLE["m"] / TABLE["m"])

    with pytest.raises(InputError, match=r"m is .* in one place and .* in another"):
        check(SCENE, two)
