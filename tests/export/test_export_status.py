"""Every generated function says whether its values are numbers, and if not, why."""

import ctypes
import functools
import math
import subprocess
from pathlib import Path

import numpy as np
import pytest

from mechanics.compiled import Model
from mechanics.compiled.c.status import watched
from mechanics.export import write_c as write_and_prove

pytestmark = pytest.mark.campaign

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

OK, SINGULAR, OVERFLOW, BAD_INPUT = range(4)
SYSTEMS = [("elastic_pendulum", "free_body"), ("rocker", "kane"), ("two_mass_chain", "lagrange")]
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-O2", "-fPIC", "-shared"]


BUILT: dict[tuple, "Library"] = {}


class Library:
    """A folder of C as functions of arrays by name; each returns its status."""

    def __init__(self, model: Model, folder: Path, compiler: str) -> None:
        self.model = model
        write_c(model, folder, name="system")
        target = folder / "system.so"
        command = [compiler, *STRICT, str(folder / "system.c"), "-o", str(target), "-lm"]
        assert subprocess.run(command, check=False).returncode == 0
        self._library = ctypes.CDLL(str(target))

    def __call__(self, name: str, **given: np.ndarray) -> tuple[int, list[np.ndarray]]:
        code = self.model.program(name)
        arrays = [np.array(given[group], dtype=float) for group, size in code.inputs if size]
        outs = [np.zeros(rows * cols) for _, (rows, cols) in code.shapes if rows * cols]
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arrays, *outs)]
        return getattr(self._library, f"system_{name}")(*pointers), outs


@pytest.fixture(params=SYSTEMS, ids=lambda pair: pair[0])
def library(request, modelled, compiler, tmp_path_factory) -> Library:
    key = (request.param, compiler)
    if key not in BUILT:
        BUILT[key] = Library(modelled(*request.param), tmp_path_factory.mktemp("c"), compiler)
    return BUILT[key]


def ordinary(model: Model) -> dict[str, np.ndarray]:
    known = model.quantities
    return {
        "q": np.full(len(known.q), 0.4),
        "u": np.full(len(known.u), 0.3),
        "inputs": np.full(len(known.inputs), 0.2),
        "p": np.array(known.typical),
        "ud": np.full(len(known.ud), 0.7),
        "multipliers": np.full(len(known.multipliers), 0.6),
        "h": np.array([1e-3]),
    }


def test_numbers_are_ok_and_the_same_as_in_python(library: Library) -> None:
    given = ordinary(library.model)
    for name in library.model.casadi:
        status, outs = library(name, **given)
        assert status == OK, name
        groups = {group for group, _ in library.model.program(name).inputs}
        found = library.model.evaluate(name, **{g: given[g] for g in groups})
        expected = [value.T.ravel() for value in found.values() if value.size]
        for mine, theirs in zip(outs, expected, strict=True):
            assert np.allclose(mine, theirs, rtol=1e-12, atol=1e-300)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_bad_input(library: Library, bad: float) -> None:
    given = ordinary(library.model)
    names = library.model.entries["p"]
    hit = 0
    for i in range(len(names)):
        values = given["p"].copy()
        values[i] = bad
        status, outs = library("forward_dynamics", **(given | {"p": values}))
        assert status in (OK, BAD_INPUT)
        # An infinity that a division hides is told all the same; a mass that does not occur is not.
        hit += status == BAD_INPUT
        if status == OK:
            assert np.isfinite(np.concatenate(outs)).all()
    assert hit >= len(names) - 1


def test_too_large_is_overflow_and_nothing_to_divide_by_is_singular(library: Library) -> None:
    given = ordinary(library.model)
    large = given | {"p": np.full(len(given["p"]), 1e300), "u": given["u"] * 1e10}
    status, outs = library("energy", **large)
    assert status == OVERFLOW and not np.isfinite(np.concatenate(outs)).all()
    none = given | {"p": np.zeros(len(given["p"]))}
    assert library("forward_dynamics", **none)[0] == SINGULAR


def test_an_infinity_that_a_quotient_hides_is_told(modelled, compiler, tmp_path: Path) -> None:
    """m = inf gives x'' = 0, which is a number: the divisor tells."""
    model = modelled("elastic_pendulum", "kane")
    library = Library(model, tmp_path / "c", compiler)
    given = ordinary(model)
    values = given["p"].copy()
    values[model.entries["p"].index("M")] = values[model.entries["p"].index("m")] = 1.5e308
    status, outs = library("forward_dynamics", **(given | {"p": values, "q": np.zeros(2)}))
    assert status == OVERFLOW, outs
    assert watched(model.program("forward_dynamics")).divisors


CARELESS = ["-ffast-math", "-Ofast", "-ffinite-math-only"]


@pytest.mark.parametrize("flag", CARELESS)
def test_compilers_that_take_infinities_for_impossible_are_refused(
    modelled, compiler, tmp_path: Path, flag: str
) -> None:
    write_c(modelled("elastic_pendulum", "kane"), tmp_path, name="system")
    for file in ("system.c", "system_batch.c"):
        command = [
            compiler,
            "-std=c99",
            flag,
            "-c",
            str(tmp_path / file),
            "-o",
            str(tmp_path / "o"),
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode != 0 and "SYSTEM_ALLOW_FAST_MATH allows it" in done.stderr
        done = subprocess.run([*command, "-DSYSTEM_ALLOW_FAST_MATH"], check=False)
        assert done.returncode == 0
