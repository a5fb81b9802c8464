"""What a function of many states returns is about values, not about what the inline sine made."""

import ctypes
import subprocess
from pathlib import Path

import numpy as np
from particles import pendulum

from mechanics import compile, derive, write_c

FINE, FAR, NOT_FINITE = 0, 1, 2


def test_angles_beyond_the_inline_sine(tmp_path: Path, compiler: str) -> None:
    folder = tmp_path / "c"
    # Its evidence holds the status that is specified, and what the binary returns.
    write_c(
        compile(derive(pendulum("", ""), "kane")),
        folder,
        name="system",
        functions=["forward_dynamics"],
    )
    target = folder / "system.so"
    files = [str(folder / "system.c"), str(folder / "system_batch.c")]
    command = [compiler, "-O2", "-fPIC", "-shared", *files, "-o", str(target), "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    call = ctypes.CDLL(str(target)).system_forward_dynamics_batch

    def status(angles: list[float], g: float) -> int:
        q, u = np.array(angles), np.zeros(len(angles))
        p, ud = np.array([1.0, g]), np.empty(len(angles))
        size = ctypes.c_size_t(len(angles))
        found = call(size, size, *(ctypes.c_void_p(a.ctypes.data) for a in (q, u, p, ud)))
        if np.isfinite(g):
            np.testing.assert_allclose(ud, -g * np.sin(q), rtol=1e-14)
        return found

    assert status([0.5, 2.0], 9.8) == FINE
    assert status([0.5, 1e300], 9.8) == FAR
    assert status([1e9] * 300, 9.8) == FAR
    assert status([0.5], np.inf) == NOT_FINITE
    assert status([1e300], np.inf) == FAR + NOT_FINITE
