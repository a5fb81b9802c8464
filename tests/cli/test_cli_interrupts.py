"""A command that is asked to end, by Ctrl-C, `kill` or a closed terminal, leaves nothing.

The compiler is a stand-in that writes its own temporary file, starts a child, and never ends.
"""

import contextlib
import itertools
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from mechanics.cli.ensemble import goes_on
from mechanics.cli.interrupts import AGAIN, told_when_stopped
from mechanics.compiled.machine.process import run

COMPILER = """\
#!/bin/sh
case "$*" in *--version*) echo "gcc stand-in"; exit 0;; esac
case "$*" in *fsyntax-only*) exit 0;; esac
touch "${TMPDIR:-/tmp}/ccObject.o"
sleep 600 &
echo "$$ $!" > "$STARTED.$$"
mv "$STARTED.$$" "$STARTED"
wait
"""
SIGNALS = (
    "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler);"
    "[signal.signal(number, signal.SIG_DFL) for number in (signal.SIGTERM, signal.SIGHUP)];"
)
"""As in a terminal: tests that run in the background, or under `nohup`, hand on what is ignored."""
CLI = f"{SIGNALS}sys.argv[0] = 'mechanics'; from mechanics.cli import main; main()"
BUILD = (
    f"{SIGNALS}"
    "from mechanics.cli.interrupts import end_in_order; end_in_order();"
    "from mechanics.compiled.machine.library import build; build('int x;', sys.argv[1], ['-O2'])"
)
WHILE_IT_STARTS = f"""\
import os, signal, subprocess, time

class Popen(subprocess.Popen):
    def __init__(self, *given, **options):
        super().__init__(*given, **options)
        while not os.path.exists(os.environ["STARTED"]):
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGTERM)

subprocess.Popen = Popen
{BUILD}"""
"""The signal comes before the caller of `Popen` has the process that it started."""
ENDS = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}


@pytest.fixture
def interrupted(tmp_path: Path) -> Callable[..., int]:
    """Run Python until its compiler runs, send a signal, and return the exit code."""
    compiler, started = tmp_path / "gcc", tmp_path / "started"
    compiler.write_text(COMPILER, encoding="utf-8")
    compiler.chmod(0o755)
    own = tmp_path / "own"
    own.mkdir()

    def call(number: signal.Signals, code: str, *arguments: object) -> int:
        given = {"CC": str(compiler), "TMPDIR": str(own), "STARTED": str(started)}
        process = subprocess.Popen(
            [sys.executable, "-c", code, *map(str, arguments or [compiler])],
            env={**os.environ, **given, "PATH": f"{tmp_path}:{os.environ['PATH']}"},
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        while not started.exists() and process.poll() is None:
            time.sleep(0.01)
        process.send_signal(number)
        _, remarks = process.communicate(timeout=60)
        assert started.exists(), remarks
        assert list(own.iterdir()) == []
        children = [int(word) for word in started.read_text(encoding="utf-8").split()]
        # A killed process of a killed parent is gone when the kernel comes to it.
        end = time.monotonic() + 20
        while any(_runs(child) for child in children) and time.monotonic() < end:
            time.sleep(0.01)
        assert not any(_runs(child) for child in children)
        return process.returncode

    return call


def _runs(process: int) -> bool:
    """Whether a process is there; one that is dead and not yet waited for is not."""
    try:
        status = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except OSError:
        return False
    return status.rpartition(")")[2].split()[0] != "Z"


CAMPAIGN = [pytest.param(n, marks=pytest.mark.campaign) for n in (signal.SIGINT, signal.SIGHUP)]


@pytest.mark.campaign
@pytest.mark.parametrize("number", [signal.SIGTERM, *CAMPAIGN])
def test_a_compiler_ends_with_the_process_and_leaves_nothing(
    interrupted: Callable[..., int], number: signal.Signals
) -> None:
    """Ctrl-C in a program of one's own is Python's KeyboardInterrupt, which exits by the signal."""
    code = interrupted(number, BUILD)
    assert code == (-signal.SIGINT if number is signal.SIGINT else ENDS[number])


def test_a_compiler_that_is_just_started_ends_with_the_process(
    interrupted: Callable[..., int],
) -> None:
    assert interrupted(signal.SIGTERM, WHILE_IT_STARTS) == ENDS[signal.SIGTERM]


@pytest.mark.parametrize("call", range(2 * len(ENDS)))
def test_what_handles_signals_is_there_again_when_a_signal_comes_between(
    call: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While handlers are exchanged, one of those that were there may raise."""
    monkeypatch.setattr(signal, "signal", _raising(signal.signal, call))
    before = {n: signal.signal(n, lambda *_: None) for n in (signal.SIGTERM, signal.SIGHUP)}
    own = {n: signal.getsignal(n) for n in ENDS}
    try:
        with contextlib.suppress(KeyboardInterrupt):
            run([sys.executable, "-c", ""], tmp_path)
        assert {n: signal.getsignal(n) for n in ENDS} == own
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _raising(change: Callable[..., object], call: int) -> Callable[..., object]:
    """`signal.signal`, of which one call raises, after those that prepare the test."""
    calls = itertools.count(-2)

    def changed(number: int, handler: object) -> object:
        if next(calls) == call:
            raise KeyboardInterrupt
        return change(number, handler)

    return changed


@pytest.mark.campaign
@pytest.mark.parametrize("number", ENDS)
@pytest.mark.parametrize(
    "command", ["codegen", "fmu", "simulate", pytest.param("verify", marks=pytest.mark.long)]
)
def test_an_interrupted_command_leaves_nothing(
    interrupted: Callable[..., int], tmp_path: Path, command: str, number: signal.Signals
) -> None:
    """Neither where it was asked to write, nor in the folder for temporary files."""
    written = tmp_path / "written"
    arguments = {
        "codegen": ["rod_pendulum", "-o", written],
        "fmu": ["rod_pendulum", "-o", written.with_suffix(".fmu")],
        "simulate": ["rod_pendulum", "--out", written.with_suffix(".csv")],
        "verify": [tmp_path / "folder"],
    }[command]
    if command == "verify":
        codegen = ["codegen", "rod_pendulum", "-o", str(arguments[0])]
        subprocess.run([sys.executable, "-c", CLI, *codegen], check=True)
    before = sorted(tmp_path.iterdir())
    assert interrupted(number, CLI, command, *arguments) == ENDS[number]
    after = [entry for entry in sorted(tmp_path.iterdir()) if not entry.name.startswith("started")]
    assert after == before


def test_a_signal_that_is_ignored_stays_ignored() -> None:
    """As SIGHUP is under `nohup`."""
    code = (
        "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN);"
        "from mechanics.cli.interrupts import end_in_order; end_in_order();"
        "print(signal.getsignal(signal.SIGHUP) is signal.SIG_IGN);"
        "print(signal.getsignal(signal.SIGTERM) is signal.SIG_DFL)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["True", "False"]


@pytest.mark.parametrize("stop", [KeyboardInterrupt(), SystemExit(143), SystemExit(129)])
def test_a_command_that_is_stopped_says_how_to_go_on(
    stop: BaseException, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "motions").mkdir()
    (tmp_path / "motions" / "part-000000000.parquet").touch()
    with pytest.raises(type(stop)), told_when_stopped():
        raise stop
    assert capsys.readouterr().err == f"stopped: {AGAIN}\n"
    with pytest.raises(type(stop)), told_when_stopped(), goes_on(tmp_path):
        raise stop
    words = f"stopped: 1 files are in {tmp_path / 'motions'}; the same command goes on from there\n"
    assert capsys.readouterr().err == words


def test_a_command_that_ends_by_itself_was_not_stopped(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit), told_when_stopped():
        raise SystemExit(3)
    assert capsys.readouterr().err == ""
