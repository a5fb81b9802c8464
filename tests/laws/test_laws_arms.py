"""Arms in space that SymPy cannot write out: cross-checked, compiled, and held against NumPy.

Referee: Newton and Euler's recursion from a textbook in plain NumPy, `tests/newton_euler.py`.
"""

from pathlib import Path

import numpy as np
import pytest
from newton_euler import inverse_dynamics
from serial_arms import Arm, serial_arm

import mechanics
from mechanics.cli import main
from mechanics.compiled.program_model import ProgramModel
from mechanics.crosscheck import ROUTES, crosscheck, derive, derive_textbook
from mechanics.equations import ProgramEquations
from mechanics.errors import InputError, ValueMissingError
from mechanics.kernel import Verdict

EPS = np.finfo(float).eps
ROUNDINGS = 256
"""Of a residual, against the sum of the magnitudes of what is added up in it."""


@pytest.fixture(scope="module")
def arm() -> Arm:
    return serial_arm(5, axes="zyx", fixed="zxy")


@pytest.fixture(scope="module")
def model(arm: Arm) -> ProgramModel:
    derived = derive(arm.scene, "kane")
    assert isinstance(derived, ProgramEquations)
    return mechanics.compile(derived)


def states(n: int, count: int = 8) -> list[tuple[np.ndarray, ...]]:
    drawn = np.random.default_rng(5)
    return [tuple(drawn.uniform(-2, 2, n) for _ in range(4)) for _ in range(count)]


def referee(arm: Arm, model: ProgramModel, q, u, ud) -> np.ndarray:
    numbers = dict(zip(model.parameters, model._numbers({}), strict=True))
    return inverse_dynamics(arm.joints(numbers), q, u, ud, np.array([0, 0, -numbers["g"]]))


def test_the_routes_agree_and_what_is_compiled_is_shown(arm: Arm) -> None:
    result = crosscheck(arm.scene)
    assert result.ok
    assert set(result.routes) == {route.name for route in ROUTES}
    assert len(result.pairs) == 6
    subjects = {finding.subject for finding in result.findings}
    assert {"compiled forward_dynamics: rows are zero", "compiled mass_matrix: as derived"} <= (
        subjects
    )
    assert {witness.verdict for witness in result.witnesses} == {Verdict.SUPPORTED}
    assert len(repr(derive(arm.scene))) < 100
    assert len(repr(model)) < 100


def test_inverse_dynamics_are_those_of_the_recursion(arm: Arm, model: ProgramModel) -> None:
    for q, u, ud, torques in states(5):
        wanted = referee(arm, model, q, u, ud) - torques
        found = model.inverse_dynamics(q, u, ud, inputs=torques)
        scale = np.abs(referee(arm, model, q, np.abs(u), np.abs(ud))).max() + np.abs(torques).max()
        assert np.abs(found - wanted).max() <= ROUNDINGS * EPS * scale


def test_forward_dynamics_solve_the_equations_of_the_recursion(
    arm: Arm, model: ProgramModel
) -> None:
    for q, u, _, torques in states(5):
        ud = model.forward_dynamics(q, u, inputs=torques)
        residual = referee(arm, model, q, u, ud) - torques
        mass = model.mass_matrix(q, u, inputs=torques)
        scale = np.abs(mass) @ np.abs(ud) + np.abs(referee(arm, model, q, u, 0 * ud))
        scale += np.abs(torques)
        assert np.all(np.abs(residual) <= ROUNDINGS * EPS * scale.max())


def test_a_batch_is_its_states_one_by_one(model: ProgramModel) -> None:
    drawn = states(5)
    q, u, _, torques = (np.array([state[k] for state in drawn]) for k in range(4))
    together = model.forward_dynamics(q, u, inputs=torques)
    assert together.shape == (8, 5)
    assert model.mass_matrix(q, u, inputs=torques).shape == (8, 5, 5)
    for k in range(8):
        alone = model.forward_dynamics(q[k], u[k], inputs=torques[k])
        assert np.array_equal(together[k], alone)
        energy = model.energy(q[k], u[k], inputs=torques[k])
        assert energy["total"] == energy["kinetic"] + energy["potential"]


def test_jacobians_are_those_of_forward_dynamics(model: ProgramModel) -> None:
    q, u, _, torques = states(5)[0]
    found = model.evaluate("jacobians", q=q, u=u, inputs=torques, p=None)
    step = 1e-6
    for name, k in (("ud_q", 0), ("ud_u", 1)):
        for j in range(5):
            ends = []
            for sign in (1, -1):
                moved = [q.copy(), u.copy()]
                moved[k][j] += sign * step
                ends.append(model.forward_dynamics(*moved, inputs=torques))
            slope = (ends[0] - ends[1]) / (2 * step)
            assert np.allclose(found[name][:, j], slope, rtol=1e-5, atol=1e-5)


def test_bad_input_is_named(arm: Arm, model: ProgramModel) -> None:
    q, u, _, torques = states(5)[0]
    with pytest.raises(InputError, match=r"q has the shape \(4,\)"):
        model.forward_dynamics(q[:4], u, inputs=torques)
    with pytest.raises(InputError, match="parameter 'mass'"):
        model.forward_dynamics(q, u, {"mass": 1.0}, inputs=torques)
    with pytest.raises(InputError, match="'flight'"):
        model.evaluate("flight", q=q)
    with pytest.raises(InputError, match="no options"):
        mechanics.compile(derive(arm.scene), fixed={"g": 9.81})
    with pytest.raises(InputError, match="too long to be written out"):
        derive_textbook(arm.scene)


def test_a_parameter_without_a_value_is_named() -> None:
    bare = serial_arm(4, axes="zyx", fixed="zxy")
    for symbol in bare.scene.parameters:
        if symbol.name == "m1":
            symbol.typical = None
    model = mechanics.compile(derive(bare.scene))
    with pytest.raises(ValueMissingError, match="parameter m1: it has no value"):
        model.forward_dynamics(np.zeros(4), np.zeros(4), inputs=np.zeros(4))


FILE = """
import sys
sys.path.insert(0, {tests!r})
from serial_arms import serial_arm

def scene():
    return serial_arm(4, axes="zyx", fixed="zxy").scene
"""


@pytest.mark.parametrize(
    ("command", "code"),
    [(["crosscheck"], 0), (["derive"], 2), (["codegen", "-o", "folder"], 2)],
)
def test_the_command_line_takes_it_or_says_why_not(
    command: list[str],
    code: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "arm.py"
    file.write_text(FILE.format(tests=str(Path(__file__).resolve().parents[1])))
    name, *options = command
    monkeypatch.setattr("sys.argv", ["mechanics", name, str(file), *options])
    with pytest.raises(SystemExit) as stop:
        main()
    assert (stop.value.code or 0) == code
    said = capsys.readouterr()
    assert "Traceback" not in said.out + said.err
    if code:
        assert "too long to be written out" in " ".join(said.err.split())
    assert not (tmp_path / "folder").exists()
