"""What code returns by name, nests, or ends without: no traceback, and no exit of its own."""

from collections.abc import Callable
from math import sin
from typing import Any

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()


def acceleration(theta: Any, u: Any, m: Any, l: Any, g: Any) -> Any:
    return 3 * g / (2 * l) * sin(theta) + 3 * u / (m * l**2)


def verdict(function: Callable) -> Verdict:
    return check(SCENE, function, blame=False).verdict


def test_keys_of_the_state_are_what_their_values_are_the_rates_of() -> None:
    def right(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return {"theta_dot": acceleration(theta, u, m, l, g), "theta": theta_dot}

    def exchanged(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return {"theta_dot": theta_dot, "theta": acceleration(theta, u, m, l, g)}

    assert verdict(right) is Verdict.PROVED
    assert verdict(exchanged) is Verdict.REFUTED


@pytest.mark.parametrize("end", [SystemExit(0), GeneratorExit()], ids=repr)
def test_code_that_ends_the_program_does_not_end_ours(end: BaseException) -> None:
    def leaves(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        raise end

    with pytest.raises(InputError, match=type(end).__name__):
        check(SCENE, leaves)


def test_a_tuple_within_a_tuple_is_refused_in_one_line() -> None:
    def nested(theta, theta_dot, u, m, l, g):  # type: ignore[no-untyped-def]
        return ((theta_dot, (acceleration(theta, u, m, l, g), 3 * g)),)

    with pytest.raises(InputError, match="returns tuple"):
        check(SCENE, nested)


def test_a_residual_that_is_zero_on_one_side_is_not_shown() -> None:
    def one_sided(theta, theta_dot, theta_ddot, u, m, l, g):  # type: ignore[no-untyped-def]
        return max(0, theta_ddot - acceleration(theta, u, m, l, g))

    assert verdict(one_sided) is Verdict.UNDECIDED
