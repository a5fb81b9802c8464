"""Every output that is compiled, on random trees in space, is what a textbook's recursion gives.

The recursion is plain NumPy and knows neither scenes nor routes. Derivatives are its own with
complex numbers (x + i h): exact but for rounding, by q, u and every parameter.
"""

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings
from hypothesis import strategies as st

from benchmarks.space.random_trees import build, links, numbers, state, trees
from benchmarks.space.scenes import Joint
from benchmarks.space.textbook import heights, inverse_dynamics, loads, turn
from mechanics import Model, compile, derive

ROUNDINGS = 64 * np.finfo(float).eps
STEP = 1e-150
CONJUGATE = ("kane", "lagrange")
"""Routes whose rows are conjugate to u; the others' may be combinations of them."""
PHASES = (Phase.explicit, Phase.generate)

Array = np.ndarray


class Textbook:
    """A tree at numbers, and what it should do there."""

    def __init__(self, joints: tuple[Joint, ...], drawn: int) -> None:
        self.joints = joints
        self.links, self.values = numbers(joints, drawn)
        self.q, self.u, self.ud, _ = state(len(joints), drawn + 1)
        self.none = np.zeros(len(joints))
        self.g = self.values["g"]

    def torques(self, ud: Array, sizes: bool = False) -> Array:
        return inverse_dynamics(self.links, self.q, self.u, ud, self.g, sizes)

    def inertial(self, ud: Array, sizes: bool = False) -> Array:
        """M u'."""
        return inverse_dynamics(self.links, self.q, self.none, ud, 0.0, sizes)

    def mass_matrix(self) -> Array:
        return np.array([self.inertial(column) for column in np.eye(len(self.q))]).T

    def slopes(self, ud: Array, name: str, k: int) -> Array:
        """Derivatives of the torques at fixed u' by an entry of q, u, or by a parameter."""
        values = dict(self.values)
        q, u = self.q.astype(complex), self.u.astype(complex)
        if name == "q":
            q[k] += STEP * 1j
        elif name == "u":
            u[k] += STEP * 1j
        else:
            values[name] += STEP * 1j
        found = inverse_dynamics(links(self.joints, values), q, u, ud, values["g"])
        return np.imag(found) / STEP


def assert_outputs_agree(joints: tuple[Joint, ...], drawn: int, route: str) -> None:
    book = Textbook(joints, drawn)
    model = compile(derive(build(joints), route), compiler=None)
    p = np.array([book.values[name] for name in model.entries["p"]])
    for check in (
        of_torques,
        of_accelerations,
        of_energy,
        of_momenta,
        of_reactions,
        of_slopes,
        of_step,
    ):
        check(book, model, p)


def of_torques(book: Textbook, model: Model, p: Array) -> None:
    torques, sizes = book.torques(book.ud), book.torques(book.ud, sizes=True)
    found = model.inverse_dynamics(book.q, book.u, book.ud, p=p)
    assert np.all(np.abs(found - torques) <= ROUNDINGS * sizes)
    left = model.residual(book.q, book.u, book.ud, p=p)
    M, f = model.mass_matrix(book.q, book.u, p), model.forcing(book.q, book.u, p)
    room = np.max(sizes)
    assert np.all(np.abs(M @ book.ud - f - left) <= ROUNDINGS * room)
    if model.equations.route in CONJUGATE:
        bias, inertial = book.torques(book.none), book.inertial(book.ud)
        bound = ROUNDINGS * book.inertial(book.ud, sizes=True)
        assert np.all(np.abs(M @ book.ud - inertial) <= bound)
        assert np.all(np.abs(f + bias) <= ROUNDINGS * book.torques(book.none, sizes=True))
    assert np.array_equal(model.coordinate_rates(book.q, book.u, p), book.u)


def of_accelerations(book: Textbook, model: Model, p: Array) -> None:
    """|M u' - f| within 64 roundings of the terms, in whatever frame these are written.

    Along the axes of a body a term may be zero that is m sin(b) cos(b) - m cos(b) sin(b) along
    others: the terms of a joint are as large as the force or couple that it transmits.
    """
    ud = model.forward_dynamics(book.q, book.u, p)
    pairs = loads(book.links, book.q, book.u, ud, book.g, sizes=True)
    turning = [link.turning for link in book.links]
    room = [
        np.sum(pair[1] if turns else pair[0]) for pair, turns in zip(pairs, turning, strict=True)
    ]
    assert np.all(np.abs(book.torques(ud)) <= ROUNDINGS * np.array(room))


def of_energy(book: Textbook, model: Model, p: Array) -> None:
    energy = model.energy(book.q, book.u, p)
    kinetic = book.u @ book.inertial(book.u) / 2
    size = np.abs(book.u) @ book.inertial(book.u, sizes=True)
    assert abs(energy["kinetic"] - kinetic) <= ROUNDINGS * size
    masses = np.array([link.mass for link in book.links])
    raised = list(masses * book.g * heights(book.links, book.q))
    assert abs(energy["potential"] - sum(raised)) <= ROUNDINGS * sum(map(abs, raised))


def of_momenta(book: Textbook, model: Model, p: Array) -> None:
    """Momenta are the loads of a motion from rest with u' = u: on the joints, and on the ground."""
    found = model.evaluate("momenta", q=book.q, u=book.u, inputs=[], p=p)
    size = book.inertial(book.u, sizes=True)
    generalized = np.ravel(found["generalized"])
    assert np.all(np.abs(generalized - book.inertial(book.u)) <= ROUNDINGS * size)
    given = (book.links, book.q, book.none, book.u, 0.0)
    linear, angular = ground_loads(book, loads(*given))
    sizes = [np.sum(np.abs(load)) for pair in loads(*given, sizes=True) for load in pair]
    room = ROUNDINGS * sum(sizes)
    assert np.all(np.abs(np.ravel(found["linear"]) - linear) <= room)
    assert np.all(np.abs(np.ravel(found["angular"]) - angular) <= (1 + reach(book)) * room)


def ground_loads(book: Textbook, joints: list[tuple[Array, Array]]) -> tuple[Array, Array]:
    """Force of the ground and its moment about the origin."""
    total = np.zeros((2, 3))
    for link, q, (force, couple) in zip(book.links, book.q, joints, strict=True):
        if link.parent < 0:
            arm = link.offset + (0 if link.turning else link.rotation @ np.eye(3)[link.axis] * q)
            R = link.rotation @ (turn(link.axis, q) if link.turning else np.eye(3))
            total += R @ force, R @ couple + np.cross(arm, R @ force)
    return total[0], total[1]


def reach(book: Textbook) -> float:
    """What no point of the tree is farther from the origin than."""
    steps = [np.linalg.norm(link.offset) + np.linalg.norm(link.centre) for link in book.links]
    return float(sum(steps) + np.sum(np.abs(book.q)))


def of_reactions(book: Textbook, model: Model, p: Array) -> None:
    ud = model.forward_dynamics(book.q, book.u, p)
    if "reactions" not in tuple(model.casadi):
        return  # the rows of this route tell none of them
    found = model.evaluate("reactions", q=book.q, u=book.u, inputs=[], p=p)["reactions"]
    given = (book.links, book.q, book.u, ud, book.g)
    wanted, sizes = loads(*given), loads(*given, sizes=True)
    # u' is known to a rounding of the largest torque, and with it what a joint transmits.
    largest = max(np.max(load) for pair in sizes for load in pair)
    names = [entry.name for entry in model.quantities.reactions]
    for name, value in zip(names, np.ravel(found), strict=True):
        kind, axis, i = "FC".index(name[0]), "xyz".index(name[1]), int(name[2:]) - 1
        assert abs(value - wanted[i][kind][axis]) <= ROUNDINGS * largest


def of_slopes(book: Textbook, model: Model, p: Array) -> None:
    """M d u'/d x = -d torques / d x at the u' of the motion."""
    ud = model.forward_dynamics(book.q, book.u, p)
    M = book.mass_matrix()
    found = model.evaluate("jacobians", q=book.q, u=book.u, inputs=[], p=p)
    size = np.max(book.torques(ud, sizes=True))
    names: dict[str, list[tuple[str, int]]] = {
        "ud_q": [("q", k) for k in range(len(book.q))],
        "ud_u": [("u", k) for k in range(len(book.q))],
        "ud_p": [(name, 0) for name in model.entries["p"]],
    }
    for group, variables in names.items():
        for column, variable in zip(np.atleast_2d(found[group]).T, variables, strict=True):
            slopes = book.slopes(ud, *variable)
            room = np.abs(M) @ np.abs(column) + np.abs(slopes) + size
            assert np.all(np.abs(M @ column + slopes) <= 4 * ROUNDINGS * room), variable


def of_step(book: Textbook, model: Model, p: Array) -> None:
    """One step of Runge and Kutta's classical method, written out."""
    h, n = 1e-3, len(book.q)

    def rate(y: Array) -> Array:
        ud = model.forward_dynamics(y[:n], y[n:], p)
        return np.concatenate([y[n:], ud])

    y = np.concatenate([book.q, book.u])
    k1 = rate(y)
    k2 = rate(y + h / 2 * k1)
    k3 = rate(y + h / 2 * k2)
    k4 = rate(y + h * k3)
    wanted = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    found = model.evaluate("step", q=book.q, u=book.u, inputs=[], p=p, h=[h])
    got = np.concatenate([np.ravel(found["q_next"]), np.ravel(found["u_next"])])
    assert np.all(np.abs(got - wanted) <= ROUNDINGS * (np.abs(y) + h * np.abs(k1)))


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("route", ("free_body", "moving_point", "kane", "lagrange"))
@pytest.mark.parametrize("part", range(100))
def test_three_hundred_random_trees(part: int, route: str) -> None:
    @seed(part)
    @settings(max_examples=3, phases=PHASES, deadline=None)
    @given(trees(), st.integers(0, 2**32))
    def assert_three_agree(joints: tuple[Joint, ...], drawn: int) -> None:
        assert_outputs_agree(joints, drawn, route)

    assert_three_agree()
