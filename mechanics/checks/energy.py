"""Kinetic energy in the speeds of the scene, which laws and admissibility both need."""

from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node
from mechanics.routes.lagrange import kinetic_energy
from mechanics.routes.rows import substitute


def kinetic(mechanism: Mechanism) -> Node:
    """T in q and u."""
    energy = kinetic_energy(mechanism)
    speeds = dict(zip(mechanism.qd, mechanism.q_rates, strict=True))
    if mechanism.u == mechanism.qd:
        return energy
    return substitute(mechanism.builder, [energy], speeds)[0]
