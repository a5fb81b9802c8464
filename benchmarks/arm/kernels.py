"""The kernels, compiled with the same flags: our C, CasADi's C of the same program, Pinocchio."""

import ctypes
import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from statistics import median
from time import process_time

import casadi
import numpy as np

from benchmarks.arm.programs import Q, U, joints, numbers
from benchmarks.kernels.race import SHORTEST
from benchmarks.kernels.robots import BOOST, EIGEN, address, built
from mechanics.compiled.c.source import function_source
from mechanics.program import Program
from mechanics.program.casadi_printer import print_function
from mechanics.program.casadi_reader import read_routine

FLAGS = ("-O3", "-march=native")
HERE = Path(__file__).parent
INVOKE = "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"
"""Boost's calls take too few arguments for Pinocchio's visitors otherwise."""

Array = np.ndarray
Run = Callable[[Array, Array, Array, Array], None]
"""From q, u and what is given, a row a state, to what is found."""

LOOP = """
void loop(long count, const double *q, const double *u, const double *given, double *found)
{
    for (long i = 0; i < count; ++i) {
        %s
    }
}
"""


def printed(program: Program, given: Sequence[str]) -> Run:
    """Our own text, as exports print it."""
    arrays = {"q": list(Q), "u": list(U), "given": list(given)}
    call = "kernel(q + 7 * i, u + 7 * i, given + 7 * i, found + 7 * i);"
    routine = read_routine(print_function(program, "kernel", arrays))
    return looping("#include <math.h>\n" + function_source(routine, arrays), call)


def by_casadi(program: Program, given: Sequence[str]) -> Run:
    """What CasADi generates for the same program."""
    arrays = {"q": list(Q), "u": list(U), "given": list(given)}
    function = print_function(program, "kernel", arrays)
    size = function.sz_w()
    call = (
        f"const double *arg[{function.sz_arg()}] = {{q + 7 * i, u + 7 * i, given + 7 * i}};\n"
        f"        double *res[{function.sz_res()}] = {{found + 7 * i}}, w[{max(size, 1)}];\n"
        "        kernel(arg, res, 0, w, 0);"
    )
    generator = casadi.CodeGenerator("kernel.c", {"with_export": False})
    generator.add(function)
    return looping(generator.dump(), call)


def looping(text: str, call: str, folder: Path = HERE) -> Run:
    """C text with a loop around a call; it may include what stands in a folder."""
    library = _built("gcc", "kernel.c", text + LOOP % call, [f"-I{folder}"], ["-lm"])

    def run(q: Array, u: Array, given: Array, found: Array) -> None:
        library.loop(ctypes.c_long(len(q)), *map(address, (q, u, given, found)))

    return run


def table() -> Array:
    """The arm of `programs`, a row a joint, as `by_pinocchio` takes it."""
    values = numbers()
    names = ("m", "cx", "cy", "cz", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Izx")
    return np.array([
        [1, 0, 0, 0, c, -s, 0, s, c, *place, *(float(values[f"{name}{i}"]) for name in names)]
        for i, (c, s, *place) in enumerate(joints(), start=1)
    ])  # fmt: skip


@cache
def _pinocchio() -> ctypes.CDLL:
    import pinocchio

    prefix = Path(pinocchio.__file__).parents[4]
    text = (HERE / "pinocchio_arm.cpp").read_text(encoding="ascii")
    words = ["-std=c++17", "-DNDEBUG", *BOOST, INVOKE, f"-I{prefix}/include", f"-I{EIGEN}"]
    library = _built("g++", "arm.cpp", text, words, [])
    library.arm_new.restype = ctypes.c_void_p
    return library


def by_pinocchio(algorithm: str, rows: Array, gravity: float) -> Run:
    """``"rnea"`` or ``"aba"``, from its headers, compiled with the same flags.

    Parameters
    ----------
    rows : array, shape (n, 22)
        Of each joint, which turns about z: the turn before it row by row, its place, mass, mass
        centre, and inertia xx, yy, zz, xy, yz, zx.
    gravity : float
        Downwards along z.
    """
    library = _pinocchio()
    arm = ctypes.c_void_p(library.arm_new(len(rows), ctypes.c_double(gravity), address(rows)))
    function = getattr(library, algorithm)

    def run(q: Array, u: Array, given: Array, found: Array) -> None:
        function(arm, ctypes.c_long(len(q)), *map(address, (q, u, given, found)))

    return run


def _built(
    compiler: str, name: str, text: str, before: Sequence[str], after: Sequence[str]
) -> ctypes.CDLL:
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        source = Path(folder) / name
        source.write_text(text, encoding="ascii")
        return built(compiler, source, [*FLAGS, *before], after)


def timed(
    kernels: Mapping[str, Run], q: Array, u: Array, given: Array, rounds: int
) -> tuple[dict[str, Array], dict[str, float]]:
    """What each kernel finds, a row a state, and its ns a state: medians, in turn."""
    found = {name: np.empty_like(q) for name in kernels}
    times: dict[str, list[float]] = {name: [] for name in kernels}
    for _ in range(rounds):
        for name, run in kernels.items():
            passes, start = 0, process_time()
            while (spent := process_time() - start) < SHORTEST:
                run(q, u, given, found[name])
                passes += 1
            times[name].append(spent / passes / len(q) * 1e9)
    return found, {name: median(own) for name, own in times.items()}
