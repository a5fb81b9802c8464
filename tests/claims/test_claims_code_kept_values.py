"""Values that are computed once and kept: the code computes with them, whatever changed since."""

from collections.abc import Callable
from functools import cache, cached_property, lru_cache
from math import sin
from typing import Any

import pytest

from mechanics import check
from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()


class Rod:
    def __init__(self, m: float, l: float, g: float) -> None:
        self.m, self.l, self.g = m, l, g

    @cached_property
    def by_property(self) -> float:
        return self.m * self.l**2 / 3

    @cached_property
    def from_another(self) -> float:
        return 1 * self.by_property

    @lru_cache  # noqa: B019
    def by_call(self) -> float:
        return self.m * self.l**2 / 3

    @cache  # noqa: B019
    def by_argument(self, part: float) -> float:
        return self.m * self.l**2 / part

    def rates_property(self, t, y, u):  # type: ignore[no-untyped-def]
        return [y[1], (self.m * self.g * self.l / 2 * sin(y[0]) + u) / self.by_property]

    def rates_another(self, t, y, u):  # type: ignore[no-untyped-def]
        return [y[1], (self.m * self.g * self.l / 2 * sin(y[0]) + u) / self.from_another]

    def rates_call(self, t, y, u):  # type: ignore[no-untyped-def]
        return [y[1], (self.m * self.g * self.l / 2 * sin(y[0]) + u) / self.by_call()]

    def rates_argument(self, t, y, u):  # type: ignore[no-untyped-def]
        return [y[1], (self.m * self.g * self.l / 2 * sin(y[0]) + u) / self.by_argument(3)]


STALE = Rod(1.0, 1.0, 9.81)


def by_another_object(t, y, u):  # type: ignore[no-untyped-def]
    return [y[1], (STALE.m * STALE.g * STALE.l / 2 * sin(y[0]) + u) / STALE.by_property]


FORMS = [Rod.rates_property, Rod.rates_another, Rod.rates_call, Rod.rates_argument]


def _proved(function: Callable[..., Any]) -> bool:
    return check(SCENE, function, blame=False).verdict is Verdict.PROVED


@pytest.mark.parametrize("form", FORMS)
def test_what_is_computed_before_a_change_is_refused(form: Callable[..., Any]) -> None:
    rod = Rod(1.0, 1.0, 9.81)
    form(rod, 0.0, [0.3, 0.0], 0.0)
    rod.l = 2.0
    with pytest.raises(InputError, match="was computed before"):
        check(SCENE, form.__get__(rod))


@pytest.mark.parametrize("form", FORMS)
def test_what_is_computed_after_a_change_is_followed(form: Callable[..., Any]) -> None:
    rod = Rod(1.0, 1.0, 9.81)
    rod.l = 2.0
    form(rod, 0.0, [0.3, 0.0], 0.0)
    assert _proved(form.__get__(rod))


def test_an_object_of_the_file_is_looked_at_too() -> None:
    assert STALE.by_property == 1 / 3
    vars(STALE)["l"] = 2.0
    with pytest.raises(InputError, match="by_property was computed before"):
        check(SCENE, by_another_object)


def test_what_another_object_keeps_is_no_matter() -> None:
    stale, rod = Rod(1.0, 1.0, 9.81), Rod(1.0, 1.0, 9.81)
    stale.by_call()
    stale.l = 2.0
    assert _proved(rod.rates_call)


KEPT = """from functools import cached_property
class Rod:
    def __init__(self, m, l, g):
        self.m, self.l, self.g = m, l, g
    {}
    def inertia(self):
        return self.m*self.l**2/3
    def rate(self, t, y, u):
        return [y[1], (self.m*self.g*self.l/2*sin(y[0]) + u)/self.inertia]
rod = Rod(1.0, 1.0, 9.81)
rod.l = 2.0
"""


@pytest.mark.parametrize(
    ("kept", "quoted"), [("@cached_property", ("rod.l = 2.0",)), ("@property", ())]
)
def test_a_change_of_what_is_kept_is_quoted(kept: str, quoted: tuple[str, ...]) -> None:
    column = Match("y", "theta theta_dot", "the usual name of such a vector")
    naming = Naming(Vocabulary(SCENE), {}, (column,))
    assert lines_around(KEPT.format(kept), {"rate"}, naming) == quoted
