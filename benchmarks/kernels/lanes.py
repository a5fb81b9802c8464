"""Kernels over many states at once, structures of arrays: generated, by hand, and heyoka's."""

import ctypes
import importlib.util

import numpy as np

from benchmarks.c_kernels import FOLDER
from benchmarks.kernels.c_loops import no_compiler
from benchmarks.kernels.case import Case, model
from benchmarks.kernels.race import Contender, Lap
from mechanics.compiled.machine.batch import library_source
from mechanics.compiled.machine.library import find_compiler, load
from mechanics.compiled.machine.vectorised import settings
from mechanics.program import Builder, interpret
from mechanics.program.casadi_reader import read
from mechanics.simulate.integrators.heyoka import Expressions

PASSES = """
void passes(long n, {arguments})
{{
    for (long k = 0; k < n; ++k)
        {name}({names});
}}
"""
IN_CACHE = 100_000
"""States from which on a pass takes long enough by itself."""
ARRAYS = ("q", "u", "inputs", "p", "ud")
TOGETHER = 16
"""Passes in one call from Python, which takes about as long as a thousand states."""


def by_hand() -> Contender:
    """benchmarks/kernels/chain_lanes.c."""

    def prepare(case: Case) -> Lap:
        text = (FOLDER / "chain_lanes.c").read_text(encoding="utf-8")
        return _lap(case, text, f"chain_{case.links}_lanes")

    return Contender("lanes by hand", no_compiler, prepare)


def generated(form: str = "auto", name: str = "generated lanes") -> Contender:
    """The generated batch kernel, with its check of far angles."""

    def prepare(case: Case) -> Lap:
        chain = model(case.links, form)
        code = chain.program("forward_dynamics")
        text = library_source(code, chain.entries, np.float64)
        return _lap(case, text, "mechanics_forward_dynamics_states")

    return Contender(name, no_compiler, prepare)


def _lap(case: Case, text: str, function: str) -> Lap:
    compiler = str(find_compiler())
    arguments = "size_t count, size_t stride, " + ", ".join(
        f"{'' if name == 'ud' else 'const '}double *{name}" for name in ARRAYS
    )
    names = ", ".join(("count", "stride", *ARRAYS))
    passes = PASSES.format(arguments=arguments, name=function, names=names)
    library = load(text + passes, compiler, f"{settings(compiler)} -fopenmp-simd")
    found = np.empty_like(case.q)
    together = TOGETHER if case.count < IN_CACHE else 1
    count = ctypes.c_size_t(case.count)
    arrays = (case.q, case.u, case.inputs, case.p, found)
    given = [
        ctypes.c_long(together),
        count,
        count,
        *(ctypes.c_void_p(a.ctypes.data) for a in arrays),
    ]
    return Lap(lambda: library.passes(*given), case.count, lambda: found, together)


def heyoka(form: str = "elimination", constant: bool = False) -> Contender:
    """Heyoka's compiled function with fast_math.

    Its expressions are those of a form: L D L^T is what one would write down for it, ``"auto"`` is
    our own shortest text. Its parameters stand beside every state, as its calls want them; where
    they are `constant`, they are numbers in the code, which favours it.
    """

    def prepare(case: Case) -> Lap:
        import heyoka as hy

        builder = Builder()
        function = model(case.links, form).casadi["forward_dynamics"]
        groups = [
            [f"{function.name_in(i)}{k}" for k in range(function.numel_in(i))]
            for i in range(function.n_in())
        ]
        arguments = {
            function.name_in(i): [*map(builder.input, names)] for i, names in enumerate(groups)
        }
        program = builder.program({"ud": read(builder, function, arguments)["ud"]})
        rows = {
            f"{name}{k}": row
            for name, array in zip(("q", "u", "inputs"), (case.q, case.u, case.inputs), strict=True)
            for k, row in enumerate(array)
        }
        given = {name: hy.expression(name) for names in groups[:-1] for name in names}
        given |= {
            name: hy.expression(float(x)) if constant else hy.par[k]
            for k, (name, x) in enumerate(zip(groups[-1], case.p, strict=True))
        }
        written = [*interpret(program, Expressions(), given)["ud"]]
        used = sorted(set().union(*(hy.get_variables(e) for e in written)))
        function = hy.cfunc(written, vars=[hy.expression(name) for name in used], fast_math=True)
        states = np.ascontiguousarray([rows[name] for name in used])
        found = np.empty_like(case.q)
        more = {} if constant else {"pars": np.repeat(case.p[:, None], case.count, axis=1)}
        return Lap(lambda: function(states, outputs=found, **more), case.count, lambda: found)

    name = "heyoka, fast_math" + (", our text" if form == "auto" else "")
    name += ", parameters constant" if constant else ""
    return Contender(name, lambda: missing("heyoka"), prepare)


def missing(package: str) -> str:
    """Why an optional package is not here; empty if it is."""
    return "" if importlib.util.find_spec(package) else f"{package} is not installed"
