"""One state from Python without a detour: the same values, the same errors, and threads."""

import ctypes
import shutil
import subprocess
import sys
import sysconfig
import threading
import tracemalloc
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from mechanics.compiled import Model, compile
from mechanics.compiled.calls.one_state import CALLS
from mechanics.compiled.machine import direct
from mechanics.compiled.machine.direct import direct_calls
from mechanics.compiled.machine.library import load
from mechanics.compiled.sampling import sample
from mechanics.errors import InputError, MechanicsError, RangeError, SingularError

SYSTEMS = [
    ("elastic_pendulum", "kane"), ("rocker", "moving_point"), ("two_mass_chain", "free_body"),
    ("four_bar", "kane"),
]  # fmt: skip
GROUPS = ("q", "u", "inputs", "p")


@pytest.fixture(scope="module")
def extension(compiler: str) -> Any:
    found = direct_calls(compiler)
    if found.module is None:
        pytest.skip(f"no extension here: {found.why_not}")
    return found.module


@pytest.fixture
def pendulum(modelled, extension: Any) -> Model:
    return modelled("elastic_pendulum", "kane")


def states(model: Model, count: int = 20) -> Iterator[dict[str, np.ndarray]]:
    groups = sample(model.quantities, count, seed=5, decades=1.0).groups
    for row in range(count):
        yield {name: group[row].copy() for name, group in zip(GROUPS, groups, strict=True)}


def fast(model: Model, name: str) -> Callable[..., Any]:
    """The call itself, made ready: it gives None where it leaves a state to the other way."""
    state = next(states(model))
    getattr(model, name)(**state)
    return model._one[name]


@pytest.mark.campaign
@pytest.mark.sample(0)
@pytest.mark.parametrize(("system", "route"), SYSTEMS, ids=lambda x: x)
def test_every_call_gives_what_evaluate_gives(
    modelled, extension: Any, system: str, route: str
) -> None:
    model = modelled(system, route)
    named = {n: asked for n, asked in CALLS.items() if n not in ("unchecked", "residual")}
    for name, asked in named.items():
        for state in states(model, 5):
            if name == "inverse_dynamics":
                state["ud"] = np.linspace(-1, 1, len(model.quantities.ud))
            found = getattr(model, name)(**state)
            expected = model.evaluate(asked.function, **state)
            assert model._one[name](*state.values()) is not None, "the fast way was not taken"
            if name == "energy":
                assert found == {out: expected[out][0] for out in asked.outputs}
                continue
            (out,) = asked.outputs
            assert found.shape == expected[out].shape and found.dtype == np.float64
            assert_array_equal(found, expected[out])


@pytest.mark.campaign
def test_residual_takes_its_arrays_in_the_order_of_the_method(modelled, extension: Any) -> None:
    model = modelled("four_bar", "kane")
    state = next(states(model))
    ud, forces = (
        np.linspace(-1, 1, len(group))
        for group in (model.quantities.ud, model.quantities.multipliers)
    )
    found = model.residual(state["q"], state["u"], ud, forces, inputs=state["inputs"], p=state["p"])
    assert_array_equal(
        found, model.evaluate("residual", ud=ud, multipliers=forces, **state)["residual"]
    )


def test_parameters_may_be_the_third_argument_and_are_typical_by_default(pendulum: Model) -> None:
    q, u, p = np.array([0.1, 0.4]), np.array([0.2, 0.3]), pendulum.typical * 1.5
    assert_array_equal(pendulum.forward_dynamics(q, u, p), pendulum.forward_dynamics(q, u, p=p))
    typical = pendulum.forward_dynamics(q, u)
    assert_array_equal(typical, pendulum.forward_dynamics(q, u, pendulum.typical))
    assert_array_equal(typical, pendulum.forward_dynamics(q, u, check=False))
    assert_array_equal(typical, pendulum.forward_dynamics(list(q), tuple(u), {"g": 9.81}))


def unaligned(values: np.ndarray) -> np.ndarray:
    store = np.zeros(values.nbytes + 1, dtype=np.uint8)
    shifted = store[1:].view(np.float64)
    shifted[:] = values
    return shifted


class Marked(np.ndarray):
    """An array of another class."""


AWKWARD: tuple[Callable[[np.ndarray], Any], ...] = (
    list, tuple, unaligned,
    lambda a: np.repeat(a, 2)[::2],
    lambda a: a[::-1].copy()[::-1],
    lambda a: a.astype(a.dtype.newbyteorder()),
    lambda a: a.astype(np.longdouble),
    lambda a: a.view(Marked),
)  # fmt: skip


@pytest.mark.parametrize("place", range(3))
def test_arrays_that_cannot_be_read_where_they_are_are_converted(
    pendulum: Model, place: int
) -> None:
    call = fast(pendulum, "forward_dynamics")
    for state in states(pendulum, 3):
        arrays = [state["q"], state["u"], state["p"]]
        expected = pendulum.forward_dynamics(*arrays)
        for change in AWKWARD:
            given = list(arrays)
            given[place] = change(given[place])
            assert call(given[0], given[1], None, given[2]) is None
            assert_array_equal(pendulum.forward_dynamics(*given), expected)


def test_whole_and_short_numbers_are_converted_too(pendulum: Model) -> None:
    expected = pendulum.forward_dynamics(np.array([1.0, 2.0]), np.array([0.0, 1.0]))
    for kind in (int, np.float32, np.int8, bool):
        q = np.array([1, 2]).astype(kind).astype(float)
        again = pendulum.forward_dynamics(
            np.array([1, 2]).astype(kind), np.array([0, 1]).astype(kind)
        )
        assert_array_equal(again, pendulum.forward_dynamics(q, np.array([0.0, 1.0])))
    assert_array_equal(pendulum.forward_dynamics(np.array([1, 2]), np.array([0, 1])), expected)


def test_read_only_arrays_are_read_and_results_are_new(pendulum: Model) -> None:
    q, u = np.array([0.1, 0.4]), np.array([0.2, 0.3])
    q.setflags(write=False)
    first, second = pendulum.forward_dynamics(q, u), pendulum.forward_dynamics(q, u)
    assert first.flags.owndata and first.flags.writeable and not np.shares_memory(first, second)
    first[:] = 0
    assert_array_equal(pendulum.forward_dynamics(q, u), second)


WRONG: tuple[tuple[type[MechanicsError], str, tuple[Any, ...]], ...] = (
    (
        InputError,
        r"q: shape \(2,\) or \(batch, 2\) expected, \(3,\) found",
        (np.zeros(3), np.zeros(2)),
    ),
    (
        InputError,
        r"u: shape \(2,\) or \(batch, 2\) expected, \(\) found",
        (np.zeros(2), np.array(1.0)),
    ),
    (InputError, "u is missing: pass 2 values", (np.zeros(2), None)),
    (InputError, "no real numbers", (np.array(["a", "b"]), np.zeros(2))),
    (InputError, "no real numbers", (np.array([1j, 0]), np.zeros(2))),
    (InputError, "theta = nan: give finite numbers", (np.array([0, np.nan]), np.zeros(2))),
    (InputError, "theta_dot = inf: give finite", (np.zeros(2), np.array([0, np.inf]))),
    (SingularError, "the equations are singular", (np.zeros(2), np.zeros(2), np.zeros(5))),
    (RangeError, "beyond the largest number", (np.zeros(2), np.array([0, 1e300]), np.full(5, 1e9))),
)


@pytest.mark.sample(2)
@pytest.mark.parametrize(("kind", "words", "arrays"), WRONG)
def test_errors_are_those_of_the_way_that_checks(
    pendulum: Model, modelled, derived, kind: type[MechanicsError], words: str, arrays: tuple
) -> None:
    fast(pendulum, "forward_dynamics")
    slow = compile(derived("elastic_pendulum", "kane"), compiler=None)
    with pytest.raises(kind, match=words) as found:
        pendulum.forward_dynamics(*arrays)
    with pytest.raises(kind) as expected:
        slow.forward_dynamics(*arrays)
    assert str(found.value) == str(expected.value)


def test_unchecked_calls_give_what_the_machine_gives(pendulum: Model) -> None:
    found = pendulum.forward_dynamics(np.zeros(2), np.zeros(2), np.zeros(5), check=False)
    assert found.shape == (2,) and not np.isfinite(found).all()


def test_batches_and_single_states_go_together(pendulum: Model) -> None:
    given = list(states(pendulum, 4))
    q, u = (np.array([state[group] for state in given]) for group in ("q", "u"))
    batch = pendulum.forward_dynamics(q, u)
    for row, state in enumerate(given):
        assert_array_equal(pendulum.forward_dynamics(state["q"], state["u"]), batch[row])
    assert pendulum.forward_dynamics(q, u).shape == (4, 2)


def test_single_precision_is_still_there(pendulum: Model) -> None:
    for state in states(pendulum, 3):
        found = pendulum.evaluate("forward_dynamics", np.float32, **state)["ud"]
        assert found.dtype == np.float32
        np.testing.assert_allclose(found, pendulum.forward_dynamics(**state), rtol=2e-2)


def test_threads_do_not_meet(pendulum: Model) -> None:
    given = list(states(pendulum, 8))
    expected = [pendulum.forward_dynamics(**state) for state in given]

    def many(i: int) -> bool:
        return all(
            np.array_equal(pendulum.forward_dynamics(**given[i]), expected[i]) for _ in range(2000)
        )

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(many, range(8)))


def test_the_first_calls_may_come_at_the_same_time(derived, extension: Any) -> None:
    model = compile(derived("elastic_pendulum", "free_body"), flags="-O1")
    q, u = np.array([0.1, 0.4]), np.array([0.2, 0.3])
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda _: model.forward_dynamics(q, u), range(8)))
    expected = model.evaluate("forward_dynamics", q=q, u=u)["ud"]
    assert all(np.array_equal(one, expected) for one in found)


@pytest.mark.parametrize("name", ["gcc", "clang"])
def test_the_extension_compiles_without_a_warning(
    extension: Any, tmp_path: Path, name: str
) -> None:
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"no {name} here")
    source = tmp_path / "extension.c"
    source.write_text(direct.extension_source(), encoding="ascii")
    # The headers of others are not looked at.
    folders = [sysconfig.get_path("include"), np.get_include()]
    include = [word for folder in folders for word in ("-isystem", folder)]
    command = [path, "-std=c11", "-Wall", "-Wextra", "-Werror", "-O2", "-fPIC", *include]
    command += ["-c", str(source), "-o", str(tmp_path / "extension.o")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


WAITS = """
#include <time.h>
void mechanics_waits_at(const double *const *arg, double *const *res)
{
    const volatile double *flag = arg[0];
    const time_t end = time(0) + 20;
    while (*flag == 0 && time(0) < end)
        ;
    res[0][0] = *flag;
}
"""


def test_other_threads_run_while_the_kernel_does(extension: Any, compiler: str) -> None:
    """The kernel waits for a number that only another thread of Python can write."""
    library = load(WAITS, compiler, "-O1")
    address = ctypes.cast(library.mechanics_waits_at, ctypes.c_void_p).value
    for call in (
        extension.Caller(address, ((1, None),), ((1, 1, 1, True),), True, library),
        None,
    ):
        flag, result = np.zeros(1), np.zeros(1)
        bound = extension.Bound(
            address, (flag.ctypes.data,), (result.ctypes.data,), (library, flag, result)
        )
        timer = threading.Timer(0.05, flag.fill, (1.0,))
        timer.start()
        found = call(flag) if call is not None else bound() or result
        timer.join()
        assert found[0] == 1.0


def test_nothing_is_kept_of_a_call(pendulum: Model) -> None:
    state = next(states(pendulum))
    call = fast(pendulum, "forward_dynamics")
    arrays = (state["q"], state["u"], None, state["p"])
    wrong = (state["q"][:1], state["u"], None, state["p"])
    bad = (state["q"] * np.nan, state["u"], None, state["p"])
    counts = [sys.getrefcount(a) for a in arrays[:2]]
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    for _ in range(3000):
        call(*arrays), call(*wrong), call(*bad)
    grown = tracemalloc.get_traced_memory()[0] - before
    tracemalloc.stop()
    assert [sys.getrefcount(a) for a in arrays[:2]] == counts[:2]
    assert grown < 3000


def test_callers_refuse_what_does_not_fit(extension: Any, pendulum: Model) -> None:
    call = fast(pendulum, "forward_dynamics")
    with pytest.raises(TypeError, match="4 inputs expected, by position"):
        call(np.zeros(2))
    with pytest.raises(TypeError, match="by position"):
        call(np.zeros(2), np.zeros(2), None, p=None)
    with pytest.raises(ValueError, match="at most"):
        extension.Caller(1, ((1, None),) * 99, (), False, None)
    with pytest.raises(ValueError, match="the default does not fit"):
        extension.Caller(1, ((1, np.zeros(2)),), (), False, None)
    with pytest.raises(ValueError, match="at most"):
        extension.Bound(1, (1,) * 99, (), None)
    with pytest.raises(TypeError, match="no arguments"):
        pendulum.buffer("forward_dynamics").run(1)  # type: ignore[call-arg]


@pytest.fixture
def without_headers(monkeypatch: pytest.MonkeyPatch, tmp_path: Any) -> Iterator[None]:
    direct_calls.cache_clear()
    monkeypatch.setattr(sysconfig, "get_path", lambda name: str(tmp_path))
    yield
    monkeypatch.undo()
    direct_calls.cache_clear()


def test_without_the_headers_of_python_ctypes_stays_and_is_named(
    derived, compiler: str, without_headers: None
) -> None:
    model = compile(derived("elastic_pendulum", "kane"))
    assert model.backend == f"C ({compiler} -O2), single states by ctypes: no Python.h"
    q, u = np.array([0.1, 0.4]), np.array([0.2, 0.3])
    expected = model.evaluate("forward_dynamics", q=q, u=u)["ud"]
    assert_array_equal(model.forward_dynamics(q, u), expected)
    buffer = model.buffer("forward_dynamics")
    buffer.inputs["q"][:], buffer.inputs["u"][:], buffer.inputs["p"][:] = q, u, model.typical
    buffer.run()
    assert_array_equal(buffer.outputs["ud"], expected)
    with pytest.raises(InputError, match="give finite numbers"):
        model.forward_dynamics(q * np.nan, u)


def test_an_extension_that_is_refused_is_done_without(
    derived, monkeypatch: pytest.MonkeyPatch, extension: Any
) -> None:
    direct_calls.cache_clear()
    monkeypatch.setattr(direct, "FLAGS", ("-no-such-flag",))
    try:
        model = compile(derived("elastic_pendulum", "kane"))
        assert ", single states by ctypes: C compiler" in model.backend
        assert model.forward_dynamics(np.zeros(2), np.zeros(2)).shape == (2,)
    finally:
        direct_calls.cache_clear()


def test_without_a_compiler_the_virtual_machine_does_it(derived) -> None:
    model = compile(derived("elastic_pendulum", "kane"), compiler=None)
    assert model.backend == "CasADi virtual machine (no C compiler)"
    q, u = np.array([0.1, 0.4]), np.array([0.2, 0.3])
    assert_array_equal(
        model.forward_dynamics(q, u), model.evaluate("forward_dynamics", q=q, u=u)["ud"]
    )


@pytest.mark.parametrize("kind", [list, tuple, np.float32, np.int64])
def test_other_types_take_the_same_way_as_doubles(
    pendulum: Model, kind: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are converted, not sent through the way that explains what is wrong."""
    q, u = np.array([1.0, 2.0]), np.array([-3.0, 4.0])
    expected = pendulum.forward_dynamics(q, u)
    given = [a.astype(kind) if issubclass(kind, np.generic) else kind(a) for a in (q, u)]
    monkeypatch.setattr(type(pendulum), "_solved", None)
    assert_array_equal(pendulum.forward_dynamics(*given), expected)
