"""The functions of a model as CasADi graphs.

    forward dynamics    (u', lambda)  from  [[M, -B], [A, 0]] (u', lambda) = (f, b)
    residual            [[M, -B], [A, 0]] (u', lambda) - (f, b)
    inverse dynamics    tau = M_T (u' - forward dynamics),   M_T = d2T/du2
    jacobians           K dx/ds = dk/ds - (dK/ds) x,   K x = k the first of these systems

The inverse dynamics are the generalized forces, conjugate to u, which have to be added to the loads
to get u'; with M_T from the kinetic energy this holds whatever the rows of a route are. Where the
rows are conjugate and nothing is constrained, it is M u' - f. Friction would change with them.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property

import casadi as ca
import sympy

from mechanics.compiled.fixed import Fixed, fix
from mechanics.compiled.forms import Form, System, named_form, written
from mechanics.compiled.forms.order import Order
from mechanics.compiled.mechanical import Totals, totals
from mechanics.compiled.quantities import DIGITS, Quantities, quantities
from mechanics.compiled.step import RK4, runge_kutta
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.scene.actions import frictions
from mechanics.scene.rates import TIME

STATE = ("q", "u", "inputs", "p")
MATRICES = frozenset({"mass_matrix", *(f"ud_{group}" for group in STATE)})
"""Outputs that are matrices, whatever their size; the others are columns."""

Builders = dict[str, tuple[tuple[str, ...], Callable[[], dict[str, ca.SX]]]]
"""By name of a function: its inputs beside the state, and what makes the graphs of its outputs."""


class Graphs(Mapping[str, ca.Function]):
    """CasADi functions by name; each is built when it is first asked for.

    Inputs are named ``q``, ``u``, ``inputs``, ``p`` (and ``ud``, ``multipliers``), dense columns.

    Parameters
    ----------
    equations : Equations
    form : str
        Of forward dynamics, one of `mechanics.compiled.FORMS`, or ``"auto"``.
    fixed : mapping of Symbol to Expr
        Exact values of parameters that are fixed.
    outputs : sequence of str, optional
        The functions to have; by default all.

    Attributes
    ----------
    derived : Equations
        As they were given.
    equations : Equations
        With the fixed values.
    """

    def __init__(
        self,
        equations: Equations,
        form: str = "auto",
        fixed: Fixed | None = None,
        outputs: Sequence[str] | None = None,
    ) -> None:
        self.derived, self.fixed = equations, dict(fixed or {})
        self.equations = fix(equations, self.fixed)
        self._named = form
        if form != "auto":
            # A form that there is not is refused at once; the cheapest is found when it is needed.
            named_form(form, self.equations)
        self._asked = self._checked(outputs)
        self.quantities: Quantities = quantities(
            self.equations, self.fixed, "reactions" in self._builders
        )
        groups = {name: getattr(self.quantities, name) for name in (*STATE, "ud", "multipliers")}
        self._columns = {name: ca.SX.sym(name, len(group)) for name, group in groups.items()}
        self._columns["h"] = ca.SX.sym("h")
        table = {
            entry.symbol: self._columns[name][i]
            for name, group in groups.items()
            for i, entry in enumerate(group)
        }
        self._constants: dict[sympy.Expr, ca.SX] = {}
        self._translate = Translator(table, self._constants)
        self._table = table
        self._built: dict[str, ca.Function] = {}

    def __getitem__(self, name: str) -> ca.Function:
        if name not in self._built:
            inputs, outputs = self._parts(name)
            graphs = self._bound(list(outputs.values()))
            self._built[name] = self._function(
                name, inputs, dict(zip(outputs, graphs, strict=True))
            )
        return self._built[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._builders)

    def __len__(self) -> int:
        return len(self._builders)

    def _bound(self, graphs: list[ca.SX]) -> list[ca.SX]:
        """Graphs with the nearest doubles in place of named constants."""
        if not self._constants:
            return graphs
        values = ca.DM([float(constant.evalf(DIGITS)) for constant in self._constants])
        return ca.substitute(graphs, [ca.vertcat(*self._constants.values())], [ca.SX(values)])

    def exact(self, name: str) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
        """The function with its named constants as one more input, and what these stand for."""
        inputs, outputs = self._parts(name)
        constants = ca.vertcat(*self._constants.values()) if self._constants else ca.SX(0, 1)
        function = self._function(name, {**inputs, "constants": constants}, outputs)
        return function, tuple(self._constants)

    def exact_rates(self) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
        """``qd``, ``ud`` and the multipliers, which the step is made of, as `exact` gives them."""
        outputs = {**self._coordinate_rates(), **self._forward_dynamics()}
        constants = ca.vertcat(*self._constants.values()) if self._constants else ca.SX(0, 1)
        inputs = {**{group: self._columns[group] for group in STATE}, "constants": constants}
        return self._function("rates", inputs, outputs), tuple(self._constants)

    def _function(
        self, name: str, inputs: Mapping[str, ca.SX], outputs: Mapping[str, ca.SX]
    ) -> ca.Function:
        graphs = ca.cse([ca.densify(graph) for graph in outputs.values()])
        return ca.Function(name, list(inputs.values()), graphs, list(inputs), list(outputs))

    def _parts(self, name: str) -> tuple[dict[str, ca.SX], dict[str, ca.SX]]:
        if name not in self._builders:
            raise self._unknown(name, self._builders)
        extra, build = self._builders[name]
        outputs = build()
        return {group: self._columns[group] for group in (*STATE, *extra)}, outputs

    def _unknown(self, name: str, known: Iterable[str]) -> InputError:
        asked = "" if self._asked is None else ", which are the outputs that were asked for"
        return InputError(
            f"function {name!r}: the model of {self.equations.scene.name!r} by"
            f" {self.equations.route} has {', '.join(known)}{asked}"
        )

    def _checked(self, outputs: Sequence[str] | None) -> tuple[str, ...] | None:
        """Outputs that were asked for, each once."""
        self._asked = None
        if outputs is None:
            return None
        names = (outputs,) if isinstance(outputs, str) else tuple(dict.fromkeys(outputs))
        for name in names:
            if name not in self._every:
                raise self._unknown(name, self._every)
        if not names:
            raise InputError(f"outputs: none asked for: there are {', '.join(self._every)}")
        return names

    @cached_property
    def _builders(self) -> Builders:
        if self._asked is None:
            return self._every
        return {name: self._every[name] for name in self._asked}

    @cached_property
    def _every(self) -> Builders:
        found: Builders = {
            "forward_dynamics": ((), self._forward_dynamics),
            "mass_matrix": ((), lambda: {"mass_matrix": self._matrix(self.equations.mass)}),
            "forcing": ((), lambda: {"forcing": self._matrix(self.equations.forcing)}),
            "residual": (("ud", "multipliers"), self._residual),
            "inverse_dynamics": (("ud",), self._inverse_dynamics),
            "energy": ((), self._energy),
            "momenta": ((), self._momenta),
            "coordinate_rates": ((), self._coordinate_rates),
            "jacobians": ((), self._jacobians),
            "step": (("h",), self._step),
        }
        if frictions(self.equations.scene):
            del found["inverse_dynamics"]
        if self.equations.solve_reactions is not None:
            found["reactions"] = ((), self._reactions)
        return found

    def _matrix(self, entries: sympy.Matrix) -> ca.SX:
        return self._translate.matrix(entries)

    @cached_property
    def _linear(self) -> System:
        return System(self.equations, self._translate, self.quantities, self._of_state)

    @property
    def form(self) -> Form:
        """How forward dynamics is written."""
        return self._written[0]

    @property
    def _solution(self) -> ca.SX:
        """(u', lambda)."""
        return self._written[1]

    @cached_property
    def _written(self) -> tuple[Form, ca.SX]:
        return written(self._named, self._linear)

    @property
    def pivots(self) -> Order:
        """The order in which rows and columns of the linear system are eliminated."""
        return tuple(self._linear.pivots)

    def _of_state(self, *graphs: ca.SX, x: ca.SX | None = None) -> ca.Function:
        inputs = {group: self._columns[group] for group in STATE}
        bound = self._bound(list(graphs))
        if x is None:
            return self._function("system", inputs, dict(zip("yz", bound, strict=False)))
        # Of what is evaluated a few times nothing is shared: that takes longer.
        return ca.Function("residual", [*inputs.values(), x], [ca.densify(bound[0])])

    def _forward_dynamics(self) -> dict[str, ca.SX]:
        n = len(self.quantities.ud)
        return {"ud": self._solution[:n, 0], "multipliers": self._solution[n:, 0]}

    def _residual(self) -> dict[str, ca.SX]:
        left, right = self._linear.graphs
        unknowns = ca.vertcat(self._columns["ud"], self._columns["multipliers"])
        return {"residual": left @ unknowns - right}

    def _inverse_dynamics(self) -> dict[str, ca.SX]:
        wanted = self._columns["ud"]
        if self._linear.symmetric:
            left, right = self._linear.graphs
            return {"forces": left @ wanted - right}
        kinetic = self._translate(self._totals.kinetic)
        inertia = ca.jacobian(ca.jacobian(kinetic, self._columns["u"]).T, self._columns["u"])
        return {"forces": inertia @ (wanted - self._forward_dynamics()["ud"])}

    @cached_property
    def _totals(self) -> Totals:
        return totals(self.equations.scene).fixed(self.fixed)

    def _energy(self) -> dict[str, ca.SX]:
        kinetic, potential = map(self._translate, (self._totals.kinetic, self._totals.potential))
        return {"kinetic": kinetic, "potential": potential, "total": kinetic + potential}

    def _momenta(self) -> dict[str, ca.SX]:
        kinetic = self._translate(self._totals.kinetic)
        return {
            "linear": self._matrix(self._totals.linear_momentum),
            "angular": self._matrix(self._totals.angular_momentum),
            "generalized": ca.jacobian(kinetic, self._columns["u"]).T,
        }

    def _coordinate_rates(self) -> dict[str, ca.SX]:
        scene = self.equations.scene
        rates = [scene.coordinate_rates[qd].xreplace(self.fixed) for qd in scene.qd]
        return {"qd": self._translate.column(rates)}

    def _reactions(self) -> dict[str, ca.SX]:
        # u' and lambda stand for the solution here, not for inputs.
        solved = dict(zip(self.equations.unknowns, ca.vertsplit(self._solution), strict=True))
        translate = Translator({**self._table, **solved}, self._constants)
        return {"reactions": translate.column([value for _, value in self.equations.reactions])}

    def _jacobians(self) -> dict[str, ca.SX]:
        """The factors of K serve every column; differentiating through them costs twice as much."""
        left, right = self._linear.graphs
        held, solution = ca.SX.sym("x", left.shape[1]), self._linear.solve(right)
        state = ca.vertcat(*(self._columns[group] for group in STATE))
        slopes = ca.jacobian(right - left @ held, state)
        columns = self._linear.solve(ca.substitute(slopes, held, solution))
        found, start = {}, 0
        for group in STATE:
            end = start + len(getattr(self.quantities, group))
            found[f"ud_{group}"] = columns[: len(self.quantities.ud), start:end]
            start = end
        return found

    def _step(self) -> dict[str, ca.SX]:
        q, u, inputs, p = (self._columns[group] for group in STATE)
        found = [self._coordinate_rates()["qd"], self._forward_dynamics()["ud"]]
        constants = ca.vertcat(*self._constants.values()) if self._constants else ca.SX(0, 1)
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
