"""Gauss's function of a scene, which its accelerations make least.

    G = 1/2 sum m |a_C - g|^2 + 1/2 alpha . I alpha + (omega x I omega) . alpha - f . a

where every acceleration is defined by that of what carries it (`carried`), and at last by u'.
"""

from sympy.physics.vector import Dyadic

from mechanics.compiled.forms.bodies.affine import Rotation, cross, rotated
from mechanics.compiled.forms.bodies.carried import Carried
from mechanics.compiled.forms.bodies.gauss import Gauss
from mechanics.compiled.forms.bodies.leaf_to_root import Way
from mechanics.compiled.forms.bodies.pulls import carried_gravity, pull
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.forms.bodies.turning import IDENTITY, Turning
from mechanics.kinematics.textbook.chain import Chain
from mechanics.scene import RigidBody


def gauss_function(reading: Reading, way: Way) -> Gauss:
    """G of a scene, in u' and the accelerations that it takes to write it."""
    scene, g = reading.scene, Gauss(way.squared)
    turning = Turning(reading, Chain(scene))
    carried = Carried(reading, turning, g, carried_gravity(reading), way.inertial)
    for body in scene.bodies:
        mass = reading(scene.plain(body.mass, body.name))
        if not mass.is_zero():
            for entry in carried.acceleration(body.centre):
                g.add_square(mass, entry)
        if isinstance(body, RigidBody):
            _spin(carried, body)
    for load in scene.loads:
        pull(carried, load)
    return g


def _spin(carried: Carried, body: RigidBody) -> None:
    """Add 1/2 alpha . I alpha + (omega x I omega) . alpha, components in the body."""
    g, inertia = carried.g, _inertia(carried.reading, body)
    if all(entry.is_zero() for row in inertia for entry in row):
        return
    alpha, omega = carried.alpha(body.frame), carried.turning.omega(body.frame)
    for i, row in enumerate(inertia):
        g.add_square(row[i], alpha[i])
        for j in range(i):
            g.add_product(row[j], alpha[i], alpha[j])
    # A scalar stands for a multiple of the identity, whose moment of momentum is along omega.
    if isinstance(body.inertia, Dyadic):
        couple = cross(omega, rotated(inertia, omega))
        for gain, component in zip(alpha, couple, strict=True):
            for unknown, coefficient in gain.coefficients.items():
                g.add_force(unknown, -(coefficient * component))


def _inertia(reading: Reading, body: RigidBody) -> Rotation:
    scene = reading.scene
    if isinstance(body.inertia, Dyadic):
        matrix = body.inertia.to_matrix(body.frame)
        return tuple(
            reading.column(scene.plain(entry, body.name) for entry in matrix[i, :])
            for i in range(3)
        )
    scalar = reading(scene.plain(body.inertia, body.name))
    return tuple(tuple(scalar * entry for entry in row) for row in IDENTITY)
