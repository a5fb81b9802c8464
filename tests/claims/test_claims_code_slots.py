"""Numbers in slots and in tuples with names are followed as those of other objects."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import pytest

from mechanics import check
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()


def law(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return [y[1], 3 * g / (2 * l) * np.sin(y[0]) + 3 * u / (m * l**2)]


class Slots:
    __slots__ = ("__weakref__", "_inertia", "g", "l", "m")

    def __init__(self, m=0.1, l=2.0, g=9.81):  # type: ignore[no-untyped-def]
        self.m, self.l, self.g = m, l, g
        self._inertia = self.m * self.l**2 / 3

    def rates(self, y, u):  # type: ignore[no-untyped-def]
        return [y[1], (u + self.moment(y[0])) / self._inertia]

    def inside(self, y, u):  # type: ignore[no-untyped-def]
        return [rate() for rate in (lambda: y[1], lambda: (u + self.moment(y[0])) / self._inertia)]

    def moment(self, angle):  # type: ignore[no-untyped-def]
        return self.m * self.g * self.l / 2 * math.sin(angle)


class Private:
    __slots__ = ("__hidden", "g", "l", "m")

    def __init__(self) -> None:
        self.m, self.l, self.g, self.__hidden = 0.1, 2.0, 9.81, 2

    def rates(self, y, u):  # type: ignore[no-untyped-def]
        return [y[1], 3 * self.g / (self.__hidden * self.l) * math.sin(y[0])
                + 3 * u / (self.m * self.l**2)]  # fmt: skip


@dataclass(frozen=True, slots=True)
class Frozen:
    m: float = 0.1
    l: float = 2.0
    g: float = 9.81


class Fields(NamedTuple):
    m: float = 0.1
    l: float = 2.0
    g: float = 9.81

    def rates(self, y, u):  # type: ignore[no-untyped-def]
        return law(y, u, self.m, self.l, self.g)


slots, frozen, fields = Slots(), Frozen(), Fields()


def of_slots(y, u):  # type: ignore[no-untyped-def]
    return law(y, u, slots.m, slots.l, slots.g)


def of_frozen_slots(y, u):  # type: ignore[no-untyped-def]
    return law(y, u, frozen.m, frozen.l, frozen.g)


def of_fields(y, u):  # type: ignore[no-untyped-def]
    return law(y, u, fields.m, fields.l, fields.g)


def of_fields_in_order(y, u):  # type: ignore[no-untyped-def]
    m, l, g = fields
    return law(y, u, m * fields[0] / fields.m, l, fields[-1] if len(fields) == 3 else g)


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "function",
    [of_slots, of_frozen_slots, of_fields, of_fields_in_order, Slots().rates, Slots().inside,
     Private().rates, fields.rates],
)  # fmt: skip
def test_their_numbers_are_those_of_the_scene(function: Callable) -> None:
    found = check(SCENE, function, blame=False)
    assert found.verdict is Verdict.PROVED
    told = " ".join(found.remarks)
    assert all(f"{number} " in told.replace(",", " ") for number in ("m = 0.1", "g = 9.81"))
    assert (slots.m, frozen.m, fields) == (0.1, 0.1, (0.1, 2.0, 9.81))


def test_what_is_wrong_for_other_numbers_is_refuted() -> None:
    def only_here(y, u):  # type: ignore[no-untyped-def]
        return law(y, u, fields.m, fields.l, fields.g * slots.l / 2)

    assert check(SCENE, only_here, blame=False).verdict is Verdict.REFUTED
