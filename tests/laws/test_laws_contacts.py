"""Scenes with constraints and friction as programs: what they compute is shown and solves them.

Small scenes are compiled both ways, from what SymPy writes out and from the program; large ones are
held against their own equations, M u' = f + B lambda and A u' = b.
"""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from arms_with_contacts import closed_arm, rolling_arm, rubbing_arm
from linkages import parallelogram, slider_crank

import mechanics
from mechanics.checks.admissible import check_scene
from mechanics.cli import main
from mechanics.compiled import Model, prove_compiled
from mechanics.crosscheck import ROUTES, crosscheck, derive
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.routes.derivation import as_program
from mechanics.scene import Scene
from mechanics.simulate import simulate
from systems import cartpole_friction, four_bar, rolling_disc

pytestmark = pytest.mark.campaign

EPS = np.finfo(float).eps
ROUNDINGS = 64
"""Of a row, against the sum of the magnitudes of what is added up in it."""
STATES = 200

SMALL: dict[str, Callable[[], Scene]] = {
    "four-bar": four_bar.scene,
    "rolling disc": rolling_disc.scene,
    "cart with friction": cartpole_friction.scene,
    "slider crank, cut at the slider": lambda: slider_crank("slider"),
    "parallelogram": lambda: parallelogram(False, "coupler"),
}
LARGE: dict[str, Callable[[], Scene]] = {
    "loop": lambda: closed_arm(4),
    "wheel": rolling_arm,
    "friction": lambda: rubbing_arm(3),
}


def as_both(scene: Scene, name: str) -> tuple[Model, Model]:
    """A scene compiled from its program and from what SymPy writes out."""
    (route,) = (route for route in ROUTES if route.name == name)
    mechanism = check_scene(scene)
    rows = route.rows(mechanism)
    program = as_program(scene, mechanism, rows)
    written = route.equations(scene, mechanism, rows)
    return mechanics.compile(program, compiler=None), mechanics.compile(written, compiler=None)


def drawn(model: Model, count: int, size: float = 1.0) -> dict[str, np.ndarray]:
    random, known = np.random.default_rng(3), model.quantities
    groups = {"q": known.q, "u": known.u, "inputs": known.inputs}
    state = {name: random.uniform(-size, size, (count, len(g))) for name, g in groups.items()}
    return {**state, "p": None}


@pytest.mark.sample(4)
@pytest.mark.parametrize("route", ["free_body", "moving_point", "lagrange"])
@pytest.mark.parametrize("name", SMALL)
def test_a_small_scene_is_the_same_both_ways(name: str, route: str) -> None:
    program, written = as_both(SMALL[name](), route)
    for finding in prove_compiled(program, [f for f in program.casadi if f != "step"]):
        assert finding.shown, finding
    assert program.entries["multipliers"] == written.entries["multipliers"]
    states = drawn(program, STATES)
    for function in ("forward_dynamics", "energy", "momenta", "jacobians"):
        one, two = (m.evaluate(function, **states) for m in (program, written))
        for output in one:
            assert one[output].shape == two[output].shape
            off = np.abs(one[output] - two[output]) / (1 + np.abs(two[output]))
            # Beside singular states both lose digits.
            assert np.all(off < 1e-8), output
            assert np.quantile([0.0, *off.flat], 0.5) < ROUNDINGS * EPS, output


@pytest.fixture(scope="module", params=list(LARGE))
def model(request: pytest.FixtureRequest) -> Model:
    derived = derive(LARGE[request.param](), "kane")
    assert derived.textbook is None
    return mechanics.compile(derived, compiler=None)


@pytest.mark.sample(1)
def test_what_is_compiled_of_a_large_scene_is_shown(model: Model) -> None:
    names = [name for name in model.casadi if name != "step"]
    findings = prove_compiled(model, names)
    assert len(findings) == len(names)
    for finding in findings:
        assert finding.shown, finding


def test_accelerations_and_multipliers_solve_the_rows(model: Model) -> None:
    """|M u' - B lambda - f| and |A u' - b|, against the sums of the magnitudes of their terms."""
    states = drawn(model, STATES, 2.0)
    solved = model.evaluate("forward_dynamics", **states)
    ud, multipliers = solved["ud"], solved["multipliers"]
    n, c = ud.shape[1], multipliers.shape[1]

    def residual(x: np.ndarray) -> np.ndarray:
        given = {"ud": x[:, :n], "multipliers": x[:, n:]}
        return model.evaluate("residual", **given, **states)["residual"]

    x = np.hstack([ud, multipliers])
    rest = residual(np.zeros_like(x))
    units = [np.tile(unit, (STATES, 1)) for unit in np.eye(n + c)]
    matrix = np.stack([residual(unit) - rest for unit in units], axis=2)
    size = np.abs(rest) + np.einsum("sij,sj->si", np.abs(matrix), np.abs(x))
    off = np.abs(residual(x))
    assert np.all(off[:, :n] <= ROUNDINGS * EPS * size[:, :n])
    # Of the constraints: what |A| |M^-1| makes of the rounding of the rows above.
    carried = np.einsum("sij,sjk->sik", np.abs(matrix[:, n:, :n]),
                        np.abs(np.linalg.inv(matrix[:, :n, :n])))  # fmt: skip
    bound = size[:, n:] + np.einsum("sij,sj->si", carried, size[:, :n])
    assert np.all(off[:, n:] <= ROUNDINGS * EPS * bound)


def test_motions_start_on_the_constraints_and_stay_there(model: Model) -> None:
    scene = model.equations.scene
    found = simulate(model, 0.2, samples=11)
    assert found.times[-1] == 0.2
    assert all(drift < 1e-8 for drift in found.drift.values())
    if scene.constraints and all(c.holonomic for c in scene.constraints):
        assert found.branch.startswith("branch: ")
    if "friction" not in scene.name and not scene.inputs:
        assert found.energy_drift < 1e-8


@pytest.mark.campaign
def test_a_wheel_with_an_arm_is_cross_checked() -> None:
    result = crosscheck(rolling_arm())
    assert result.ok
    assert len(result.pairs) == 6
    subjects = {finding.subject for finding in result.findings}
    for name in ("forward dynamics", "residual", "jacobians", "reactions"):
        assert f"compiled {name} = derived, free_body" in subjects
    assert {witness.verdict for witness in result.witnesses} == {Verdict.SUPPORTED}


def test_forms_that_need_a_free_tree_are_named() -> None:
    with pytest.raises(InputError, match=r"the bodies are no tree, for .* constrains them"):
        model = mechanics.compile(derive(rolling_arm()), form="articulated", compiler=None)
        _ = model.form


FILE = """
import sys
sys.path.insert(0, {tests!r})
from arms_with_contacts import rolling_arm as scene
"""


@pytest.mark.campaign
def test_code_of_a_wheel_is_written_and_verified(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, folder, found = (tmp_path / name for name in ("wheel.py", "folder", "found.json"))
    file.write_text(FILE.format(tests=str(Path(__file__).resolve().parents[1])))

    def run(*words: object) -> int:
        monkeypatch.setattr("sys.argv", ["mechanics", *map(str, words)])
        with pytest.raises(SystemExit) as stop:
            main()
        return int(stop.value.code or 0)

    asked = ("--outputs", "forward_dynamics", "--no-batch")
    assert run("codegen", file, "-o", folder, *asked) == 0
    assert run("verify", folder, "--scene", file, "--no-compile", "--json", found) == 0
    steps = json.loads(found.read_text())["steps"]
    verdicts = {finding["verdict"] for step in steps for finding in step["findings"]}
    assert verdicts <= {"PROVED", "CERTIFIED"}
