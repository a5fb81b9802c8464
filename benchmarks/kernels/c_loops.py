"""C functions called state by state from a loop in C: generated, by hand, and CasADi's own.

States stand one after the other: q, u and inputs of state i begin at i times their size.
"""

import ctypes

import casadi as ca
import numpy as np

from benchmarks.c_kernels import FOLDER
from benchmarks.kernels.case import Case, model
from benchmarks.kernels.race import Contender, Lap
from mechanics.compiled.c.source import function_source, signature
from mechanics.compiled.machine.library import find_compiler, load

FLAGS = "-O3 -march=native"

LOOP = """
void loop(long n, const double *q, const double *u, const double *f, const double *p, double *ud)
{{
    for (long i = 0; i < n; ++i)
        {name}(q + i * {n}, u + i * {n}, f + i, p, ud + i * {n});
}}
"""

CASADI_LOOP = """
void loop(long n, const double *q, const double *u, const double *f, const double *p, double *ud)
{{
    const double *arg[{args}];
    double *res[{results}], w[{work} + 1];
    long long int iw[{integers} + 1];
    for (long i = 0; i < n; ++i) {{
        arg[0] = q + i * {n};
        arg[1] = u + i * {n};
        arg[2] = f + i;
        arg[3] = p;
        res[0] = ud + i * {n};
        res[1] = 0;
        forward_dynamics(arg, res, iw, w, 0);
    }}
}}
"""


def no_compiler() -> str:
    """Why C cannot be compiled here."""
    return "" if find_compiler() else "no C compiler"


def generated(form: str = "auto", name: str = "generated C") -> Contender:
    """The function that `mechanics codegen` writes, without its status."""

    def source(case: Case) -> str:
        chain = model(case.links, form)
        code = chain.program("forward_dynamics")
        head = signature(code, name="chain")
        text = function_source(code, chain.entries, head=head)
        return "#include <math.h>\n" + text + LOOP.format(name="chain", n=case.links + 1)

    return Contender(name, no_compiler, lambda case: _lap(case, source(case)))


def by_hand() -> Contender:
    """benchmarks/kernels/cart_pole.c, for one link."""

    def source(case: Case) -> str:
        if case.links != 1:
            raise ValueError(f"cart_pole.c has one link, {case.links} asked for")
        text = (FOLDER / "cart_pole.c").read_text(encoding="utf-8")
        return text + LOOP.format(name="cart_pole", n=2)

    return Contender("C by hand", no_compiler, lambda case: _lap(case, source(case)))


def casadi(form: str = "auto", name: str = "CasADi's C") -> Contender:
    """What CasADi generates from the same graph."""

    def source(case: Case) -> str:
        function = model(case.links, form).casadi["forward_dynamics"]
        generator = ca.CodeGenerator("chain")
        generator.add(function)
        return generator.dump() + CASADI_LOOP.format(
            args=max(function.sz_arg(), 4), results=max(function.sz_res(), 2),
            work=function.sz_w(), integers=function.sz_iw(), n=case.links + 1,
        )  # fmt: skip

    return Contender(name, no_compiler, lambda case: _lap(case, source(case)))


def _lap(case: Case, source: str) -> Lap:
    library = load(source, str(find_compiler()), FLAGS)
    states = [np.ascontiguousarray(a.T) for a in (case.q, case.u, case.inputs)]
    accelerations = np.empty_like(states[0])
    # The result of a lap holds the arrays, so they live as long as what points at them.
    arrays = [*states, case.p, accelerations]
    arguments = [ctypes.c_long(case.count), *(ctypes.c_void_p(a.ctypes.data) for a in arrays)]

    def run() -> None:
        library.loop(*arguments)

    return Lap(run, case.count, lambda: arrays[-1].T)
