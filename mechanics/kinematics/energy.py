"""Kinetic energy of each body, and what it is differentiated to.

T = m v . v / 2 + omega . I omega / 2        M_ij = d2T / du_i du_j        p_i = dT / dq_i'

omega in the frame of the body, in which its inertia is constant.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction

from mechanics.kinematics import chain
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.vectors import Matrix, Vector, dot, times

HALF = Fraction(1, 2)


def kinetic_energies(
    mechanism: Mechanism, rates: Mapping[Node, Node], factor: Fraction = HALF
) -> tuple[tuple[Node, Node], ...]:
    """Of translation and of rotation of each body, in J.

    Parameters
    ----------
    rates : mapping of Node to Node
        Those of the mechanism for energies in q and u; its coordinate rates for q and q'.
    factor : Fraction
        1 for twice the energies, whose sum takes fewer operations to be halved.
    """
    points = chain.motions(mechanism, rates).points
    turning = chain.own_rates(mechanism, rates)
    found, share = [], mechanism.builder.constant(factor)
    for body in mechanism.bodies:
        velocity, rotation = points[body.centre].velocity, mechanism.builder.zero
        if body.frame is not None and body.inertia is not None:
            omega = turning[body.frame]
            rotation = share * dot(omega, times(body.inertia, omega))
        found.append((share * body.mass * dot(velocity, velocity), rotation))
    return tuple(found)


def momenta(energies: Iterable[Node], rates: Vector) -> Vector:
    """Derivatives of a sum of energies by speeds or by the rates of coordinates."""
    listed = list(energies)
    return tuple(gradient(listed, [1] * len(listed), rates))


def mass_matrix(mechanism: Mechanism, energies: Iterable[Node]) -> Matrix:
    """Second derivatives of energies in q and u by the speeds."""
    slopes = momenta(energies, mechanism.u)
    return tuple(tuple(gradient([slope], [1], mechanism.u)) for slope in slopes)
