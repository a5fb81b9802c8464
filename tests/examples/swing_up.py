"""Swing up a pendulum on a cart with CasADi's Opti and IPOPT, and try the force that is found.

    minimise    sum F_k^2 h
    subject to  (q, u)_(k+1) = step((q, u)_k, F_k, h),   |F_k| <= 30 N,   |q0| <= 1 m
                q1 = pi and all at rest at the begin,    q1 = 0 and all at rest at the end

The pendulum hangs at q1 = pi and stands upright at q1 = 0. ``step`` is a function of the model: one
Runge-Kutta step of order four. Opti differentiates it, twice. Whether the force does what it should
is then seen by another integrator, DOP853 with small steps, which knows nothing of the plan but the
force. Run it with ``python tests/examples/swing_up.py``.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np

import mechanics
from mechanics.simulate import Trajectory
from systems import pendulum_chain

DURATION, INTERVALS = 3.0, 90  # s, each with a constant force
LARGEST_FORCE, RAIL = 30.0, 1.0  # N, m
HANGING, UPRIGHT = np.pi, 0.0
IPOPT = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes"}


@dataclass(frozen=True)
class Plan:
    """What the optimiser found: forces over equal intervals, and the states between them."""

    force: np.ndarray
    q: np.ndarray
    u: np.ndarray

    def __call__(self, t: float) -> float:
        """The force at a time, in N: constant over each interval."""
        k = int(t / DURATION * len(self.force))
        return float(self.force[min(k, len(self.force) - 1)])


def cart_pole() -> mechanics.Model:
    """A cart of 2 kg with a link of 1 m and 1 kg at its end."""
    scene = pendulum_chain.scene(links=1)
    return mechanics.compile(mechanics.derive(scene))


def swing_up(model: mechanics.Model, intervals: int = INTERVALS) -> Plan:
    """The plan with the smallest sum of squares of the force."""
    step, p, h = model.casadi["step"], model.typical, DURATION / intervals
    opti = ca.Opti()
    q, u = opti.variable(2, intervals + 1), opti.variable(2, intervals + 1)
    F = opti.variable(1, intervals)

    opti.minimize(ca.sumsqr(F) * h)
    q_next, u_next = step.map(intervals)(q[:, :-1], u[:, :-1], F, p, h)
    opti.subject_to(q[:, 1:] == q_next)
    opti.subject_to(u[:, 1:] == u_next)
    opti.subject_to(opti.bounded(-LARGEST_FORCE, F, LARGEST_FORCE))
    opti.subject_to(opti.bounded(-RAIL, q[0, :], RAIL))
    opti.subject_to(q[:, 0] == [0, HANGING])
    opti.subject_to(q[:, -1] == [0, UPRIGHT])
    opti.subject_to([u[:, 0] == 0, u[:, -1] == 0])

    # A guess that turns the pendulum steadily; from rest the optimiser finds no way up.
    opti.set_initial(q[1, :], np.linspace(HANGING, UPRIGHT, intervals + 1))
    opti.solver("ipopt", IPOPT)
    found = opti.solve()
    return Plan(found.value(F), found.value(q), found.value(u))


def tried(model: mechanics.Model, plan: Plan) -> Trajectory:
    """The motion that the force drives, by DOP853."""
    return mechanics.simulate(
        model,
        DURATION,
        initial={"q0": 0, "q1": HANGING},
        inputs={"F": plan},
        samples=len(plan.force) + 1,
    )


def main() -> None:
    """Print what was found."""
    model = cart_pole()
    plan = swing_up(model)
    motion = tried(model, plan)
    q0, q1 = motion.coordinates["q0"], motion.coordinates["q1"]
    print(f"largest force            {np.max(np.abs(plan.force)):7.3f} N of {LARGEST_FORCE} N")
    print(f"farthest from the middle {np.max(np.abs(q0)):7.3f} m of {RAIL} m")
    print(f"angle at the end         {q1[-1]:7.4f} rad from upright")
    print(f"from the plan            {np.max(np.abs(q1 - plan.q[1])):7.4f} rad at most")


if __name__ == "__main__":
    main()
