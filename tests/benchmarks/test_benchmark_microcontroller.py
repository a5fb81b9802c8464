"""Single precision on a Cortex-M4F: it cross-compiles, tests itself in QEMU, and is measured."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from benchmarks import microcontroller
from benchmarks.microcontroller import Measured, measured, missing_tools, rows
from mechanics.cli.load import load
from mechanics.compiled import Model, compile
from mechanics.crosscheck import derive
from mechanics.errors import CompilerError

pytestmark = pytest.mark.campaign


@pytest.fixture(scope="module")
def cross_compiler() -> None:
    """Skips without the tools; in CI they have to be there."""
    if packages := missing_tools():
        words = f"install {' '.join(packages)}"
        if os.environ.get("MECHANICS_CI"):
            pytest.fail(words)
        pytest.skip(words)


@pytest.fixture(scope="module")
def model() -> Model:
    return compile(derive(load("elastic_pendulum").scene(), "free_body"), compiler=None)


@pytest.fixture(scope="module")
def found(cross_compiler, model: Model, tmp_path_factory) -> Measured:
    return measured(model, tmp_path_factory.mktemp("with a space"))


@pytest.fixture(scope="module")
def inline(cross_compiler, model: Model, tmp_path_factory) -> Measured:
    return measured(model, tmp_path_factory.mktemp("inline"), inline=True)


def test_the_self_test_passes_in_the_emulator(found: Measured, inline: Measured) -> None:
    assert found.selftest == inline.selftest == "kernel_single: 0 failures"


def test_inline_sines_call_nothing_and_are_smaller(found: Measured, inline: Measured) -> None:
    for own, library in zip(inline.functions, found.functions, strict=True):
        assert own.flash_with_calls == own.flash
        assert own.flash <= library.flash_with_calls and own.stack <= library.stack
        # A frame may hold room that no value came to.
        assert own.frame - 8 <= own.stack <= own.frame


def test_sizes_are_those_of_every_function(model: Model, found: Measured) -> None:
    names = [at.name for at in found.functions]
    assert names == [*model.casadi, "forward_dynamics_prepared"]
    sines = {at.name: at for at in found.functions}
    assert sines["forward_dynamics"].flash_with_calls > sines["forward_dynamics"].flash + 1000
    # No function of the library is called here.
    assert sines["coordinate_rates"].flash_with_calls == sines["coordinate_rates"].flash
    for at in found.functions:
        assert 0 < at.flash <= at.flash_with_calls < 2**14
        # A frame may hold room that no value came to; what is called comes on top.
        assert 0 <= at.stack < 2**10 and at.frame <= at.stack + 8
    assert sum("`forward_dynamics`" in row for row in rows("pendulum", found)) == 1


def test_a_changed_sign_fails_in_the_emulator(
    cross_compiler, model: Model, monkeypatch, tmp_path
) -> None:
    write = microcontroller.write_c

    def spoilt(*arguments, **named) -> None:
        write(*arguments, **named)
        path = tmp_path / "c" / "kernel_single.c"
        text = path.read_text(encoding="ascii")
        changed, count = re.subn(r"ud\[1\] = ", "ud[1] = -", text, count=1)
        assert count == 1
        path.write_text(changed, encoding="ascii")

    monkeypatch.setattr(microcontroller, "write_c", spoilt)
    with pytest.raises(CompilerError, match=r"forward_dynamics, state 0, entry 1: .* expected"):
        measured(model, tmp_path)


def test_an_exception_ends_the_emulation_as_a_failure(cross_compiler, tmp_path: Path) -> None:
    (tmp_path / "trap.c").write_text(
        "int main(void) { return *(volatile int *)0xFFFFFFF0u; }\n", encoding="ascii"
    )
    program = str(tmp_path / "trap")
    command = microcontroller.linker(tmp_path / "trap.c")
    subprocess.run([*command, "-o", program], check=True)
    done = subprocess.run([*microcontroller.emulator(), program], check=False, timeout=60)
    assert done.returncode != 0


def test_missing_tools_are_named(model: Model, monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(CompilerError, match="install gcc-arm-none-eabi libnewlib-arm-none-eabi q"):
        measured(model, tmp_path)
