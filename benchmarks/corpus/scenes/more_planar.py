"""Bodies that move in a plane: cars, flyers, a satellite with an appendage, a walker, a mouse
in a wheel."""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    pin,
    torque,
    weld,
)


def car():
    """Wong's car: x forwards, y to the left, forces of both axles, front wheels steered by
    delta_f."""
    X, Y, psi, Vx, Vy, W = dynamicsymbols("X Y psi V_x V_y Omega_z")
    Fxf, Fxr, Fyf, Fyr, d = dynamicsymbols("F_xf F_xr F_yf F_yr delta_f")
    m, I, l1, l2 = P("m:kg I_z:kg*m^2 l_1:m l_2:m")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (psi, N.z))
    C = O.locatenew("C", X * N.x + Y * N.y)
    front, rear = C.locatenew("F", l1 * A.x), C.locatenew("R", -l2 * A.x)
    wheel = (Fxf * cos(d) - Fyf * sin(d)) * A.x + (Fxf * sin(d) + Fyf * cos(d)) * A.y
    c, s = cos(psi), sin(psi)
    return Scene(
        "car",
        N,
        O,
        coordinates=(X, Y, psi),
        inputs=(Fxf, Fxr, Fyf, Fyr, d),
        plane=N.z,
        speeds=(
            (Vx, X.diff() * c + Y.diff() * s),
            (Vy, Y.diff() * c - X.diff() * s),
            (W, psi.diff()),
        ),
        bodies=(RigidBody("car", C, A, m, I),),
        loads=(
            force("front axle", front, wheel, on="car"),
            force("rear axle", rear, Fxr * A.x + Fyr * A.y, on="car"),
        ),
    )


def pvtol():
    """Two forces at r below the centre of mass: F_1 to the side, F_2 along the axis; friction c."""
    x, y, th, F1, F2 = dynamicsymbols("x y theta F_1 F_2")
    m, J, r, c, g = P("m:kg J:kg*m^2 r:m c:N*s/m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (th, N.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    K = C.locatenew("K", -r * A.y)
    return Scene(
        "vectored thrust",
        N,
        O,
        coordinates=(x, y, th),
        inputs=(F1, F2),
        plane=N.z,
        bodies=(RigidBody("craft", C, A, m, J),),
        loads=(
            gravity(-g * N.y),
            force("jet", K, F1 * A.x + F2 * A.y, on="craft"),
            force("drag", C, -c * (x.diff() * N.x + y.diff() * N.y), on="craft"),
        ),
    )


def quadrotor():
    """Tip to tip ell; theta clockwise, u1 on the right, u2 on the left."""
    x, y, th, u1, u2 = dynamicsymbols("x y theta u1 u2")
    m, J, l, g = P("mass:kg J:kg*m^2 ell:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-th, N.z))
    C = O.locatenew("C", x * N.x + y * N.y)
    right, left = C.locatenew("R", l / 2 * A.x), C.locatenew("L", -l / 2 * A.x)
    return Scene(
        "planar quadrotor",
        N,
        O,
        coordinates=(x, y, th),
        inputs=(u1, u2),
        plane=N.z,
        bodies=(RigidBody("craft", C, A, m, J),),
        loads=(
            gravity(-g * N.y),
            force("one", right, u1 * A.y, on="craft"),
            force("two", left, u2 * A.y, on="craft"),
        ),
    )


def thrust():
    """The mass of a drone whose roll phi and thrust are given."""
    y, z, phi, T = dynamicsymbols("y z phi thrust")
    m, g = P("weight:kg g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", y * N.y + z * N.z)
    return Scene(
        "drone",
        N,
        O,
        coordinates=(y, z),
        inputs=(phi, T),
        plane=N.x,
        bodies=(Particle("drone", C, m),),
        loads=(
            gravity(-g * N.z),
            force("rotors", C, T * (-sin(phi) * N.y + cos(phi) * N.z), on="drone"),
        ),
    )


def cantilever():
    """A satellite and an appendage that turns against it by psi_d."""
    b, d, T = dynamicsymbols("psi_b psi_d T_c")
    Ib, Ip, c, k = P("I_b:kg*m^2 I_p:kg*m^2 c_p:N*m*s k_p:N*m")
    N, O = ReferenceFrame("N"), Point("O")
    hull = pin("hull", None, "body", at=O, axis=N.z, angle=b)
    arm = pin("arm", "body", "appendage", at=O, axis=hull.frame.z, angle=d)
    return Scene(
        "satellite",
        N,
        O,
        plane=N.z,
        joints=(hull, arm),
        inputs=(T,),
        bodies=(
            RigidBody("body", O, hull.frame, 0, Ib),
            RigidBody("appendage", O, arm.frame, 0, Ip),
        ),
        loads=(
            torque("control", T * N.z, on="body"),
            torque("bending", -(c * d.diff() + k * d) * N.z, on="appendage", by="body"),
        ),
    )


def cubli():
    """One face of a cube on its corner, a wheel in it; I_b about the corner."""
    b, w, T = dynamicsymbols("theta_b theta_w T_m")
    mb, lb, mw, l, Ib, Iw, Cb, Cw, g = P(
        "m_b:kg l_b:m m_w:kg l:m I_b:kg*m^2 I_w:kg*m^2 C_b:N*m*s C_w:N*m*s g:m/s^2"
    )
    N, O = ReferenceFrame("N"), Point("O")
    corner = pin("corner", None, "face", at=O, axis=-N.z, angle=b)
    B = corner.frame
    hub = corner.point.locatenew("H", l * B.y)
    shaft = pin("shaft", "face", "wheel", at=hub, axis=-B.z, angle=w)
    moment = T - Cw * w.diff()
    return Scene(
        "cube",
        N,
        O,
        plane=N.z,
        joints=(corner, shaft),
        inputs=(T,),
        bodies=(
            RigidBody("face", corner.point.locatenew("C", lb * B.y), B, mb, Ib - mb * lb**2),
            RigidBody("wheel", hub, shaft.frame, mw, Iw),
        ),
        loads=(
            gravity(-g * N.y),
            torque("friction", Cb * b.diff() * N.z, on="face"),
            torque("motor", -moment * N.z, on="wheel", by="face"),
        ),
    )


def compass():
    """Goswami's compass gait in swing: legs of a (below) and b (above) the masses m, hip m_H,
    both angles from upright."""
    ns, s = dynamicsymbols("theta_ns theta_s")
    m, mH, a, b, g = P("m:kg m_H:kg a:m b:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    foot = pin("foot", None, "stance", at=O, axis=N.z, angle=s)
    hip = foot.point.locatenew("H", (a + b) * foot.frame.y)
    swing = pin("hip", "stance", "swing", at=hip, axis=N.z, angle=ns)
    pelvis = weld("pelvis", "stance", "pelvis", at=hip, frame=foot.frame)
    return Scene(
        "compass gait",
        N,
        O,
        plane=N.z,
        joints=(foot, swing, pelvis),
        coordinates=(ns, s),
        loads=(gravity(-g * N.y),),
        bodies=(
            RigidBody("stance", foot.point.locatenew("S", a * foot.frame.y), foot.frame, m, 0),
            RigidBody("pelvis", pelvis.point, pelvis.frame, mH, 0),
            RigidBody("swing", hip.locatenew("W", -b * swing.frame.y), swing.frame, m, 0),
        ),
    )


def mouse():
    """A mouse that runs by theta (from the downward vertical) in a wheel that has turned by
    phi; f between them."""
    th, phi, f = dynamicsymbols("theta phi f")
    m, I, a, g = P("m:kg I:kg*m^2 a:m g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    axle = pin("axle", None, "wheel", at=O, axis=N.z, angle=phi)
    run = pin("run", None, "mouse", at=O, axis=N.z, angle=th)
    return Scene(
        "mouse in a wheel",
        N,
        O,
        plane=N.z,
        joints=(axle, run),
        inputs=(f,),
        coordinates=(th, phi),
        bodies=(
            RigidBody("wheel", O, axle.frame, 0, I),
            RigidBody("mouse", O.locatenew("M", -a * run.frame.y), run.frame, m, 0),
        ),
        loads=(gravity(-g * N.y), torque("legs", f * N.z, on="mouse", by="wheel")),
    )
