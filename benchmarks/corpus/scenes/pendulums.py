"""Coupled, spherical, double and damped pendulums."""

from sympy import sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import held, of_one_particle
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    spring,
    torque,
)

theta1, theta2, theta, phi, x, u, f = dynamicsymbols("theta1 theta2 theta phi x u f")
m, l, a, k, g, c, b, ell = parameters(
    "m l a k g c b ell", units="kg m m N/m m/s^2 kg/s 1/s m", typical="1 1 0.4 5 9.81 0.2 0.1 1"
)
mass, gravity_, L_ = parameters("mass gravity L", units="kg m/s^2 m", typical="10 10 0.2")
m1, m2, l1, l2, M = parameters("m1 m2 l1 l2 M", units="kg kg m m kg", typical="1 2 1 0.7 1")
I1, I2, b1, b2 = parameters(
    "I1 I2 b1 b2", units="kg*m^2 kg*m^2 N*m*s N*m*s", typical="0.01 0.01 0.1 0.1"
)


def coupled():
    """Two equal pendulums; a horizontal spring k joins their rods at a below the pivots."""
    N, O = ReferenceFrame("N"), Point("O")
    A, B = (N.orientnew(n, "Axis", (q, N.z)) for n, q in (("A", theta1), ("B", theta2)))
    P, Q = O.locatenew("P", -l * A.y), O.locatenew("Q", -l * B.y)
    E, F = O.locatenew("E", -a * A.y), O.locatenew("F", -a * B.y)
    return Scene(
        "coupled pendulums",
        N,
        O,
        coordinates=(theta1, theta2),
        bodies=(RigidBody("one", P, A, m, 0), RigidBody("two", Q, B, m, 0)),
        loads=(gravity(-g * N.y), spring("k", E, F, k, along=N.x, first_on="one", second_on="two")),
        reactions=tuple(
            reaction(f"{axis}{n}", at=O, on=n, by=None, along=v)
            for n in ("one", "two")
            for axis, v in (("X", N.x), ("Y", N.y))
        ),
        example={"theta1": 0.3},
    )


def spherical():
    """theta from hanging, phi about the vertical; c is drag over speed."""
    return _spherical(mass, L_, gravity_, c)


def spherical_free():
    """The same without drag, as m, l, g."""
    return _spherical(m, l, g, 0)


def _spherical(weight, length, field, drag):
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    B = A.orientnew("B", "Axis", (-theta, A.y))
    P = O.locatenew("P", -length * B.z)
    loads = [gravity(-field * N.z)]
    if drag:
        # -B.z is the string; out along B.x, round along A.y.
        v = length * theta.diff() * B.x + length * sin(theta) * phi.diff() * A.y
        loads.append(force("drag", P, -drag * v, on="bob"))
    return of_one_particle(
        "spherical pendulum", N, O, (theta, phi), ("bob", P, weight), tuple(loads),
        example={"theta": 1.2, "phi_dot": 4.0}, S=B.z,
    )  # fmt: skip


def double_upright():
    """Two masses on rods, angles of both from upright."""
    N, O = ReferenceFrame("N"), Point("O")
    A, B = (N.orientnew(n, "Axis", (-q, N.z)) for n, q in (("A", theta1), ("B", theta2)))
    P = O.locatenew("P", l1 * A.y)
    Q = P.locatenew("Q", l2 * B.y)
    return Scene(
        "double pendulum, upright",
        N,
        O,
        coordinates=(theta1, theta2),
        bodies=(Particle("one", P, m1), Particle("two", Q, m2)),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("S1", at=P, on="one", by=None, along=A.y),
            reaction("S2", at=Q, on="two", by="one", along=B.y),
        ),
        example={"theta1": 0.3},
    )


def _rods(mass1, mass2, length1, length2, inertia1, inertia2, upright, loads=(), inputs=()):
    N, O = ReferenceFrame("N"), Point("O")
    s = 1 if upright else -1
    A, B = (N.orientnew(n, "Axis", (-s * q, N.z)) for n, q in (("A", theta1), ("B", theta2)))
    C1 = O.locatenew("C1", s * length1 / 2 * A.y)
    E = O.locatenew("E", s * length1 * A.y)
    C2 = E.locatenew("C2", s * length2 / 2 * B.y)
    more = tuple(torque(n, v * -s * N.z, on=on, by=by) for n, v, on, by in loads)
    return Scene(
        "two rods",
        N,
        O,
        coordinates=(theta1, theta2),
        bodies=(
            RigidBody("rod1", C1, A, mass1, inertia1),
            RigidBody("rod2", C2, B, mass2, inertia2),
        ),
        loads=(gravity(-g * N.y), *more),
        reactions=(*held(O, "rod1", X1=N.x, Y1=N.y), *held(E, "rod2", "rod1", X2=N.x, Y2=N.y)),
        inputs=inputs,
        example={"theta1": 0.3},
    )


def double_rods():
    """Two equal rods of mass m and length ell, angles of both from hanging."""
    return _rods(m, m, ell, ell, m * ell**2 / 12, m * ell**2 / 12, False)


def pendubot():
    """Two rods, angles from upright; f and b1 on the inner, b2 on the outer, all absolute."""
    return _rods(
        m1,
        m2,
        l1,
        l2,
        I1,
        I2,
        True,
        (
            ("f", f, "rod1", None),
            ("b1", -b1 * theta1.diff(), "rod1", None),
            ("b2", -b2 * theta2.diff(), "rod2", None),
        ),
        (f,),
    )


def damped():
    """A point mass, theta1 from hanging, a torque -b m l^2 theta1'."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta1, N.z))
    P = O.locatenew("P", -l * A.y)
    return Scene(
        "damped pendulum",
        N,
        O,
        coordinates=(theta1,),
        bodies=(RigidBody("rod", P, A, m, 0),),
        loads=(gravity(-g * N.y), torque("b", -b * m * l**2 * theta1.diff() * N.z, on="rod")),
        reactions=held(O, "rod", X=N.x, Y=N.y),
        example={"theta1": 0.3},
    )


def on_cart():
    """Cart M that u pushes, point mass m on a rod l, theta from hanging."""
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P = O.locatenew("P", x * N.x)
    Q = P.locatenew("Q", -l * A.y)
    return Scene(
        "pendulum on a cart",
        N,
        O,
        coordinates=(x, theta),
        bodies=(Particle("cart", P, M), Particle("bob", Q, m)),
        loads=(gravity(-g * N.y), force("u", P, u * N.x, on="cart")),
        reactions=(
            reaction("N", at=P, on="cart", by=None, along=N.y),
            reaction("S", at=Q, on="bob", by="cart", along=A.y),
        ),
        inputs=(u,),
        example={"theta": 0.3},
    )
