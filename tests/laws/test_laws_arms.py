"""Arms in space that SymPy cannot write out: cross-checked, compiled, and held against NumPy.

Referee: a textbook's recursion in plain NumPy, `benchmarks/space/textbook.py`.
"""

import json
from pathlib import Path

import numpy as np
import pytest
from serial_arms import Arm, serial_arm

import mechanics
from benchmarks.space.textbook import inverse_dynamics
from mechanics.cli import main
from mechanics.compiled import Model, prove_compiled
from mechanics.crosscheck import ROUTES, crosscheck, derive, derive_textbook
from mechanics.errors import InputError, SingularError, ValueMissingError
from mechanics.kernel import Verdict

EPS = np.finfo(float).eps
ROUNDINGS = 256
"""Of a residual, against the sum of the magnitudes of what is added up in it."""


@pytest.fixture(scope="module")
def arm() -> Arm:
    return serial_arm(5, axes="zyx", fixed="zxy")


@pytest.fixture(scope="module")
def model(arm: Arm) -> Model:
    derived = derive(arm.scene, "kane")
    assert derived.textbook is None
    return mechanics.compile(derived)


def states(n: int, count: int = 8) -> list[tuple[np.ndarray, ...]]:
    drawn = np.random.default_rng(5)
    return [tuple(drawn.uniform(-2, 2, n) for _ in range(4)) for _ in range(count)]


def referee(arm: Arm, model: Model, q, u, ud) -> np.ndarray:
    numbers = dict(zip(model.entries["p"], model.typical, strict=True))
    return inverse_dynamics(arm.joints(numbers), q, u, ud, numbers["g"])


@pytest.mark.campaign
def test_the_routes_agree_and_what_is_compiled_is_shown(arm: Arm) -> None:
    result = crosscheck(arm.scene)
    assert result.ok
    assert set(result.routes) == {route.name for route in ROUTES}
    assert all(route.form and route.forward for route in result.routes.values())
    assert len(result.pairs) == 6
    subjects = {finding.subject for finding in result.findings}
    for name in ("forward dynamics", "inverse dynamics", "mass matrix", "reactions"):
        assert f"compiled {name} = derived, free_body" in subjects
    assert {witness.verdict for witness in result.witnesses} == {Verdict.SUPPORTED}
    assert len(repr(derive(arm.scene))) < 100
    assert len(repr(model)) < 100


def test_inverse_dynamics_are_those_of_the_recursion(arm: Arm, model: Model) -> None:
    for q, u, ud, torques in states(5):
        wanted = referee(arm, model, q, u, ud) - torques
        found = model.inverse_dynamics(q, u, ud, inputs=torques)
        scale = np.abs(referee(arm, model, q, np.abs(u), np.abs(ud))).max() + np.abs(torques).max()
        assert np.abs(found - wanted).max() <= ROUNDINGS * EPS * scale


def test_forward_dynamics_solve_the_equations_of_the_recursion(arm: Arm, model: Model) -> None:
    for q, u, _, torques in states(5):
        ud = model.forward_dynamics(q, u, inputs=torques)
        residual = referee(arm, model, q, u, ud) - torques
        mass = model.mass_matrix(q, u, inputs=torques)
        scale = np.abs(mass) @ np.abs(ud) + np.abs(referee(arm, model, q, u, 0 * ud))
        scale += np.abs(torques)
        assert np.all(np.abs(residual) <= ROUNDINGS * EPS * scale.max())


def test_a_batch_is_its_states_one_by_one(model: Model) -> None:
    drawn = states(5)
    q, u, _, torques = (np.array([state[k] for state in drawn]) for k in range(4))
    together = model.forward_dynamics(q, u, inputs=torques)
    assert together.shape == (8, 5)
    assert model.mass_matrix(q, u, inputs=torques).shape == (8, 5, 5)
    for k in range(8):
        alone = model.forward_dynamics(q[k], u[k], inputs=torques[k])
        assert np.allclose(together[k], alone, rtol=64 * EPS, atol=0)
        energy = model.energy(q[k], u[k], inputs=torques[k])
        assert energy["total"] == energy["kinetic"] + energy["potential"]


@pytest.mark.campaign
def test_jacobians_are_those_of_forward_dynamics(model: Model) -> None:
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


def test_bad_input_is_named(arm: Arm, model: Model) -> None:
    q, u, _, torques = states(5)[0]
    with pytest.raises(InputError, match=r"q: shape .* \(4,\) found"):
        model.forward_dynamics(q[:4], u, inputs=torques)
    with pytest.raises(InputError, match="no parameter mass"):
        model.forward_dynamics(q, u, {"mass": 1.0}, inputs=torques)
    with pytest.raises(InputError, match="'flight'"):
        model.evaluate("flight", q=q)
    with pytest.raises(InputError, match="choose among elimination, composite, articulated"):
        mechanics.compile(derive(arm.scene), form="fewest")
    with pytest.raises(SingularError, match="do not determine the accelerations"):
        mechanics.compile(derive(arm.scene), fixed={n: 0 for n in massless(arm)})
    with pytest.raises(InputError, match="too long to be written out"):
        derive_textbook(arm.scene)


def test_a_parameter_without_a_value_is_named() -> None:
    bare = serial_arm(4, axes="zyx", fixed="zxy")
    for symbol in bare.scene.parameters:
        if symbol.name == "m1":
            symbol.typical = None
    model = mechanics.compile(derive(bare.scene))
    with pytest.raises(ValueMissingError, match="parameter m1: a number is needed"):
        model.forward_dynamics(np.zeros(4), np.zeros(4), inputs=np.zeros(4))


FILE = """
import sys
sys.path.insert(0, {tests!r})
from serial_arms import serial_arm

def scene():
    return serial_arm(4, axes="zyx", fixed="zxy").scene
"""

OUTPUTS = "forward_dynamics,inverse_dynamics"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    made = tmp_path / "arm.py"
    made.write_text(FILE.format(tests=str(Path(__file__).resolve().parents[1])))
    return made


def run(monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    """The exit code of a command."""
    monkeypatch.setattr("sys.argv", ["mechanics", *words])
    with pytest.raises(SystemExit) as stop:
        main()
    return int(stop.value.code or 0)


@pytest.mark.campaign
def test_its_code_is_written_and_verified_with_its_physics(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "folder"
    words = ("codegen", str(file), "-o", str(folder), "--outputs", OUTPUTS, "--no-batch")
    assert run(monkeypatch, *words) == 0
    again = tmp_path / "found.json"
    asked = ("--no-compile", "--json", str(again))
    assert run(monkeypatch, "verify", str(folder), "--scene", str(file), *asked) == 0
    told = json.loads(again.read_text())
    steps = {step["step"]: step["findings"] for step in told["steps"]}
    physics = steps["physics, derived again = graph"]
    assert [finding["subject"].split(" = ")[0] for finding in physics] == [
        "compiled forward dynamics", "compiled inverse dynamics",
    ]  # fmt: skip
    found = [finding["verdict"] for findings in steps.values() for finding in findings]
    assert set(found) <= {"PROVED", "CERTIFIED"}
    changed = (folder / "equations.json").read_text().replace('"sin"', '"cos"', 1)
    (folder / "equations.json").write_text(changed)
    assert run(monkeypatch, "verify", str(folder), "--no-compile") == 1


@pytest.mark.campaign
def test_it_is_simulated_and_becomes_a_unit(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    motion, unit = tmp_path / "motion.csv", tmp_path / "arm.fmu"
    assert run(monkeypatch, "simulate", str(file), "--duration", "0.2", "--out", str(motion)) == 0
    lines = motion.read_text().splitlines()
    assert len(lines) == 502
    energies = [float(line.split(",")[-1]) for line in lines[1:]]
    assert max(energies) - min(energies) <= 1e-8 * max(map(abs, energies))
    assert run(monkeypatch, "fmu", str(file), "-o", str(unit)) == 0
    assert unit.exists()


def massless(arm: Arm) -> list[str]:
    """The last joint's mass and inertia."""
    n = len(arm.axes)
    return [f"{name}{n}" for name in "mABCDEF"]


@pytest.mark.sample(1)
@pytest.mark.parametrize("names", [("g",), ("z1", "c2", "F3"), None])
def test_numbers_bound_early_never_make_a_count_larger(
    arm: Arm, model: Model, names: tuple[str, ...] | None
) -> None:
    values = {name: 0.25 for name in names or model.entries["p"]}
    fixed = mechanics.compile(derive(arm.scene, "kane"), fixed=values)
    for name in ("forward_dynamics", "inverse_dynamics", "mass_matrix", "energy"):
        assert fixed.program(name).operations <= model.program(name).operations
    for finding in prove_compiled(fixed, ("forward_dynamics", "inverse_dynamics")):
        assert finding.shown, finding
