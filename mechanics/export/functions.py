"""What each function computes, in the words of its header: one comment a prototype."""

from mechanics.compiled.graphs import MATRICES
from mechanics.program.routine import Routine

FUNCTIONS = {
    "forward_dynamics": ("Accelerations u' (and multipliers) from the state.",),
    "mass_matrix": ("M of the equations M u' = f + B lambda.",),
    "forcing": ("Right side f of the equations M u' = f + B lambda.",),
    "residual": ("M u' - f - B lambda, and below it A u' - b of the constraints.",),
    "inverse_dynamics": (
        "Generalized forces, conjugate to u, which added to the loads give u'.",
    ),
    "energy": ("Kinetic, potential and total energy.",),
    "momenta": ("Momentum, angular momentum about the origin, and generalized momenta dT/du.",),
    "coordinate_rates": ("Rates of the coordinates: q' = N u + n.",),
    "jacobians": ("Derivatives of u' by q, u, inputs and p.",),
    "reactions": ("The reactions listed above, from the state.",),
    "domain": (
        "How far inside of its domain a reduced model is: where no margin is negative, what is",
        "reduced is within its bound. reduction.json has the bound, and the ranges in this order.",
    ),
    "prepare": ("What the forward dynamics use of the parameters only: once for many states.",),
    "forward_dynamics_prepared": (
        "The same accelerations with what the function above makes of p: fewer operations.",
        "Quotients by a parameter are products with its reciprocal: off by at most 1.5 units in",
        "the last place each, instead of 0.5.",
    ),
    "step": (
        "State at t + h by the classical Runge-Kutta method of order 4, inputs held over the",
        "step: in place with q_next = q and u_next = u.",
    ),
}  # fmt: skip
"""Lines about each function."""

OF_THE_SCENE = {
    "position": ("Position of a point, which the scene declares, from the origin.",),
    "rotation": ("Orientation of a frame, which the scene declares: v = R v_frame.",),
    "velocity": ("Velocity of a point, which the scene declares, in the inertial frame.",),
    "jacobian": ("Derivative by u of the velocity or angular velocity of that output.",),
}
"""The same of what a scene wants computed, by what is given."""

OUTPUTS = {
    "mass_matrix": "row i, column j",
    "forcing": "row i of the equations",
    "residual": "row i of the equations",
    "forces": "forces[i] * u[i] is a power in W",
    "generalized": "generalized[i] * u[i] is an energy in J",
    "linear": "component i in the inertial frame, in kg m/s",
    "angular": "component i in the inertial frame, in kg m^2/s",
    "qd": "rate of q[i], in the unit of q[i] per s",
    "margins": "a pair a range, value less its lower end and upper end less the value",
    "kinetic": "in J",
    "potential": "in J",
    "total": "in J",
    "ud_q": "derivative of ud[i] by q[j]",
    "ud_u": "derivative of ud[i] by u[j]",
    "ud_inputs": "derivative of ud[i] by inputs[j]",
    "ud_p": "derivative of ud[i] by p[j]",
    "position": "component i, in m",
    "rotation": "component i of axis j",
    "velocity": "component i, in m/s",
    "jacobian": "component i by u[j]",
}
"""What an entry is, for outputs that are no array with a table of its own."""


def about(code: Routine, name: str) -> str:
    """The comment before a prototype."""
    first, _ = code.shapes[0]
    lines = list(FUNCTIONS.get(name) or OF_THE_SCENE[first])
    for out, (rows, cols) in code.shapes:
        if out in OUTPUTS and rows * cols:
            place = f"i + {rows} * j" if out in MATRICES else "i" if rows > 1 else "0"
            lines.append(f"  {out}[{place}]: {OUTPUTS[out]}")
    return "/* " + "\n * ".join(lines) + " */"
