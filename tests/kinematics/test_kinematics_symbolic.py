"""Motion in plain symbols: each body has its own, velocities are rates, T adds up."""

from types import ModuleType

import pytest
from sympy import Matrix, Rational

from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import RigidBody, Scene
from systems import elastic_pendulum, rocker, rolling_disc

SYSTEMS = [elastic_pendulum, rocker, rolling_disc]


def numbers(scene: Scene) -> dict:
    """A state with parameters, all of them different."""
    symbols = (*scene.q, *scene.u, *scene.ud, *scene.parameters, *scene.input_symbols)
    return {symbol: Rational(7 + 3 * k, 11) for k, symbol in enumerate(dict.fromkeys(symbols))}


def rate(entries: Matrix, scene: Scene) -> Matrix:
    """d/dt of a function of q and u, in q, u and u'."""
    moved = entries.jacobian(scene.q) * Matrix([scene.coordinate_rates[qd] for qd in scene.qd])
    return moved + entries.jacobian(scene.u) * Matrix(scene.ud)


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.__name__)
def test_each_body_moves_as_its_own_frame_and_mass_centre(system: ModuleType) -> None:
    scene = system.scene()
    kinematics, at = Kinematics(scene), numbers(scene)

    def same(left: Matrix, right: Matrix) -> bool:
        return max(abs(entry) for entry in (left - right).subs(at).evalf(30)) < 1e-25

    total = 0
    for body in scene.bodies:
        motion = kinematics.bodies[body.name]
        assert motion.body is body
        assert same(motion.centre.position, scene.position(body.centre))
        assert same(motion.centre.velocity, rate(motion.centre.position, scene))
        assert same(motion.centre.acceleration, rate(motion.centre.velocity, scene))
        if isinstance(body, RigidBody):
            assert same(motion.rotation, scene.rotation(body.frame))
            turned = Matrix.hstack(*(rate(motion.rotation[:, k], scene) for k in range(3)))
            crossed = [motion.angular_velocity.cross(motion.rotation[:, k]) for k in range(3)]
            assert same(turned, Matrix.hstack(*crossed))
        total += motion.translation + motion.turning
    assert same(Matrix([total]), Matrix([kinematics.kinetic_energy]))
