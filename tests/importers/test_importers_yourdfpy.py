"""Robots in URDF as another reader of them has them: poses of links, and where the mass is."""

from pathlib import Path

import numpy as np
import pytest

import mechanics

yourdfpy = pytest.importorskip("yourdfpy")
MODELS = Path(__file__).parents[1] / "models"
QUICK = ("two_link",)
EVERY = [
    pytest.param(name, marks=() if name in QUICK else pytest.mark.campaign)
    for name in ("two_link", "scara", "ur5", "panda", "quadruped", "humanoid")
]
G = 9.81


@pytest.mark.parametrize("name", EVERY)
def test_poses_and_potential_energy_are_those_of_yourdfpy(name):
    path = MODELS / f"{name}.urdf"
    other = yourdfpy.URDF.load(path, load_meshes=False)
    scene = mechanics.from_urdf(path, root="fixed", symbolic=(), multiples=False)
    places = [output for output in scene.outputs if output.endswith("_position")]
    turns = [output.replace("_position", "_orientation") for output in places]
    model = mechanics.compile(mechanics.derive(scene), outputs=["energy", *places, *turns])
    still, random = np.zeros(len(scene.q)), np.random.default_rng(2)
    names = [symbol.name for symbol in scene.q]
    assert set(other.actuated_joint_names) == set(names)

    def height(q):
        """Sum of mass times height."""
        other.update_cfg(dict(zip(names, q, strict=True)))
        total = 0.0
        for link, known in other.link_map.items():
            if (own := known.inertial) is not None:
                at = np.eye(4) if own.origin is None else own.origin
                total += own.mass * (other.get_transform(link, other.base_link) @ at)[2, 3]
        return total

    def potential(q):
        return model.energy(q, still, p=[G] * len(scene.parameters), inputs=still)["potential"]

    for q in random.uniform(-1.5, 1.5, (5, len(names))):
        lifted = G * (height(q) - height(still))
        assert potential(q) - potential(still) == pytest.approx(lifted, rel=1e-12, abs=1e-12)
        other.update_cfg(dict(zip(names, q, strict=True)))
        for place, turn in zip(places, turns, strict=True):
            pose = other.get_transform(place.removesuffix("_position"), other.base_link)
            assert model.output(place, q) == pytest.approx(pose[:3, 3], abs=1e-14)
            assert np.abs(model.output(turn, q) - pose[:3, :3]).max() < 1e-14
