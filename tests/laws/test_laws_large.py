"""What is said of scenes that stay programs: printed, linearized, measured."""

import types
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from arms_with_contacts import hanging_arm, rolling_arm
from linkages import parallelogram
from serial_arms import serial_arm
from sympy import Rational, cos, pi, simplify, sin
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from mechanics.checks.admissible import check_scene
from mechanics.cli import main
from mechanics.cli.program_listing import program_python
from mechanics.crosscheck import ROUTES, crosscheck, derive
from mechanics.extremes.truth import truth
from mechanics.kernel import Verdict
from mechanics.linear import linearize, state_space
from mechanics.linear.values import with_numbers
from mechanics.program import Builder
from mechanics.program.listing import LONGEST, listing
from mechanics.routes.derivation import as_program
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, Position
from mechanics.scene.system import System
from mechanics.simulate.integrators import INTEGRATORS
from mechanics.trade.accurate import simulate
from systems import elastic_pendulum, four_bar, rolling_disc

EPS = np.finfo(float).eps

FILE = """
import sys
sys.path.insert(0, {tests!r})
{line}
"""
SCENES = {
    "arm": "from serial_arms import serial_arm\ndef scene(): return serial_arm(4, 'zyx').scene",
    "wheel": "from arms_with_contacts import rolling_arm as scene",
    "hanging": "from arms_with_contacts import hanging_arm as scene",
}


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Run a command on one of `SCENES`; its exit code and what it wrote."""

    def command(name: str, system: str, *words: object) -> tuple[int, str, str]:
        file = tmp_path / f"{system}.py"
        file.write_text(FILE.format(tests=str(Path(__file__).parents[1]), line=SCENES[system]))
        monkeypatch.setattr("sys.argv", ["mechanics", name, str(file), *map(str, words)])
        with pytest.raises(SystemExit) as stop:
            main()
        said = capsys.readouterr()
        return int(stop.value.code or 0), said.out, said.err

    return command


@pytest.mark.campaign
@pytest.mark.parametrize("system", ["arm", "wheel"])
def test_the_printed_module_computes_what_the_model_does(run, system: str) -> None:
    code, text, _ = run("derive", system, "--route", "kane", "--format", "python")
    assert code == 0
    module = types.ModuleType("printed")
    exec(text, module.__dict__)
    scene = serial_arm(4, "zyx").scene if system == "arm" else rolling_arm()
    model = mechanics.compile(derive(scene, "kane"), compiler=None)
    known, random = model.quantities, np.random.default_rng(7)
    q, u, ud, inputs, multipliers = (
        random.uniform(-1, 1, len(getattr(known, group)))
        for group in ("q", "u", "ud", "inputs", "multipliers")
    )
    p = np.array(known.typical)
    given = {"q": q, "u": u, "ud": ud, "multipliers": multipliers, "inputs": inputs, "p": p}
    # An array without entries is no argument.
    own = module.residual(**{name: value for name, value in given.items() if len(value)})
    theirs = model.residual(q, u, ud, multipliers, inputs=inputs)
    assert np.allclose(own, theirs, rtol=0, atol=1024 * EPS * np.abs(theirs).max())
    found = model.evaluate("forward_dynamics", q=q, u=u, inputs=inputs, p=None)
    wanted = np.concatenate([found["ud"], found["multipliers"]])
    state = (part for part in (q, u, inputs, p) if len(part))
    assert np.allclose(module.solution(*state), wanted, rtol=1e-9, atol=1e-9)


@pytest.mark.campaign
@pytest.mark.parametrize("form", ["text", "latex"])
def test_long_equations_are_printed_line_by_line(run, form: str) -> None:
    code, text, _ = run("derive", "arm", "--format", form, "--fix", "g=9.81")
    assert code == 0
    lines = text.splitlines()
    assert max(map(len, lines)) < 400
    sign = "=" if form == "text" else "&="
    assert sum(line.startswith(f"0 {sign}") for line in lines) == 4
    defined = [line.split(f" {sign}")[0] for line in lines if f" {sign} " in line]
    named = [name for name in defined if name != "0"]
    assert len(named) == len(set(named)) > 100


def test_a_listing_is_its_program() -> None:
    build = Builder()
    x, y = build.input("x"), build.input("x1")
    s = x.sin()
    for _ in range(2 * LONGEST):
        s = s * y + x
    program = build.program({"f": [s, s * s]})
    found = listing(program)
    assert all(name.name != "x1" for name, _ in found.lines)
    values: dict = {symbol: Rational(1, 3) for _, e in found.lines for symbol in e.free_symbols}
    for name, value in found.lines:
        values[name] = value.subs(values)
    one, two = (e.subs(values).evalf(20) for e in found.outputs["f"])
    assert abs(two - one**2) < 1e-15


HANGING = {"q1": -pi / 2, "q3": -pi / 2}


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["free_body", "lagrange"])
@pytest.mark.parametrize(
    "make, at",
    [
        (lambda: parallelogram(False, "coupler"), HANGING),
        (rolling_disc.scene, {}),
        (elastic_pendulum.scene, {}),
    ],
    ids=["parallelogram", "rolling disc", "elastic pendulum"],
)
def test_linear_equations_are_those_of_what_is_written_out(make, at, name: str) -> None:
    scene = make()
    rest = {q.name: at.get(q.name, 0) for q in scene.q}
    inputs = {s.name: 0 for s in scene.input_symbols}
    mechanism = check_scene(scene)
    (route,) = (route for route in ROUTES if route.name == name)
    rows = route.rows(mechanism)
    both = as_program(scene, mechanism, rows), route.equations(scene, mechanism, rows)
    one, two = (linearize(equations, rest, inputs) for equations in both)
    assert one.coordinates == two.coordinates
    # Rows of procedure (i) may be combined otherwise where they are written out.
    n = len(one.coordinates)
    factor = one.mass * two.mass.inv()
    assert factor.rank() == n
    for matrix in ("damping", "stiffness"):
        off = getattr(one, matrix) - factor * getattr(two, matrix)
        assert off.applyfunc(simplify).is_zero_matrix, matrix


@pytest.mark.campaign
def test_a_hanging_arm_swings_as_its_jacobians_say(run) -> None:
    scene = hanging_arm()
    equations = derive(scene, "lagrange")
    numbers = {symbol: with_numbers(scene, symbol) for symbol in scene.parameters}
    linear = linearize(equations, {q.name: 0 for q in scene.q}, {}, numbers)
    a, _ = state_space(linear)
    model = mechanics.compile(equations, compiler=None)
    n = len(scene.q)
    still = {"q": np.zeros(n), "u": np.zeros(n), "inputs": np.zeros(0), "p": None}
    found = model.evaluate("jacobians", **still)
    assert np.allclose(a[n:, :n], found["ud_q"], rtol=1e-10, atol=1e-10)
    assert np.allclose(a[n:, n:], found["ud_u"], rtol=1e-10, atol=1e-10)
    code, text, _ = run("modes", "hanging")
    assert code == 0
    assert text.count("omega_") == n
    code, text, _ = run("linearize", "hanging")
    assert code == 0
    assert "equilibrium: " in text


def test_enclosed_accelerations_are_those_of_what_is_written_out() -> None:
    scene = four_bar.scene()
    mechanism = check_scene(scene)
    (route,) = (route for route in ROUTES if route.name == "free_body")
    rows = route.rows(mechanism)
    program, written = as_program(scene, mechanism, rows), route.equations(scene, mechanism, rows)
    known = mechanics.compile(program, compiler=None).quantities
    symbols = [e.symbol for group in ("q", "u", "inputs", "p") for e in getattr(known, group)]
    values = np.random.default_rng(2).uniform(0.5, 1.5, len(symbols)).tolist()
    one, two = (truth(equations, symbols).at(values) for equations in (program, written))
    assert one.solution is not None
    assert two.solution is not None
    for x, y in zip(one.solution, two.solution, strict=True):
        assert x.overlaps(y)
        assert x.rel_accuracy_bits() > 80


@pytest.mark.campaign
def test_an_arm_is_simulated_to_an_accuracy() -> None:
    model = mechanics.compile(derive(hanging_arm(), "kane"))
    members = [member for member in INTEGRATORS if member.name in ("C RK4", "C RK8")]
    found = simulate(model, 0.2, accuracy=1e-8, samples=5, initial={"q1": 0.3}, members=members)
    assert found.error_estimate < 1e-8
    plain = simulate(model, 0.2, samples=5, initial={"q1": 0.3}, rtol=1e-12, atol=1e-12)
    for name, values in found.coordinates.items():
        assert np.allclose(values, plain.coordinates[name], rtol=0, atol=1e-7)


CODE = """
import math

def torques({arguments}):
{lines}
    return [{outputs}]
"""


def as_code(change: tuple[str, str] = ("", "")) -> Callable[..., object]:
    """What a person could have written: the residual of an arm of four as a Python function."""
    scene = serial_arm(4, "zyx").scene
    text = program_python(derive(scene, "kane"), {})
    body = text.split("def residual")[1].split("def solution")[0]
    lines = [line for line in body.splitlines() if " = " in line and "," not in line.split("=")[0]]
    outputs = body.split("numpy.array([")[1].split("], dtype")[0]
    symbols = (*scene.q, *scene.qd, *scene.ud, *scene.input_symbols, *scene.parameters)
    code = CODE.format(
        arguments=", ".join(map(str, symbols)), lines="\n".join(lines), outputs=outputs
    )
    code = code.replace("numpy.", "math.")
    if change[0]:
        assert change[0] in code
        code = code.replace(*change, 1)
    module = types.ModuleType("written")
    exec(code, module.__dict__)
    return module.torques


@pytest.mark.campaign
def test_code_is_judged_against_the_program() -> None:
    scene = serial_arm(4, "zyx").scene
    right = mechanics.check(scene, as_code())
    assert right.ok
    assert len(right.judged) == 4
    wrong = mechanics.check(scene, as_code(("math.sin(q3)", "math.cos(q3)")))
    assert wrong.verdict is Verdict.REFUTED
    assert any("no term-by-term search is made" in remark for remark in wrong.remarks)
    with pytest.raises(mechanics.errors.InputError, match="leave out values"):
        mechanics.check(scene, as_code(), values={"g": 9.81})


@pytest.mark.campaign
def test_statements_about_a_wheel_are_judged() -> None:
    energy = "T = 1"
    found = mechanics.check(rolling_arm(), energy)
    assert found.verdict is Verdict.REFUTED
    rolled = mechanics.check(rolling_arm(), "x_ddot = 0")
    assert rolled.verdict is Verdict.REFUTED


@pytest.mark.campaign
def test_published_rows_of_a_large_scene_are_checked() -> None:
    (c1,) = (p for p in hanging_arm().parameters if p.name == "c1")
    q1 = dynamicsymbols("q1")
    rows = (
        published("(1)", Position("C1", "z"), c1 * cos(q1), label="height"),
        published("(2)", Position("C1", "z"), c1 * sin(q1), label="height, wrong"),
        published("(3)", EquationOfMotion(), q1.diff().diff(), sin(q1), label="wrong"),
    )
    found = crosscheck(System("hanging arm", hanging_arm, rows)).published
    verdicts = [entry.finding.verdict for entry in found]
    assert verdicts == [Verdict.PROVED, Verdict.REFUTED, Verdict.REFUTED]
