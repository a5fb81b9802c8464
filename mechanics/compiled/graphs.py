"""The functions of a model as CasADi graphs, from equations that are written out or programs.

What each computes is in `mechanics.compiled.textbook` and `mechanics.compiled.outputs`.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from math import inf
from typing import Any

import casadi as ca

from mechanics.compiled.arrays import arrays_of
from mechanics.compiled.constant_folding import CONSTANTS, Exact, at, folded
from mechanics.compiled.fixed import Fixed
from mechanics.compiled.forms import FORMS
from mechanics.compiled.programs.common_denominators import gathered
from mechanics.compiled.programs.reciprocals import with_reciprocals
from mechanics.compiled.quantities import STATE, Quantities, mechanism_of, quantities
from mechanics.compiled.reduced import Reduced
from mechanics.compiled.source import Source, graphs_of, with_fixed
from mechanics.compiled.step import RK4, runge_kutta
from mechanics.compiled.textbook import dense_function
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError
from mechanics.kinematics.outputs import SLOPE, output_functions
from mechanics.program.casadi_printer import nearest
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import Routine
from mechanics.scene.actions import frictions
from mechanics.scene.rates import TIME

MATRICES = frozenset({"mass_matrix", "rotation", SLOPE, *(f"ud_{group}" for group in STATE)})
"""Outputs that are matrices, whatever their size; the others are columns."""

Inputs = dict[str, tuple[str, ...]]
"""By name of a function: its inputs beside the state."""


class Graphs(Mapping[str, ca.Function]):
    """CasADi functions by name; each is built when it is first asked for.

    Inputs are named ``q``, ``u``, ``inputs``, ``p`` (and ``ud``, ``multipliers``), dense columns.

    Parameters
    ----------
    form : str
        Of forward dynamics, one of `mechanics.compiled.FORMS`, or ``"auto"``.
    fixed : mapping of Symbol to Expr
        Exact values of parameters that are fixed.
    outputs : sequence of str, optional
        The functions to have; by default all.
    reduced : Reduced, optional
        Functions in the place of those of the equations, and which ones there are.

    Attributes
    ----------
    derived : Equations
        As they were given.
    quantities : Quantities
        Of all arrays.
    source : Source
        What makes the graphs of outputs.
    """

    def __init__(
        self,
        equations: Equations,
        form: str = "auto",
        fixed: Fixed | None = None,
        outputs: Sequence[str] | None = None,
        reduced: Reduced | None = None,
    ) -> None:
        self.derived, self.fixed, self.reduced = equations, dict(fixed or {}), reduced
        self._asked = outputs is not None
        every = function_inputs(equations) if reduced is None else dict(reduced.inputs)
        self._inputs = every if outputs is None else self._chosen(every, outputs)
        self._built: dict[str, ca.Function] = {}
        self._exact: dict[str, Exact] = {}
        self._found: dict[str, tuple[str, dict[str, ca.SX]]] = {}
        self._named = form
        put = with_fixed(equations, self.fixed, form)
        self.quantities: Quantities = quantities(put, self.fixed, "reactions" in self._inputs)
        self._arrays = arrays_of(self.quantities)
        self._columns = self._arrays.columns
        self.source = Source(put, self.fixed, form, self._arrays)

    @property
    def equations(self) -> Equations:
        """With the fixed values, where they are written out."""
        return self.source.equations

    def __getitem__(self, name: str) -> ca.Function:
        if name not in self._built:
            function, constants = self.exact(name)
            inputs = self._parts(name)[0]
            doubles = ca.DM([nearest(constant) for constant in constants])
            graphs = function.call([*inputs.values(), ca.SX(doubles)])
            self._built[name] = dense_function(
                name, inputs, dict(zip(function.name_out(), graphs, strict=True))
            )
        return self._built[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._inputs)

    def __len__(self) -> int:
        return len(self._inputs)

    def exact(self, name: str) -> Exact:
        """The function with its named constants as one more input, and what these stand for."""
        if name not in self._exact:
            inputs, outputs = self._parts(name)
            self._exact[name] = self._folded(name, inputs, outputs)
        return self._exact[name]

    def exact_rates(self) -> Exact:
        """``qd``, ``ud`` and the multipliers, which the step is made of, as `exact` gives them."""
        inputs = {group: self._columns[group] for group in STATE}
        return self._folded("rates", inputs, self._rates())

    def _folded(
        self, name: str, inputs: Mapping[str, ca.SX], outputs: Mapping[str, ca.SX]
    ) -> Exact:
        function = dense_function(name, {**inputs, CONSTANTS: self._arrays.named}, outputs)
        return folded(function, tuple(self._arrays.constants))

    def routine(self, name: str) -> Routine:
        """The function with the nearest doubles in place of its named constants."""
        function, constants = self.exact(name)
        code = read_routine(function, [Fraction(nearest(constant)) for constant in constants])
        return replace(code, inputs=code.inputs[:-1])

    def _parts(self, name: str) -> tuple[dict[str, ca.SX], dict[str, ca.SX]]:
        if name not in self._inputs:
            raise self._unknown(name, self._inputs)
        outputs = self._step() if name == "step" else self._outputs(name)
        return {group: self._columns[group] for group in (*STATE, *self._inputs[name])}, outputs

    def _unknown(self, name: str, known: Iterable[str]) -> InputError:
        asked = ", which are the outputs that were asked for" if self._asked else ""
        return InputError(
            f"function {name!r}: the model of {self.derived.scene.name!r} by"
            f" {self.derived.route} has {', '.join(known)}{asked}"
        )

    def _chosen(self, every: Inputs, outputs: Sequence[str]) -> Inputs:
        """Functions that were asked for, each once."""
        names = (outputs,) if isinstance(outputs, str) else tuple(dict.fromkeys(outputs))
        for name in names:
            if name not in every:
                self._asked = False
                raise self._unknown(name, every)
        if not names:
            raise InputError(f"outputs: none asked for: there are {', '.join(every)}")
        return {name: every[name] for name in names}

    @property
    def form(self) -> str:
        """How forward dynamics is written."""
        return self._shorter("forward_dynamics")[0]

    def _outputs(self, name: str) -> dict[str, ca.SX]:
        return self._shorter(name)[1]

    def _shorter(self, name: str) -> tuple[str, dict[str, ca.SX]]:
        """Form of forward dynamics and graphs of a function.

        Numbers bound before a form is looked for lead to shorter graphs, most of the time; those of
        free parameters, bound afterwards, are never longer than with the parameters.
        """
        if self.reduced is not None and name in self.reduced.functions:
            return "", graphs_of(self.reduced.functions[name], self._arrays)
        if name not in self._found:
            found = self.source.outputs(name)
            self._found[name] = self.source.form if name == "forward_dynamics" else "", found
            if (free := self._free) is not None:
                other = self._put(name, free)
                counts = [
                    _operations(self._arrays.bound([*each.values()])) for each in (found, other)
                ]
                if counts[1] < counts[0] and self._solved(name, other):
                    self._found[name] = free._shorter(name)[0], other
        return self._found[name]

    @cached_property
    def _free(self) -> "Graphs | None":
        """The same functions of free parameters, where numbers can be put in place of these."""
        written = self.derived.textbook is not None and self._named == "auto"
        if self.reduced or not self.fixed or not written or 0 in self.fixed.values():
            return None
        # The step is made of these two, asked for or not.
        return Graphs(self.derived, outputs=(*self._inputs, "coordinate_rates", "forward_dynamics"))

    def _solved(self, name: str, outputs: Mapping[str, ca.SX]) -> bool:
        """Whether forward dynamics solve the system at the numbers: a pivot may vanish there."""
        if name != "forward_dynamics" or self.source.matrices is None:
            return True
        return self.source.matrices.solved_by(ca.vertcat(*outputs.values()))

    def _put(self, name: str, free: "Graphs") -> dict[str, ca.SX]:
        """Graphs of free parameters with the fixed numbers."""
        own = {entry.symbol: self._columns["p"][i] for i, entry in enumerate(self.quantities.p)}
        entries = [entry.symbol for entry in free.quantities.p]
        inputs, outputs = free._parts(name)
        if "ud_p" in outputs:
            kept = [k for k, symbol in enumerate(entries) if symbol not in self.fixed]
            outputs = {**outputs, "ud_p": outputs["ud_p"][:, kept]}
        function = dense_function(name, {**inputs, CONSTANTS: free._arrays.named}, outputs)
        values: dict[str, Sequence[Any]] = {g: ca.vertsplit(self._columns[g]) for g in inputs}
        values["p"] = [self.fixed[s] if s in self.fixed else own[s] for s in entries]
        values[CONSTANTS] = tuple(free._arrays.constants)
        return at(function, values, Translator({}, self._arrays.constants).exact)

    def _rates(self) -> dict[str, ca.SX]:
        """q', u' and the multipliers."""
        return {**self._outputs("coordinate_rates"), **self._outputs("forward_dynamics")}

    def _step(self) -> dict[str, ca.SX]:
        q, u, inputs, p = (self._columns[group] for group in STATE)
        found = [self._rates()[name] for name in ("qd", "ud")]
        constants = self._arrays.named
        rates = ca.Function("rates", [q, u, inputs, p, constants], [ca.vertcat(*found)])
        times = [i for i, entry in enumerate(self.quantities.inputs) if entry.symbol == TIME]
        n, h = len(self.quantities.q), self._columns["h"]

        def rate(y: ca.SX, share: Fraction | float) -> ca.SX:
            held = ca.SX(inputs)
            for i in times:
                held[i] += float(share) * h
            return rates(y[:n], y[n:], held, p, constants)

        y = runge_kutta(RK4, rate, ca.vertcat(q, u), h)
        return {"q_next": y[:n], "u_next": y[n:]}


def _operations(graphs: list[ca.SX]) -> float:
    """Operations of what C is printed from; infinite where a number divides by zero."""
    column = ca.densify(ca.vertcat(*(ca.vec(graph) for graph in graphs)))
    try:
        code = read_routine(dense_function("counted", {"x": _symbols(column)}, {"y": column}))
    except ExpressionError:
        return inf
    return with_reciprocals(gathered(code)).operations


def _symbols(graph: ca.SX) -> ca.SX:
    return ca.vertcat(*ca.symvar(graph)) if ca.symvar(graph) else ca.SX(0, 1)


def form_names(equations: Equations) -> tuple[str, ...]:
    """Forms of forward dynamics that may suit some equations."""
    return tuple(form.name for form in FORMS if not form.unsuited(equations))


def function_inputs(equations: Equations) -> Inputs:
    """The functions of a model, with their inputs beside the state."""
    found: Inputs = {
        "forward_dynamics": (),
        "mass_matrix": (),
        "forcing": (),
        "residual": ("ud", "multipliers"),
        "inverse_dynamics": ("ud",),
        "energy": (),
        "momenta": (),
        "coordinate_rates": (),
        "jacobians": (),
        "step": ("h",),
    }
    if frictions(equations.scene):
        del found["inverse_dynamics"]
    if equations.tells_reactions:
        found["reactions"] = ()
    found |= dict.fromkeys(output_functions(mechanism_of(equations)), ())
    return found
