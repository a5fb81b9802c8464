"""The equations of the seed document's problem 2, part (c), typed by hand: the rolling rocker.

Part (a), the shapes, is in `systems.rocker_shapes_ledger`; parts (d) and (e), the linearized rocker
and its control, are in `systems.rocker_control_ledger`.
"""

from sympy import Rational, Symbol, cos, sin
from sympy.physics.mechanics import dynamicsymbols

from mechanics.scene.published import Published, published
from mechanics.scene.quantities import (
    AngularMomentum,
    AngularMomentumPrinciple,
    EquationOfMotion,
    Moment,
    MomentOfMomentum,
    Momentum,
    MomentumPrinciple,
    MovingPointPrinciple,
    MovingPointTerm,
    Position,
    RateOfAngularMomentum,
    Velocity,
)
from mechanics.scene.typed import along_z, as_printed, cross, d_dt, plane
from systems.rocker import I_C, M, R, f, g, theta

t = dynamicsymbols._t
T, N = Symbol("T", real=True), Symbol("N", real=True)
theta_dot = theta.diff(t)
theta_ddot = theta_dot.diff(t)

# Names of the source for what its later lines repeat, typed as it prints them.
x = R * theta + R / 2 * sin(theta)
y = R + R / 2 * cos(theta)
P_x = M * (R * theta_dot + R / 2 * theta_dot * cos(theta))
P_y = -M * R / 2 * theta_dot * sin(theta)
P = plane(P_x, P_y)
BC = plane(R / 2 * sin(theta), R + R / 2 * cos(theta))
H_B = -(I_C * theta_dot + M * R**2 * theta_dot * (Rational(5, 4) + cos(theta)))
dH_B = -(
    (I_C + M * R**2 * (Rational(5, 4) + cos(theta))) * theta_ddot
    - M * R**2 * theta_dot**2 * sin(theta)
)

PUBLISHED: tuple[Published, ...] = (
    published("x", Position("C", "x"), x, label="horizontal position of C"),
    published("y", Position("C", "y"), y, label="vertical position of C"),
    published("P_x", Momentum("rocker", "x"), M * d_dt(x), label="M times the rate of x"),
    published("P_x", Momentum("rocker", "x"), P_x, label="horizontal momentum"),
    published("P_y", Momentum("rocker", "y"), M * d_dt(y), label="M times the rate of y"),
    published("P_y", Momentum("rocker", "y"), P_y, label="vertical momentum"),
    published(
        "H_C",
        AngularMomentum("rocker", along="-z"),
        I_C * theta_dot,
        label="angular momentum about C, clockwise",
        note="omega is the rate of theta, so the two forms of the source are one",
    ),
    published(
        "(4)",
        MomentumPrinciple("rocker", "x"),
        f + T,
        M * (R + R / 2 * cos(theta)) * theta_ddot - M * R / 2 * theta_dot**2 * sin(theta),
        label="horizontal momentum principle",
        note="a closing bracket too many in the source",
    ),
    published(
        "(5)",
        MomentumPrinciple("rocker", "y"),
        N - M * g,
        -M * R / 2 * (theta_ddot * sin(theta) + theta_dot**2 * cos(theta)),
        label="vertical momentum principle",
        latex=(
            r"N-M g=\frac{d P_{y}}{d t}=-M \frac{R}{2}\left(\ddot{\theta} \sin \theta+"
            r"\dot{\theta}^{2} \cos \theta\right)"
        ),
    ),
    published(
        "(6)",
        AngularMomentumPrinciple("rocker", "-z"),
        N * R / 2 * sin(theta) - T * (R + R / 2 * cos(theta)),
        I_C * theta_ddot,
        label="angular momentum principle about C, clockwise",
        latex=(
            r"N \frac{R}{2} \sin \theta-T\left(R+\frac{R}{2} \cos \theta\right)=\frac{d "
            r"H_{C}}{d t}=I_{C} \ddot{\theta}"
        ),
    ),
    published(
        "(7)",
        EquationOfMotion(),
        (I_C + M * R**2 * (Rational(5, 4) + cos(theta))) * theta_ddot
        - M * R**2 / 2 * theta_dot**2 * sin(theta)
        - M * g * R / 2 * sin(theta),
        f * (R + R / 2 * cos(theta)),
        label="equation of motion",
        latex=(
            r"\left[I_{C}+M R^{2}\left(\frac{5}{4}+\cos \theta\right)\right] "
            r"\ddot{\theta}-M \frac{R^{2}}{2} \dot{\theta}^{2} \sin \theta-M g \frac{R}{2} "
            r"\sin \theta=f(t)\left(R+\frac{R}{2} \cos \theta\right)"
        ),
        note="printed twice, after each procedure",
    ),
    published(
        "v_B",
        Velocity("B"),
        plane(R * theta_dot, 0),
        label="velocity of the geometric contact point",
    ),
    published(
        "(ii) (1)",
        MovingPointPrinciple("rocker", "B"),
        cross(BC, plane(f, -M * g)),
        d_dt(along_z(-I_C * theta_dot) + cross(BC, P)) + cross(plane(R * theta_dot, 0), P),
        label="angular momentum about the moving point B, both sides evaluated",
    ),
    published(
        "tau_B",
        Moment("rocker", "B"),
        along_z(-f * (R + R / 2 * cos(theta)) - M * g * R / 2 * sin(theta)),
        label="moment about B",
    ),
    published(
        "BC",
        Position("C", of="B"),
        plane(R / 2 * sin(theta), R + R / 2 * cos(theta)),
        label="vector from B to C",
    ),
    published("P", Momentum("rocker"), plane(P_x, P_y), label="momentum vector"),
    published(
        "BC x P",
        MomentOfMomentum("rocker", "B"),
        along_z(P_y * R / 2 * sin(theta) - P_x * (R + R / 2 * cos(theta))),
        label="moment of the momentum about B, with P_x and P_y",
    ),
    published(
        "BC x P",
        MomentOfMomentum("rocker", "B"),
        along_z(M * theta_dot * (-((R / 2 * sin(theta)) ** 2) - (R + R / 2 * cos(theta)) ** 2)),
        label="moment of the momentum about B",
    ),
    published(
        "H_B",
        AngularMomentum("rocker", "B"),
        along_z(-I_C * theta_dot) + cross(BC, P),
        label="angular momentum about B from H_C and BC x P",
    ),
    published(
        "H_B", AngularMomentum("rocker", "B"), along_z(H_B), label="angular momentum about B"
    ),
    published(
        "dH_B/dt",
        RateOfAngularMomentum("rocker", "B"),
        d_dt(along_z(H_B)),
        label="rate of the angular momentum about B, not carried out",
    ),
    published(
        "dH_B/dt",
        RateOfAngularMomentum("rocker", "B"),
        along_z(dH_B),
        label="rate of the angular momentum about B",
    ),
    published(
        "v_B x P",
        MovingPointTerm("rocker", "B"),
        cross(plane(R * theta_dot, 0), P),
        label="extra term, as a cross product",
    ),
    published(
        "v_B x P",
        MovingPointTerm("rocker", "B"),
        along_z(R * theta_dot * P_y),
        label="extra term, with P_y",
    ),
    published(
        "v_B x P",
        MovingPointTerm("rocker", "B"),
        along_z(-M * R**2 / 2 * theta_dot**2 * sin(theta)),
        label="extra term",
    ),
    published(
        "(ii) final",
        MovingPointPrinciple("rocker", "B", "z"),
        -f * (R + R / 2 * cos(theta)) - M * g * R / 2 * sin(theta),
        as_printed(dH_B, -M * R**2 / 2 * theta_dot**2 * sin(theta)),
        label="generalized angular momentum equation about B",
        note="the source prints the unit vector u_z with one term only",
    ),
    published(
        "(ii) final",
        EquationOfMotion(),
        -f * (R + R / 2 * cos(theta)) - M * g * R / 2 * sin(theta),
        as_printed(dH_B, -M * R**2 / 2 * theta_dot**2 * sin(theta)),
        label="equivalent to (7)",
    ),
)
