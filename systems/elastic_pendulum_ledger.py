"""Every displayed equation of the seed document's problem 1, typed by hand."""

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
    RateOfMomentum,
    ReactionValue,
)
from mechanics.scene.typed import along_z, cross, d_dt, plane
from systems.elastic_pendulum import I_C, L, M, g, k, m, theta, x

t = dynamicsymbols._t
T, N, N1 = (Symbol(name, real=True) for name in ("T", "N", "N1"))
x_dot, theta_dot = x.diff(t), theta.diff(t)
x_ddot, theta_ddot = x_dot.diff(t), theta_dot.diff(t)

# Names of the source for what its later lines repeat, typed as it prints them.
x_C = x + L / 2 * sin(theta)
y_C = -L / 2 * cos(theta)
p_x = M * (x_dot + L / 2 * theta_dot * cos(theta))
p_y = M * L / 2 * theta_dot * sin(theta)
P = plane(p_x, p_y)
v_C = plane(x_dot + L / 2 * theta_dot * cos(theta), L / 2 * theta_dot * sin(theta))
BC = plane(L / 2 * sin(theta), -L / 2 * cos(theta))
DOWN = plane(sin(theta), -cos(theta))

P_X_TWICE = "the source writes p_x for the carriage here and for the pendulum elsewhere"

PUBLISHED: tuple[Published, ...] = (
    published("x_C", Position("C", "x"), x_C, label="horizontal position of C"),
    published("y_C", Position("C", "y"), y_C, label="vertical position of C"),
    published("p_x", Momentum("pendulum", "x"), M * d_dt(x_C), label="M times the rate of x_C"),
    published("p_x", Momentum("pendulum", "x"), p_x, label="horizontal momentum of the pendulum"),
    published("p_y", Momentum("pendulum", "y"), M * d_dt(y_C), label="M times the rate of y_C"),
    published("p_y", Momentum("pendulum", "y"), p_y, label="vertical momentum of the pendulum"),
    published(
        "H_C",
        AngularMomentum("pendulum", along="z"),
        I_C * theta_dot,
        label="angular momentum of the pendulum about C, with I_C",
    ),
    published(
        "H_C",
        AngularMomentum("pendulum", along="z"),
        M * L**2 / 12 * theta_dot,
        label="angular momentum of the pendulum about C",
    ),
    published(
        "m x'",
        Momentum("carriage", "x"),
        m * x_dot,
        label="horizontal momentum of the carriage",
    ),
    published(
        "(1)",
        MovingPointPrinciple("pendulum", "B"),
        cross(BC, plane(0, -M * g)),
        d_dt(along_z(I_C * theta_dot) + cross(BC, P)) + cross(plane(x_dot, 0), P),
        label="angular momentum about the moving point B, both sides evaluated",
    ),
    published(
        "(2)",
        MomentumPrinciple("carriage", "x"),
        T - 2 * k * x,
        m * x_ddot,
        label="horizontal momentum principle of the carriage",
        latex=r"T-2 k x=\frac{d p_{x}}{d t}=m \ddot{x}",
        note=P_X_TWICE,
    ),
    published(
        "N_1",
        ReactionValue("N1"),
        N1,
        m * g + N,
        label="reaction of the rod that supports the carriage",
    ),
    published(
        "(3)",
        RateOfMomentum("pendulum", "x"),
        d_dt(M * (x_dot + L / 2 * theta_dot * cos(theta))),
        label="rate of the pendulum's horizontal momentum, not carried out",
    ),
    published(
        "(3)",
        MomentumPrinciple("pendulum", "x"),
        -T,
        M * (x_ddot + L / 2 * (theta_ddot * cos(theta) - theta_dot**2 * sin(theta))),
        label="horizontal momentum principle of the pendulum",
        latex=(
            r"-T=\frac{d p_{x}}{d t}=\frac{d}{d t} M\left(\dot{x}+\frac{L}{2} \dot{\theta} "
            r"\cos \theta\right)=M\left[\ddot{x}+\frac{L}{2}\left(\ddot{\theta} \cos "
            r"\theta-\dot{\theta}^{2} \sin \theta\right)\right]"
        ),
    ),
    published(
        "(4)",
        RateOfMomentum("pendulum", "y"),
        d_dt(M * L / 2 * theta_dot * sin(theta)),
        label="rate of the pendulum's vertical momentum, not carried out",
    ),
    published(
        "(4)",
        MomentumPrinciple("pendulum", "y"),
        N - M * g,
        M * L / 2 * (theta_ddot * sin(theta) + theta_dot**2 * cos(theta)),
        label="vertical momentum principle of the pendulum",
        latex=(
            r"N-M g=\frac{d p_{y}}{d t}=\frac{d}{d t}\left(M \frac{L}{2} \dot{\theta} \sin "
            r"\theta\right)=M \frac{L}{2}\left(\ddot{\theta} \sin \theta+\dot{\theta}^{2} "
            r"\cos \theta\right)"
        ),
    ),
    published(
        "(5)",
        AngularMomentumPrinciple("pendulum", "z"),
        T * L / 2 * cos(theta) - N * L / 2 * sin(theta),
        M * L**2 / 12 * theta_ddot,
        label="angular momentum principle of the pendulum about C",
        latex=(
            r"T \frac{L}{2} \cos \theta-N \frac{L}{2} \sin \theta=\frac{d H_{C}}{d t}="
            r"\frac{M L^{2}}{12} \ddot{\theta}"
        ),
    ),
    published(
        "(6)",
        EquationOfMotion(),
        (M + m) * x_ddot
        + 2 * k * x
        + M * L / 2 * theta_ddot * cos(theta)
        - M * L / 2 * theta_dot**2 * sin(theta),
        0,
        label="equation of motion, horizontal",
        latex=(
            r"(M+m) \ddot{x}+2 k x+M \frac{L}{2} \ddot{\theta} \cos \theta-M \frac{L}{2} "
            r"\dot{\theta}^{2} \sin \theta=0"
        ),
    ),
    published(
        "(7)",
        EquationOfMotion(),
        M * L / 2 * x_ddot * cos(theta) + M * L**2 / 3 * theta_ddot + M * g * L / 2 * sin(theta),
        0,
        label="equation of motion, about the pivot",
        latex=(
            r"M \frac{L}{2} \ddot{x} \cos \theta+M \frac{L^{2}}{3} \ddot{\theta}+M g "
            r"\frac{L}{2} \sin \theta=0"
        ),
    ),
    published(
        "(ii) system",
        RateOfMomentum(("carriage", "pendulum"), "x"),
        d_dt(m * x_dot + p_x),
        label="rate of the whole system's horizontal momentum, with p_x",
    ),
    published(
        "(ii) system",
        RateOfMomentum(("carriage", "pendulum"), "x"),
        d_dt(m * x_dot + M * (x_dot + L / 2 * theta_dot * cos(theta))),
        label="rate of the whole system's horizontal momentum, not carried out",
    ),
    published(
        "(ii) system",
        MomentumPrinciple(("carriage", "pendulum"), "x"),
        -2 * k * x,
        (M + m) * x_ddot + M * L / 2 * (theta_ddot * cos(theta) - theta_dot**2 * sin(theta)),
        label="horizontal momentum principle of the whole system",
    ),
    published(
        "(ii) system",
        EquationOfMotion(),
        -2 * k * x,
        (M + m) * x_ddot + M * L / 2 * (theta_ddot * cos(theta) - theta_dot**2 * sin(theta)),
        label="equivalent to (6)",
        latex=(
            r"-2 k x=\frac{d}{d t}\left(m \dot{x}+p_{x}\right)=\frac{d}{d t}\left[m \dot{x}+"
            r"M\left(\dot{x}+\frac{L}{2} \dot{\theta} \cos \theta\right)\right]=(M+m) "
            r"\ddot{x}+M \frac{L}{2}\left(\ddot{\theta} \cos \theta-\dot{\theta}^{2} \sin "
            r"\theta\right)"
        ),
    ),
    published(
        "tau_B",
        Moment("pendulum", "B"),
        along_z(-M * g * L / 2 * sin(theta)),
        label="moment about B",
    ),
    published(
        "BC x P",
        MomentOfMomentum("pendulum", "B"),
        cross(BC, P),
        label="moment of the pendulum's momentum about B",
    ),
    published(
        "H_B",
        AngularMomentum("pendulum", "B"),
        along_z(I_C * theta_dot) + cross(BC, P),
        label="angular momentum about B, with I_C",
    ),
    published(
        "H_B",
        AngularMomentum("pendulum", "B"),
        along_z(M * L**2 / 12 * theta_dot) + L / 2 * cross(DOWN, P),
        label="angular momentum about B, with p_x and p_y",
    ),
    published(
        "H_B",
        AngularMomentum("pendulum", "B"),
        along_z(M * L**2 / 12 * theta_dot) + L / 2 * cross(DOWN, M * v_C),
        label="angular momentum about B, momenta written out",
        note="a closing bracket too many in the source",
    ),
    published(
        "H_B",
        AngularMomentum("pendulum", "B"),
        along_z(
            M * L**2 * theta_dot * (Rational(1, 12) + sin(theta) ** 2 / 4 + cos(theta) ** 2 / 4)
            + M * L / 2 * x_dot * cos(theta)
        ),
        label="angular momentum about B, multiplied out",
    ),
    published(
        "H_B",
        AngularMomentum("pendulum", "B"),
        along_z(M * L**2 / 3 * theta_dot + M * L / 2 * x_dot * cos(theta)),
        label="angular momentum about B",
    ),
    published(
        "v_B x P",
        MovingPointTerm("pendulum", "B"),
        cross(plane(x_dot, 0), P),
        label="additional term, as a cross product",
    ),
    published(
        "v_B x P",
        MovingPointTerm("pendulum", "B"),
        along_z(x_dot * p_y),
        label="additional term, with p_y",
    ),
    published(
        "v_B x P",
        MovingPointTerm("pendulum", "B"),
        along_z(M * L / 2 * theta_dot * x_dot * sin(theta)),
        label="additional term",
    ),
    published(
        "(ii) final",
        MovingPointPrinciple("pendulum", "B", "z"),
        -M * g * L / 2 * sin(theta),
        d_dt(M * L**2 / 3 * theta_dot + M * L / 2 * x_dot * cos(theta))
        + M * L / 2 * theta_dot * x_dot * sin(theta),
        label="generalized angular momentum equation about B",
    ),
    published(
        "(ii) final",
        MovingPointPrinciple("pendulum", "B", "z"),
        -M * g * L / 2 * sin(theta),
        M * L**2 / 3 * theta_ddot + M * L / 2 * x_ddot * cos(theta),
        label="generalized angular momentum equation about B, carried out",
    ),
    published(
        "(ii) final",
        EquationOfMotion(),
        -M * g * L / 2 * sin(theta),
        M * L**2 / 3 * theta_ddot + M * L / 2 * x_ddot * cos(theta),
        label="equivalent to (7)",
        latex=(
            r"-M g \frac{L}{2} \sin \theta=\frac{d}{d t}\left[M \frac{L^{2}}{3} "
            r"\dot{\theta}+M \frac{L}{2} \dot{x} \cos \theta\right]+M \frac{L}{2} "
            r"\dot{\theta} \dot{x} \sin \theta=M \frac{L^{2}}{3} \ddot{\theta}+M "
            r"\frac{L}{2} \ddot{x} \cos \theta"
        ),
    ),
)
