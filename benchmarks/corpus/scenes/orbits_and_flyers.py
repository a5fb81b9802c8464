"""Bodies in a plane: flyers, a car, an aircraft, satellites, orbits."""

from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P, of_one_particle
from benchmarks.corpus.free_bodies import central_force, craft
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    pin,
    reaction,
    slide,
    torque,
)

t = dynamicsymbols._t


def birotor():
    """Rotors at +-L; u2 on the right, u1 on the left."""
    u1, u2 = dynamicsymbols("u1 u2")
    L, m, I, g = P("L:m m:kg I:kg*m^2 g:m/s^2")
    return craft(
        "x z theta",
        m,
        I,
        lambda N, A, C: (
            force("left", C.locatenew("L", -L * A.x), u1 * A.y, on="craft"),
            force("right", C.locatenew("R", L * A.x), u2 * A.y, on="craft"),
        ),
        (u1, u2),
        g=g,
    )


def jet():
    """Thrust T at the mass centre, forces F at the wing tips l, tilted by alpha."""
    T, F = dynamicsymbols("T F")
    m, J, l, alpha, g = P("m:kg J:kg*m^2 l:m alpha:1 g:m/s^2")
    return craft(
        "x y theta",
        m,
        J,
        lambda N, A, C: (
            force("thrust", C, T * A.y, on="craft"),
            force(
                "right",
                C.locatenew("R", l * A.x),
                F * (sin(alpha) * A.x + cos(alpha) * A.y),
                on="craft",
            ),
            force(
                "left",
                C.locatenew("L", -l * A.x),
                F * (sin(alpha) * A.x - cos(alpha) * A.y),
                on="craft",
            ),
        ),
        (T, F),
        g=g,
    )


def slung():
    """A drone M with a load m on L: at x - L sin(alpha), z - L cos(alpha); thrust U1, torque U2;
    theta clockwise."""
    x, z, theta, alpha, U1, U2 = dynamicsymbols("x z theta alpha U1 U2")
    g, m, M, I, L = P("g:m/s^2 m:kg M:kg Itheta:kg*m^2 L:m")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (-theta, N.z))
    C = O.locatenew("C", x * N.x + z * N.y)
    drone = RigidBody("drone", C, A, M, I)
    hinge = pin("cable", "drone", "load", at=C, axis=-N.z, angle=alpha)
    return Scene(
        "drone with a load",
        N,
        O,
        coordinates=(x, z, theta, alpha),
        inputs=(U1, U2),
        plane=N.z,
        joints=(hinge,),
        bodies=(
            drone,
            RigidBody("load", hinge.point.locatenew("S", -L * hinge.frame.y), hinge.frame, m, 0),
        ),
        loads=(
            gravity(-g * N.y),
            force("thrust", C, U1 * A.y, on="drone"),
            torque("rotors", -U2 * N.z, on="drone"),
        ),
    )


def _car(names, forces, inputs, m, I):
    """Speeds forwards, to the left, of yaw; forces(N, A, C, speeds)."""
    X, Y, psi = dynamicsymbols("X Y psi")
    u, v, r = dynamicsymbols(names)
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (psi, N.z))
    C = O.locatenew("C", X * N.x + Y * N.y)
    c, s = cos(psi), sin(psi)
    return Scene(
        "car",
        N,
        O,
        coordinates=(X, Y, psi),
        inputs=inputs,
        plane=N.z,
        speeds=(
            (u, X.diff() * c + Y.diff() * s),
            (v, Y.diff() * c - X.diff() * s),
            (r, psi.diff()),
        ),
        bodies=(RigidBody("car", C, A, m, I),),
        loads=forces(A, C, u, v, r),
        example={names.split()[0]: 10.0},
    )


def _bicycle(names, inputs, m, I, a, b, Cf, Cr):
    """Tyres with side forces by small slip angles; a side force of two tyres each."""
    d, F = inputs

    def forces(A, C, u, v, r):
        front, rear = 2 * Cf * (d - (v + a * r) / u), -2 * Cr * (v - b * r) / u
        return (
            force("front", C.locatenew("F", a * A.x), front * A.y, on="car"),
            force("rear", C.locatenew("R", -b * A.x), rear * A.y, on="car"),
            force("drive", C, F * A.x, on="car"),
        )

    return _car(names, forces, inputs, m, I)


def bicycle():
    """In words."""
    numbers = P("MASS:kg INERTIA_Z:kg*m^2 LENGTH_A:m LENGTH_B:m FRICTION_FRONT:N FRICTION_REAR:N")
    return _bicycle("speed lateral_speed yaw_rate", dynamicsymbols("steering traction"), *numbers)


def rajamani():
    """In the symbols of the textbook."""
    numbers = P("m:kg I_z:kg*m^2 l_f:m l_r:m C_f:N C_r:N")
    return _bicycle("V_x V_y r", dynamicsymbols("delta F_x"), *numbers)


def aircraft():
    """Speeds U forwards and W downwards in the aircraft, Q of pitch; x forwards, z down."""
    x, z, theta, U, W, Q, X, Z, M = dynamicsymbols("x z theta U W Q X Z M")
    m, I, g = P("m:kg I_y:kg*m^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.y))
    C = O.locatenew("C", x * N.x + z * N.z)
    c, s = cos(theta), sin(theta)
    return Scene(
        "aircraft",
        N,
        O,
        coordinates=(x, z, theta),
        inputs=(X, Z, M),
        plane=N.y,
        speeds=(
            (U, x.diff() * c - z.diff() * s),
            (W, x.diff() * s + z.diff() * c),
            (Q, theta.diff()),
        ),
        bodies=(RigidBody("aircraft", C, A, m, I),),
        loads=(
            gravity(g * N.z),
            force("aerodynamics", C, X * A.x + Z * A.z, on="aircraft"),
            torque("pitching", M * N.y, on="aircraft"),
        ),
    )


def pitch():
    """A satellite in a circular orbit of the rate n, pitch theta against the local vertical,
    gravity gradient."""
    theta = dynamicsymbols("theta")
    Ix, Iy, Iz, n = P("I_x:kg*m^2 I_y:kg*m^2 I_z:kg*m^2 n:1/s", typical="3 2 1 0.001")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (n * t + theta, N.z))
    moment = -3 * n**2 * (Ix - Iz) * sin(theta) * cos(theta)
    return Scene(
        "satellite",
        N,
        O,
        plane=N.z,
        coordinates=(theta,),
        bodies=(RigidBody("satellite", O, A, 0, Iy),),
        loads=(torque("gravity gradient", moment * N.z, on="satellite"),),
    )


def transfer():
    """Speeds u outwards and v forwards, thrust T at the angle phi from the local horizontal."""
    r, theta, u, v, T, phi = dynamicsymbols("r theta u v T phi")
    m, mu = P("m:kg mu:m^3/s^2")
    return central_force(
        (r, theta),
        m,
        m * mu / r**2,
        (T * sin(phi), T * cos(phi)),
        (T, phi),
        ((u, r.diff()), (v, r * theta.diff())),
    )


def lunar():
    """Thrusts u1 outwards and u2 forwards, in parts of u_bar."""
    r, theta, u1, u2 = dynamicsymbols("r theta u1 u2")
    m, mu, bar = P("m:kg mu:m^3/s^2 u_bar:N")
    return central_force((r, theta), m, m * mu / r**2, (u1 * bar, u2 * bar), (u1, u2))


def central():
    """A potential -k/r."""
    r, theta = dynamicsymbols("r theta")
    m, k = P("m:kg k:N*m^2")
    return central_force((r, theta), m, k / r**2)


def _kepler(names, m, GM):
    x, y = dynamicsymbols(names)
    N, O = ReferenceFrame("N"), Point("O")
    C = O.locatenew("C", x * N.x + y * N.y)
    d = sqrt(x**2 + y**2) ** 3
    return of_one_particle(
        "planet", N, O, (x, y), ("planet", C, m),
        (force("gravity", C, -m * GM / d * (x * N.x + y * N.y), on="planet"),),
        example={str(x.func): 1.0, str(y.func): 0.2}, side=N.z,
    )  # fmt: skip


def planet():
    """r1, r2 from the sun, whose GM is one parameter."""
    m, GM = P("m:kg GM:m^3/s^2")
    return _kepler("r1 r2", m, GM)


def two_body():
    """x, y from the central mass M."""
    m, G, M = P("m:kg G:N*m^2/kg^2 M:kg")
    return _kepler("x y", m, G * M)


def wedge():
    """A block m at x, y on a movable wedge M; the wedge's slope falls to the left, its tip at x +
    y/tan(theta)."""
    from sympy import tan

    x, y = dynamicsymbols("x y")
    m, M, th, g = P("m:kg M:kg theta:1 g:m/s^2", typical="1 2 0.5 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    B = O.locatenew("B", x * N.x + y * N.y)
    W = O.locatenew("W", (x + y / tan(th)) * N.x)
    normal = sin(th) * N.x + cos(th) * N.y
    return Scene(
        "block on a wedge",
        N,
        O,
        coordinates=(x, y),
        bodies=(Particle("block", B, m), Particle("wedge", W, M)),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("N_1", at=B, on="block", by="wedge", along=normal),
            reaction("N_2", at=W, on="wedge", by=None, along=N.y),
            reaction("side_1", at=B, on="block", by=None, along=N.z),
            reaction("side_2", at=W, on="wedge", by=None, along=N.z),
        ),
    )


def maglev():
    """A ball x below a magnet with the current i, pulled up by C i^2/x^2."""
    x, i = dynamicsymbols("x i")
    m, C, g = P("m:kg C:N*m^2/A^2 g:m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    fall = slide("fall", None, "ball", at=O, axis=-N.y, distance=x)
    return Scene(
        "ball below a magnet",
        N,
        O,
        plane=N.z,
        joints=(fall,),
        inputs=(i,),
        bodies=(RigidBody("ball", fall.point, N, m, 0),),
        loads=(gravity(-g * N.y), force("magnet", fall.point, C * i**2 / x**2 * N.y, on="ball")),
        example={"x": 0.01},
    )
