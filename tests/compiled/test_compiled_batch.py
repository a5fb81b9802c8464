"""Many states at once: as exact as one by one, wherever they stand, however arrays are laid out."""

import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from mechanics.compiled import Model, compile
from mechanics.compiled.c.lanes import FAR, WILD
from mechanics.compiled.c.sine import LIMIT
from mechanics.compiled.calls.many_states import MANY
from mechanics.compiled.machine.batch import BatchKernel
from mechanics.compiled.machine.vectorised import settings
from mechanics.errors import CompilerError, InputError, SingularError
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import run
from mechanics.routes.derivation import by_route
from systems import rocker

pytestmark = pytest.mark.campaign

SYSTEMS = [
    ("elastic_pendulum", "kane"), ("rocker", "moving_point"), ("two_mass_chain", "free_body"),
    ("rolling_disc", "free_body"), ("four_bar", "kane"),
]  # fmt: skip
COUNT = MANY + 37
COUNTS = (0, 1, 7, 8, 15, 255, 256, 257, 700)
DYNAMICS = "forward_dynamics"
State = dict[str, np.ndarray]


@pytest.fixture
def pendulum(modelled, compiler: str) -> Model:
    return modelled("elastic_pendulum", "kane")


def states(model: Model, count: int, kind: type = np.float64) -> State:
    """Inputs of forward dynamics at `count` states about some that have a solution."""
    random = np.random.default_rng(count)
    found = {}
    for group, size in model.program(DYNAMICS).inputs:
        if group == "p":
            found["p"] = model.typical.astype(kind)
        else:
            found[group] = random.uniform(-1.2, 1.2, (count, size)).astype(kind)
    return found


def kernel(model: Model, compiler: str, kind: type = np.float64, **more) -> BatchKernel:
    return BatchKernel(model.program(DYNAMICS), model.entries, kind, compiler, **more)


def called(made: BatchKernel, model: Model, given: State, order: str = "C") -> tuple:
    """Results, (states, entries) by output, and what was met; arrays are C- or F-ordered."""
    count, kind = len(given["q"]), given["q"].dtype
    shapes = [(count, rows * cols) for _, (rows, cols) in model.program(DYNAMICS).shapes]
    results = [np.full(shape, np.nan, kind, order=order) for shape in shapes]
    arguments = [
        a if a.ndim == 1 else np.array(a, order=order)
        for a in (given[g] for g, _ in model.program(DYNAMICS).inputs)
    ]
    return results, made(arguments, results)


def exact(model: Model, given: State) -> list[np.ndarray]:
    """In extended precision, by NumPy."""
    code, count = model.program(DYNAMICS), len(given["q"])
    columns = [
        [np.broadcast_to(given[g][..., k], count) for k in range(size)] for g, size in code.inputs
    ]
    groups = run(code, columns, np.longdouble)
    return [np.array([np.broadcast_to(e, count) for e in entries]).T for entries in groups]


@pytest.mark.sample(1)
@pytest.mark.parametrize(("system", "route"), SYSTEMS)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_batches_are_as_exact_as_single_states(modelled, compiler, system, route, kind) -> None:
    model = modelled(system, route)
    given = states(model, 300, kind)
    ones = model.kernel(DYNAMICS, kind)(
        [np.atleast_2d(given[g]) for g, _ in model.program(DYNAMICS).inputs], 300
    )
    many, _ = called(kernel(model, compiler, kind), model, given)
    for true, one, found in zip(exact(model, given), ones, many, strict=True):
        # Near a singular state both are off: what counts is how far, beside each other.
        scale = np.finfo(kind).eps * np.abs(true).max(axis=0, initial=0)
        single = np.abs(one - true).max(axis=0, initial=0)
        assert np.all(np.abs(found - true).max(axis=0, initial=0) <= 4 * single + 4 * scale)


def test_a_result_does_not_depend_on_where_the_state_stands(pendulum: Model, each: str) -> None:
    given, made = states(pendulum, max(COUNTS)), kernel(pendulum, each)
    whole = called(made, pendulum, given)[0][0]
    for count in COUNTS:
        for first in (0, 3):
            part = {g: a if g == "p" else a[first : first + count] for g, a in given.items()}
            for order in "CF":
                found, met = called(made, pendulum, part, order)
                assert met == 0
                assert_array_equal(found[0], whole[first : first + count])


def test_compilers_give_the_same_bits(modelled) -> None:
    found = [name for name in map(shutil.which, ("gcc", "clang")) if name]
    if len(found) < 2:
        pytest.skip("one C compiler here")
    for system, route in SYSTEMS[:2]:
        model = modelled(system, route)
        given = states(model, 100)
        first, second = (called(kernel(model, name), model, given)[0] for name in found)
        for a, b in zip(first, second, strict=True):
            assert_array_equal(a, b)


def test_arrays_of_any_strides_are_read_and_written(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, COUNT, 2))
    expected = pendulum.forward_dynamics(q, u)
    wide = np.zeros((2 * COUNT, 5))
    wide[::2, 1::3] = q
    backwards = u[::-1].copy()[::-1]
    for rows in (np.asfortranarray(q), wide[::2, 1::3], q.repeat(3, axis=0)[::3]):
        assert_array_equal(pendulum.forward_dynamics(rows, backwards), expected)
    apart = np.zeros(COUNT * 17 + 3, np.uint8)[3:].view(np.dtype([("x", "f8", 2), ("y", "u1")]))
    apart["x"] = q
    assert not apart["x"].flags.aligned
    assert_array_equal(pendulum.forward_dynamics(apart["x"], u), expected)
    one = pendulum.forward_dynamics(q, u[0])
    assert_array_equal(one, pendulum.forward_dynamics(q, np.repeat(u[:1], COUNT, axis=0)))


def test_results_are_laid_out_as_the_states_are(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, COUNT, 2))
    assert pendulum.forward_dynamics(q, u).flags.c_contiguous
    turned = pendulum.forward_dynamics(np.asfortranarray(q), np.asfortranarray(u))
    assert turned.flags.f_contiguous


@pytest.mark.parametrize("count", [3, COUNT])
def test_results_are_written_where_asked(pendulum: Model, count: int) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, count, 2))
    expected = pendulum.forward_dynamics(q, u)
    for out in (np.empty((count, 2)), np.empty((2, count)).T, np.empty((2 * count, 4))[::2, ::2]):
        assert pendulum.forward_dynamics(q, u, out=out) is out
        assert_array_equal(out, expected)
    same = u.copy()
    assert_array_equal(pendulum.forward_dynamics(q, same, out=same), expected)
    for wrong in (np.empty((count, 3)), np.empty((count, 2), np.float32), [[0.0, 0.0]] * count):
        with pytest.raises(InputError, match=rf"out: an array of shape \({count}, 2\)"):
            pendulum.forward_dynamics(q, u, out=wrong)
    fixed = np.empty((count, 2))
    fixed.flags.writeable = False
    with pytest.raises(InputError, match="out: the array for ud cannot be written to"):
        pendulum.forward_dynamics(q, u, out=fixed)


def test_parameters_of_their_own_for_every_state(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, COUNT, 2))
    p = pendulum.typical * np.random.default_rng(1).uniform(0.5, 2, (COUNT, len(pendulum.typical)))
    found = pendulum.forward_dynamics(q, u, p)
    single = np.array([pendulum.forward_dynamics(q[i], u[i], p[i]) for i in range(0, COUNT, 40)])
    np.testing.assert_allclose(found[::40], single, rtol=1e-13)


@pytest.mark.parametrize("check", [True, False])
def test_inputs_of_all_states_or_of_each(modelled, compiler: str, check: bool) -> None:
    model = modelled("rocker", "moving_point")
    given = states(model, COUNT)
    q, u, inputs = given["q"], given["u"], given.get("inputs", np.zeros((COUNT, 0)))
    each_one = model.forward_dynamics(q, u, inputs=np.tile(inputs[:1], (COUNT, 1)), check=check)
    shared = model.forward_dynamics(q, u, inputs=inputs[0], check=check)
    by_list = model.forward_dynamics(q.tolist(), u, inputs=inputs[0].tolist(), check=check)
    np.testing.assert_allclose(shared, each_one, rtol=1e-12, atol=1e-12)
    assert_array_equal(by_list, shared)


def test_threads_take_parts(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, 5 * COUNT, 2))
    expected = pendulum.forward_dynamics(q, u)
    for threads in (2, 3, 64):
        assert_array_equal(pendulum.forward_dynamics(q, u, threads=threads), expected)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_large_angles_get_the_sine_of_the_library(pendulum: Model, each: str, kind: type) -> None:
    made = kernel(pendulum, each, kind)
    given = states(pendulum, 400, kind)
    near = called(made, pendulum, given)[0][0]
    limit = kind(LIMIT)
    beyond = np.nextafter(limit, kind(np.inf))
    angles = {3: beyond, 70: 1e22, 71: -3e30, 300: -beyond}
    for place, angle in angles.items():
        given["q"][place, 1] = angle
    (found, *_), met = called(made, pendulum, given)
    assert met == FAR
    code = pendulum.program(DYNAMICS)
    single = pendulum.kernel(DYNAMICS, kind)
    for place in angles:
        one = [np.atleast_2d(given[g] if g == "p" else given[g][place]) for g, _ in code.inputs]
        assert_array_equal(found[place], single(one, 1)[0][0])
    others = np.setdiff1d(np.arange(400), list(angles))
    assert_array_equal(found[others], near[others])
    given["q"][3, 1] = limit
    given["q"][list(angles)[1:], 1] = 1
    assert called(made, pendulum, given)[1] == 0


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_what_is_no_number_stays_in_its_lane(pendulum: Model, each: str, bad: float) -> None:
    made = kernel(pendulum, each, checked=True)
    given = states(pendulum, 300)
    near = called(made, pendulum, given)[0][0]
    given["q"][5, 1] = given["q"][200, 0] = given["u"][260, 1] = bad
    (found, *_), met = called(made, pendulum, given)
    assert met == FAR | WILD
    touched = [5, 200, 260]
    assert not np.isfinite(found[touched]).all(axis=1).any()
    others = np.setdiff1d(np.arange(300), touched)
    assert_array_equal(found[others], near[others])


def test_a_checked_batch_names_the_state(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, COUNT, 2))
    q[COUNT - 2, 1] = np.nan
    with pytest.raises(InputError, match=f"state {COUNT - 2} of the batch: theta = nan"):
        pendulum.forward_dynamics(q, u)
    assert np.isnan(pendulum.forward_dynamics(q, u, check=False)[COUNT - 2]).all()
    p = np.tile(pendulum.typical, (COUNT, 1))
    p[7, [e.name in ("M", "m") for e in pendulum.quantities.p]] = 0
    with pytest.raises(SingularError, match="state 7 of the batch"):
        pendulum.forward_dynamics(np.zeros_like(q), u, p)
    q[COUNT - 2, 1] = 1e9
    far = pendulum.forward_dynamics(q, u)
    np.testing.assert_allclose(far[-2], pendulum.forward_dynamics(q[-2], u[-2]), rtol=1e-14)


@pytest.mark.parametrize(("system", "route"), SYSTEMS[:2])
def test_every_function_takes_a_large_batch(modelled, compiler, system: str, route: str) -> None:
    model = modelled(system, route)
    few = 5
    for name in ("mass_matrix", "coordinate_rates", "energy"):
        code = model.program(name)
        given = {
            g: model.typical if g == "p" else np.random.default_rng(2).uniform(-1, 1, (COUNT, s))
            for g, s in code.inputs
        }
        many = model.evaluate(name, **given)
        some = model.evaluate(name, **{g: a if g == "p" else a[:few] for g, a in given.items()})
        for output, value in many.items():
            assert value.shape == (COUNT, *some[output].shape[1:])
            np.testing.assert_allclose(value[:few], some[output], rtol=1e-12, atol=1e-12)


def test_no_compiler_computes_the_same(derived, pendulum: Model) -> None:
    without = compile(derived("elastic_pendulum", "kane"), compiler=None)
    assert without.batch_kernel(DYNAMICS) is None
    assert without.vectorised() == (
        "not vectorised: there is no C compiler: states are computed one by one"
    )
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, MANY, 2))
    out = np.empty((MANY, 2))
    found = without.forward_dynamics(q, u, out=out, threads=2)
    assert found is out
    np.testing.assert_allclose(found, pendulum.forward_dynamics(q, u), rtol=1e-13, atol=1e-14)


@pytest.mark.sample(1)
@pytest.mark.parametrize(("system", "route"), SYSTEMS)
def test_every_system_is_vectorised(modelled, each: str, system: str, route: str) -> None:
    found = kernel(modelled(system, route), each).vectorised
    assert found.lanes > 1, found.sentence
    assert found.sentence.endswith(f": {found.lanes} states at a time")


def test_the_model_says_whether_it_is_vectorised(pendulum: Model) -> None:
    assert pendulum.vectorised() == pendulum.batch_kernel(DYNAMICS).vectorised.sentence
    assert pendulum.vectorised(DYNAMICS, np.float32).startswith("vectorised by ")


def test_what_is_not_vectorised_says_why(each: str) -> None:
    x = ca.SX.sym("x")
    code = read_routine(ca.Function("f", [x], [ca.atan2(x, 2) + ca.exp(x)], ["q"], ["y"]))
    made = BatchKernel(code, {"q": ("x",)}, np.float64, each)
    assert made.vectorised.lanes == 1
    assert "the loop calls atan2, exp" in made.vectorised.sentence
    given, result = np.linspace(-1, 1, 20)[:, None], np.empty((20, 1))
    assert made([given], [result]) == 0
    np.testing.assert_allclose(result, np.arctan2(given, 2) + np.exp(given), rtol=1e-15)


def test_calls_release_the_lock(pendulum: Model) -> None:
    q, u = np.random.default_rng(0).uniform(-1, 1, (2, 400_000, 2))
    made, out = pendulum.batch_kernel(DYNAMICS), np.empty((400_000, 2))
    arguments = [q, u, np.zeros((400_000, 0)), pendulum.typical]
    unused = [np.empty((400_000, 0)) for _ in pendulum.program(DYNAMICS).shapes[1:]]
    steps = 0
    with ThreadPoolExecutor(1) as pool:
        for _ in range(50):  # a busy machine may give one call no chance to be seen
            running = pool.submit(made, arguments, [out, *unused])
            while not running.done():
                steps += 1
            assert running.result() == 0
            if steps > 20:
                break
            steps = 0
    # With the lock held, this thread would have stood still in every call until it was over.
    assert steps > 20


@pytest.mark.parametrize("threads", [0, -3, 1.5])
def test_a_number_of_threads_that_is_none_is_refused(threads: float) -> None:
    model = compile(by_route("kane", rocker.scene()), compiler=None)
    states = np.zeros((4, 1))
    with pytest.raises(InputError, match=r"threads: .* found: a whole number from 1 on"):
        model.forward_dynamics(states, states, inputs=np.zeros((4, 1)), threads=threads)


def test_settings_are_asked_for_without_writing_a_file(tmp_path: Path) -> None:
    """A compiler that refuses a setting removes its output, which must not be a device."""
    asked, stand_in = tmp_path / "asked", tmp_path / "cc"
    stand_in.write_text(f'#!/bin/sh\necho "$@" >> "{asked}"\nexit 1\n', encoding="utf-8")
    stand_in.chmod(0o755)
    with pytest.raises(CompilerError, match="does not know -O3"):
        settings(str(stand_in))
    lines = asked.read_text(encoding="utf-8").splitlines()
    assert lines and all("-fsyntax-only" in line and "-o" not in line.split() for line in lines)
