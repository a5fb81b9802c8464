"""Andrews' squeezing mechanism: seven bodies in a plane, three loops, one freedom.

A motor turns the crank K1 against a spring; K2, K3, K4 and K6 meet in the pin P. With the positions
of P by each way, from O, B and twice from A,

    P = O + rr e(beta) - d e(beta + theta)
      = B - ss n(gamma)
      = A + zt e(delta) - e n(phi + delta)
      = A - u n(epsilon) + zf e(omega + epsilon),     e(x) = (cos x, sin x), n(x) = (-sin x, cos x)

Source: the problem ANDREWS of the Test Set for Initial Value Problem Solvers (F. Mazzia,
C. Magherini, University of Bari), after E. Hairer and G. Wanner, Solving Ordinary Differential
Equations II (1996), section VII.7: geometry, parameters, state at t = 0 and motion.
"""

from sympy import ImmutableMatrix, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import (
    RigidBody,
    Scene,
    holonomic,
    parameters,
    reaction,
    spring,
    torque,
)
from mechanics.scene.published import published
from mechanics.scene.quantities import Identity, MassMatrix

beta, theta, gamma, phi, delta, omega, epsilon = coordinates = dynamicsymbols(
    "beta theta gamma phi delta omega epsilon"
)
xa, ya, xb, yb, xc, yc = parameters(
    "xa ya xb yb xc yc",
    units="m m m m m m",
    typical="-0.06934 -0.00227 -0.03635 0.03273 0.014 0.072",
    positive=False,
)
d, da, e, ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, zf, zt, fa = parameters(
    "d da e ea rr ra ss sa sb sc sd ta tb u ua ub zf zt fa",
    units=" ".join(["m"] * 19),
    typical="0.028 0.0115 0.02 0.01421 0.007 0.00092 0.035 0.01874 0.01043 0.018 0.02 0.02308"
    " 0.00916 0.04 0.01228 0.00449 0.02 0.04 0.01421",
)
c0, l0, mom = parameters("c0 l0 mom", units="N/m m N*m", typical="4530 0.07785 0.033")
masses = parameters(
    "m1 m2 m3 m4 m5 m6 m7",
    units=" ".join(["kg"] * 7),
    typical="0.04325 0.00365 0.02373 0.00706 0.07050 0.00706 0.05498",
)
inertias = parameters(
    "I1 I2 I3 I4 I5 I6 I7",
    units=" ".join(["kg*m^2"] * 7),
    typical="2.194e-6 4.410e-7 5.255e-6 5.667e-7 1.169e-5 5.667e-7 1.912e-5",
)

START = {
    "beta": -0.0617138900142764496358948458001,
    "theta": 0.0,
    "gamma": 0.455279819163070380255912382449,
    "phi": 0.222668390165885884674473185609,
    "delta": 0.487364979543842550225598953530,
    "omega": -0.222668390165885884674473185609,
    "epsilon": 1.23054744454982119249735015568,
}
"""Angles at t = 0, at rest."""

END = 0.03
"""Time of `ANGLES` and `RATES`, in s."""

ANGLES = {
    "beta": 15.81077119629904,
    "theta": -15.75637105984298,
    "gamma": 0.04082224013073101,
    "phi": -0.5347301163226948,
    "delta": 0.5244099658805304,
    "omega": 0.5347301163226948,
    "epsilon": 1.048080741042263,
}
RATES = {
    "beta": 1139.920302151208,
    "theta": -1424.379294994111,
    "gamma": 11.03291221937134,
    "phi": 19.29337464421385,
    "delta": 0.5735699284790808,
    "omega": -19.29337464421385,
    "epsilon": 0.3231791658026955,
}


def scene() -> Scene:
    """The seven bodies, with the three other arms cut off K2 at P."""
    ground, origin = ReferenceFrame("N"), Point("O")
    turned = {
        "K1": (ground, beta),
        "K3": (ground, gamma),
        "K5": (ground, delta),
        "K7": (ground, epsilon),
    }
    frames = {name: frame.orientnew(name, "Axis", (angle, ground.z))
              for name, (frame, angle) in turned.items()}  # fmt: skip
    for name, inner, angle in (("K2", "K1", theta), ("K4", "K5", phi), ("K6", "K7", omega)):
        frames[name] = frames[inner].orientnew(name, "Axis", (angle, ground.z))

    def place(start: Point, name: str, x: object, y: object, frame: ReferenceFrame) -> Point:
        return start.locatenew(name, x * frame.x + y * frame.y)

    a, b, c = (
        place(origin, n, x, y, ground) for n, x, y in (("A", xa, ya), ("B", xb, yb), ("C", xc, yc))
    )
    joint2 = place(origin, "end of K1", rr, 0, frames["K1"])
    joint4 = place(a, "end of K5", zt, 0, frames["K5"])
    joint6 = place(a, "end of K7", 0, -u, frames["K7"])
    starts = {"K1": origin, "K2": joint2, "K3": b, "K4": joint4, "K5": a, "K6": joint6, "K7": a}
    centres = {
        "K1": (ra, 0),
        "K2": (-da, 0),
        "K3": (sb, -sa),
        "K4": (0, ea - e),
        "K5": (ta, tb),
        "K6": (zf - fa, 0),
        "K7": (-ua, -ub),
    }
    ends = {"K2": (-d, 0), "K3": (0, -ss), "K4": (0, -e), "K6": (zf, 0)}
    carriers = {"K2": "K1", "K4": "K5", "K6": "K7"}
    bodies, reactions = [], []
    for (name, start), mass, inertia in zip(starts.items(), masses, inertias, strict=True):
        centre = place(start, f"centre of {name}", *centres[name], frames[name])
        bodies.append(RigidBody(name, centre, frames[name], mass, inertia))
        reactions += [
            reaction(f"{name}{axis}", at=start, on=name, by=carriers.get(name), along=along)
            for axis, along in (("x", ground.x), ("y", ground.y))
        ]
    pin = place(joint2, "P", *ends["K2"], frames["K2"])
    constraints = []
    for name in ("K3", "K4", "K6"):
        end = place(starts[name], f"end of {name}", *ends[name], frames[name])
        apart = pin.pos_from(end)
        for axis, along in (("x", ground.x), ("y", ground.y)):
            reactions.append(reaction(f"P{name[1]}{axis}", at=pin, on="K2", by=name, along=along))
            constraints.append(
                holonomic(f"P on {name} along {axis}", apart.dot(along), f"P{name[1]}{axis}")
            )
    spring_end = place(b, "D", sd, -sc, frames["K3"])
    return Scene(
        "Andrews' squeezing mechanism",
        ground,
        origin,
        coordinates=tuple(coordinates),
        bodies=tuple(bodies),
        loads=(
            torque("motor", mom * ground.z, on="K1"),
            spring("spring", c, spring_end, c0, length=l0, second_on="K3"),
        ),
        reactions=tuple(reactions),
        constraints=tuple(constraints),
        example=START,
    )


def _mass_matrix() -> ImmutableMatrix:
    """M(p) of the source, entry by entry."""
    m1, m2, m3, m4, m5, m6, m7 = masses
    I1, I2, I3, I4, I5, I6, I7 = inertias
    pair = m2 * (da**2 - da * rr * cos(theta)) + I2
    left = m4 * ((e - ea) ** 2 + zt * (e - ea) * sin(phi)) + I4
    right = m6 * ((zf - fa) ** 2 - u * (zf - fa) * sin(omega)) + I6
    diagonal = (
        m1 * ra**2 + m2 * (rr**2 - 2 * da * rr * cos(theta) + da**2) + I1 + I2,
        m2 * da**2 + I2,
        m3 * (sa**2 + sb**2) + I3,
        m4 * (e - ea) ** 2 + I4,
        m4 * (zt**2 + 2 * zt * (e - ea) * sin(phi) + (e - ea) ** 2)
        + m5 * (ta**2 + tb**2) + I4 + I5,
        m6 * (zf - fa) ** 2 + I6,
        m6 * ((zf - fa) ** 2 - 2 * u * (zf - fa) * sin(omega) + u**2)
        + m7 * (ua**2 + ub**2) + I6 + I7,
    )  # fmt: skip
    beside = {(0, 1): pair, (3, 4): left, (5, 6): right}
    return ImmutableMatrix(
        7, 7, lambda i, j: diagonal[i] if i == j else beside.get((min(i, j), max(i, j)), 0)
    )


PUBLISHED = (
    published("M", MassMatrix(), _mass_matrix(), label="mass matrix, constraints aside"),
    *(
        published(f"g{number}", Identity(), left, right, label=f"P by K2 and by {by}, along {axis}")
        for number, left, right, by, axis in (
            (1, rr * cos(beta) - d * cos(beta + theta) - ss * sin(gamma), xb, "K3", "x"),
            (2, rr * sin(beta) - d * sin(beta + theta) + ss * cos(gamma), yb, "K3", "y"),
            (3, rr * cos(beta) - d * cos(beta + theta) - e * sin(phi + delta) - zt * cos(delta),
             xa, "K4", "x"),
            (4, rr * sin(beta) - d * sin(beta + theta) + e * cos(phi + delta) - zt * sin(delta),
             ya, "K4", "y"),
            (5, rr * cos(beta) - d * cos(beta + theta) - zf * cos(omega + epsilon)
             - u * sin(epsilon), xa, "K6", "x"),
            (6, rr * sin(beta) - d * sin(beta + theta) - zf * sin(omega + epsilon)
             + u * cos(epsilon), ya, "K6", "y"),
        )
    ),
)  # fmt: skip
