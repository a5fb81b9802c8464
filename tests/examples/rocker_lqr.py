"""Balance the rocker by an LQR, and find out from where it comes back.

    y' = A y + B f,   y = (theta, theta')        minimise  integral of y^T Q y + r f^2
    A^T P + P A - P B B^T P / r + Q = 0          f = -K y,   K = B^T P / r

A and B come from `mechanics.linearize` at theta = 0, exactly, and are made numbers by
`state_space`; SciPy solves Riccati's equation. The law then holds the nonlinear rocker, with the
force as state feedback, while the simulation watches that it neither lifts off nor slips nor leaves
its half discs. Run it with ``python tests/examples/rocker_lqr.py``.
"""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import logm, solve_continuous_are

import mechanics
from mechanics.linear import state_space
from mechanics.simulate import Ending, Trajectory
from systems import rocker

# Deviations that cost as much as each other: 0.1 rad, 1 rad/s, 1 N.
LARGEST = (0.1, 1.0, 1.0)
DURATION = 3.0  # s
BACK = 1e-2  # share of the first deviation that may be left in the end


@dataclass(frozen=True)
class Regulator:
    """The gains, and the linear closed loop y' = (A - B K) y."""

    gains: np.ndarray
    closed_loop: np.ndarray

    @property
    def law(self) -> mechanics.Feedback:
        """The force as a function of the state."""
        return mechanics.Feedback(lambda t, q, u: -self.gains @ [*q, *u])

    @property
    def poles(self) -> np.ndarray:
        """Of the closed loop, in 1/s."""
        return np.sort_complex(np.linalg.eigvals(self.closed_loop))


def design(equations: mechanics.Equations) -> Regulator:
    """The regulator for the upright rocker."""
    linear = mechanics.linearize(equations, at={"theta": 0}, inputs={"f": 0})
    A, B = state_space(linear)
    *states, force = (1 / deviation**2 for deviation in LARGEST)
    P = solve_continuous_are(A, B, np.diag(states), [[force]])
    K = B.T @ P / force
    return Regulator(K, A - B @ K)


def released(
    model: mechanics.Model, regulator: Regulator, theta: float, theta_dot: float = 0.0,
    duration: float = DURATION,
) -> Trajectory:  # fmt: skip
    """The nonlinear closed loop from an initial state."""
    return mechanics.simulate(
        model,
        duration,
        initial={"theta": theta, "theta_dot": theta_dot},
        inputs={"f": regulator.law},
        samples=201,
    )


def measured_poles(model: mechanics.Model, regulator: Regulator, size: float = 1e-4) -> np.ndarray:
    """Poles of the nonlinear closed loop near the equilibrium: log of its flow, over time."""
    time = 0.1
    columns = []
    for start in ((size, 0.0), (0.0, size)):
        motion = released(model, regulator, *start, duration=time)
        columns.append([motion.coordinates["theta"][-1], motion.speeds["theta_dot"][-1]])
    return np.sort_complex(np.linalg.eigvals(logm(np.transpose(columns) / size) / time))


def comes_back(model: mechanics.Model, regulator: Regulator, theta: float) -> bool:
    """Whether the rocker, released at rest, returns without leaving the domain of the model."""
    try:
        motion = released(model, regulator, theta)
    except mechanics.MechanicsError:
        return False  # it would start outside
    deviation = abs(motion.coordinates["theta"][-1])
    return motion.ending is Ending.COMPLETE and deviation < BACK * theta


def largest_angle(model: mechanics.Model, regulator: Regulator) -> float:
    """The angle up to which it comes back, by bisection, in rad."""
    inside, outside = 0.0, np.pi / 2
    while outside - inside > 1e-3:
        middle = (inside + outside) / 2
        if comes_back(model, regulator, middle):
            inside = middle
        else:
            outside = middle
    return inside


def main() -> None:
    """Print what was found."""
    equations = mechanics.derive(rocker.scene())
    model, regulator = mechanics.compile(equations), design(equations)
    limit = largest_angle(model, regulator)
    stiffness, damping = regulator.gains[0]
    print(f"f = -{stiffness:.4g} N/rad * theta - {damping:.4g} N s/rad * theta'")
    print(f"poles of the linear closed loop    {regulator.poles}  1/s")
    print(f"poles of the nonlinear closed loop {measured_poles(model, regulator)}  1/s")
    print(f"released at rest it comes back from up to {limit:.3f} rad;")
    for beyond in (limit, limit + 2e-3):
        try:
            print(f"    from {beyond:.3f} rad: {released(model, regulator, beyond).reason}")
        except mechanics.MechanicsError as refusal:
            print(f"    from {beyond:.3f} rad: {refusal}")


if __name__ == "__main__":
    main()
