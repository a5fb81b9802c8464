"""Equations as fast functions: ``compile(equations) -> Model``.

A model is data and calls. It takes and gives NumPy arrays, one state or a batch of them, by machine
code where a C compiler is found and by CasADi's virtual machine where none is.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sympy import Expr, Symbol

from mechanics.compiled.checked import checked
from mechanics.compiled.fixed import read_fixed, words
from mechanics.compiled.given import given_array
from mechanics.compiled.graphs import MATRICES, Graphs
from mechanics.compiled.machine.buffer import Buffer
from mechanics.compiled.machine.evaluator import FLAGS, Kernel, evaluator
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.program import Program
from mechanics.compiled.programs import Programs
from mechanics.compiled.quantities import DIGITS, Quantities
from mechanics.equations import Equations
from mechanics.errors import InputError

Array = NDArray[np.floating]


@dataclass(frozen=True, eq=False)
class Model:
    """Compiled functions of one set of equations.

    Arrays have shape (n,) for one state or (batch, n) for many; an array of one state is shared by
    the whole batch. `p` may also map names to values, the rest being typical; None takes the
    typical values of all parameters.

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

    @property
    def quantities(self) -> Quantities:
        """Names, units and order of the entries of every array, and typical parameters."""
        return self.casadi.quantities

    @property
    def backend(self) -> str:
        """What evaluates the functions."""
        if self.compiler is None:
            return "CasADi virtual machine (no C compiler)"
        return f"C ({self.compiler} {self.flags})"

    @property
    def form(self) -> str:
        """How forward dynamics is written: the name of one of `mechanics.compiled.FORMS`."""
        return self.casadi.form.name

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

    def program(self, name: str) -> Program:
        """Instructions of a function, or of a part of it; see `mechanics.compiled.programs`."""
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

    def evaluate(
        self, name: str, kind: type[np.floating] = np.float64, **arrays: Any
    ) -> dict[str, Array]:
        """Every output of a function.

        Parameters
        ----------
        name : str
            One of `casadi`.
        kind : numpy.float64 or numpy.float32
        **arrays
            By name of the input.

        Raises
        ------
        InputError
            If an array is missing, unknown or has a wrong shape; it is named with both shapes.
        """
        code = self.program(name)
        given = [
            self._array(g, names, kind, arrays) for g, names in self.programs.names(name).items()
        ]
        unknown = set(arrays) - {group for group, _ in code.inputs}
        if unknown:
            raise InputError(
                f"{name}: there is no input {', '.join(sorted(unknown))}: the inputs are"
                f" {', '.join(group for group, _ in code.inputs)}"
            )
        counts = {
            group: len(a) for (group, _), a in zip(code.inputs, given, strict=True) if a.ndim == 2
        }
        if len(set(counts.values())) > 1:
            sizes = ", ".join(f"{group} {count}" for group, count in counts.items())
            raise InputError(f"{name}: batches of different size: {sizes}: give one size to all")
        count = next(iter(counts.values()), 1)
        results = self.kernel(name, kind)([np.atleast_2d(a) for a in given], count)
        shaped = {}
        for (out, (rows, cols)), result in zip(code.shapes, results, strict=True):
            entries = result.reshape(count, cols, rows).swapaxes(1, 2)
            entries = entries if out in MATRICES else entries[:, :, 0]
            shaped[out] = entries if counts else entries[0]
        return shaped

    def _array(
        self, group: str, names: Sequence[str], kind: type[np.floating], arrays: Mapping[str, Any]
    ) -> Array:
        value = arrays.get(group)
        if group == "p" and (value is None or isinstance(value, Mapping)):
            value = self._parameters(value or {})
        return given_array(group, names, kind, value)

    def _parameters(self, given: Mapping[str, float]) -> Array:
        names = self.entries["p"]
        if unknown := set(given) - set(names):
            held = f", and fixed: {words(self.casadi.fixed)}" if self.fixed else ""
            raise InputError(
                f"there is no parameter {', '.join(sorted(unknown))}: the parameters are"
                f" {', '.join(names)}{held}"
            )
        if set(given) == set(names):
            return np.array([given[name] for name in names], dtype=float)
        values = dict(zip(names, self.typical, strict=True)) | dict(given)
        return np.array([values[name] for name in names], dtype=float)

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

    def forward_dynamics(
        self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None, check: bool = True
    ) -> Array:
        """u' from the state: (n,) or (batch, n).

        With `check`, a state at which a value is no number raises InputError, SingularError or
        RangeError, which name it; without, the array holds what the machine gives.
        """
        return self._solved(check, q=q, u=u, inputs=inputs, p=p)["ud"]

    def multipliers(
        self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None, check: bool = True
    ) -> Array:
        """Multipliers lambda, the reactions that maintain the constraints; as forward_dynamics."""
        return self._solved(check, q=q, u=u, inputs=inputs, p=p)["multipliers"]

    def _solved(self, check: bool, **arrays: Any) -> dict[str, Array]:
        if not check:
            return self.evaluate("forward_dynamics", **arrays)
        code = self.program("forward_dynamics")
        names = self.programs.names("forward_dynamics")
        given = {g: self._array(g, names[g], np.float64, arrays) for g, _ in code.inputs}
        return checked(self.equations.scene.name, code, self.entries, given, self.evaluate)

    def mass_matrix(
        self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> Array:
        """M of the route's rows: (rows, n) or (batch, rows, n)."""
        return self.evaluate("mass_matrix", q=q, u=u, inputs=inputs, p=p)["mass_matrix"]

    def forcing(self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None) -> Array:
        """Right side f of the route's rows: (rows,) or (batch, rows)."""
        return self.evaluate("forcing", q=q, u=u, inputs=inputs, p=p)["forcing"]

    def residual(
        self, q: ArrayLike, u: ArrayLike, ud: ArrayLike, multipliers: Any = None,
        *, inputs: Any = None, p: Any = None,
    ) -> Array:  # fmt: skip
        """[M u' - f - B lambda; A u' - b], in the units of the rows."""
        arrays = {"q": q, "u": u, "ud": ud, "multipliers": multipliers, "inputs": inputs, "p": p}
        return self.evaluate("residual", **arrays)["residual"]

    def inverse_dynamics(
        self, q: ArrayLike, u: ArrayLike, ud: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> Array:
        """Generalized forces, conjugate to u, which added to the loads give u'."""
        arrays = {"q": q, "u": u, "ud": ud, "inputs": inputs, "p": p}
        return self.evaluate("inverse_dynamics", **arrays)["forces"]

    def coordinate_rates(
        self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> Array:
        """q' = N u + n."""
        return self.evaluate("coordinate_rates", q=q, u=u, inputs=inputs, p=p)["qd"]

    def energy(
        self, q: ArrayLike, u: ArrayLike, *, inputs: Any = None, p: Any = None
    ) -> dict[str, Array]:
        """``kinetic``, ``potential`` and ``total`` energy, in J."""
        return {
            name: value[..., 0]
            for name, value in self.evaluate("energy", q=q, u=u, inputs=inputs, p=p).items()
        }


def compile(
    equations: Equations,
    *,
    compiler: str | None = "auto",
    flags: str = FLAGS[0],
    form: str = "auto",
    fixed: Mapping[str, Any] | None = None,
    outputs: Sequence[str] | None = None,
    reciprocals: bool = True,
) -> Model:
    """Compile equations of motion.

    Graphs and machine code are made when they are first used; what is not used is not derived.

    Parameters
    ----------
    equations : Equations
    compiler : str or None
        Path or name of a C compiler; ``"auto"`` looks for one ($CC, cc, gcc, clang); None uses
        CasADi's virtual machine.
    flags : str
        Settings of the compiler. ``"-O2"`` rounds every operation as it is written;
        ``"-O3 -march=native"`` does too, faster on this machine only; with ``-ffast-math`` sums are
        reordered, and NaN and infinity are no longer reported.
    form : str
        Of forward dynamics: the name of one of `mechanics.compiled.FORMS`; ``"auto"`` takes the one
        that suits the equations best.
    fixed : mapping of str to number, optional
        Parameters that are numbers from here on: ``{"g": 9.81, "c": 0}``. A float is the decimal
        that was typed, 981/100; a text may be a fraction. Terms with a zero factor are dropped.
    outputs : sequence of str, optional
        The functions to have, such as ``("forward_dynamics", "energy")``; by default all.
    reciprocals : bool
        Whether several quotients by one divisor are products with its reciprocal: fewer divisions,
        each product off by at most 1.5 units in the last place instead of 0.5.

    Raises
    ------
    InputError
        If there is no such form, parameter or output, the equations have no such form, or a value
        is no number, negative where it must not be, or a divisor that is zero.
    SingularError
        If the equations do not determine the accelerations at the fixed values.
    """
    found = find_compiler() if compiler == "auto" else compiler
    table = read_fixed(equations.scene, fixed or {})
    graphs = Graphs(equations, form, table, outputs)
    return Model(equations, graphs, found, Programs(graphs, reciprocals), flags)
