"""Carts with one or two rods, with an eccentric rotor on a spring, with a load."""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import P
from mechanics.scene import RigidBody, Scene, force, gravity, pin, slide, torque


def _cart(x, mass, rods, g, push, *, more=(), inputs=(), order=None):
    """A cart at x; each rod: angle, sense of it, mass, reach, inertia, (length, parent)."""
    N, O = ReferenceFrame("N"), Point("O")
    track = slide("track", None, "cart", at=O, axis=N.x, distance=x)
    bodies, joints = [RigidBody("cart", track.point, N, mass, 0)], [track]
    ends = {"cart": track.point}
    for name, parent, angle, up, sense, m, reach, inertia, length in rods:
        # sense +1: the top of an upright rod, or the end of a hanging one, goes to the right
        axis = -N.z if up * sense > 0 else N.z
        joint = pin(f"pin {name}", parent, name, at=ends[parent], axis=axis, angle=angle)
        y = up * joint.frame.y
        bodies.append(
            RigidBody(name, joint.point.locatenew(f"C {name}", reach * y), joint.frame, m, inertia)
        )
        joints.append(joint)
        ends[name] = joint.point.locatenew(f"E {name}", length * y)
    loads = [gravity(-g * N.y)] if g != 0 else []
    loads.append(force("push", track.point, push * N.x, on="cart"))
    loads += [make(N, O, track.point) for make in more]
    return Scene(
        "cart",
        N,
        O,
        plane=N.z,
        bodies=bodies,
        joints=joints,
        loads=loads,
        inputs=inputs,
        **({"coordinates": order} if order else {}),
    )


def pybrain():
    """theta before s; a uniform pole of half the length l, from upright."""
    theta, s, F = dynamicsymbols("theta s F")
    mp, mc, l, g = P("mp:kg mc:kg l:m g:m/s^2")
    return _cart(s, mc, [("pole", "cart", theta, 1, 1, mp, l, mp * l**2 / 3, 0)], g, F, inputs=(F,))


def two_poles():
    """Two uniform poles side by side on one cart, of half the lengths LENGTH_1, LENGTH_2;
    friction MUP in the pins."""
    x, a, b, F = dynamicsymbols("x theta_1 theta_2 force")
    M, m1, m2, l1, l2, mu, g = P(
        "MASSCART:kg MASSPOLE_1:kg MASSPOLE_2:kg LENGTH_1:m LENGTH_2:m MUP:N*m*s g:m/s^2"
    )
    rods = [
        ("one", "cart", a, 1, 1, m1, l1, m1 * l1**2 / 3, 0),
        ("two", "cart", b, 1, 1, m2, l2, m2 * l2**2 / 3, 0),
    ]
    return _cart(
        x,
        M,
        rods,
        g,
        F,
        inputs=(F,),
        more=[
            lambda N, O, A: torque("friction one", mu * a.diff() * N.z, on="one"),
            lambda N, O, A: torque("friction two", mu * b.diff() * N.z, on="two"),
        ],
    )


def dip():
    """A double rod on a cart, both angles from upright."""
    x, a, b, u = dynamicsymbols("x theta_1 theta_2 u")
    m0, m1, m2, l1, l2, L1, J1, J2, g = P(
        "m_0:kg m_1:kg m_2:kg l_1:m l_2:m L_1:m J_1:kg*m^2 J_2:kg*m^2 g:m/s^2"
    )
    rods = [("one", "cart", a, 1, 1, m1, l1, J1, L1), ("two", "one", b, 1, 1, m2, l2, J2, 0)]
    return _cart(x, m0, rods, g, u, inputs=(u,))


def cartpend():
    """A bob m on L, from upright, a friction d of the cart; pushed by u."""
    x, theta, u = dynamicsymbols("x theta u")
    M, m, L, g, d = P("M:kg m:kg L:m g:m/s^2 d:N*s/m")
    return _cart(x, M, [("rod", "cart", theta, 1, 1, m, L, 0, 0)], g, u - d * x.diff(), inputs=(u,))


def crane():
    """A load that hangs: at x - L sin(theta)."""
    x, theta, F = dynamicsymbols("x theta F")
    mc, mp, L, g = P("m_c:kg m_p:kg L:m g:m/s^2")
    return _cart(x, mc, [("load", "cart", theta, -1, -1, mp, L, 0, 0)], g, F, inputs=(F,))


def feedback_systems():
    """A rod with its top at p - l sin(theta), frictions c and gamma."""
    p, theta, F = dynamicsymbols("p theta F")
    M, m, J, l, c, gamma, g = P("M:kg m:kg J:kg*m^2 l:m c:N*s/m gamma:N*m*s g:m/s^2")
    return _cart(
        p,
        M,
        [("rod", "cart", theta, 1, -1, m, l, J, 0)],
        g,
        F - c * p.diff(),
        inputs=(F,),
        more=[
            lambda N, O, A: torque("friction", -gamma * theta.diff() * N.z, on="rod"),
        ],
    )


def tora():
    """A rotor in a horizontal plane on a platform on a spring."""
    x, theta, u = dynamicsymbols("x_c theta u")
    M, m, L, J, k = P("M:kg m:kg L:m J:kg*m^2 k:N/m")
    return _cart(
        x,
        M,
        [("rotor", "cart", theta, 1, 1, m, L, J, 0)],
        0,
        -k * x,
        inputs=(u,),
        more=[
            lambda N, O, A: torque("motor", -u * N.z, on="rotor", by="cart"),
        ],
    )


def rtac():
    """The same in the symbols of the benchmark, with a disturbance F."""
    q, theta, N_, F = dynamicsymbols("q theta N F")
    M, m, e, I, k = P("M:kg m:kg e:m I:kg*m^2 k:N/m")
    return _cart(
        q,
        M,
        [("rotor", "cart", theta, 1, 1, m, e, I, 0)],
        0,
        F - k * q,
        inputs=(N_, F),
        more=[
            lambda N, O, A: torque("motor", -N_ * N.z, on="rotor", by="cart"),
        ],
    )


def rddl():
    """A uniform pole of half the length LEN, from upright."""
    x, theta, F = dynamicsymbols("x theta force")
    mc, mp, l, g = P("MASS_CART:kg MASS_POLE:kg LEN:m GRAVITY:m/s^2")
    return _cart(x, mc, [("pole", "cart", theta, 1, 1, mp, l, mp * l**2 / 3, 0)], g, F, inputs=(F,))


def forum():
    """Mass M of the cart; the rod's top is at x - r sin(theta)."""
    x, theta, F = dynamicsymbols("x theta F")
    M, m, r, g = P("M:kg m:kg r:m g:m/s^2")
    return _cart(x, M, [("rod", "cart", theta, 1, -1, m, r, 0, 0)], g, F, inputs=(F,))
