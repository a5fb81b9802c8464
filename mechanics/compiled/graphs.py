"""The functions of a model as CasADi graphs.

    forward dynamics    (u', lambda)  from  [[M, -B], [A, 0]] (u', lambda) = (f, b)
    residual            [[M, -B], [A, 0]] (u', lambda) - (f, b)
    inverse dynamics    tau = M_T (u' - forward dynamics),   M_T = d2T/du2
    jacobians           K dx/ds = dk/ds - (dK/ds) x,   K x = k the first of these systems

The inverse dynamics are the generalized forces, conjugate to u, which have to be added to the loads
to get u'; with M_T from the kinetic energy this holds whatever the rows of a route are. Where the
rows are conjugate and nothing is constrained, it is M u' - f.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property

import casadi as ca
import numpy as np
import sympy

from mechanics.compiled.factor import solve_general, solve_symmetric
from mechanics.compiled.mechanical import Totals, totals
from mechanics.compiled.order import Order, pivot_order
from mechanics.compiled.program import program, run
from mechanics.compiled.quantities import DIGITS, Quantities, quantities
from mechanics.compiled.sampling import DECADES, sample
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import InputError

STATE = ("q", "u", "inputs", "p")
MATRICES = frozenset({"mass_matrix", *(f"ud_{group}" for group in STATE)})
"""Outputs that are matrices, whatever their size; the others are columns."""

TRIALS = 64
SEED = 2


class Graphs(Mapping[str, ca.Function]):
    """CasADi functions by name; each is built when it is first asked for.

    Inputs are named ``q``, ``u``, ``inputs``, ``p`` (and ``ud``, ``multipliers``), dense columns.

    Parameters
    ----------
    equations : Equations
    """

    def __init__(self, equations: Equations) -> None:
        self.equations = equations
        self.quantities: Quantities = quantities(equations)
        groups = {name: getattr(self.quantities, name) for name in (*STATE, "ud", "multipliers")}
        self._columns = {name: ca.SX.sym(name, len(group)) for name, group in groups.items()}
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
            exact = list(self._constants.values())
            bound = [float(constant.evalf(DIGITS)) for constant in self._constants]
            graphs = list(outputs.values())
            if exact:
                graphs = ca.substitute(graphs, [ca.vertcat(*exact)], [ca.SX(ca.DM(bound))])
            self._built[name] = self._function(
                name, inputs, dict(zip(outputs, graphs, strict=True))
            )
        return self._built[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._builders)

    def __len__(self) -> int:
        return len(self._builders)

    def exact(self, name: str) -> tuple[ca.Function, tuple[sympy.Expr, ...]]:
        """The function with its named constants as one more input, and what these stand for."""
        inputs, outputs = self._parts(name)
        constants = ca.vertcat(*self._constants.values()) if self._constants else ca.SX(0, 1)
        function = self._function(name, {**inputs, "constants": constants}, outputs)
        return function, tuple(self._constants)

    def _function(
        self, name: str, inputs: Mapping[str, ca.SX], outputs: Mapping[str, ca.SX]
    ) -> ca.Function:
        graphs = ca.cse([ca.densify(graph) for graph in outputs.values()])
        return ca.Function(name, list(inputs.values()), graphs, list(inputs), list(outputs))

    def _parts(self, name: str) -> tuple[dict[str, ca.SX], dict[str, ca.SX]]:
        if name not in self._builders:
            raise InputError(
                f"function {name!r}: the model of {self.equations.scene.name!r} by"
                f" {self.equations.route} has {', '.join(self._builders)}"
            )
        extra, build = self._builders[name]
        outputs = build()
        return {group: self._columns[group] for group in (*STATE, *extra)}, outputs

    @cached_property
    def _builders(self) -> dict[str, tuple[tuple[str, ...], Callable[[], dict[str, ca.SX]]]]:
        found: dict[str, tuple[tuple[str, ...], Callable[[], dict[str, ca.SX]]]] = {
            "forward_dynamics": ((), self._forward_dynamics),
            "mass_matrix": ((), lambda: {"mass_matrix": self._matrix(self.equations.mass)}),
            "forcing": ((), lambda: {"forcing": self._matrix(self.equations.forcing)}),
            "residual": (("ud", "multipliers"), self._residual),
            "inverse_dynamics": (("ud",), self._inverse_dynamics),
            "energy": ((), self._energy),
            "momenta": ((), self._momenta),
            "coordinate_rates": ((), self._coordinate_rates),
            "jacobians": ((), self._jacobians),
        }
        if self.equations.reactions:
            found["reactions"] = ((), self._reactions)
        return found

    def _matrix(self, entries: sympy.Matrix) -> ca.SX:
        return self._translate.matrix(entries)

    @cached_property
    def _system(self) -> tuple[ca.SX, ca.SX]:
        left, right = self.equations.system
        return self._matrix(left), self._matrix(right)

    @cached_property
    def _symmetric(self) -> bool:
        eq = self.equations
        return eq.conjugate and not eq.multipliers and not eq.constraint_matrix.rows

    @cached_property
    def _solution(self) -> ca.SX:
        """(u', lambda)."""
        return self._solve(self._system[1])

    def _solve(self, rhs: ca.SX) -> ca.SX:
        if self._symmetric:
            return solve_symmetric(self._system[0], rhs)
        return solve_general(self._system[0], rhs, self.pivots)

    @cached_property
    def pivots(self) -> Order:
        """The order in which rows and columns of the linear system are eliminated."""
        n = self._system[0].shape[0]
        if self._symmetric:
            return tuple((i, i) for i in reversed(range(n)))
        constants = list(self._constants.values())
        bound = ca.SX(ca.DM([float(constant.evalf(DIGITS)) for constant in self._constants]))
        graphs = list(self._system)
        if constants:
            graphs = ca.substitute(graphs, [ca.vertcat(*constants)], [bound])
        inputs = {group: self._columns[group] for group in STATE}
        code = program(self._function("system", inputs, dict(zip("Ab", graphs, strict=True))))
        # Half of the states are ordinary ones, half as wild as those of the residual checks.
        drawn = [sample(self.quantities, TRIALS, SEED, decades) for decades in (1.0, DECADES)]
        groups = (np.vstack(pair) for pair in zip(*(d.groups for d in drawn), strict=True))
        columns = [list(group.T) for group in groups]
        left, right = run(code, columns, np.float64)
        filler = np.zeros(2 * TRIALS)
        stacked = [np.stack(np.broadcast_arrays(*e, filler)[:-1], 1) for e in (left, right)]
        # Entries come column by column.
        return pivot_order(stacked[0].reshape(-1, n, n).swapaxes(1, 2).copy(), stacked[1])

    def _forward_dynamics(self) -> dict[str, ca.SX]:
        n = len(self.quantities.ud)
        return {"ud": self._solution[:n, 0], "multipliers": self._solution[n:, 0]}

    def _residual(self) -> dict[str, ca.SX]:
        left, right = self._system
        unknowns = ca.vertcat(self._columns["ud"], self._columns["multipliers"])
        return {"residual": left @ unknowns - right}

    def _inverse_dynamics(self) -> dict[str, ca.SX]:
        wanted = self._columns["ud"]
        if self._symmetric:
            left, right = self._system
            return {"forces": left @ wanted - right}
        kinetic = self._translate(self._totals.kinetic)
        inertia = ca.jacobian(ca.jacobian(kinetic, self._columns["u"]).T, self._columns["u"])
        return {"forces": inertia @ (wanted - self._forward_dynamics()["ud"])}

    @cached_property
    def _totals(self) -> Totals:
        return totals(self.equations.scene)

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
        return {"qd": self._translate.column([scene.coordinate_rates[qd] for qd in scene.qd])}

    def _reactions(self) -> dict[str, ca.SX]:
        # u' and lambda stand for the solution here, not for inputs.
        solved = dict(zip(self.equations.unknowns, ca.vertsplit(self._solution), strict=True))
        translate = Translator({**self._table, **solved}, self._constants)
        return {"reactions": translate.column([value for _, value in self.equations.reactions])}

    def _jacobians(self) -> dict[str, ca.SX]:
        """The factors of K serve every column; differentiating through them costs twice as much."""
        left, right = self._system
        held = ca.SX.sym("x", left.shape[1])
        state = ca.vertcat(*(self._columns[group] for group in STATE))
        slopes = ca.jacobian(right - left @ held, state)
        columns = self._solve(ca.substitute(slopes, held, self._solution))
        found, start = {}, 0
        for group in STATE:
            end = start + len(getattr(self.quantities, group))
            found[f"ud_{group}"] = columns[: len(self.quantities.ud), start:end]
            start = end
        return found
