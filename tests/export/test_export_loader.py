"""The Python file of a folder: it works alone, with and without NumPy, and says what is wrong."""

import functools
import importlib.util
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from mechanics.compiled import Model
from mechanics.compiled.machine.native import find_compiler
from mechanics.export import write_c as write_and_prove

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

ALONE = """\
import sys
sys.modules["mechanics"] = sys.modules["casadi"] = None
{without}
sys.path.insert(0, {folder!r})
from pendulum_loader import load
system = load()
found = system.forward_dynamics([0.1, 0.2], [0.3, 0.4])
print(*found.ud, type(found.ud).__name__)
print(*system.jacobians([0.1, 0.2], [0.3, 0.4]).ud_p.{flat})
"""


@pytest.fixture(scope="module")
def model(modelled) -> Model:
    return modelled("elastic_pendulum", "kane")


@pytest.fixture(scope="module")
def folder(model: Model, tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("with a space") / "c"
    write_c(model, place, name="pendulum", precision="both")
    return place


@pytest.fixture(scope="module")
def loader(folder: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("pendulum_loader", folder / "pendulum_loader.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def system(loader: ModuleType):
    if find_compiler() is None:
        pytest.skip("no C compiler here")
    return loader.load()


@pytest.mark.parametrize("numpy", [True, False])
def test_it_works_without_mechanics(model: Model, folder: Path, numpy: bool) -> None:
    if find_compiler() is None:
        pytest.skip("no C compiler here")
    without = "" if numpy else 'sys.modules["numpy"] = None'
    flat = "ravel(order='F')" if numpy else "tolist()"
    text = ALONE.format(folder=str(folder), without=without, flat=flat)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    first, second = (line.split() for line in done.stdout.splitlines())
    assert first.pop() == ("ndarray" if numpy else "array")
    state = {"q": [0.1, 0.2], "u": [0.3, 0.4]}
    assert np.allclose([*map(float, first)], model.forward_dynamics(**state), rtol=1e-13)
    expected = model.evaluate("jacobians", **state)["ud_p"].ravel(order="F")
    assert np.allclose([*map(float, second)], expected, rtol=1e-12, atol=1e-15)


def test_every_function_is_there_with_named_results(model: Model, system) -> None:
    state = {"q": [0.5, 1.0], "u": [-0.3, 0.4]}
    more = {"ud": [0.7, 0.1], "h": [1e-3]}
    for name in model.casadi:
        groups = {group for group, size in model.program(name).inputs if size}
        given = state | {group: value for group, value in more.items() if group in groups}
        found = getattr(system, name)(**given)
        expected = model.evaluate(name, **given)
        for out, value in expected.items():
            if value.size:
                result = getattr(found, out)
                assert result.shape == value.shape
                assert np.allclose(result, value, rtol=1e-12, atol=1e-15)


def test_arrays_may_be_given_by_names(model: Model, system) -> None:
    q, u = {"theta": 1.0, "x": 0.5}, {"x_dot": -0.3, "theta_dot": 0.4}
    found = system.forward_dynamics(q=q, u=u, p={"L": 2})
    assert np.allclose(found.ud, model.forward_dynamics([0.5, 1.0], [-0.3, 0.4], p={"L": 2}))


def test_single_precision(model: Model, loader: ModuleType, system) -> None:
    single = loader.load(precision="single")
    found = single.forward_dynamics([0.5, 1.0], [-0.3, 0.4]).ud
    exact = model.forward_dynamics([0.5, 1.0], [-0.3, 0.4])
    assert found.dtype == np.float32
    assert 0 < np.abs(found - exact).max() < 1e-5


def test_a_library_that_was_built_is_loaded(loader: ModuleType, system, tmp_path: Path) -> None:
    target = loader.build(tmp_path / "mine.so", flags="-O1", compiler=find_compiler())
    found = loader.load(target).energy([0.5, 1.0], [-0.3, 0.4])
    assert found == system.energy([0.5, 1.0], [-0.3, 0.4])


def test_a_status_is_an_error_that_holds_the_results(loader: ModuleType, system) -> None:
    with pytest.raises(loader.StatusError, match=r"pendulum\.forward_dynamics: singular") as caught:
        system.forward_dynamics([0, 0], [0, 0], [0] * 5)
    assert caught.value.status == 1 and np.isnan(caught.value.results.ud).any()
    with pytest.raises(loader.StatusError, match="bad input"):
        system.energy([float("nan"), 0], [0, 0])


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"q": [1.0]}, r"q has 1 entries: x, theta are 2"),
        ({"q": {"x": 1.0}}, r"q lacks theta"),
        ({"q": {"x": 1.0, "phi": 2.0}}, r"q has no 'phi': it has x, theta"),
        ({}, r"q lacks x, theta"),
        ({"q": [0, 0], "u": [0, 0], "p": {"mass": 1}}, r"p has no 'mass': it has L, M, g, k, m"),
    ],
)
def test_wrong_arrays_are_named(system, given: dict, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        system.forward_dynamics(**given)


def test_wrong_arguments_are_named(system) -> None:
    with pytest.raises(TypeError, match="forward_dynamics takes 3 arrays, not 4"):
        system.forward_dynamics([0, 0], [0, 0], None, [0])
    with pytest.raises(TypeError, match="'x' is unknown or given twice"):
        system.forward_dynamics([0, 0], [0, 0], x=1)
    with pytest.raises(TypeError, match="'q' is unknown or given twice"):
        system.forward_dynamics([0, 0], [0, 0], q=[0, 0])


def test_what_hinders_a_build_is_told(loader: ModuleType, monkeypatch, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="precision 'half': this folder has double, single"):
        loader.load(precision="half")
    if find_compiler() is not None:
        with pytest.raises(OSError, match=r"refused pendulum\.c, .*: .*no-such-flag"):
            loader.load(flags="--no-such-flag")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    with pytest.raises(OSError, match=r"no C compiler among cc, gcc, clang: .*PENDULUM_SHARED=ON"):
        loader.load()


def test_threads_call_at_the_same_time(system) -> None:
    starts = [0.1 * i for i in range(8)]

    def motion(angle: float) -> list[float]:
        q, u = [0.0, angle], [0.0, 0.0]
        for _ in range(200):
            q, u = system.step(q, u, None, [1e-2])
        return [*q, *u]

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(motion, starts)) == [motion(start) for start in starts]
