"""The right-hand side as a shared library with CasADi's calling convention, which counts calls.

``rate(y, inputs, p)`` and its Jacobian by y; nothing here is ever differentiated by the others, so
those blocks are left empty.
"""

import ctypes
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import casadi as ca

from mechanics.compiled.machine.native import affordable, load
from mechanics.compiled.model import Model

COUNTED = """
#undef {name}
long long {name}_calls = 0;
CASADI_SYMBOL_EXPORT int {name}(const casadi_real** arg, casadi_real** res, casadi_int* iw,
    casadi_real* w, int mem)
{{
    ++{name}_calls;
    return {name}_uncounted(arg, res, iw, w, mem);
}}
"""
NAMES = ("rate", "jac_rate")


@dataclass(frozen=True)
class Counters:
    """How often the two functions have been called.

    Attributes
    ----------
    cells : tuple
        The counters of the library; none on the virtual machine, which does not count.
    """

    cells: tuple[ctypes.c_longlong, ...] = ()

    @property
    def counted(self) -> bool:
        """Whether there are counters."""
        return bool(self.cells)

    def __call__(self) -> tuple[int, int]:
        """Calls of the right-hand side and of the Jacobian so far."""
        if not self.cells:
            return 0, 0
        return self.cells[0].value, self.cells[1].value


def external(model: Model) -> tuple[Callable[..., ca.MX], Counters]:
    """``rate(y, inputs, p)`` as a function that CasADi calls, and its counters."""
    known = model.right_hand_side.rate
    rate, slope = known.function, _jacobian(model)
    if model.compiler is None:
        return rate, Counters()
    flags = affordable(model.flags, known.routine.operations)
    library = load(_source(rate, slope), model.compiler, flags)
    cells = tuple(ctypes.c_longlong.in_dll(library, f"{name}_calls") for name in NAMES)
    return ca.external("rate", library._name), Counters(cells)


def _jacobian(model: Model) -> ca.Function:
    """The Jacobian by y with the names and arguments that CasADi looks for."""
    rate = model.right_hand_side.rate.function
    arguments = rate.sx_in()
    size = rate.numel_out(0)
    blocks = [model.right_hand_side.jacobian.function(*arguments)]
    blocks += [ca.SX(size, argument.numel()) for argument in arguments[1:]]
    # The Jacobian does not need the value: an empty column, or CasADi would compute it each time.
    known = ca.SX.sym("out_yd", ca.Sparsity(size, 1))
    names = [rate.name_in(i) for i in range(rate.n_in())]
    return ca.Function(
        "jac_rate",
        [*arguments, known],
        blocks,
        [*names, "out_yd"],
        [f"jac_yd_{name}" for name in names],
    )


def _source(*functions: ca.Function) -> str:
    generator = ca.CodeGenerator("rate.c", {"with_header": False})
    for function in functions:
        generator.add(function)
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        text = Path(generator.generate(f"{folder}/")).read_text(encoding="utf-8")
    renamed = "".join(f"#define {name} {name}_uncounted\n" for name in NAMES)
    return renamed + text + "".join(COUNTED.format(name=name) for name in NAMES)
