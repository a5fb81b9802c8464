"""An arm from its file to a controller, C and a unit for simulators."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from importers.by_pinocchio import peer
from sympy import pi

import mechanics

FILE = Path(__file__).parents[1] / "models" / "panda.urdf"
POSE = {"q1": 0, "q2": -pi / 4, "q3": 0, "q4": -3 * pi / 4, "q5": 0, "q6": pi / 2, "q7": pi / 4}
NAMES = tuple(POSE)


@pytest.fixture(scope="module")
def equations():
    return mechanics.derive(mechanics.from_urdf(FILE, symbolic=()))


@pytest.mark.campaign
def test_c_gives_the_torques_of_pinocchio(equations, tmp_path):
    model = mechanics.compile(equations, outputs=["inverse_dynamics"])
    mechanics.write_c(model, tmp_path / "panda")
    spec = importlib.util.spec_from_file_location("loader", tmp_path / "panda" / "panda_loader.py")
    loader = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loader)
    library, other, rng = loader.load(), peer(FILE, NAMES), np.random.default_rng(4)
    for q, u, ud in rng.uniform(-2.5, 2.5, (1000, 3, 7)):
        wanted = other.inverse_dynamics(q, u, ud)
        found = library.inverse_dynamics(q=q, u=u, inputs=np.zeros(7), p=[9.81], ud=ud).forces
        assert np.abs(found - wanted).max() < 1e-12 * max(1, np.abs(wanted).max())


@pytest.mark.campaign
def test_a_regulator_holds_it_at_a_pose(equations):
    control = pytest.importorskip("control")
    hold = mechanics.trim(equations, POSE)
    plant = mechanics.linearize(equations, POSE, inputs=hold).to_control()
    gains, _, poles = control.lqr(plant, np.diag([100.0] * 7 + [1.0] * 7), 0.01 * np.eye(7))
    assert poles.real.max() < 0
    at = np.array([float(value) for value in POSE.values()])
    model = mechanics.compile(equations)
    torques = np.array([
        float(value.subs({g: g.exact for g in value.free_symbols})) for value in hold.values()
    ])  # fmt: skip
    rest = np.zeros(7)
    weight = model.inverse_dynamics(at, rest, rest, inputs=rest)
    assert torques == pytest.approx(weight, abs=1e-12)

    def law(k):
        return mechanics.Feedback(
            lambda t, q, u: torques[k] - gains[k] @ np.concatenate([q - at, u])
        )

    begin = {name: at[k] + 0.03 * (-1) ** k for k, name in enumerate(NAMES)}
    inputs = {f"tau_{name}": law(k) for k, name in enumerate(NAMES)}
    found = mechanics.simulate(model, 0.5, initial=begin, inputs=inputs)
    left = [abs(found.columns[name][-1] - at[k]) for k, name in enumerate(NAMES)]
    assert max(left) < 0.2 * 0.03


@pytest.mark.campaign
def test_it_runs_as_a_unit(equations, tmp_path):
    fmpy = pytest.importorskip("fmpy")
    model = mechanics.compile(equations)
    begin = {name: float(value) for name, value in POSE.items()}
    unit = mechanics.write_fmu(model, tmp_path / "panda.fmu", initial=begin, prove=False, step=1e-3)
    ours = mechanics.simulate(model, 0.04, initial=begin)
    found = fmpy.simulate_fmu(str(unit), stop_time=0.04, output=list(NAMES), output_interval=0.01)
    assert abs(ours.columns["q4"][-1] - begin["q4"]) > 1e-3
    for name in NAMES:
        assert found[name][-1] == pytest.approx(ours.columns[name][-1], abs=1e-9)
