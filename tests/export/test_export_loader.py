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
many = system.forward_dynamics_batch([[0.1, 0.1], [0.2, 1e999]], [[0.3] * 2, [0.4] * 2])
print(*many.status)
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


@pytest.mark.campaign
@pytest.mark.parametrize("numpy", [True, False])
def test_it_works_without_mechanics(model: Model, folder: Path, numpy: bool) -> None:
    if find_compiler() is None:
        pytest.skip("no C compiler here")
    without = "" if numpy else 'sys.modules["numpy"] = None'
    flat = "ravel(order='F')" if numpy else "tolist()"
    text = ALONE.format(folder=str(folder), without=without, flat=flat)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    first, second, status = (line.split() for line in done.stdout.splitlines())
    assert status == ["0", "3"]
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


WRONG = [
    ({"q": 5.0}, r"q is 5\.0: give 2 entries, x, theta, or names with values"),
    ({"q": "ab"}, r"q is 'ab': give 2 entries"),
    ({"q": [1.0, "a"]}, r"theta of q is 'a': give a number"),
    ({"q": [[1.0, 2.0], [3.0, 4.0]]}, r"x of q is \[1\.0, 2\.0\]: give a number"),
    ({"q": {"x": None, "theta": 1}}, r"x of q is None: give a number"),
    ({"q": [0, 0], "u": [0, 0], "p": {"L": 1j}}, r"L of p is 1j: give a number"),
    ({"q": [object() for _ in range(90)]}, r"q has 90 entries: x, theta are 2"),
]


@pytest.mark.parametrize(("given", "words"), WRONG)
def test_what_is_no_number_is_named(system, given: dict, words: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{words}") as caught:
        system.forward_dynamics(**given)
    assert "\n" not in str(caught.value)


ROWS = np.ones((2, 3))
WRONG_ROWS = [
    ({"q": [1.0, 2.0], "u": ROWS}, r"x of q is 1\.0: give a row of numbers, one a state"),
    ({"q": [[1, 2], [3]], "u": ROWS}, r"q has 2 states in x, 1 in theta: give as many in each"),
    ({"q": [[1, 2], [3, "a"]], "u": ROWS}, r"theta of q is 'a': give a number"),
    ({"q": ROWS}, r"u lacks x_dot, theta_dot"),
    ({"q": 3, "u": ROWS}, r"q is 3: give 2 rows, x, theta, or names with values"),
    ({"q": ROWS.T, "u": ROWS}, r"q has 3 rows: x, theta are 2"),
    ({"q": ROWS, "u": ROWS[:, :2]}, r"forward_dynamics_batch: 3 in q, 2 in u: give as many states"),
    ({"q": ROWS * 1j, "u": ROWS}, r"q is an array of complex128: give an array of numbers"),
    ({"q": ROWS, "u": ROWS, "p": ROWS}, r"p has 2 entries: L, M, g, k, m are 5"),
]


@pytest.mark.parametrize(("given", "words"), WRONG_ROWS)
def test_wrong_rows_are_named(system, given: dict, words: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{words}") as caught:
        system.forward_dynamics_batch(**given)
    assert "\n" not in str(caught.value)


def test_many_states_have_a_status_each(loader: ModuleType, system) -> None:
    """As the function of one state: the rest of a batch is as it is without the bad ones."""
    q = np.array([[0.1, 0.2, np.nan, 0.4, 0.5], [0.3, 1e300, 0.3, 0.2, np.inf]])
    u = np.array([[0.0, 0.1, 0.2, 0.3, 0.4], [0.1, 0.2, 0.3, 1e200, 0.0]])
    found = system.forward_dynamics_batch(q, u)
    assert [loader.STATUS[i] for i in found.status] == [
        "ok", "ok", "bad input", "overflow", "bad input"]  # fmt: skip
    for i in (0, 1):
        one = system.forward_dynamics(q[:, i], u[:, i]).ud
        assert np.allclose(found.ud[:, i], one, rtol=1e-12)
    names = {"theta": q[1].tolist(), "x": q[0].tolist()}
    listed = system.forward_dynamics_batch(q=names, u=u.tolist())
    assert np.array_equal(listed.status, found.status)
    assert np.array_equal(listed.ud, found.ud, equal_nan=True)
    assert not system.forward_dynamics_batch(q[:, :2], u[:, :2]).status.any()
    none = system.forward_dynamics_batch(q[:, :0], u[:, :0])
    assert none.ud.shape == (2, 0) and none.status.shape == (0,)
    singular = system.forward_dynamics_batch(q[:, :2], u[:, :2], [0.0] * 5).status
    assert [loader.STATUS[i] for i in singular] == ["singular"] * 2


def test_a_library_without_the_functions_is_named(
    loader: ModuleType, system, tmp_path: Path
) -> None:
    (tmp_path / "a.c").write_text("int other(void) { return 0; }\n", encoding="utf-8")
    target = str(tmp_path / "a.so")
    command = [str(find_compiler()), "-shared", "-fPIC", str(tmp_path / "a.c"), "-o", target]
    subprocess.run(command, check=True)
    with pytest.raises(
        OSError, match=r"a\.so has no pendulum_\w+: build it from the files of this"
    ):
        loader.load(target)


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
