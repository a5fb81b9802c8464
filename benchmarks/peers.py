"""What is measured beside our routes: SymPy's own ways to the cart with n links.

Each function returns (M, f) in SymPy's dynamic symbols, and does all of its work when it is called.
"""

from sympy import Matrix, simplify
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols
from sympy.physics.mechanics.models import n_link_pendulum_on_cart

from mechanics.equations import Equations


def stock_kane(links: int) -> tuple[Matrix, Matrix]:
    """Kane's method as in `sympy.physics.mechanics.models`: velocities by `v2pt_theory`."""
    method = n_link_pendulum_on_cart(links, cart_force=True, joint_torques=False)
    return method.mass_matrix, method.forcing


def explicit_kane(links: int) -> tuple[Matrix, Matrix]:
    """The same system with every velocity set, one term a link."""
    from sympy import symbols

    q, u = dynamicsymbols(f"q:{links + 1}"), dynamicsymbols(f"u:{links + 1}")
    m, length, g = symbols(f"m:{links + 1}"), symbols(f"l:{links}"), symbols("g")
    force = dynamicsymbols("F")
    frame, origin = ReferenceFrame("I"), Point("O")
    origin.set_vel(frame, 0)
    point = origin.locatenew("P0", q[0] * frame.x)
    velocity = u[0] * frame.x
    point.set_vel(frame, velocity)
    bodies = [Particle("Pa0", point, m[0])]
    loads = [(point, force * frame.x - m[0] * g * frame.y)]
    for i in range(links):
        link = frame.orientnew(f"B{i}", "Axis", [q[i + 1], frame.z])
        link.set_ang_vel(frame, u[i + 1] * frame.z)
        point = point.locatenew(f"P{i + 1}", length[i] * link.y)
        # A link along its y axis that turns with u about z moves its end along -x.
        velocity = velocity - length[i] * u[i + 1] * link.x
        point.set_vel(frame, velocity)
        bodies.append(Particle(f"Pa{i + 1}", point, m[i + 1]))
        loads.append((point, -m[i + 1] * g * frame.y))
    kinematic = [qi.diff() - ui for qi, ui in zip(q, u, strict=True)]
    method = KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=kinematic)
    method.kanes_equations(bodies, loads)
    return method.mass_matrix, method.forcing


def simplified_difference(one: Equations, two: Equations) -> Matrix:
    """`sympy.simplify` of the difference of two routes' accelerations."""
    first = one.mass.LUsolve(one.forcing)
    second = two.mass.LUsolve(two.forcing)
    return (first - second).applyfunc(simplify)
