"""Methods over lanes: against references, orders of convergence, energy, every operation."""

import functools
import platform
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.problems import pose
from mechanics.compiled import Model, compile
from mechanics.compiled.machine.library import FLAGS, REMARKS, build, find_compiler
from mechanics.compiled.machine.vectorised import TELL, loop_line, vectorised
from mechanics.compiled.right_hand_side import Held, read_held
from mechanics.crosscheck import derive
from mechanics.errors import ExpressionError
from mechanics.program import Program
from mechanics.scene import Particle, Scene, force, parameters
from mechanics.simulate import Ensemble, Status, ensemble, simulate
from mechanics.simulate.constraints import manifold
from mechanics.simulate.ensembles.choice import best
from mechanics.simulate.ensembles.explicit import RATE, dop853_source
from mechanics.simulate.ensembles.library import Library
from mechanics.simulate.ensembles.run import ADAPTIVE, SOURCES, Method, integrated
from mechanics.simulate.ensembles.taylor import taylor_source
from mechanics.simulate.integrators import INTEGRATORS, Problem, Setting
from mechanics.simulate.reference import Reference, reference
from systems import ALL

pytestmark = [
    pytest.mark.campaign,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler here"),
]
SYSTEMS = ("elastic_pendulum", "rocker", "pendulum_chain", "four_bar")
PAIRS = [(i, j) for i in range(40) for j in range(i)]
TIMES = np.array([0.0, 0.05, 0.2])


@functools.cache
def model_of(name: str) -> Model:
    scenes = {system.name: system.scene for system in ALL}
    return compile(derive(scenes[name](), "free_body"))


@functools.cache
def posed(name: str) -> Problem:
    return pose(model_of(name), TIMES)


@functools.cache
def referred(name: str) -> Reference:
    return reference(posed(name))


def solved(problem: Problem, count: int = 3, **setting: object) -> Ensemble:
    """The motion of a problem, several times."""
    model = problem.model
    names = [e.name for e in (*model.quantities.q, *model.quantities.u)]
    return ensemble(
        model, float(problem.times[-1]), times=problem.times, beyond_domain=True,
        initial={n: np.full(count, x) for n, x in zip(names, problem.start, strict=True)},
        parameters={e.name: x for e, x in zip(model.quantities.p, problem.p, strict=True)},
        **setting,
    )  # fmt: skip


@pytest.mark.sample(1)
@pytest.mark.parametrize(
    ("name", "setting", "bound"),
    [
        *((name, {"method": "taylor", "tolerance": 1e-9}, 1e-9) for name in SYSTEMS),
        ("rocker", {"method": "taylor", "tolerance": 1e-6}, 1e-6),
        ("rocker", {"method": "taylor", "tolerance": 1e-12}, 1e-12),
        ("elastic_pendulum", {"method": "taylor", "tolerance": 1e-15}, 1e-13),
        ("elastic_pendulum", {"method": "dop853", "tolerance": 1e-9}, 1e-7),
        ("rocker", {"method": "dop853", "tolerance": 1e-12}, 1e-10),
        ("elastic_pendulum", {"method": "rk8", "step": 2e-3}, 1e-10),
    ],
)
def test_states_are_those_of_the_reference(name: str, setting: dict, bound: float) -> None:
    known = referred(name)
    found = solved(posed(name), **setting)
    assert found.complete and np.all(found.reached == len(TIMES))
    for states in found.states:
        assert np.max(known.errors(states) / known.scale) < bound


@pytest.mark.parametrize("name", ["rk4", "rk5", "rk8"])
def test_fixed_steps_are_those_of_the_scalar_method(name: str) -> None:
    problem, scalar = posed("elastic_pendulum"), f"C {name.upper()}"
    member = next(m for m in INTEGRATORS if m.name == scalar)
    one = member.prepare(problem, Setting(scalar, step=0.01))()
    many = solved(problem, method=name, step=0.01)
    assert np.allclose(many.states, one.states, rtol=1e-13, atol=1e-14)
    assert np.all(many.evaluations == one.evaluations)


@pytest.mark.parametrize(
    ("name", "degree", "step"), [("rk4", 4, 0.02), ("rk5", 5, 0.025), ("rk8", 8, 0.1)]
)
def test_orders_of_convergence(name: str, degree: int, step: float) -> None:
    """Two halvings of the step."""
    model, initial = model_of("elastic_pendulum"), {"theta": np.array([0.4, 0.8]), "x": 0.1}
    exact = ensemble(model, 2.0, initial=initial, tolerance=1e-15)
    errors = [
        np.linalg.norm((found.states - exact.states)[:, -1])
        for h in (step, step / 4)
        for found in [ensemble(model, 2.0, initial=initial, method=name, step=h)]
    ]
    assert abs(np.log2(errors[0] / errors[1]) / 2 - degree) < 0.5


def test_adaptive_steps_are_as_many_as_the_scalar_method_takes() -> None:
    problem = replace(posed("elastic_pendulum"), times=np.array([0.0, 2.0]))
    member = next(m for m in INTEGRATORS if m.name == "SciPy DOP853")
    one = member.prepare(problem, Setting(member.name, tolerance=1e-9))()
    many = solved(problem, method="dop853", tolerance=1e-9)
    assert np.all(np.abs(many.evaluations - one.evaluations) <= 0.2 * one.evaluations)
    assert np.allclose(many.states, one.states, rtol=0, atol=1e-7)


@pytest.mark.parametrize("method", ["taylor", "dop853"])
def test_parameters_and_starts_of_their_own(method: str) -> None:
    """Every lane is the motion that `simulate` finds for its numbers."""
    model, random = model_of("elastic_pendulum"), np.random.default_rng(5)
    initial = {"theta": random.uniform(-3, 3, 19), "x_dot": random.uniform(-1, 1, 19), "x": 0.2}
    parameters = {"L": random.uniform(0.5, 2, 19), "k": random.uniform(5, 20, 19)}
    many = ensemble(
        model, 1.0, initial=initial, parameters=parameters, method=method, tolerance=1e-11
    )
    for i in (0, 7, 15, 16, 18):
        one = simulate(
            model, 1.0, samples=2, rtol=1e-11, atol=1e-12,
            initial={name: float(np.broadcast_to(a, 19)[i]) for name, a in initial.items()},
            parameters={name: float(a[i]) for name, a in parameters.items()},
        )  # fmt: skip
        for name in many.names:
            column = (one.coordinates | one.speeds)[name]
            assert abs(many[name][i, -1] - column[-1]) < 1e-9


@pytest.mark.parametrize("method", ["taylor", "dop853"])
def test_energy_stays(method: str) -> None:
    model, count = model_of("pendulum_chain"), 20
    n = len(model.quantities.q)
    random = np.random.default_rng(6)
    initial = {e.name: random.uniform(-2, 2, count) for e in model.quantities.q}
    found = ensemble(
        model, 2.0, initial=initial, times=np.linspace(0, 2, 9), method=method, tolerance=1e-12
    )
    states = found.states.reshape(-1, 2 * n)
    energy = model.energy(states[:, :n], states[:, n:], inputs=np.zeros(1))
    total = (np.asarray(energy["kinetic"]) + np.asarray(energy["potential"])).reshape(count, -1)
    assert np.max(np.abs(total - total[:, :1])) < 1e-8


def test_times_between_steps_are_as_good_as_the_ends() -> None:
    """The whole polynomial of a step, not its end alone."""
    problem = posed("elastic_pendulum")
    model, times = problem.model, np.linspace(0, 1, 101)
    for setting, bound in (({"method": "taylor"}, 1e-11), ({"method": "dop853"}, 1e-6)):
        found = ensemble(model, 1.0, times=times, **setting)
        direct = ensemble(model, 1.0, times=times, method="rk8", step=1e-3)
        assert int(found.steps[0]) < 40
        assert np.max(np.abs(found.states - direct.states)) < bound


def test_constraints_are_kept_to_the_tolerance() -> None:
    problem = posed("four_bar")
    model, scene = problem.model, problem.model.equations.scene
    closed = manifold(scene, model.numbers(problem.p), {})
    found = solved(problem, tolerance=1e-9)
    for t, state in zip(TIMES, found.states[0], strict=True):
        assert np.max(np.abs(closed.residual(t, state))) < 1e-9


OPERATIONS: dict[str, Callable[[ca.SX], ca.SX]] = {
    "sqrt": lambda x: ca.sqrt(2 + x), "exp": ca.exp, "log": lambda x: ca.log(2 + x),
    "sin": ca.sin, "tan": ca.tan, "sinh": ca.sinh, "cosh": ca.cosh, "tanh": ca.tanh,
    "asin": ca.asin, "acos": ca.acos, "atan": ca.atan, "asinh": ca.asinh,
    "acosh": lambda x: ca.acosh(2 + x), "atanh": ca.atanh, "erf": ca.erf,
    "power": lambda x: (2 + x) ** 1.3, "whole power": lambda x: x**3, "square": lambda x: x**2,
    "scaled square": lambda x: x * (3 * x), "inverse": lambda x: 1 / (2 + x),
    "power of a value": lambda x: (2 + x) ** x, "quotient": lambda x: (1 + x) / (2 + x**2),
    "hypot": lambda x: ca.hypot(x, 1 + x), "expm1": ca.expm1, "log1p": ca.log1p,
    "negative": lambda x: -(x * x), "twice": lambda x: 2 * (x * ca.cos(x)),
}  # fmt: skip


@pytest.mark.sample(12)
@pytest.mark.parametrize("name", OPERATIONS)
def test_series_of_every_operation(name: str) -> None:
    """x' = f(x), and what is computed from parameters: a' = f(p)."""
    y, p = ca.SX.sym("y", 2), ca.SX.sym("p")
    f = OPERATIONS[name]
    graph = ca.Function("rate", [y, p], [ca.vertcat(f(y[0]) + 0.1, f(p) * y[0])], ["y", "held"],
                        ["yd"])  # fmt: skip
    method = Library(read_held(graph), 2, str(find_compiler()), taylor_source)
    start = np.column_stack([np.linspace(0.05, 0.4, 18), np.zeros(18)])
    held, times = np.linspace(0.1, 0.6, 18)[:, None].copy(), np.array([0.0, 0.2, 0.3])
    by = Method("taylor", 1e-13, 1000)
    found = integrated(method, by, start, held, times, 1)
    assert not found.status.any() and np.max(found.steps) < 10
    for i in (0, 17):

        def rate(t: float, state: np.ndarray, p: float = held[i, 0]) -> np.ndarray:
            return np.asarray(graph(state, p)).ravel()

        exact = solve_ivp(
            rate, (0, 0.3), start[i], "DOP853", times, rtol=1e-13, atol=1e-14
        ).y.T  # fmt: skip
        assert np.allclose(found.states[i], exact, rtol=1e-10, atol=1e-11)


def rate_program(held: Held) -> tuple[Program, tuple[str, ...]]:
    return held.program, held.state


def test_what_has_no_series_is_left_to_dop853() -> None:
    y, p = ca.SX.sym("y"), ca.SX.sym("p")
    graph = ca.Function("rate", [y, p], [-p * ca.fabs(y)], ["y", "held"], ["yd"])
    with pytest.raises(ExpressionError, match="operation abs has no Taylor series"):
        taylor_source(read_held(graph))
    assert best(*rate_program(read_held(graph)), 1e-12) == "dop853"
    method = Library(read_held(graph), 1, str(find_compiler()), dop853_source)
    times = np.array([0.0, 2.0])
    found = integrated(
        method, Method("dop853", 1e-9, 999), np.ones((1, 1)), np.ones((1, 1)), times, 1
    )  # fmt: skip
    assert abs(found.states[0, 1, 0] - np.exp(-2)) < 1e-8


def test_choice_goes_by_counted_operations() -> None:
    """A series for a few products and small errors; many bodies are cheaper by their slopes."""
    small = rate_program(model_of("elastic_pendulum").right_hand_side.held)
    assert [best(*small, share) for share in (1e-12, 1e-18)] == ["taylor", "taylor"]
    y, p = ca.SX.sym("y", 40), ca.SX.sym("p")
    products = ca.vertcat(*(y[i] * y[j] * ca.sin(y[i] - y[j]) for i, j in PAIRS))
    rates = products[:40] + products[40:80]
    graph = ca.Function("rate", [y, p], [rates], ["y", "held"], ["yd"])
    assert best(*rate_program(read_held(graph)), 1e-6) == "dop853"


def test_linear_motion_takes_a_few_steps_and_is_exact() -> None:
    """Series that end, and entries that stay zero, do not hold the step back."""
    y, p = ca.SX.sym("y", 3), ca.SX.sym("p")
    graph = ca.Function(
        "rate", [y, p], [ca.vertcat(y[1], p, ca.SX(0))], ["y", "held"], ["yd"]
    )  # fmt: skip
    method = Library(read_held(graph), 3, str(find_compiler()), taylor_source)
    start, held = np.array([[1.0, -2.0, 0.0]]), np.array([[3.0]])
    times = np.array([0.0, 10.0, 1000.0])
    found = integrated(method, Method("taylor", 1e-12, 1000), start, held, times, 1)
    expected = np.column_stack([1 - 2 * times + 1.5 * times**2, -2 + 3 * times, 0 * times])
    assert np.allclose(found.states[0], expected, rtol=1e-15) and found.steps[0] < 5


def test_angles_beyond_the_inline_sine() -> None:
    """A wheel that has turned 2e6 rad: its lane has its sine from the library, the others not."""
    y, p = ca.SX.sym("y", 2), ca.SX.sym("p")
    graph = ca.Function(
        "rate", [y, p], [ca.vertcat(p, ca.sin(y[0]))], ["y", "held"], ["yd"]
    )  # fmt: skip
    near, far = np.array([0.3, 0.0]), np.array([2e6, 0.0])
    times, held = np.array([0.0, 2.0]), np.full((17, 1), 1.5)
    for name in ADAPTIVE:
        method = Library(read_held(graph), 2, str(find_compiler()), SOURCES[name])
        by = Method(name, 1e-13, 1000)
        alone = integrated(method, by, np.tile(near, (17, 1)), held, times, 1).states
        start = np.tile(near, (17, 1))
        start[4] = far
        mixed = integrated(method, by, start, held, times, 1).states
        others = np.arange(17) != 4
        assert np.array_equal(mixed[others], alone[others])
        for states, begin in ((mixed[4], 2e6), (mixed[0], 0.3)):
            exact = (np.cos(begin) - np.cos(begin + 3.0)) / 1.5
            assert abs(states[1, 1] - exact) < 1e-9


@pytest.mark.parametrize("method", ["taylor", "dop853", "rk8"])
def test_time_in_the_equations(method: str) -> None:
    """x = F (1 - cos 3 t) / (9 m), x' = F sin(3 t) / (3 m)."""
    x, t = dynamicsymbols("x"), dynamicsymbols._t
    m, F = parameters("m F", units="kg N", typical="2 5")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x)
    scene = Scene(
        "pushed", ground, origin, coordinates=(x,), bodies=(Particle("mass", place, m),),
        loads=(force("push", place, F * cos(3 * t) * ground.x, on="mass"),),
    )  # fmt: skip
    times, masses = np.array([0.0, 0.7, 2.0]), np.array([1.0, 2.0, 4.0])
    by = {"step": 0.01} if method == "rk8" else {"tolerance": 1e-11}
    found = ensemble(
        compile(derive(scene, "kane")), 2.0, times=times, parameters={"m": masses}, method=method,
        **by,
    )  # fmt: skip
    for states, mass in zip(found.states, masses, strict=True):
        exact = np.stack([5 * (1 - np.cos(3 * times)) / 9, 5 * np.sin(3 * times) / 3]) / mass
        assert np.allclose(states, exact.T, rtol=0, atol=1e-9)
    assert all(status is Status.FINISHED for status in found.status)


@pytest.mark.parametrize("name", ["gcc", "clang"])
def test_slopes_are_computed_in_vectors(name: str) -> None:
    """The loop over lanes of the right-hand side, as the compiler tells."""
    compiler = shutil.which(name)
    if compiler is None:
        pytest.skip(f"no {name} here")
    function = model_of("elastic_pendulum").right_hand_side.held
    method = Library(function, 4, compiler, dop853_source)
    file = build(method.text, compiler, [*FLAGS, *method.flags.split(), TELL[name]], ["-lm"])
    remarks = file.with_suffix(REMARKS).read_text(encoding="utf-8")
    line = loop_line(method.text, f"{RATE}_lanes")
    assert vectorised(remarks, compiler, line, 8, function.routine).lanes > 1


@pytest.mark.parametrize("name", ["gcc", "clang"])
def test_series_are_computed_in_vectors(name: str, tmp_path: Path) -> None:
    """No product of single numbers where coefficients are multiplied."""
    compiler = shutil.which(name)
    if compiler is None:
        pytest.skip(f"no {name} here")
    if platform.machine() != "x86_64":
        pytest.skip("reads the instructions of x86_64")
    method = Library(model_of("elastic_pendulum").right_hand_side.held, 4, compiler, taylor_source)
    source, assembly = tmp_path / "series.c", tmp_path / "series.s"
    source.write_text(method.text + "\nvoid *mechanics_expand = (void *)expand;\n")
    settings = [*FLAGS, *method.flags.split(), "-fno-inline-small-functions"]
    subprocess.run(
        [compiler, *settings, "-S", str(source), "-o", str(assembly)], check=True
    )  # fmt: skip
    lines = assembly.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("expand:"))
    last = next(i for i, line in enumerate(lines) if i > first and ".cfi_endproc" in line)
    body = "\n".join(lines[first:last])
    packed, single = (len(re.findall(rf"\tv?f?n?(?:mul|m(?:add|sub)\d*){kind}\b", body))
                      for kind in ("pd", "sd"))  # fmt: skip
    assert packed > 20 * max(1, single)


@pytest.mark.parametrize("tolerance", [10.0**-k for k in range(3, 14)])
def test_terms_that_vanish_by_symmetry_do_not_lengthen_a_step(tolerance: float) -> None:
    """A pendulum released where its rod is level: three of four terms of its series vanish."""
    motions = ensemble(
        model_of("rod_pendulum"), 3.0, initial={"theta": [np.pi / 2, -np.pi / 2]},
        tolerance=tolerance, method="taylor",
    )  # fmt: skip
    theta, rate = motions.states[:, -1].T
    # In J, with all typical values; it starts with none.
    assert np.all(np.abs(rate**2 / 6 + 5 * np.cos(theta)) < 100 * tolerance)
