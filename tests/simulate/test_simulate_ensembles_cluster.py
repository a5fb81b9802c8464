"""A real scheduler and its workers: one of them is killed, nothing is lost, nothing is twice."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from mechanics.cluster import workers
from mechanics.compiled import compile
from mechanics.compiled.machine.native import find_compiler
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.simulate import ensemble, write_ensemble
from mechanics.simulate.ensembles.grid import read_grid
from systems import elastic_pendulum

pytestmark = [
    pytest.mark.campaign,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler here"),
]
MOTIONS, PART, DURATION = 20_000, 500, 5.0
VARY = {"theta": (0.1, 3.0, MOTIONS)}


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """Address of a scheduler, and its two workers, as the documentation starts them."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    dask = [sys.executable, "-m", "dask"]
    commands = [
        [*dask, "scheduler", "--host", address, "--no-dashboard"],
        *2 * [[*dask, "worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
               "--local-directory", str(tmp_path)]],
    ]  # fmt: skip
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    running = [subprocess.Popen(command, **quiet) for command in commands]  # type: ignore[call-overload]
    try:
        _wait_for_two(address)
        yield address, running[1:]
    finally:
        for process in running:
            process.kill()
            process.wait()


def _wait_for_two(address: str) -> None:
    import distributed

    with distributed.Client(address, timeout=60, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=60)


def test_a_killed_worker_costs_its_part_once(
    cluster: tuple[str, list[subprocess.Popen[bytes]]], tmp_path: Path
) -> None:
    address, (victim, _) = cluster
    model = compile(derive(elastic_pendulum.scene(), "kane"))
    shares: list[float] = []

    def kill(share: float) -> None:
        shares.append(share)
        if share > 0.3 and victim.poll() is None:
            victim.send_signal(signal.SIGKILL)
            victim.wait()

    with workers(address) as team:
        assert team.size() == 2
        found = write_ensemble(
            model, DURATION, tmp_path / "a", VARY, part=PART, executor=team.executor,
            workers=team.size, progress=kill,
        )  # fmt: skip
        assert team.size() == 1
        runs = _runs(address)
    assert victim.returncode == -signal.SIGKILL
    rows = pq.read_table(tmp_path / "a" / "motions")
    assert rows["motion"].to_pylist() == list(range(MOTIONS))
    assert found.endings == {"finished": MOTIONS} and len(shares) == MOTIONS // PART
    column = read_grid(VARY).columns(0, MOTIONS)["theta"]
    entries = (*model.quantities.q, *model.quantities.u)
    alone = ensemble(model, DURATION, initial={"theta": column}).states[:, -1]
    assert np.array_equal(np.column_stack([rows[e.name] for e in entries]), alone)
    # What the killed worker had under way, or had not handed over, was begun again; no more.
    assert MOTIONS // PART <= runs <= MOTIONS // PART + 4


def _runs(address: str) -> int:
    """How often a part was finished."""
    import distributed

    def finished(dask_scheduler: object) -> int:
        log = dask_scheduler.transition_log  # type: ignore[attr-defined]
        return sum(one.start == "processing" and one.finish == "memory" for one in log)

    with distributed.Client(address, set_as_default=False) as client:
        return int(client.run_on_scheduler(finished))


def test_processes_of_this_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two workers, and one compilation."""
    log, wrapper = tmp_path / "log", tmp_path / "cc"
    wrapper.write_text(f'#!/bin/sh\ncase "$*" in *" -c "*) echo "$$" >>{log};; esac\n'
                       f'exec {find_compiler()} "$@"\n')  # fmt: skip
    wrapper.chmod(0o755)
    model = compile(derive(elastic_pendulum.scene(), "kane"))
    monkeypatch.setenv("CC", str(wrapper))
    with workers(processes=2) as team:
        assert team.size() == 2
        write_ensemble(model, 1.0, tmp_path / "a", VARY, part=PART, executor=team.executor,
                       workers=team.size, method="rk4", step=0.1)  # fmt: skip
        pids = {team.executor.submit(os.getpid).result() for _ in range(8)}
    assert log.read_text().count("\n") == 1 and os.getpid() not in pids
    rows = pq.read_table(tmp_path / "a" / "motions")
    assert rows["motion"].to_pylist() == list(range(MOTIONS))


def test_a_scheduler_that_is_not_there_is_named() -> None:
    started = time.monotonic()
    for address in ("tcp://127.0.0.1:1", "nonsense://x"):
        with pytest.raises(InputError, match=r"no scheduler answers there .*dask scheduler"):
            workers(address).__enter__()
    assert time.monotonic() - started < 300
    with pytest.raises(InputError, match="give one of them"):
        workers().__enter__()
    with pytest.raises(InputError, match="at least 1 is needed"):
        workers(processes=0).__enter__()


def test_a_scheduler_that_goes_away_is_told(
    cluster: tuple[str, list[subprocess.Popen[bytes]]], tmp_path: Path
) -> None:
    """What is written stays, and the run can be gone on with."""
    import distributed

    address, _ = cluster
    model = compile(derive(elastic_pendulum.scene(), "kane"))

    def end(share: float) -> None:
        if share > 0.3 and not ended:
            ended.append(share)
            with distributed.Client(address, set_as_default=False) as client:
                client.shutdown()

    ended: list[float] = []
    with (
        pytest.raises(InputError, match="its scheduler went away"),
        workers(address) as team,
    ):
        write_ensemble(
            model, DURATION, tmp_path / "a", VARY, part=PART, executor=team.executor,
            workers=team.size, progress=end,
        )  # fmt: skip
    found = write_ensemble(model, DURATION, tmp_path / "a", VARY)
    assert 0.3 * MOTIONS < found.before < MOTIONS and found.endings == {"finished": MOTIONS}
