"""Kernels over many states at once, structures of arrays: generated, by hand, and heyoka's."""

import ctypes
import importlib.util

import numpy as np

from benchmarks.c_kernels import FOLDER
from benchmarks.kernels.c_loops import no_compiler
from benchmarks.kernels.case import Case
from benchmarks.kernels.race import Contender, Lap
from mechanics.compiled.machine.native import find_compiler, load
from mechanics.simulate.integrators.heyoka import expressions

FLAGS = "-O3 -march=native -fopenmp-simd"
WIDE = "-mprefer-vector-width=512"
"""Gcc otherwise takes half of the widest registers; clang has the same setting."""
BY_HAND = (1, 5)


def by_hand() -> Contender:
    """benchmarks/kernels/chain_lanes.c."""

    def prepare(case: Case) -> Lap:
        text = (FOLDER / "chain_lanes.c").read_text(encoding="utf-8")
        library = load(text, str(find_compiler()), f"{FLAGS} {WIDE}")
        function = library[f"chain_{case.links}_lanes"]
        found = np.empty_like(case.q)
        arrays = (case.q, case.u, case.inputs, case.p, found)
        count = ctypes.c_size_t(case.count)
        arguments = [count, count, *(ctypes.c_void_p(a.ctypes.data) for a in arrays)]
        return Lap(lambda: function(*arguments), case.count, lambda: found)

    return Contender("lanes by hand", no_compiler, prepare)


def heyoka(constant: bool = False) -> Contender:
    """Heyoka's compiled function with fast_math.

    Its parameters stand beside every state, as its calls want them; where they are `constant`, they
    are numbers in the code, which favours it.
    """

    def prepare(case: Case) -> Lap:
        import heyoka as hy

        code = case.model.program("forward_dynamics")
        rows = {
            f"{name}{k}": row
            for name, array in zip(("q", "u", "inputs"), (case.q, case.u, case.inputs), strict=True)
            for k, row in enumerate(array)
        }
        given = [[hy.expression(f"{name}{k}") for k in range(size)] for name, size in code.inputs]
        numbers = enumerate(case.p)
        given[-1] = [hy.expression(float(x)) if constant else hy.par[k] for k, x in numbers]
        written = expressions(code, given)[0]
        used = sorted(set().union(*(hy.get_variables(e) for e in written)))
        function = hy.cfunc(written, vars=[hy.expression(name) for name in used], fast_math=True)
        states = np.ascontiguousarray([rows[name] for name in used])
        found = np.empty_like(case.q)
        more = {} if constant else {"pars": np.repeat(case.p[:, None], case.count, axis=1)}
        return Lap(lambda: function(states, outputs=found, **more), case.count, lambda: found)

    name = "heyoka, fast_math, parameters constant" if constant else "heyoka, fast_math"
    return Contender(name, lambda: missing("heyoka"), prepare)


def missing(package: str) -> str:
    """Why an optional package is not here; empty if it is."""
    return "" if importlib.util.find_spec(package) else f"{package} is not installed"
