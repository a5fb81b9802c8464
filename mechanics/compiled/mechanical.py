"""Energy and momenta of the whole scene, from its bodies.

T = sum (m v.v + omega.I omega) / 2        P = sum m v        H_O = sum (r x m v + I omega)
"""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Symbol, zeros

from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.potential import potential


@dataclass(frozen=True)
class Totals:
    """Energies in J, linear momentum in kg m/s and angular momentum about the origin in kg m^2/s.

    The momenta are 3 x 1 inertial components; everything is in q, u, inputs and parameters.
    """

    kinetic: Expr
    potential: Expr
    linear_momentum: Matrix
    angular_momentum: Matrix

    def fixed(self, table: Mapping[Symbol, Expr]) -> "Totals":
        """The same with numbers in place of parameters."""
        if not table:
            return self
        values = (self.kinetic, self.potential, self.linear_momentum, self.angular_momentum)
        return Totals(*(value.xreplace(dict(table)) for value in values))


def totals(scene: Scene) -> Totals:
    """Energy and momenta of a scene."""
    kinematics = Kinematics(scene)
    linear, angular = zeros(3, 1), zeros(3, 1)
    for motion in kinematics.bodies.values():
        momentum = motion.body.mass * motion.centre.velocity
        linear += momentum
        angular += motion.centre.position.cross(momentum)
        angular += motion.inertia * motion.angular_velocity
    return Totals(kinematics.kinetic_energy, potential(scene), linear, angular)
