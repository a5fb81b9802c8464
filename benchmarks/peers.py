"""What is measured beside our routes: SymPy's own ways to the cart with n links.

Each function returns (M, f) in SymPy's dynamic symbols, and does all of its work when it is called.
"""

from sympy import Matrix, cos, simplify, sin, symbols
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from mechanics.equations import Equations


def stock_kane(links: int) -> tuple[Matrix, Matrix]:
    """Kane's method as in `sympy.physics.mechanics.models`: velocities by `v2pt_theory`."""
    method = n_link_pendulum_on_cart(links, cart_force=True, joint_torques=False)
    return method.mass_matrix, method.forcing


def explicit_kane(links: int) -> tuple[Matrix, Matrix]:
    """The same system with every velocity set, in inertial components.

    Of the ways to write the velocities this leaves the fewest operations: 308 for five links, where
    those of `v2pt_theory`, along the links, leave 416.
    """
    q, u = dynamicsymbols(f"q:{links + 1}"), dynamicsymbols(f"u:{links + 1}")
    m, length, g = symbols(f"m:{links + 1}"), symbols(f"l:{links}"), symbols("g")
    force = dynamicsymbols("F")
    frame, point = ReferenceFrame("I"), Point("P0")
    velocity = u[0] * frame.x
    point.set_vel(frame, velocity)
    bodies = [Particle("Pa0", point, m[0])]
    loads = [(point, force * frame.x - m[0] * g * frame.y)]
    for i in range(1, links + 1):
        # A link along its y axis that turns with u about z moves its end along -x.
        along = cos(q[i]) * frame.x + sin(q[i]) * frame.y
        velocity = velocity - length[i - 1] * u[i] * along
        point = Point(f"P{i}")
        point.set_vel(frame, velocity)
        bodies.append(Particle(f"Pa{i}", point, m[i]))
        loads.append((point, -m[i] * g * frame.y))
    kinematic = [qi.diff() - ui for qi, ui in zip(q, u, strict=True)]
    method = KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=kinematic)
    method.kanes_equations(bodies, loads)
    return method.mass_matrix, method.forcing


def simplified_difference(one: Equations, two: Equations) -> Matrix:
    """`sympy.simplify` of the difference of two routes' accelerations."""
    first = one.mass.LUsolve(one.forcing)
    second = two.mass.LUsolve(two.forcing)
    return (first - second).applyfunc(simplify)
