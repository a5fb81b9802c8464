"""Every compiled function of a model by name, over NumPy arrays: one state or a batch of them.

By machine code where a C compiler is found and by CasADi's virtual machine where none is.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sympy import Expr, Symbol

from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.calls.arguments import given_array, named_parameters
from mechanics.compiled.calls.many_states import MANY, look_at, run, shared, written
from mechanics.compiled.graphs import MATRICES, Graphs
from mechanics.compiled.jax_functions import JaxFunctions
from mechanics.compiled.machine.batch import BatchKernel
from mechanics.compiled.machine.buffer import Buffer
from mechanics.compiled.machine.direct import direct_calls
from mechanics.compiled.machine.evaluator import FLAGS, Kernel, evaluator
from mechanics.compiled.machine.native import LONG
from mechanics.compiled.programs.of_model import Programs
from mechanics.compiled.quantities import DIGITS, Quantities
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.program.routine import Routine

Array = NDArray[np.floating]


@dataclass(frozen=True, eq=False)
class Functions:
    """Compiled functions of one set of equations, by name.

    Arrays have shape (n,) for one state or (batch, n) for many; an array of one state is shared by
    the whole batch. `p` may also map names to values, the rest being typical; None takes the
    typical values of all parameters. Contiguous arrays of doubles are read where they are.

    Attributes
    ----------
    equations : Equations
    casadi : mapping of str to casadi.Function
        Every function as a CasADi graph with named inputs and outputs, built on first use.
    compiler : str or None
        Path of the C compiler; None for the virtual machine.
    programs : Programs
        What C is printed from.
    flags : str
        Settings of the C compiler.
    """

    equations: Equations
    casadi: Graphs
    compiler: str | None
    programs: Programs
    flags: str = FLAGS[0]
    _kernels: dict[tuple[str, type], Kernel] = field(default_factory=dict, repr=False)
    _batches: dict[tuple, BatchKernel] = field(default_factory=dict, repr=False)

    @property
    def quantities(self) -> Quantities:
        """Names, units and order of the entries of every array, and typical parameters."""
        return self.casadi.quantities

    @property
    def backend(self) -> str:
        """What evaluates the functions."""
        if self.compiler is None:
            return "CasADi virtual machine (no C compiler)"
        why_not = direct_calls(self.compiler).why_not
        by = f", single states by ctypes: {why_not}" if why_not else ""
        return f"C ({self.compiler} {self.flags}){by}"

    @property
    def form(self) -> str:
        """How forward dynamics is written: the name of one of `mechanics.compiled.FORMS`."""
        return self.casadi.form

    @property
    def fixed(self) -> dict[str, Expr]:
        """Exact values of the parameters that are fixed, by name; `p` does not hold these."""
        return {symbol.name: value for symbol, value in self.casadi.fixed.items()}

    def numbers(self, p: ArrayLike) -> dict[Symbol, float]:
        """Every parameter's value, the fixed ones included, where `p` are those of the rest."""
        given = zip((e.symbol for e in self.quantities.p), np.asarray(p, dtype=float), strict=True)
        known = {symbol: float(value.evalf(DIGITS)) for symbol, value in self.casadi.fixed.items()}
        return known | {symbol: float(value) for symbol, value in given}

    @property
    def typical(self) -> Array:
        """Typical parameters, in order; ValueMissingError names one that has none."""
        return np.array(self.quantities.typical, dtype=float)

    @property
    def jax(self) -> JaxFunctions:
        """Every function for JAX: ``model.jax["forward_dynamics"](q, u, inputs, p)["ud"]``."""
        return JaxFunctions(self.casadi, self.programs)

    def program(self, name: str) -> Routine:
        """Instructions of a function, or of a part of it; see `compiled.programs.of_model`."""
        return self.programs[name]

    @property
    def entries(self) -> dict[str, tuple[str, ...]]:
        """Names of the entries of every input."""
        return self.programs.entries

    def kernel(self, name: str, kind: type[np.floating] = np.float64) -> Kernel:
        """The evaluator of a function in a precision; C is compiled here, on first use."""
        if (name, kind) not in self._kernels:
            function = self.casadi[name] if name in tuple(self.casadi) else None
            code, names = self.program(name), self.programs.names(name)
            self._kernels[name, kind] = evaluator(
                function, code, names, kind, self.compiler, self.flags
            )
        return self._kernels[name, kind]

    def batch_kernel(
        self,
        name: str,
        kind: type[np.floating] = np.float64,
        shared: Sequence[str] = SHARED,
        checked: bool = False,
    ) -> BatchKernel | None:
        """The evaluator of many states at once, compiled for this machine on first use.

        None where there is no C compiler, or the function is so long that compiling it for speed
        takes minutes. Its `vectorised` tells what the compiler made of it.
        """
        code, key = self.program(name), (name, kind, tuple(shared), checked)
        if self.compiler is None or code.operations > LONG:
            return None
        if key not in self._batches:
            names = self.programs.names(name)
            self._batches[key] = BatchKernel(code, names, kind, self.compiler, shared, checked)
        return self._batches[key]

    def vectorised(
        self, name: str = "forward_dynamics", kind: type[np.floating] = np.float64
    ) -> str:
        """Whether many states are computed by vectors, in words, and why not."""
        kernel = self.batch_kernel(name, kind)
        if kernel is not None:
            return kernel.vectorised.sentence
        why = "there is no C compiler" if self.compiler is None else "the function is too long"
        return f"not vectorised: {why}: states are computed one by one"

    def evaluate(
        self,
        name: str,
        kind: type[np.floating] = np.float64,
        *,
        out: Mapping[str, Array] | None = None,
        threads: int = 1,
        **arrays: Any,
    ) -> dict[str, Array]:
        """Every output of a function.

        Parameters
        ----------
        name : str
            One of `casadi`.
        kind : numpy.float64 or numpy.float32
        out : mapping of str to array, optional
            Arrays that outputs are written to, by name.
        threads : int
            How many parts of a large batch are computed at a time.
        **arrays
            By name of the input.

        Raises
        ------
        InputError
            If an array is missing, unknown or has a wrong shape; it is named with both shapes.
        """
        given, count = self._given(name, kind, arrays)
        return self._evaluated(name, kind, given, count, out, threads)[0]

    def _given(
        self, name: str, kind: type[np.floating], arrays: Mapping[str, Any]
    ) -> tuple[dict[str, Array], int | None]:
        """The inputs as arrays, and the number of states; None for a single one."""
        named = self.programs.names(name)
        given = {g: self._array(g, names, kind, arrays) for g, names in named.items()}
        if unknown := set(arrays) - set(given):
            raise InputError(
                f"{name}: there is no input {', '.join(sorted(unknown))}: the inputs are"
                f" {', '.join(given)}"
            )
        counts = {group: len(a) for group, a in given.items() if a.ndim == 2}
        if len(set(counts.values())) > 1:
            sizes = ", ".join(f"{group} {count}" for group, count in counts.items())
            raise InputError(f"{name}: batches of different size: {sizes}: give one size to all")
        return given, next(iter(counts.values()), None)

    def _evaluated(
        self,
        name: str,
        kind: type[np.floating],
        given: Mapping[str, Array],
        count: int | None,
        out: Mapping[str, Array] | None = None,
        threads: int = 1,
        checked: bool = False,
    ) -> tuple[dict[str, Array], int]:
        """Every output, and what the batch kernel has met; with `checked`, it looks for more."""
        code, out, met = self.program(name), out or {}, 0
        look_at(code, out, count, kind, threads)
        many = self._many(name, kind, given, count, checked)
        if many is None or count is None:
            cells = [np.ascontiguousarray(np.atleast_2d(array)) for array in given.values()]
            results = self.kernel(name, kind)(cells, 1 if count is None else count)
        else:
            flat = {output: array for output, array in out.items() if output not in MATRICES}
            results, met = run(many, code, given, count, flat, threads)
        shaped = {}
        for (output, (rows, cols)), result in zip(code.shapes, results, strict=True):
            entries = result.reshape(len(result), cols, rows).swapaxes(1, 2)
            entries = entries if output in MATRICES else entries[:, :, 0]
            shaped[output] = entries[0] if count is None else entries
        return written(shaped, out), met

    def _many(
        self,
        name: str,
        kind: type[np.floating],
        given: Mapping[str, Array],
        count: int | None,
        checked: bool = False,
    ) -> BatchKernel | None:
        """The batch kernel, if so many states are worth it."""
        if count is None or count < MANY:
            return None
        return self.batch_kernel(name, kind, shared(given), checked)

    def _array(
        self, group: str, names: Sequence[str], kind: type[np.floating], arrays: Mapping[str, Any]
    ) -> Array:
        value = arrays.get(group)
        if group == "p" and (value is None or isinstance(value, Mapping)):
            value = named_parameters(names, value or {}, self.quantities, self.casadi.fixed)
        return given_array(group, names, kind, value)

    def buffer(self, name: str) -> Buffer:
        """A function bound to arrays of its own, parameters set to typical values where known."""
        code = self.program(name)
        inputs = {group: np.zeros(size) for group, size in code.inputs}
        flat = [np.zeros(rows * cols) for _, (rows, cols) in code.shapes]
        views = {
            out: array.reshape(cols, rows).T if out in MATRICES else array
            for (out, (rows, cols)), array in zip(code.shapes, flat, strict=True)
        }
        return Buffer(inputs, views, self.kernel(name).bound(list(inputs.values()), flat))
