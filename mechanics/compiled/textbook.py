"""The functions of a model from equations that are written out, as CasADi graphs.

    forward dynamics    (u', lambda)  from  [[M, -B], [A, 0]] (u', lambda) = (f, b)
    residual            [[M, -B], [A, 0]] (u', lambda) - (f, b)
    inverse dynamics    tau = M_T (u' - forward dynamics),   M_T = d2T/du2
    jacobians           K dx/ds = dk/ds - (dK/ds) x,   K x = k the first of these systems

The inverse dynamics are the generalized forces, conjugate to u, which have to be added to the loads
to get u'; with M_T from the kinetic energy this holds whatever the rows of a route are. Where the
rows are conjugate and nothing is constrained, it is M u' - f. Friction would change with them.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import sympy

from mechanics.compiled.arrays import Arrays
from mechanics.compiled.fixed import Fixed
from mechanics.compiled.forms import Form, System, written
from mechanics.compiled.forms.order import Order
from mechanics.compiled.quantities import STATE
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations


def instructions(outputs: Mapping[str, ca.SX]) -> int:
    """CasADi's count of what the outputs of a function take."""
    graphs = [ca.densify(graph) for graph in outputs.values()]
    symbols = ca.symvar(ca.vertcat(*map(ca.vec, graphs)))
    return int(ca.Function("graph", symbols, ca.cse(graphs)).n_instructions())


def dense_function(
    name: str, inputs: Mapping[str, ca.SX], outputs: Mapping[str, ca.SX]
) -> ca.Function:
    """A function of dense columns and matrices, what they share computed once."""
    graphs = ca.cse([ca.densify(graph) for graph in outputs.values()])
    return ca.Function(name, list(inputs.values()), graphs, list(inputs), list(outputs))


@dataclass(frozen=True, eq=False)
class Textbook:
    """Graphs of the outputs of equations that SymPy has written out.

    Attributes
    ----------
    equations : Equations
        With the fixed values.
    fixed : mapping of Symbol to Expr
    named : str
        Form of forward dynamics, or ``"auto"``.
    from_bodies : callable
        From the name of a form to graphs of (u', lambda) that start from the bodies.
    """

    equations: Equations
    fixed: Fixed
    named: str
    arrays: Arrays
    from_bodies: Callable[[str], list[ca.SX]]

    def outputs(self, name: str) -> dict[str, ca.SX]:
        """The graphs of the outputs of a function."""
        return self._every[name]()

    @cached_property
    def _every(self) -> dict[str, Callable[[], dict[str, ca.SX]]]:
        return {
            "forward_dynamics": self._forward_dynamics,
            "mass_matrix": lambda: {"mass_matrix": self._matrix(self.equations.mass)},
            "forcing": lambda: {"forcing": self._matrix(self.equations.forcing)},
            "residual": self._residual,
            "inverse_dynamics": self._inverse_dynamics,
            "coordinate_rates": self._coordinate_rates,
            "jacobians": self._jacobians,
            "reactions": self._reactions,
        }

    @cached_property
    def _translate(self) -> Translator:
        return Translator(self.arrays.table, self.arrays.constants)

    def _matrix(self, entries: sympy.Matrix) -> ca.SX:
        return self._translate.matrix(entries)

    @cached_property
    def system(self) -> System:
        """What forms of forward dynamics start from."""
        known = self.arrays.quantities
        return System(self.equations, self._translate, known, self._of_state, self.from_bodies)

    @property
    def form(self) -> str:
        """How forward dynamics is written: the name of one of `mechanics.compiled.FORMS`."""
        return self._written[0].name

    def solved_by(self, solution: ca.SX) -> bool:
        """Whether a graph of (u', lambda) is a solution at states that are drawn."""
        return self.system.solved_by(solution)

    @property
    def _solution(self) -> ca.SX:
        """(u', lambda)."""
        return self._written[1]

    @cached_property
    def _written(self) -> tuple[Form, ca.SX]:
        return written(self.named, self.system)

    @property
    def pivots(self) -> Order:
        """The order in which rows and columns of the linear system are eliminated."""
        return tuple(self.system.pivots)

    def _of_state(self, *graphs: ca.SX, x: ca.SX | None = None) -> ca.Function:
        inputs = {group: self.arrays.columns[group] for group in STATE}
        bound = self.arrays.bound(list(graphs))
        if x is None:
            return dense_function("system", inputs, dict(zip("yz", bound, strict=False)))
        # Of what is evaluated a few times nothing is shared: that takes longer.
        return ca.Function("residual", [*inputs.values(), x], [ca.densify(bound[0])])

    def _forward_dynamics(self) -> dict[str, ca.SX]:
        n = len(self.arrays.quantities.ud)
        return {"ud": self._solution[:n, 0], "multipliers": self._solution[n:, 0]}

    def _residual(self) -> dict[str, ca.SX]:
        left, right = self.system.graphs
        unknowns = ca.vertcat(self.arrays.columns["ud"], self.arrays.columns["multipliers"])
        return {"residual": left @ unknowns - right}

    def _inverse_dynamics(self) -> dict[str, ca.SX]:
        wanted = self.arrays.columns["ud"]
        if self.system.symmetric:
            left, right = self.system.graphs
            return {"forces": left @ wanted - right}
        inertia = self._matrix(self.equations.kinematics.mass_matrix.xreplace(dict(self.fixed)))
        return {"forces": inertia @ (wanted - self._forward_dynamics()["ud"])}

    def _coordinate_rates(self) -> dict[str, ca.SX]:
        scene = self.equations.scene
        rates = [scene.coordinate_rates[qd].xreplace(self.fixed) for qd in scene.qd]
        return {"qd": self._translate.column(rates)}

    def _reactions(self) -> dict[str, ca.SX]:
        # u' and lambda stand for the solution here, not for inputs.
        solved = dict(zip(self.equations.unknowns, ca.vertsplit(self._solution), strict=True))
        translate = Translator({**self.arrays.table, **solved}, self.arrays.constants)
        return {"reactions": translate.column([value for _, value in self.equations.reactions])}

    def _jacobians(self) -> dict[str, ca.SX]:
        """The factors of K serve every column; differentiating through them costs twice as much."""
        left, right = self.system.graphs
        held, solution = ca.SX.sym("x", left.shape[1]), self.system.solve(right)
        state = ca.vertcat(*(self.arrays.columns[group] for group in STATE))
        slopes = ca.jacobian(right - left @ held, state)
        columns = self.system.solve(ca.substitute(slopes, held, solution))
        found, start = {}, 0
        for group in STATE:
            end = start + len(getattr(self.arrays.quantities, group))
            found[f"ud_{group}"] = columns[: len(self.arrays.quantities.ud), start:end]
            start = end
        return found
