"""Robots in MJCF: the accelerations are MuJoCo's, loops and ties hold, what is rough is named."""

from pathlib import Path

import numpy as np
import pytest

import mechanics
from mechanics.errors import InputError

mujoco = pytest.importorskip("mujoco")

MODELS = Path(__file__).parents[1] / "models"
BODY = '<body name="b"><inertial pos="0 0 -1" mass="1" diaginertia="1 1 1"/>{}</body>'


def write(folder, body="", rest="", option=""):
    file = folder / "model.xml"
    inner = BODY.format('<joint name="q" axis="0 1 0"/>' + body)
    text = f"<option>{option}</option><worldbody>{inner}</worldbody>{rest}"
    file.write_text(f"<mujoco>{text}</mujoco>", encoding="utf-8")
    return file


class Peer:
    """A model in MuJoCo: states in and accelerations out in our order."""

    def __init__(self, path, scene):
        self.model = mujoco.MjModel.from_xml_path(str(path))
        self.data = mujoco.MjData(self.model)
        self.q, self.u = ([str(symbol) for symbol in group] for group in (scene.q, scene.u))

    def places(self):
        """(ours, theirs) of coordinates and of speeds."""
        q, u = [], []
        for j in range(self.model.njnt):
            name, kind = self.model.joint(j).name, int(self.model.jnt_type[j])
            a, v = int(self.model.jnt_qposadr[j]), int(self.model.jnt_dofadr[j])
            parts, rates = [name], [f"{name}_dot"]
            if kind <= 1:
                parts = [f"{name}_e{k}" for k in range(4)]
                rates = [f"{name}_w{k}" for k in "xyz"]
            if kind == 0:
                parts = [f"{name}_{k}" for k in "xyz"] + parts
                rates = [f"{name}_{k}_dot" for k in "xyz"] + rates
            q += [(self.q.index(part), a + k) for k, part in enumerate(parts)]
            u += [(self.u.index(rate), v + k) for k, rate in enumerate(rates)]
        return q, u

    def accelerations(self, q, u, inputs):
        own_q, own_u = self.places()
        for ours, theirs in own_q:
            self.data.qpos[theirs] = q[ours]
        for ours, theirs in own_u:
            self.data.qvel[theirs] = u[ours]
        self.data.ctrl[:] = inputs
        mujoco.mj_forward(self.model, self.data)
        found = np.zeros(len(self.u))
        for ours, theirs in own_u:
            found[ours] = self.data.qacc_smooth[theirs]
        return found


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["pendulums", "walker"])
def test_motion_is_that_of_mujoco(name):
    path, rng = MODELS / f"{name}.xml", np.random.default_rng(2)
    scene = mechanics.from_mjcf(path, symbolic=())
    model = mechanics.compile(mechanics.derive(scene), outputs=["forward_dynamics"])
    q, u = rng.uniform(-0.5, 0.5, len(scene.q)), rng.uniform(-1, 1, len(scene.u))
    # Each scene has one quaternion, which stands last.
    q[-4:] /= np.linalg.norm(q[-4:])
    inputs = rng.uniform(-1, 1, len(scene.inputs))
    wanted = Peer(path, scene).accelerations(q, u, inputs)
    found = model.forward_dynamics(q, u, inputs=inputs)
    assert np.abs(found - wanted).max() < 1e-12 * np.abs(wanted).max()


def test_armature_adds_to_the_inertia_of_a_joint(tmp_path):
    file = write(tmp_path)
    text = file.read_text(encoding="utf-8").replace(
        'axis="0 1 0"', 'axis="0 1 0" armature="0.5" damping="0.2" stiffness="3" springref="57.3"'
    )
    file.write_text(text, encoding="utf-8")
    scene = mechanics.from_mjcf(file, symbolic=())
    model = mechanics.compile(mechanics.derive(scene), outputs=["forward_dynamics"])
    (found,) = model.forward_dynamics([0.3], [0.4])
    torque = -9.81 * np.sin(0.3) - 0.2 * 0.4 - 3 * (0.3 - np.deg2rad(57.3))
    assert found == pytest.approx(torque / (1 + 1 + 0.5), rel=1e-12)


@pytest.mark.campaign
def test_a_loop_and_a_tie_are_held():
    equations = mechanics.derive(mechanics.from_mjcf(MODELS / "four_bar.xml", symbolic=()))
    assert equations.scene.degrees_of_freedom == 1
    model = mechanics.compile(equations)
    found = mechanics.simulate(model, 0.2, inputs={"motor": 0.3})
    crank, coupler, rocker, fly = (
        found.columns[name][-1] for name in ("crank", "coupler", "rocker", "fly")
    )
    assert abs(crank) > 0.1
    assert fly == pytest.approx(2 * rocker + 0.3 * rocker**2, abs=1e-9)
    peer = mujoco.MjModel.from_xml_path(str(MODELS / "four_bar.xml"))
    data = mujoco.MjData(peer)
    data.qpos[:] = [crank, coupler, rocker, fly]
    mujoco.mj_forward(peer, data)
    assert np.abs(data.efc_pos).max() < 1e-9


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["pendulums", "four_bar"])
def test_routes_agree(name):
    scene = mechanics.from_mjcf(MODELS / f"{name}.xml")
    assert mechanics.crosscheck(scene).ok


SPHERE, FLOOR = '<geom size="0.1"/>', '<body><geom type="plane" size="1 1 1"/></body>'


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("parts", "kind"),
    [
        ({"rest": '<worldbody><geom name="floor" type="plane" size="1 1 1"/></worldbody>',
          "body": '<geom name="foot" size="0.1"/>'}, "contact"),
        ({"body": '<joint name="s" type="slide" frictionloss="1"/>'}, "friction"),
        ({"body": '<joint name="s" type="ball" armature="1"/>'}, "armature"),
        ({"rest": '<actuator><intvelocity name="m" joint="q" actrange="0 1"/></actuator>'},
         "actuators"),
        ({"rest": '<tendon><fixed name="t" limited="true" range="0 1"><joint joint="q" coef="1"/>'
                  "</fixed></tendon>"}, "tendons"),
        ({"option": '<flag/>', "rest": '<option density="1.2"/>'}, "fluid"),
    ],
)  # fmt: skip
def test_what_is_not_smooth_is_named_and_left_out_when_asked(tmp_path, parts, kind):
    file = write(tmp_path, **parts)
    with pytest.raises(InputError, match=rf"{kind}: .*leave_out=\('{kind}',\)") as error:
        mechanics.from_mjcf(file)
    assert "\n" not in str(error.value)
    scene = mechanics.from_mjcf(file, leave_out=(kind,))
    assert any(note.startswith(f"{kind} left out") for note in scene.notes)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<robot/>", "no joint moves|MuJoCo refuses it"),
        ("<mujoco><worldbody><body/></worldbody></mujoco>", "no joint moves anything"),
        ('<!DOCTYPE m [<!ENTITY a "b">]><mujoco/>', "DOCTYPE"),
        ("<mujoco><worldbody>" + BODY * 401 + "</worldbody></mujoco>", "401 bodies: at most 400"),
        (
            f'<mujoco><worldbody><replicate count="1000000">{BODY}'
            "</replicate></worldbody></mujoco>",
            "1000000 bodies: at most 400",
        ),
        (
            '<mujoco><asset><hfield name="h" nrow="99999" ncol="99999" size="1 1 1 1"/></asset>'
            "</mujoco>",
            "a hfield of more than 16000000 entries",
        ),
        (
            f"<mujoco><worldbody>{BODY}</worldbody></mujoco>".replace('"1"', '"nan"'),
            "inertial mass='nan': give finite numbers",
        ),
        ("<mujoco", "it is no XML"),
        ('<mujoco><worldbody><body><joint/><inertial pos="0 0 0" mass="-1" diaginertia="1 1 1"/>'
         "</body></worldbody></mujoco>", "MuJoCo refuses it"),
    ],
)  # fmt: skip
def test_hostile_files_get_one_line(tmp_path, text, words):
    file = tmp_path / "model.xml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words) as error:
        mechanics.from_mjcf(file)
    assert "\n" not in str(error.value)


def test_what_may_be_left_out_is_checked():
    with pytest.raises(InputError, match="leave_out"):
        mechanics.from_mjcf(MODELS / "walker.xml", leave_out=("everything",))
