"""Engines that are here agree with the scenes that their models are made from."""

from pathlib import Path

import numpy as np
import pytest
import small_trees

from mechanics.compare import ENGINES, compare, engine, installed, of_scene
from mechanics.compare.projection import admitted
from mechanics.compare.states import draw
from mechanics.errors import InputError, MechanicsError
from mechanics.importers import from_mjcf, from_urdf
from mechanics.scene import Scene
from systems import double_pendulum, pendulum_chain

UR5 = Path(__file__).parents[1] / "models" / "ur5.urdf"
TWO_LINK = Path(__file__).parents[1] / "models" / "two_link.urdf"
SCARA = Path(__file__).parents[1] / "models" / "scara.urdf"
TREES = {"arm": small_trees.arm, "lift": small_trees.lift, "floating": small_trees.floating,
         "puck": small_trees.puck, "sprung": small_trees.sprung}  # fmt: skip
SLOW = ("sympy", "drake", "pybullet", "roboticstoolbox")


@pytest.mark.sample(2)
@pytest.mark.parametrize("model", TREES)
@pytest.mark.parametrize("name", [name for name, _, _ in ENGINES if name not in SLOW])
def test_an_engine_agrees_with_a_scene(name: str, model: str) -> None:
    if name not in installed():
        pytest.skip(f"{name} is not installed")
    found = compare(TREES[model](), name, states=3)
    assert found.agree, [(row.quantity, row.difference) for row in found.rows]
    assert len(found.rows) >= 7


@pytest.mark.campaign
@pytest.mark.parametrize("model", ["arm", "lift", "sprung"])
@pytest.mark.parametrize("name", SLOW)
def test_an_engine_that_is_slower_agrees_with_a_scene(name: str, model: str) -> None:
    if name not in installed():
        pytest.skip(f"{name} is not installed")
    found = compare(TREES[model](), name, states=4)
    assert found.agree, [(row.quantity, row.difference) for row in found.rows]


def test_damping_that_a_file_states_and_pinocchio_leaves_out_is_named() -> None:
    if "pinocchio" not in installed():
        pytest.skip("pinocchio is not installed")
    found = compare(from_urdf(SCARA), "pinocchio", states=3, file=SCARA)
    (cause,) = found.causes
    assert cause.names == ("joint damping",) and "25 N m s/rad at q3" in cause.words
    assert found.unexplained == ()


def test_accelerations_that_pinocchio_does_not_compute_are_named() -> None:
    """Thread 449: `computeAllTerms` leaves `ddq` as it stands."""
    pin = pytest.importorskip("pinocchio")
    model = pin.buildModelFromUrdf(str(TWO_LINK))
    data = model.createData()

    def accelerations(q, v, f):
        pin.computeAllTerms(model, data, pin.neutral(model), v)
        return data.ddq

    found = compare(from_urdf(TWO_LINK), {"forward_dynamics": accelerations}, states=3)
    (cause,) = found.causes
    assert cause.names == ("not computed",) and "left at zero" in cause.words


@pytest.mark.campaign
def test_a_map_of_pinocchio_that_is_no_derivative_is_named() -> None:
    """Thread 2093 is mended in `dccrba`; the other function takes the velocity of the mass centre
    from its data, where it is zero as long as nothing computes it."""
    pin = pytest.importorskip("pinocchio")
    scene, model = from_urdf(UR5), pin.buildModelFromUrdf(str(UR5))
    data = model.createData()
    answers = {
        "momentum_matrix": lambda q, v: pin.computeCentroidalMap(model, data, q),
        "momentum_matrix_rate": lambda q, v: pin.dccrba(model, model.createData(), q, v),
    }
    assert compare(scene, answers, states=3).agree
    answers["momentum_matrix_rate"] = lambda q, v: pin.computeCentroidalMapTimeVariation(
        model, data, q, v
    )
    found = compare(scene, answers, states=3)
    assert found.agree or [cause.names for cause in found.causes] == [("point of a momentum",)]


def test_armature_of_a_mujoco_model_is_named() -> None:
    mujoco = pytest.importorskip("mujoco")
    from mechanics.compare.tree import links
    from mechanics.compare.urdf import mjcf

    text = mjcf(links(of_scene(small_trees.arm(2)))).replace("<joint ", '<joint armature="0.1" ')
    assert mujoco.MjModel.from_xml_string(text).dof_armature.tolist() == [0.1, 0.1]


def refused(scene: Scene, name: str) -> str:
    with pytest.raises(MechanicsError) as caught:
        engine(name, of_scene(scene))
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_what_engines_do_not_take_is_refused_in_one_line() -> None:
    if "pinocchio" in installed():
        assert "take a tree, in which one joint carries each body" in refused(
            double_pendulum.scene(), "pinocchio"
        )
        assert "couple: engines' models are made with gravity, inputs, and springs" in refused(
            small_trees.sprung(3), "pinocchio"
        )
        assert "couple: a spring without potential energy" in refused(
            small_trees.sprung(1), "pinocchio"
        )
    assert "up to 4 bodies" in refused(pendulum_chain.scene(8), "sympy")
    with pytest.raises(InputError, match="engine 'bullet': they are pinocchio, mujoco"):
        compare(double_pendulum.scene(), "bullet")


@pytest.mark.campaign
def test_states_are_drawn_on_constraints_of_quaternions(tmp_path: Path) -> None:
    """Two bodies on ball joints, their tips tied together."""
    pytest.importorskip("mujoco")
    one = '<body name="{}" pos="{} 0 0"><joint type="ball"/><inertial pos="0 0 0.2" mass="1"'
    one += ' diaginertia="1 2 2"/></body>'
    loop = '<equality><connect body1="a" body2="b" anchor="0.4 0 0.3"/></equality>'
    text = f"<mujoco><worldbody>{one.format('a', 0)}{one.format('b', 0.8)}</worldbody>{loop}"
    (tmp_path / "loop.xml").write_text(text + "</mujoco>")
    scene = from_mjcf(tmp_path / "loop.xml")
    ours = of_scene(scene)
    drawn = draw(scene, 5, ours.values)
    states = admitted(ours, drawn)
    assert len(states) == 5 and len(scene.rotations) == 2 and len(ours.mechanism.constraints) == 3
    assert np.abs(states.q - drawn.q).max() > 0.1
    still = np.zeros_like(states.v)
    rates = ours.constraints(states.q, still)[0]
    assert np.abs(ours.gap(states.q)).max() < 1e-12
    assert np.abs(np.einsum("nij,nj->ni", rates, states.v)).max() < 1e-11
    for rotation in scene.rotations:
        places = [[*scene.coordinates].index(entry) for entry in rotation.coordinates]
        assert np.linalg.norm(states.q[:, places], axis=1) == pytest.approx(1, abs=1e-14)


def test_answers_that_are_none_are_refused() -> None:
    scene = small_trees.arm(2)
    with pytest.raises(InputError, match="'mass' is no quantity"):
        compare(scene, {"mass": lambda q, v: np.eye(2)})
    with pytest.raises(InputError, match="there is no frame 'tool': they are link1, link2"):
        compare(scene, {"jacobian tool": lambda q, v: np.eye(2)})
    with pytest.raises(InputError, match="mass_matrix: the answers are no arrays of finite"):
        compare(scene, {"mass_matrix": lambda q, v: np.full((2, 2), np.nan)})
    with pytest.raises(InputError, match="there is no parameter 'G'"):
        compare(scene, {"bias": lambda q, v: v}, values={"G": 1.0})
