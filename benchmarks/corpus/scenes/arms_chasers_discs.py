"""Arms, satellites, masses on springs, a wedge, discs on a wire, a quarter of a car."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, one_mass, two_link_arm, two_masses
from benchmarks.corpus.free_bodies import chaser, turning_body
from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    pin,
    slide,
    torque,
)

t = dynamicsymbols._t


def centres():
    """Two links with the mass centres at lc1, lc2, the inertias I1, I2 about them."""
    m1, m2, l1, _, lc1, lc2, I1, I2, g = P(
        "m1:kg m2:kg l1:m l2:m lc1:m lc2:m I1:kg*m^2 I2:kg*m^2 g:m/s^2"
    )
    u = dynamicsymbols("tau1 tau2")
    return two_link_arm(dynamicsymbols("q1 q2"), l1, (m1, lc1, I1), (m2, lc2, I2), g, u, u)


def monkey():
    """An acrobot of uniform rods, q1 from below, a torque u in the elbow."""
    a, b, u = dynamicsymbols("q1 q2 u")
    m1, m2, l1, l2, g = P("m1:kg m2:kg l1:m l2:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    shoulder = pin("shoulder", None, "one", at=O, axis=N.z, angle=a)
    A, P1 = shoulder.frame, shoulder.point
    elbow = pin("elbow", "one", "two", at=P1.locatenew("E", -l1 * A.y), axis=A.z, angle=b)
    B = elbow.frame
    C1, C2 = P1.locatenew("C1", -l1 / 2 * A.y), elbow.point.locatenew("C2", -l2 / 2 * B.y)
    return Scene(
        "arm", N, O, plane=N.z, joints=(shoulder, elbow), inputs=(u,),
        loads=(gravity(-g * N.y), torque("elbow moment", u * N.z, on="two", by="one")),
        bodies=(RigidBody("one", C1, A, m1, m1 * l1**2 / 12),
                RigidBody("two", C2, B, m2, m2 * l2**2 / 12)),
    )  # fmt: skip


def euler_body():
    """A rigid body that turns freely, rates omega_1, ... and torques T_1, ... about its axes."""
    return turning_body(
        "omega_1 omega_2 omega_3", "I_1:kg*m^2 I_2:kg*m^2 I_3:kg*m^2",
        dynamicsymbols("T_1 T_2 T_3"), name="spacecraft",
    )  # fmt: skip


def hill():
    """A chaser near a target in a circular orbit with the rate n: x outwards, y forwards.

    Forces F_x, F_y, F_z beside the linear gravity.
    """
    m, n = P("m:kg n:1/s")
    F = dynamicsymbols("F_x F_y F_z")
    return chaser(m, n, lambda N: N.orientnew("A", "Axis", (n * t, N.z)), (2, -1, -1), F, "y")


def feder():
    """m on a spring D."""
    x = dynamicsymbols("x")
    m, D = P("m:kg D:N/m")
    return one_mass(x, m, -D * x)


def forced():
    """m, a spring k, a damper b, a force F."""
    x, F = dynamicsymbols("x F")
    m, b, k = P("m:kg b:N*s/m k:N/m")
    return one_mass(x, m, F - b * x.diff() - k * x, (F,))


def constant_force():
    """m, a spring k, a damper c, a constant force F."""
    x = dynamicsymbols("x")
    m, c, k, F = P("m:kg c:N*s/m k:N/m F:N")
    return one_mass(x, m, F - c * x.diff() - k * x)


def quarter():
    """A mass ms at z_s on ks, cs, an unsprung one mu at z_u on ku above the road z_ur."""
    a, b, u = dynamicsymbols("z_s z_u z_ur")
    ms, mu, ks, cs, ku = P("ms:kg mu:kg ks:N/m cs:N*s/m ku:N/m")
    strut = -ks * (a - b) - cs * (a.diff() - b.diff())
    return two_masses(
        (a, b),
        (ms, mu),
        lambda N, A, B: (
            force("strut", A, strut * N.x, on="one", by="two"),
            force("tyre", B, -ku * (b - u) * N.x, on="two"),
        ),
        (u,),
    )


def wedge():
    """A ramp M at X on a smooth table, a block m at q down its slope, which falls towards -x."""
    X, q = dynamicsymbols("X q")
    M, m, g, th = P("M:kg m:kg g:m/s^2 theta:1", typical="2 1 9.81 0.7")
    N, O = ReferenceFrame("N"), Point("O")
    table = slide("table", None, "ramp", at=O, axis=N.x, distance=X)
    down = -cos(th) * N.x - sin(th) * N.y
    slope = slide("slope", "ramp", "block", at=table.point, axis=down, distance=q)
    return Scene(
        "block on a ramp", N, O, plane=N.z, joints=(table, slope), loads=(gravity(-g * N.y),),
        bodies=(RigidBody("ramp", table.point, N, M, 0),
                RigidBody("block", slope.point, N, m, 0)),
    )  # fmt: skip
