"""A Python function is judged by its formulas only where it computes them with numbers, too."""

import math
import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp

import mechanics
from mechanics.claims.code.trace.numerical_check import doubt_when_called
from mechanics.claims.code.trace.tracing import trace
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import rod_pendulum

ROD = derived(rod_pendulum.scene())
NAMES = {"state": "theta theta_dot"}
CALLS = [0]
CACHE: dict[str, int] = {}


def rates(state, u, m, l, g, three: Any = 3) -> list:  # type: ignore[no-untyped-def]
    theta, theta_dot = state
    return [theta_dot, three * g / (2 * l) * np.sin(theta) + 3 * u / (m * l**2)]


def filled(array: np.ndarray, values: list) -> np.ndarray:
    array[0], array[1] = values
    return array


def array_of_integers(state, u, m, l, g):
    return filled(np.array([0, 0]), rates(state, u, m, l, g))


def zeros_of_integers(state, u, m, l, g):
    return filled(np.zeros(2, dtype=int), rates(state, u, m, l, g))


def array_as_integers(state, u, m, l, g):
    return np.array(rates(state, u, m, l, g), dtype=int)


def state_as_integers(state, u, m, l, g):
    return [state[1], rates(np.array(state, dtype=int), u, m, l, g)[1]]


def by_dtype(state, u, m, l, g):
    return rates(state, u, m, l, g, 3 if state.dtype == object else 4)


def by_type(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if type(state[0]).__name__ == "float64" else 3)


def by_type_of_a_float(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if type(u).__name__ == "float" else 3)


def by_attribute(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if hasattr(state[0], "dtype") else 3)


def by_class(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if isinstance(u, np.floating) else 3)


def by_subtype(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if np.issubdtype(state.dtype, np.floating) else 3)


def by_exception(state, u, m, l, g):
    try:
        three = 4 if u // 2 > -5 else 5
    except TypeError:
        three = 3
    return rates(state, u, m, l, g, three)


def rounded(state, u, m, l, g):
    try:
        u = round(u)
    except TypeError:
        u = u + 0
    return rates(state, u, m, l, g)


def rounded_array(state, u, m, l, g):
    try:
        u = np.round(u)
    except TypeError:
        u = u + 0
    return rates(state, u, m, l, g)


def by_global_state(state, u, m, l, g):
    CALLS[0] += 1
    return rates(state, u, m, l, g, 3 if CALLS[0] == 1 else 4)


def by_cache(state, u, m, l, g):
    CACHE["k"] = 4 if "k" in CACHE else 3
    return rates(state, u, m, l, g, CACHE["k"])


def by_mutable_default(state, u, m, l, g, log=[]):  # noqa: B006
    log.append(1)
    return rates(state, u, m, l, g, 3 if len(log) == 1 else 4)


SOURCE = random.Random(1)


def by_chance(state, u, m, l, g):
    return rates(state, u, m, l, g, 3 if SOURCE.random() < 0.5 else 4)


def absorbed(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if u == u + 1e-300 else 3)


def truncated_on_one_way(state, u, m, l, g):
    array = np.zeros(2) if state[1] < 20 else np.zeros(2, dtype=int)
    return filled(array, rates(state, u, m, l, g))


def no_sum(state, u, m, l, g):
    return rates(
        state,
        u if u + 0 is not None and type(u).__module__ not in ("builtins", "numpy") else None,
        m,
        l,
        g,
    )


def one_number_more(state, u, m, l, g):
    return rates(state, u, m, l, g) + ([0.0] if type(u).__module__ in ("builtins", "numpy") else [])


def never_defined(state, u, m, l, g):
    if type(u).__module__ in ("builtins", "numpy"):
        raise ValueError("no number\nis right")
    return rates(state, u, m, l, g)


def absorbed_far_away(state, u, m, l, g):
    return rates(state, u + 1e30 - 1e30 if u > 1e9 else u, m, l, g)


def truth_by_identity(state, u, m, l, g):
    return rates(state, u, m, l, g, 4 if (u > 1e9) is True else 3)


def changed_by_another_name(state, u, m, l, g):
    other = np.array(state, copy=False)
    if u > 1e9:
        other = np.array(other, dtype=float, copy=False)
        other[0] = 0.0
    return rates(state, u, m, l, g)


def sum_of_truths(state, u, m, l, g):
    one = (np.array([True]) + np.array([True]))[0]
    return rates(state, u, m, l, g, 3 + one - 1 if u < 1e9 else 3 * (2 - one) + one - 1)


def no_truth(state, u, m, l, g):
    return rates(state, u, m, l, g, 3 if (~np.array([True]))[0] == 0 or u < 1e9 else 4)


def large_integer(state, u, m, l, g):
    zero = (np.array([2**62]) * 4)[0]
    return rates(state, u, m, l, g, 3 if zero == 0 or u < 1e9 else 4)


OTHERWISE = [absorbed, absorbed_far_away]
OF_INTEGERS = [
    array_of_integers, zeros_of_integers, array_as_integers, state_as_integers,
    truncated_on_one_way,
]  # fmt: skip


@pytest.mark.parametrize("function", OF_INTEGERS)
def test_what_is_put_into_an_array_of_integers_is_not_followed(function: Callable) -> None:
    with pytest.raises(InputError, match="arrays of integers and the like hide a formula, in line"):
        mechanics.check(ROD, function, names=NAMES)


def test_truth_values_are_not_told_apart_by_identity() -> None:
    with pytest.raises(InputError, match="is, which compares no numbers"):
        mechanics.check(ROD, truth_by_identity, names=NAMES)


def test_an_array_under_another_name_is_the_same_array() -> None:
    found = mechanics.check(ROD, changed_by_another_name, names=NAMES)
    assert {j.finding.verdict.name for j in found.judged} == {"UNDECIDED"}


@pytest.mark.parametrize("function", [sum_of_truths, no_truth, large_integer])
def test_arrays_of_integers_and_truths_compute_as_those_of_numpy(function: Callable) -> None:
    found = mechanics.check(ROD, function, names=NAMES)
    assert {j.finding.verdict.name for j in found.judged} == {"PROVED"}


@pytest.mark.parametrize(
    "function",
    [by_dtype, by_type, by_type_of_a_float, by_attribute, by_class, by_subtype, no_sum,
     one_number_more, never_defined],
)  # fmt: skip
def test_code_that_asks_of_which_class_a_number_is_is_refused(function: Callable) -> None:
    with pytest.raises(InputError, match=r"of which class a number is|it calls (dtype|__module__)"):
        mechanics.check(ROD, function, names=NAMES)


@pytest.mark.parametrize("function", [by_exception, rounded, rounded_array])
def test_what_fails_for_traced_numbers_only_is_refused_where_the_code_goes_on(function) -> None:
    with pytest.raises(InputError, match=r"cannot be traced: line .* TypeError"):
        mechanics.check(ROD, function, names=NAMES)


@pytest.mark.parametrize("function", OTHERWISE)
def test_code_that_computes_something_else_with_numbers_has_a_doubt(function: Callable) -> None:
    found = mechanics.check(ROD, function, names=NAMES)
    verdicts = {j.finding.verdict.name for j in found.judged}
    assert verdicts == {"UNDECIDED"}
    for judged in found.judged:
        words = judged.statement.doubt
        assert words.startswith("called with numbers it returns other values than its formulas")
        assert "theta = " in words
        assert "\n" not in words


@pytest.mark.parametrize("function", [by_global_state, by_cache, by_mutable_default])
def test_code_that_changes_what_stays_has_a_doubt(function: Callable) -> None:
    found = mechanics.check(ROD, function, names=NAMES)
    assert {j.finding.verdict.name for j in found.judged} == {"UNDECIDED"}
    assert found.judged[0].statement.doubt.startswith("a call changes ")


def test_code_that_calls_chance_is_refused() -> None:
    with pytest.raises(InputError, match=r"it calls random numbers|depends on where"):
        mechanics.check(ROD, by_chance, names=NAMES)


def in_single_precision(state, u, m, l, g):
    return np.array(rates(state, u, m, l, g), dtype=np.float32)


def as_a_list(state, u, m, l, g):
    return [state[1], 1.5 * g / l * math.sin(state[0]) + 3 * u / (m * l**2)]


def like_the_state(state, u, m, l, g):
    return filled(np.zeros_like(state), rates(state, u, m, l, g))


def of_a_numpy_scalar(state, u, m, l, g):
    return rates(state, u.item(), m, l, g)


def of_a_scalar(state, u, m, l, g):
    return rates(state, u, m, l, g, 3 if np.isscalar(state[0]) else 4)


def by_a_root(state, u, m, l, g):
    sine = np.sign(math.sin(state[0])) * math.sqrt(1 - math.cos(state[0]) ** 2)
    return [state[1], rates(state, u, m, l, g)[1] + 0 * sine]


def partly_defined(state, u, m, l, g):
    if u > 1:
        raise ValueError("beyond the motor")
    assert abs(state[0]) < 3
    return rates(state, u, m, l, g)


def undefined_by_halves(state, u, m, l, g):
    return rates(state, np.sqrt(u) ** 2, m, l, g)


RIGHT = [
    rates, in_single_precision, as_a_list, like_the_state, of_a_numpy_scalar, of_a_scalar,
    by_a_root, partly_defined,
]  # fmt: skip


@pytest.mark.parametrize("function", RIGHT)
def test_right_code_stays_proved(function: Callable) -> None:
    found = mechanics.check(ROD, function, names=NAMES)
    assert [j.statement.doubt for j in found.judged] == ["", ""]
    assert [j.finding.verdict.name for j in found.judged] == ["PROVED", "PROVED"]


def test_right_code_that_is_nan_for_half_of_all_states_is_shown_where_it_is_not():
    found = mechanics.check(ROD, undefined_by_halves, names=NAMES)
    first, second = (j.finding for j in found.judged)
    assert (first.verdict.name, first.domain) == ("PROVED", "")
    assert (second.verdict.name, second.domain) == ("UNDECIDED", "PROVED WHERE u >= 0")


X, Y = sp.symbols("x y", real=True)


def cancelling(x, y):
    return [((x + 1e6) - 1e6) * y, 1 / (1e-3 * y) - 1 / (1e-3 * x)]


def solving_in_single_precision(x, y):
    matrix = np.array([[2 + x * x, x * y], [x * y, 2 + y * y]], dtype=np.float32)
    return np.linalg.solve(matrix, np.array([x, y], dtype=np.float32))


def overflowing(x, y):
    return [math.exp(200 * x * x), math.cosh(y)]


@pytest.mark.parametrize("function", [cancelling, solving_in_single_precision, overflowing])
def test_rounding_and_overflow_are_no_doubt(function: Callable) -> None:
    given = {"x": X, "y": Y}
    assert doubt_when_called(function, given, trace(function, given)) == ""


def test_formulas_without_a_value_anywhere_are_told() -> None:
    given = {"x": X}

    def nowhere(x):
        return [np.sqrt(-1 - x * x)]

    words = doubt_when_called(nowhere, given, trace(nowhere, given))
    assert words == "it cannot be called with numbers: its formulas have no value at random states"


TENTH, QUARTER = np.float32(0.1), np.float32(0.25)


def a_rounded_number(theta, theta_dot, u, m, l, g):
    return np.float32(0.1) * g * 15 / l * np.sin(theta) + 3 * u / (m * l**2)


def a_rounded_number_outside(theta, theta_dot, u, m, l, g):
    return TENTH * g * 15 / l * np.sin(theta) + 3 * u / (m * l**2)


def a_rounded_entry(theta, theta_dot, u, m, l, g):
    numbers = np.array([0.1, 3], dtype=np.float32)
    return numbers[0] * g * 15 / l * np.sin(theta) + numbers[1] * u / (m * l**2)


@pytest.mark.parametrize("function", [a_rounded_number, a_rounded_number_outside, a_rounded_entry])
def test_a_number_that_single_precision_rounds_is_refused(function: Callable) -> None:
    with pytest.raises(InputError, match=r"0\.1 is rounded to 0\.1000000014"):
        mechanics.check(ROD, function)


def a_held_number(theta, theta_dot, u, m, l, g):
    return QUARTER * 6 * g / l * np.sin(theta) + np.float32(3) * u / (m * l**2)


def test_single_precision_is_told() -> None:
    found = mechanics.check(ROD, a_held_number)
    assert found.ok
    assert any(note.startswith("single precision") for note in found.judged[0].statement.notes)
