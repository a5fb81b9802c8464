"""The right-hand side y' = f(y, inputs, p), y = (q, u), of a model, and what is made of it once.

    q' = N u + n,    u' = forward dynamics (q, u, inputs, p)

One function and one call: what both halves need is computed once. Each value is a function of the
graphs, the names and the compiler alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType

import casadi as ca
import numpy as np

from mechanics.compiled.c.source import function_source, signature
from mechanics.compiled.forms.members import ELIMINATION, PRIMITIVE
from mechanics.compiled.graphs import STATE, Graphs
from mechanics.compiled.machine.evaluator import Kernel, evaluator
from mechanics.compiled.step import Tableau, runge_kutta
from mechanics.program import Builder, Program
from mechanics.program.builder import Node
from mechanics.program.casadi_reader import read, read_routine
from mechanics.program.routine import Routine, entries_of
from mechanics.program.sympy_reader import read as read_expressions

NEEDED = ("forward_dynamics", "coordinate_rates")
INNER = "mechanics_inner"
"""The function in C that a loop calls."""
SHORT = 120
"""Instructions below which it does not pay to look for another form."""


@dataclass(frozen=True, eq=False, repr=False)
class Compiled:
    """A function of y, inputs and p, and its code.

    Attributes
    ----------
    function : casadi.Function
    entries : mapping of str to tuple of str
        Names of the entries of its inputs.
    """

    function: ca.Function
    entries: Mapping[str, tuple[str, ...]]
    compiler: str | None
    flags: str

    @cached_property
    def routine(self) -> Routine:
        """Its instructions."""
        return read_routine(self.function)

    @cached_property
    def double(self) -> Kernel:
        """Its evaluator."""
        return self._evaluator(np.float64)

    @cached_property
    def single(self) -> Kernel:
        """Its evaluator in single precision."""
        return self._evaluator(np.float32)

    def kernel(self, kind: type[np.floating]) -> Kernel:
        """Its evaluator in a precision."""
        return self.single if kind is np.float32 else self.double

    def _evaluator(self, kind: type[np.floating]) -> Kernel:
        names, flags = dict(self.entries), self.flags
        return evaluator(self.function, self.routine, names, kind, self.compiler, flags)

    @cached_property
    def _inner_double(self) -> str:
        return self._inner("double")

    @cached_property
    def _inner_single(self) -> str:
        return self._inner("float")

    def inner(self, kind: type[np.floating]) -> str:
        """The definition of `INNER` in C."""
        return self._inner_single if kind is np.float32 else self._inner_double

    def _inner(self, real: str) -> str:
        head = f"static {signature(self.routine, real, INNER)}"
        return function_source(self.routine, dict(self.entries), real, head)


@dataclass(frozen=True, eq=False, repr=False)
class Held:
    """f of many motions, all of them with inputs that stay; data that can travel.

    Attributes
    ----------
    routine : Routine
        ``rate(y, held)``: y' from the state, with t as its last entry if it is held, and from the
        inputs without t and the parameters. As it is written.
    program : Program
        ``yd`` of inputs called as in C.
    """

    routine: Routine
    program: Program

    @property
    def sizes(self) -> tuple[int, int]:
        """Entries of the state, and of what is held."""
        (_, size), (_, count) = self.routine.inputs
        return size, count

    @property
    def state(self) -> tuple[str, ...]:
        """Names of the state's entries in C."""
        return tuple(f"y[{k}]" for k in range(self.sizes[0]))


def read_held(function: ca.Function) -> Held:
    """A function ``rate(y, held) -> yd``."""
    code, builder = read_routine(function), Builder()
    names = entries_of(code.inputs)
    size, _ = (count for _, count in code.inputs)
    arguments = {"y": names[:size], "held": names[size:]}
    nodes = {group: [*map(builder.input, entries)] for group, entries in arguments.items()}
    (rates,) = read(builder, function, nodes).values()
    return Held(code, builder.program({"yd": rates}, names))


@dataclass(frozen=True, eq=False, repr=False)
class RightHandSide:
    """f of a model.

    Attributes
    ----------
    model_graphs : Graphs
        Of the model: all functions, or those that were asked for.
    """

    model_graphs: Graphs
    compiler: str | None
    flags: str

    @cached_property
    def graphs(self) -> Graphs:
        """With what a motion needs even where the model was not asked for it, in its form."""
        known = self.model_graphs
        return known if {*NEEDED} <= {*known} else self._graphs(known.form)

    def _graphs(self, form: str) -> Graphs:
        known = self.model_graphs
        missing = [name for name in NEEDED if name not in tuple(known)]
        return Graphs(known.derived, form, known.fixed, (*known, *missing))

    @cached_property
    def entries(self) -> dict[str, tuple[str, ...]]:
        """Names of the entries of y, inputs and p."""
        known = self.model_graphs.quantities
        names = {group: tuple(e.name for e in getattr(known, group)) for group in STATE}
        return {"y": (*names["q"], *names["u"]), "inputs": names["inputs"], "p": names["p"]}

    @cached_property
    def rate(self) -> Compiled:
        """``rate(y, inputs, p) -> yd``: dense columns."""
        known = self.graphs.quantities
        sizes = {group: len(getattr(known, group)) for group in STATE}
        y = ca.SX.sym("y", sizes["q"] + sizes["u"])
        w, p = (ca.SX.sym(group, sizes[group]) for group in ("inputs", "p"))
        state = (y[: sizes["q"]], y[sizes["q"] :], w, p)
        rates = self.graphs["coordinate_rates"](*state)
        accelerations, _ = self.graphs["forward_dynamics"](*state)
        yd = ca.densify(ca.vertcat(rates, accelerations))
        return self._compiled("rate", [y, w, p], yd, "yd")

    @cached_property
    def jacobian(self) -> Compiled:
        """``rate_jacobian(y, inputs, p) -> slope``: df/dy, (n + m) x (n + m), by columns."""
        y, w, p = self.rate.function.sx_in()
        slope = ca.densify(ca.jacobian(self.rate.function(y, w, p), y))
        return self._compiled("rate_jacobian", [y, w, p], slope, "slope")

    def _compiled(self, name: str, inputs: Sequence[ca.SX], output: ca.SX, out: str) -> Compiled:
        names = ["y", "inputs", "p"]
        function = ca.Function(name, [*inputs], ca.cse([output]), names, [out])
        return Compiled(function, self.entries, self.compiler, self.flags)

    @property
    def timed(self) -> bool:
        """Whether the time is among the inputs."""
        return "t" in self.entries["inputs"]

    @cached_property
    def held(self) -> Held:
        """f with the state and what is held as its arguments."""
        function, names = self.rate.function, self.entries["inputs"]
        y, w, p = function.sx_in()
        state, given = y, w
        rates = function(y, w, p)
        if self.timed:
            time = w[names.index("t")]
            state, rates = ca.vertcat(y, time), ca.vertcat(rates, 1)
            given = ca.vertcat(*(w[i] for i, name in enumerate(names) if name != "t"))
        held = ca.vertcat(given, p)
        function = ca.Function("rate", [state, held], [ca.densify(rates)], ["y", "held"], ["yd"])
        return read_held(function)

    @cached_property
    def steps(self) -> Mapping[str, Step]:
        """Of each explicit Runge-Kutta method, by its name."""
        # SciPy, of which their coefficients are, takes longer to import than all the rest.
        from mechanics.compiled.tableaus import TABLEAUX

        return MappingProxyType({tableau.name: Step(self, tableau) for tableau in TABLEAUX})

    @cached_property
    def program(self) -> Program:
        """``yd`` of inputs by name; constants are the doubles of the graph."""
        builder = Builder()
        arguments = {group: [*map(builder.input, names)] for group, names in self.entries.items()}
        order = [entry for names in self.entries.values() for entry in names]
        return builder.program(read(builder, self.rate.function, arguments), order)

    @cached_property
    def shortest(self) -> Program:
        """``yd``, its constants exact, in the form with the fewest operations.

        In exact numbers all forms are equal.
        """
        best, equations = self._exact(self.graphs), self.model_graphs.derived
        if best.count < SHORT or equations.textbook is None:
            return best
        for form in (ELIMINATION, PRIMITIVE):
            if form.name == self.model_graphs.form or form.unsuited(equations):
                continue
            other = self._exact(self._graphs(form.name))
            best = min(best, other, key=lambda program: program.count)
        return best

    def _exact(self, graphs: Graphs) -> Program:
        builder, names = Builder(), self.entries
        q = names["y"][: len(graphs.quantities.q)]
        groups = (q, names["y"][len(q) :], names["inputs"], names["p"])
        arguments = {
            name: [builder.input(entry) for entry in group]
            for name, group in zip(STATE, groups, strict=True)
        }
        rates: list[Node] = []
        for name, output in (("coordinate_rates", "qd"), ("forward_dynamics", "ud")):
            function, constants = graphs.exact(name)
            arguments["constants"] = [*read_expressions(builder, constants)]
            rates += read(builder, function, arguments)[output]
        return builder.program({"yd": rates}, [entry for group in groups for entry in group])


@dataclass(frozen=True, eq=False, repr=False)
class Step:
    """One step of an explicit method, inputs held, but for time."""

    of: RightHandSide
    tableau: Tableau

    @cached_property
    def compiled(self) -> Compiled:
        """``step(y, inputs, p, h) -> y_next``."""
        y, w, p = self.of.rate.function.sx_in()
        h = ca.SX.sym("h")
        after = runge_kutta(self.tableau, self._moved(w, p, h), y, h)
        names = ["y", "inputs", "p", "h"]
        function = ca.Function("step", [y, w, p, h], ca.cse([after]), names, ["y_next"])
        entries = {**self.of.entries, "h": ("h",)}
        return Compiled(function, entries, self.of.compiler, self.of.flags)

    def _moved(self, w: ca.SX, p: ca.SX, h: ca.SX) -> Callable[[ca.SX, Fraction | float], ca.SX]:
        names = self.of.entries["inputs"]

        def at(y: ca.SX, share: Fraction | float) -> ca.SX:
            held = ca.SX(w)
            if self.of.timed:
                held[names.index("t")] += float(share) * h
            return self.of.rate.function(y, held, p)

        return at
