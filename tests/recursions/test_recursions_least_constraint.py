"""Gauss's principle gives the accelerations at which Newton's and Euler's rows vanish."""

import pytest
from serial_arms import serial_arm

from mechanics.errors import SingularError
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder
from mechanics.program.elimination import expand_solves
from mechanics.program.residues import Residues
from mechanics.recursions import newton_euler
from mechanics.recursions.least_constraint import WAYS, Way, forward_dynamics
from mechanics.recursions.pseudo_inertia import moments
from mechanics.routes.rows import substitute
from mechanics.scene import Particle, Scene, gravity
from systems import acrobot, double_pendulum, elastic_pendulum, pendulum_chain

SCENES = {
    "elastic pendulum": elastic_pendulum.scene(),
    "double pendulum": double_pendulum.scene(),
    "acrobot": acrobot.scene(),
    "chain of six": pendulum_chain.scene(6),
    "arm in space": serial_arm(3, axes="zyx", fixed="zxy").scene,
}


def lowered(scene: Scene) -> Mechanism:
    return lower(scene, Builder())


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", SCENES)
def test_rows_vanish_at_the_accelerations(name: str, way: Way) -> None:
    mechanism = lowered(SCENES[name])
    rows = newton_euler.rows(mechanism, moments(mechanism))
    ud = dict(zip(mechanism.ud, forward_dynamics(mechanism, way), strict=True))
    filter_ = Residues(mechanism.builder)
    assert all(map(filter_.is_zero, substitute(mechanism.builder, rows, ud)))
    assert not all(map(filter_.is_zero, rows))


def test_operations_grow_linearly_with_the_links() -> None:
    counts = []
    for links in (6, 7, 8):
        mechanism = lowered(pendulum_chain.scene(links))
        nodes = {"ud": forward_dynamics(mechanism, WAYS[0])}
        counts.append(expand_solves(mechanism.builder.program(nodes)).count)
    assert counts[2] - counts[1] == counts[1] - counts[0] <= 37


def test_what_has_no_mass_is_refused() -> None:
    scene = double_pendulum.scene()
    light = [Particle(body.name, body.centre, 0) for body in scene.bodies]
    with pytest.raises(SingularError, match="nothing that moves with it has mass"):
        forward_dynamics(lowered(replaced(scene, light)), WAYS[0])


def replaced(scene: Scene, bodies: list[Particle]) -> Scene:
    return Scene(
        scene.name, scene.frame, scene.origin, coordinates=scene.coordinates,
        bodies=tuple(bodies), loads=(gravity(-scene.frame.y),), reactions=scene.reactions,
    )  # fmt: skip
