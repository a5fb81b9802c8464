"""How code gives its results: arrays that it writes, dictionaries, what solves linear systems."""

from collections.abc import Callable

import numpy as np
import pytest
import scipy.linalg
from numpy.linalg import solve
from scipy import linalg

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import cartpole
from systems.double_pendulum import scene

SCENE = scene()
m1, m2, l1, l2, g = 1.0, 2.0, 1.0, 0.5, 9.81


def mass(q):  # type: ignore[no-untyped-def]
    other = m2 * l1 * l2 * np.cos(q[0] - q[1])
    return np.array([[(m1 + m2) * l1**2, other], [other, m2 * l2**2]])


def right(q, v, sign=1):  # type: ignore[no-untyped-def]
    s = m2 * l1 * l2 * np.sin(q[0] - q[1])
    first = -s * v[1] ** 2 - (m1 + m2) * g * l1 * np.sin(q[0])
    return np.array([first, sign * s * v[0] ** 2 - m2 * g * l2 * np.sin(q[1])])


def lower_half(a):  # type: ignore[no-untyped-def]
    a[0, 1] = 7.0
    return a


def least_squares(a, b):  # type: ignore[no-untyped-def]
    found, *_ = np.linalg.lstsq(a, b, rcond=None)
    return found


def cramer(a, b):  # type: ignore[no-untyped-def]
    whole = np.linalg.det(a)
    first = np.linalg.det(np.column_stack([b, a[:, 1]]))
    return np.array([first, np.linalg.det(np.column_stack([a[:, 0], b]))]) / whole


SOLVERS = [
    np.linalg.solve, solve, least_squares, cramer,
    lambda a, b: np.linalg.inv(a) @ b,
    lambda a, b: np.linalg.pinv(a).dot(b),
    lambda a, b: scipy.linalg.solve(a, b),
    lambda a, b: linalg.solve(a, b, assume_a="pos"),
    lambda a, b: linalg.lu_solve(linalg.lu_factor(a), b),
    lambda a, b: linalg.cho_solve(linalg.cho_factor(a), b),
    lambda a, b: linalg.cho_solve(linalg.cho_factor(lower_half(a), lower=True), b),
]  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("solved", SOLVERS)
def test_linear_systems(solved: Callable) -> None:
    def rates(t, y):  # type: ignore[no-untyped-def]
        q, v = y[:2], y[2:]
        return np.concatenate([v, solved(mass(q), right(q, v))])

    def wrong(t, y):  # type: ignore[no-untyped-def]
        q, v = y[:2], y[2:]
        return np.concatenate([v, solved(mass(q), right(q, v, -1))])

    assert check(SCENE, rates, blame=False).verdict is Verdict.PROVED
    assert check(SCENE, wrong, blame=False).verdict is Verdict.REFUTED


def test_arrays_beside_numbers_that_are_traced() -> None:
    def rates(t, y):  # type: ignore[no-untyped-def]
        a, b = mass(y), right(y, y[2:])
        whole = a[0, 0] * a[1, 1] - a[0, 1] * a[1, 0]
        return np.append(y[2:], np.array([[a[1, 1], -a[0, 1]], [-a[1, 0], a[0, 0]]]) @ b / whole)

    assert check(SCENE, rates, blame=False).verdict is Verdict.PROVED


def test_half_of_a_matrix_that_is_wrong_is_seen() -> None:
    def rates(t, y):  # type: ignore[no-untyped-def]
        q, v = y[:2], y[2:]
        return np.concatenate([v, linalg.solve(lower_half(mass(q)), right(q, v), assume_a="pos")])

    assert check(SCENE, rates, blame=False).verdict is Verdict.REFUTED


def test_an_array_that_is_written_is_what_is_returned() -> None:
    def rates(t, y, dydt):  # type: ignore[no-untyped-def]
        dydt[:2] = y[2:]
        dydt[2:] = np.linalg.solve(mass(y), right(y, y[2:]))

    def accelerations(q, v, out):  # type: ignore[no-untyped-def]
        found = np.linalg.solve(mass(q), right(q, v))
        out[0] = found[0]
        out[1] = found[0]
        return out

    assert check(SCENE, rates, blame=False).verdict is Verdict.PROVED
    assert check(SCENE, accelerations, blame=False).verdict is Verdict.REFUTED


def test_an_array_that_is_written_beside_what_is_returned_is_not_passed_over() -> None:
    def beside(q, v, M):  # type: ignore[no-untyped-def]
        M[0] = 5 * q[0]
        return np.linalg.solve(mass(q), right(q, v))

    def with_a_status(t, y, dydt):  # type: ignore[no-untyped-def]
        dydt[:2] = y[2:]
        dydt[2:] = np.linalg.solve(mass(y), right(y, y[2:]))
        return 0

    with pytest.raises(InputError, match="function beside: it fills M and returns something else"):
        check(SCENE, beside, blame=False)
    assert check(SCENE, with_a_status, blame=False).verdict is Verdict.PROVED


def test_keys_say_what_is_returned() -> None:
    def accelerations(q, qd, swapped=False):  # type: ignore[no-untyped-def]
        found = np.linalg.solve(mass(q), right(q, qd))
        return {"phi2_ddot": found[1], "phi1_ddot": found[0]}

    def rates(q, qd):  # type: ignore[no-untyped-def]
        found = np.linalg.solve(mass(q), right(q, qd))
        names = ("phi1_ddot", "phi1_dot", "phi2_ddot", "phi2_dot")
        return dict(zip(names, (found[0], qd[0], found[1], qd[1]), strict=True))

    def exchanged(q, qd):  # type: ignore[no-untyped-def]
        found = np.linalg.solve(mass(q), right(q, qd))
        return {"phi2_ddot": found[0], "phi1_ddot": found[1]}

    assert check(SCENE, accelerations, blame=False).verdict is Verdict.PROVED
    assert check(SCENE, rates, blame=False).verdict is Verdict.PROVED
    assert check(SCENE, exchanged, blame=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize(("period", "verdict"), [(2 * np.pi, "PROVED"), (np.pi, "REFUTED")])
def test_angles_may_be_wrapped_by_their_period(period: float, verdict: str) -> None:
    def rates(t, y):  # type: ignore[no-untyped-def]
        q, v = (y[:2] + np.pi) % period - np.pi, y[2:]
        return np.concatenate([v, np.linalg.solve(mass(q), right(q, v))])

    assert check(SCENE, rates, blame=False).verdict.name == verdict


CART = cartpole.scene()


def test_entries_of_x_are_no_coordinate_x() -> None:
    def update(t, x, u, params={}):  # type: ignore[no-untyped-def]  # noqa: B006
        mc, mp = params.get("mc", 1.0), params.get("mp", 0.1)
        l, g = params.get("l", 0.5), params.get("g", 9.8)
        other = mp * l * np.cos(x[1])
        a = np.array([[mc + mp, other], [other, 4 / 3 * mp * l**2]])
        b = [u[0] + mp * l * np.sin(x[1]) * x[3] ** 2, mp * g * l * np.sin(x[1])]
        return np.concatenate((x[2:4], solve(a, b)))

    assert check(CART, update, blame=False).verdict is Verdict.PROVED


def test_what_has_no_name_is_told() -> None:
    def star(t, y, *args):  # type: ignore[no-untyped-def]
        (force,) = args
        return [y[1], force, y[3], 0]

    def by_settings(state, force, settings):  # type: ignore[no-untyped-def]
        return [state[1], force / settings.cart_mass, state[3], 0]

    with pytest.raises(InputError, match=r"\*args is read as nothing"):
        check(CART, star)
    with pytest.raises(InputError, match=r"settings.cart_mass: nothing .* --name 'cart_mass=..."):
        check(CART, by_settings)
