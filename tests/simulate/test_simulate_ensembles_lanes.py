"""Lanes: independent of each other, of the size of the batch, of threads and of the compiler."""

import functools
import re
import shutil
from typing import Any

import numpy as np
import pytest
from sympy import sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.compiled import Model, compile
from mechanics.compiled.machine.native import find_compiler
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.scene import Particle, Scene, force, parameters
from mechanics.simulate import Ensemble, Status, ensemble
from systems import elastic_pendulum, rocker

pytestmark = pytest.mark.campaign

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler here")
METHODS: tuple[dict[str, Any], ...] = (
    {"method": "taylor", "tolerance": 1e-9},
    {"method": "dop853", "tolerance": 1e-9},
    {"method": "rk4", "step": 0.01},
)
IDS = [str(setting["method"]) for setting in METHODS]
TIMES = np.array([0.0, 0.3, 1.0])
LANES = 16


@functools.cache
def pendulum(compiler: str | None = "auto") -> Model:
    return compile(derive(elastic_pendulum.scene(), "free_body"), compiler=compiler)


@functools.cache
def kepler() -> Model:
    """A particle that is attracted by the origin with m mu / r^2."""
    x, y = dynamicsymbols("x y")
    m, mu = parameters("m mu", units="kg m^3/s^2", typical="1 1")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x + y * ground.y)
    pull = -m * mu / sqrt(x**2 + y**2) ** 3
    scene = Scene(
        "planet", ground, origin, coordinates=(x, y), bodies=(Particle("planet", place, m),),
        loads=(force("gravity", place, pull * (x * ground.x + y * ground.y), on="planet"),),
    )  # fmt: skip
    return compile(derive(scene, "kane"))


def starts(count: int) -> dict[str, Any]:
    random = np.random.default_rng(7)
    return {
        "initial": {"theta": random.uniform(-3, 3, count), "x": random.uniform(-1, 1, count)},
        "parameters": {"L": random.uniform(0.5, 2, count), "g": 9.81},
    }


def reordered(given: dict[str, Any], order: Any) -> dict[str, Any]:
    return {
        group: {name: a[order] if np.ndim(a) else a for name, a in values.items()}
        for group, values in given.items()
    }


def run(given: dict[str, Any], setting: dict[str, Any], **more: Any) -> Ensemble:
    return ensemble(pendulum(), 1.0, times=TIMES, **given, **setting, **more)


@needs_compiler
@pytest.mark.parametrize("setting", METHODS, ids=IDS)
def test_order_of_the_motions_does_not_matter(setting: dict[str, Any]) -> None:
    given, order = starts(41), np.random.default_rng(8).permutation(41)
    straight, mixed = run(given, setting), run(reordered(given, order), setting)
    assert np.array_equal(mixed.states, straight.states[order])
    assert np.array_equal(mixed.steps, straight.steps[order])
    assert np.array_equal(mixed.evaluations, straight.evaluations[order])


@needs_compiler
@pytest.mark.parametrize("setting", METHODS, ids=IDS)
@pytest.mark.parametrize("count", [0, 1, LANES - 1, LANES, LANES + 1, 2 * LANES + 3])
def test_any_number_of_motions(setting: dict[str, Any], count: int) -> None:
    given = starts(40)
    some = run(reordered(given, slice(count)), setting)
    assert some.states.shape == (count, 3, 4) and len(some.status) == count
    assert np.array_equal(some.states, run(given, setting).states[:count])
    assert some.complete and np.all(some.reached == 3)


@needs_compiler
@pytest.mark.parametrize("setting", METHODS, ids=IDS)
@pytest.mark.parametrize("threads", [2, 3, 64])
def test_threads_change_nothing(setting: dict[str, Any], threads: int) -> None:
    given = starts(37)
    one, many = run(given, setting), run(given, setting, threads=threads)
    assert np.array_equal(one.states, many.states) and one.status == many.status
    assert np.array_equal(one.evaluations, many.evaluations)


@pytest.mark.sample(1)
@needs_compiler
@pytest.mark.parametrize("setting", METHODS, ids=IDS)
def test_compilers_agree(setting: dict[str, Any]) -> None:
    present = [name for name in ("gcc", "clang") if shutil.which(name)]
    found = [
        ensemble(pendulum(shutil.which(name)), 1.0, times=TIMES, **starts(18), **setting)
        for name in present
    ]
    assert found[0].complete
    for one in found[1:]:
        assert np.allclose(one.states, found[0].states, rtol=0, atol=1e-11)


def test_without_a_compiler_it_says_so() -> None:
    """Slower, to the same tolerance."""
    for setting in METHODS:
        found = ensemble(pendulum(None), 1.0, times=TIMES, **starts(3), **setting)
        assert "one by one, because there is no C compiler" in found.note and found.complete
        finest = ensemble(pendulum(None), 1.0, times=TIMES, **starts(3), tolerance=1e-13)
        error = 1e-4 if setting["method"] == "rk4" else 1e-6
        assert np.allclose(found.states, finest.states, rtol=0, atol=error)
        assert np.all(found.evaluations > 0) and np.all(found.reached == 3)


@needs_compiler
@pytest.mark.parametrize("setting", METHODS[:2], ids=IDS[:2])
def test_a_singular_lane_disturbs_no_other(setting: dict[str, Any]) -> None:
    """A planet at rest falls into the sun at t = pi / (2 sqrt 2) = 1.11 s; the others go around."""
    times = np.array([0.0, 0.5, 1.0, 1.5])
    orbits = {"x": np.linspace(0.8, 1.2, 20), "y_dot": np.full(20, 1.0)}
    fallen = {name: column.copy() for name, column in orbits.items()}
    fallen["x"][5], fallen["y_dot"][5] = 1.0, 0.0
    fallen["x"][9], fallen["y_dot"][9] = 0.0, 0.0
    alone, mixed = (
        ensemble(kepler(), 1.5, times=times, initial=initial, budget=3000, **setting)
        for initial in (orbits, fallen)
    )
    others = [i for i in range(20) if i not in (5, 9)]
    assert np.array_equal(mixed.states[others], alone.states[others]) and alone.complete
    assert mixed.status[5] in (Status.STALLED, Status.NOT_FINITE, Status.TOO_LONG)
    assert mixed.status[9] is Status.NOT_FINITE
    assert mixed.reached[[5, 9]].tolist() == [3, 1] and not mixed.complete
    assert np.all(np.isfinite(mixed.states[5, :3])) and np.all(np.isnan(mixed.states[5, 3:]))
    assert np.all(np.isnan(mixed.states[9, 1:])) and "18 of 20: the whole" in mixed.note


@needs_compiler
def test_fixed_steps_tell_what_is_not_finite() -> None:
    initial = {"x": np.array([1.0, 0.0, 1.0]), "y_dot": np.array([1.0, 0.0, 0.9])}
    found = ensemble(kepler(), 1.0, times=[0.0, 0.5, 1.0], initial=initial, step=0.01)
    assert [s is Status.FINISHED for s in found.status] == [True, False, True]
    assert found.reached.tolist() == [3, 1, 3] and found.steps.tolist() == [100, 0, 100]
    assert np.all(np.isnan(found.states[1, 1:])) and np.all(np.isfinite(found.states[[0, 2]]))


@needs_compiler
def test_each_lane_has_steps_of_its_own() -> None:
    """Kepler's ellipses come back after 2 pi a^(3/2); the flatter, the more steps."""
    around = 2 * np.pi
    near = np.linspace(0.2, 1.0, 17)
    initial = {"x": near, "y_dot": np.sqrt(2 / near - 1)}
    found = ensemble(kepler(), around, initial=initial, tolerance=1e-12)
    assert np.max(np.abs(found.states[:, 1] - found.states[:, 0])) < 1e-10
    assert np.all(np.diff(found.steps) <= 0) and found.steps[0] > 1.5 * found.steps[-1]


@needs_compiler
def test_a_budget_ends_a_motion() -> None:
    found = run(starts(20), METHODS[0], budget=5)
    assert all(status is Status.TOO_LONG for status in found.status) and np.all(found.steps == 5)


@needs_compiler
def test_columns_by_name() -> None:
    found = run(starts(3), METHODS[0])
    assert np.array_equal(found["theta"], found.states[:, :, 1]) and found["x_dot"].shape == (3, 3)
    with pytest.raises(InputError, match="'phi': the coordinates and speeds are x, theta, x_dot"):
        found["phi"]


@needs_compiler
def test_defined_parameters_follow_those_that_are_arrays() -> None:
    """The rocker's moments of inertia are defined by its masses and lengths."""
    model = compile(derive(rocker.scene(), "free_body"))
    radius = np.array([0.9, 1.0, 1.1])
    name = next(e.name for e in model.quantities.p if e.name.startswith(("R", "r")))
    many = ensemble(model, 0.5, parameters={name: radius}, beyond_domain=True)
    for i, value in enumerate(radius):
        one = ensemble(model, 0.5, parameters={name: value}, beyond_domain=True)
        assert np.allclose(one.states[0], many.states[i], rtol=0, atol=1e-13)
    assert np.all(np.diff(many.states[:, -1, 0]) != 0)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"initial": {"phi": 1.0}}, "initial value 'phi': the scene has no such name"),
        ({"parameters": {"q": [1.0]}}, "parameter 'q': the scene has no such name"),
        ({"inputs": {"f": 1.0}}, "input 'f': the scene has no such name"),
        ({"initial": {"theta": [1.0, np.nan]}}, "initial value theta: nan is not finite"),
        ({"initial": {"theta": "high"}}, "initial value theta: 'high' holds what is no number"),
        ({"initial": {"theta": np.ones((2, 2))}}, "initial value theta: shape (2, 2) found"),
        ({"initial": {"theta": [1.0, 2.0]}, "parameters": {"L": [1.0]}}, "arrays of one length"),
        ({"parameters": {"L": [1.0, -2.0]}}, "parameter L: -2 is negative"),
        ({"inputs": {"f": np.sin}}, "input f: a function of time is found"),
        ({"tolerance": 1e-9, "step": 0.1}, "tolerance and step: both are given"),
        ({"tolerance": 0.0}, "tolerance: 0.0 found"),
        ({"tolerance": 1e-17}, "tolerance: 1e-17 found"),
        ({"step": -1.0}, "step: -1.0 found"),
        ({"method": "euler"}, "method 'euler': the methods are auto, taylor, dop853, rk4"),
        ({"method": "rk4"}, "method 'rk4': it has fixed steps"),
        ({"method": "taylor", "step": 0.1}, "method 'taylor': it chooses its steps"),
        ({"times": [0.0, 0.5]}, "times: [0.  0.5] found"),
        ({"times": [0.0, 0.7, 0.5, 1.0]}, "numbers that increase from 0 to the duration"),
        ({"times": "now"}, "times: 'now' found"),
        ({"threads": 0}, "threads: 0 found"),
        ({"budget": 1.5}, "budget: 1.5 found"),
        ({"step": 1e-9}, "step 1e-09 s: 1e+09 steps are needed, and the budget is 1000000"),
        ({"initial": [{"theta": 1.0}]}, "initial values: list found: give a mapping"),
    ],
)
def test_mistakes_are_told_in_a_line(given: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        ensemble(pendulum(), 1.0, **given)
    assert "\n" not in str(caught.value)


def test_durations_and_models_are_checked() -> None:
    for duration in (0.0, -1.0, float("inf"), "long"):
        with pytest.raises(InputError, match="a positive number of seconds is needed"):
            ensemble(pendulum(), duration)  # type: ignore[arg-type]
    with pytest.raises(mechanics.MechanicsError, match="ensemble: Model wanted, Scene found"):
        mechanics.ensemble(elastic_pendulum.scene(), 1.0)  # type: ignore[arg-type]


def test_conditions_of_validity_are_not_watched_in_silence() -> None:
    model = compile(derive(rocker.scene(), "free_body"))
    with pytest.raises(InputError, match="conditions of validity, which an ensemble does not"):
        ensemble(model, 1.0)
