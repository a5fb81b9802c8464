"""Ensembles in parts: neither parts, nor order, nor workers, nor a stop can be seen in a result."""

import json
import shutil
import sys
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.cluster import workers
from mechanics.compiled import Model, compile
from mechanics.compiled.machine.native import find_compiler
from mechanics.crosscheck import derive
from mechanics.errors import CompilerError, InputError
from mechanics.simulate import ensemble, write_ensemble
from mechanics.simulate.ensembles import task as tasks
from mechanics.simulate.ensembles.grid import read_grid
from mechanics.simulate.ensembles.run import SOURCES, Method
from mechanics.simulate.ensembles.settings import task_of
from mechanics.simulate.ensembles.task import from_text, to_text
from systems import EVERY

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler here")
STEPS: dict[str, Any] = {"method": "rk4", "step": 0.05}
VARY = {"theta": (0.1, 3.0, 10), "M": (1.0, 2.0, 10)}


@cache
def model_of(name: str) -> Model:
    scenes = {system.name: system.scene for system in EVERY}
    return compile(derive(scenes[name](), "kane"))


def in_memory(times: np.ndarray, **more: Any) -> np.ndarray:
    """States of the grid, by the function for what memory holds."""
    theta, m = (a.ravel() for a in np.meshgrid(
        np.linspace(0.1, 3.0, 10), np.linspace(1.0, 2.0, 10), indexing="ij"))  # fmt: skip
    columns = read_grid(VARY).columns(0, 100)
    assert np.allclose(columns["theta"], theta, rtol=1e-15, atol=0)
    assert np.allclose(columns["M"], m, rtol=1e-15, atol=0)
    found = ensemble(
        model_of("elastic_pendulum"), 1.0, times=times, initial={"theta": columns["theta"]},
        parameters={"M": columns["M"]}, **STEPS, **more,
    )  # fmt: skip
    return found.states


def write(folder: Path, **more: Any) -> Any:
    return write_ensemble(model_of("elastic_pendulum"), 1.0, folder, VARY, **STEPS, **more)


def states_in(folder: Path, table: str = "motions") -> np.ndarray:
    """Coordinates and speeds, in the order of the files."""
    rows = pq.read_table(folder / table)
    assert np.array_equal(np.unique(rows["motion"]), np.arange(100))
    return np.column_stack([rows[name] for name in ("x", "theta", "x_dot", "theta_dot")])


@needs_compiler
def test_parts_and_workers_change_no_bit(tmp_path: Path) -> None:
    expected = in_memory(np.array([0.0, 1.0]))[:, -1]
    for part, here in ((7, False), (8, True), (100, False), (1000, True)):
        folder = tmp_path / str(part)
        with ThreadPoolExecutor(2) as executor:
            found = write(folder, part=part, executor=executor, workers=lambda: 2, here=here)
        assert found.complete and found.endings == {"finished": 100} and found.before == 0
        assert np.array_equal(states_in(folder), expected)
        assert not [*folder.glob("*/*.new")]


@needs_compiler
def test_samples_are_those_of_memory(tmp_path: Path) -> None:
    times = np.linspace(0.0, 1.0, 11)
    write(tmp_path / "a", samples=11, part=33)
    found = states_in(tmp_path / "a", "samples").reshape(100, 11, 4)
    assert np.array_equal(found, in_memory(times))
    rows = pq.read_table(tmp_path / "a" / "samples")
    assert np.array_equal(rows["t"], np.tile(times, 100))
    assert np.array_equal(rows["motion"], np.repeat(np.arange(100), 11))


class Counting(Executor):
    """Runs at once, and counts; from a number on it is stopped."""

    def __init__(self, most: int) -> None:
        self.most, self.count = most, 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        if self.count == self.most:
            raise KeyboardInterrupt
        self.count += 1
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


@needs_compiler
def test_a_stopped_run_goes_on_and_does_nothing_twice(tmp_path: Path) -> None:
    folder, first, second = tmp_path / "a", Counting(6), Counting(99)
    with pytest.raises(KeyboardInterrupt):
        write(folder, part=10, executor=first)
    files = {file: file.stat().st_mtime_ns for file in (folder / "motions").glob("part-*")}
    half = folder / "motions" / "part-000000009.new"
    half.write_bytes(b"PAR1 and no more")
    found = write(folder, part=25, executor=second)
    assert found.before == 10 * len(files) and second.count == 10 - len(files) > 0
    assert all(file.stat().st_mtime_ns == time for file, time in files.items())
    assert not half.exists()
    assert np.array_equal(states_in(folder), in_memory(np.array([0.0, 1.0]))[:, -1])
    third = Counting(0)
    assert write(folder, executor=third).before == 100


class Careless(Counting):
    """Loses the folder before its parts are computed."""

    def __init__(self, folder: Path) -> None:
        super().__init__(99)
        self.folder = folder

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        shutil.rmtree(self.folder, ignore_errors=True)
        return super().submit(fn, *args, **kwargs)


@needs_compiler
@pytest.mark.parametrize("here", [False, True])
def test_a_disk_that_goes_away_is_told_in_one_line(here: bool, tmp_path: Path) -> None:
    lost = Careless(tmp_path / "a" / "motions")
    with pytest.raises(InputError, match=r"folder .*a.*: it cannot be written: No such file"):
        write(tmp_path / "a", executor=lost, here=here)


@needs_compiler
def test_a_folder_of_something_else_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "a"
    write(folder)
    with pytest.raises(InputError, match=r'another run, with initial \{\}, not \{"theta_dot": 1\}'):
        write(folder, initial={"theta_dot": 1})
    with pytest.raises(InputError, match=r"another run, with duration 1\.0, not 2\.0"):
        write_ensemble(model_of("elastic_pendulum"), 2.0, folder, VARY, **STEPS)
    (folder / "ensemble.json").write_text("{")
    with pytest.raises(InputError, match=r"ensemble\.json cannot be read"):
        write(folder)
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "mine.txt").write_text("keep me")
    with pytest.raises(InputError, match="it holds other files"):
        write(tmp_path / "b")
    with pytest.raises(InputError, match="it is a file"):
        write(tmp_path / "b" / "mine.txt")
    with pytest.raises(InputError, match="there is no folder"):
        write(tmp_path / "c" / "d")
    with pytest.raises(InputError, match="it cannot be written"):
        write(Path("/proc/ensemble"))
    with pytest.raises(InputError, match="GB are free: take fewer"):
        vary = {"theta": (0.0, 1.0, 10**6), "M": (1.0, 2.0, 10**6)}
        write_ensemble(model_of("elastic_pendulum"), 1.0, tmp_path / "large", vary, **STEPS)
    with pytest.raises(InputError, match="samples: 1000000000 found: at most"):
        write(tmp_path / "larger", samples=10**9)
    assert [*(tmp_path / "b").iterdir()] == [tmp_path / "b" / "mine.txt"]


@needs_compiler
def test_two_runs_do_not_share_a_folder(tmp_path: Path) -> None:
    inside: list[str] = []

    def again(share: float) -> None:
        with pytest.raises(InputError, match="another process is writing there"):
            write(tmp_path / "a")
        inside.append("refused")

    write(tmp_path / "a", progress=again)
    assert inside


@pytest.mark.parametrize(
    ("vary", "words"),
    [
        ({}, "nothing found"),
        ({"theta": (0.0, 1.0, 1)}, "at least 2"),
        ({"theta": (0.0, float("nan"), 5)}, "two finite numbers"),
        ({"theta": (-1e308, 1e308, 5)}, "two finite numbers"),
        ({"theta": (0.0, 1.0, 2.5)}, "how many values"),
        ({"theta": 3}, "two finite numbers"),
        ({"theta": (0.0, 1.0, 10**7), "M": (1.0, 2.0, 10**7)}, "at most 1e\\+12 motions"),
        ({"nothing": (0.0, 1.0, 5)}, "no such name"),
        ({"M": (-1.0, 1.0, 5)}, "is negative"),
    ],
)
def test_ranges_that_are_none(tmp_path: Path, vary: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        write_ensemble(model_of("elastic_pendulum"), 1.0, tmp_path / "a", vary, **STEPS)
    assert not (tmp_path / "a").exists()


def test_what_is_not_installed_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InputError, match=r"pip install 'mechanics\[parquet\]'"):
        write(tmp_path / "a")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError, match=r"pip install 'mechanics\[cluster\]'"):
        workers(processes=2).__enter__()


@given(st.lists(st.integers(2, 5), min_size=1, max_size=3), st.data())
def test_columns_of_a_part_are_those_of_the_whole(sizes: list[int], data: Any) -> None:
    """And the values are numpy.linspace's to the last bits, the ends exactly."""
    grid = read_grid({f"a{k}": (0.1 * k, 0.7 + k, n) for k, n in enumerate(sizes)})
    first = data.draw(st.integers(0, grid.count - 1))
    last = data.draw(st.integers(first + 1, grid.count))
    whole, some = grid.columns(0, grid.count), grid.columns(first, last)
    lines = [np.linspace(0.1 * k, 0.7 + k, n) for k, n in enumerate(sizes)]
    for k, mesh in enumerate(np.meshgrid(*lines, indexing="ij")):
        assert np.array_equal(some[f"a{k}"], whole[f"a{k}"][first:last])
        assert np.allclose(whole[f"a{k}"], mesh.ravel(), rtol=4e-16, atol=1e-16)
        assert {whole[f"a{k}"][0], whole[f"a{k}"][-1]} == {0.1 * k, 0.7 + k}


@pytest.mark.parametrize("name", ["two_mass_chain", "elastic_pendulum"])
@pytest.mark.parametrize("method", ["taylor", "dop853", "rk8"])
def test_a_task_travels_as_text_and_is_compiled_from_the_same_c(name: str, method: str) -> None:
    times = np.array([0.0, 1 / 3, 1.0])
    sent = task_of(model_of(name), Method(method, 1e-3, 100), times)
    received = from_text(to_text(sent))
    source = SOURCES[method]
    assert source(received.held) == source(sent.held)
    assert received.method == sent.method and received.moving == sent.moving
    assert np.array_equal(received.times, times)


def test_a_task_of_another_version_is_refused() -> None:
    whole = json.loads(
        to_text(task_of(model_of("elastic_pendulum"), Method("rk4", 0.1, 9), np.arange(2.0)))
    )
    with pytest.raises(InputError, match="install the same version of mechanics everywhere"):
        from_text(json.dumps(whole | {"format": "mechanics ensemble 9"}))


def test_a_worker_without_a_compiler_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tasks, "find_compiler", lambda: None)
    with (
        ThreadPoolExecutor(1) as executor,
        pytest.raises(CompilerError, match="it has no C compiler"),
    ):
        ensemble(model_of("elastic_pendulum"), 1.0, executor=executor, method="rk4", step=0.123)


def test_what_is_no_executor_is_refused() -> None:
    for given_ in ({"executor": 2}, {"executor": ThreadPoolExecutor(1), "threads": 2}):
        with pytest.raises(InputError, match=r"give an Executor of concurrent\.futures"):
            ensemble(model_of("elastic_pendulum"), 1.0, **given_)  # type: ignore[arg-type]


@needs_compiler
@pytest.mark.campaign
@pytest.mark.parametrize("setting", [{"tolerance": 1e-9}, {"method": "dop853"}, STEPS], ids=str)
def test_any_executor_gives_the_bits_of_this_process(setting: dict[str, Any]) -> None:
    theta = np.linspace(2.4, 2.6, 1000)
    alone = ensemble(model_of("elastic_pendulum"), 2.0, initial={"theta": theta}, **setting)
    for kind in (ThreadPoolExecutor, ProcessPoolExecutor):
        with kind(2) as executor:
            found = ensemble(
                model_of("elastic_pendulum"), 2.0, initial={"theta": theta}, executor=executor,
                **setting,
            )  # fmt: skip
        assert np.array_equal(found.states, alone.states) and found.status == alone.status
        assert np.array_equal(found.steps, alone.steps) and found.method == alone.method
        assert np.array_equal(found.evaluations, alone.evaluations)


@needs_compiler
@pytest.mark.campaign
@pytest.mark.parametrize("name", ["four_bar", "rolling_disc", "quadrotor"])
def test_scenes_with_constraints_and_quaternions(name: str, tmp_path: Path) -> None:
    model = model_of(name)
    first = model.equations.scene.q[0].name
    value = float(model.equations.scene.example.get(first, 0.0))
    vary = {first: (value, value + 0.1, 9)}
    column = read_grid(vary).columns(0, 9)[first]
    expected = ensemble(model, 0.1, initial={first: column}, **STEPS).states[:, -1]
    write_ensemble(model, 0.1, tmp_path / "a", vary, part=4, **STEPS)
    rows = pq.read_table(tmp_path / "a" / "motions")
    entries = (*model.quantities.q, *model.quantities.u)
    assert np.array_equal(np.column_stack([rows[e.name] for e in entries]), expected)
