"""Where the graphs of a model come from: matrices that are written out, and programs.

Equations that are not written out have programs alone. What every route has to give is compiled
from what is shorter. What an output is made from is chosen in `mechanics.compiled.textbook` and
`mechanics.compiled.outputs`; numbers that no double holds stay exact, as named constants.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
import sympy

from mechanics.compiled.arrays import GROUPS, Arrays
from mechanics.compiled.bordered import bind, tried_pivots
from mechanics.compiled.fixed import Fixed, fix, words
from mechanics.compiled.forms import FORMS, named_form
from mechanics.compiled.outputs import Outputs
from mechanics.compiled.quantities import STATE, mechanism_of
from mechanics.compiled.textbook import Textbook, instructions
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SingularError
from mechanics.kinematics.outputs import SLOPE, output_functions
from mechanics.mechanism import Mechanism
from mechanics.program import Builder, Program
from mechanics.program.casadi_printer import print_graphs
from mechanics.program.interpret import include
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import acceleration_forms, coefficients

OF_BODIES = frozenset({"energy", "momenta"})
"""Functions that no route has anything to do with; programs give them."""
OF_EVERY_ROUTE = frozenset({"inverse_dynamics", "jacobians"})
"""Functions that are the same whatever the rows of a route are, and that programs make shorter."""
OF_ROWS = frozenset({"mass_matrix", "forcing"})
"""Those that programs give where the rows of a route are conjugate to u, in the order of u."""


def with_fixed(equations: Equations, fixed: Fixed, form: str) -> Equations:
    """The equations with the fixed values in their matrices, once form and values are possible.

    Raises
    ------
    InputError
        For a form that there is not, and a division by a parameter that is fixed to zero.
    SingularError
        If the equations do not determine the accelerations at the fixed values.
    """
    put = fix(equations, fixed) if equations.textbook is not None else equations
    if form != "auto":
        # A form that there is not is refused at once; the cheapest is found when it is needed.
        named_form(form, put)
    if equations.textbook is not None:
        return put
    if fixed:
        _determined(equations, fixed)
    return equations


def _determined(equations: Equations, fixed: Fixed) -> None:
    """Find the system for (u', lambda) regular at the fixed values: at a point of a field."""
    mechanism, rows = equations.program
    unknowns = (*mechanism.ud, *rows.multipliers)
    matrix = coefficients([*rows.values, *acceleration_forms(mechanism)], unknowns)
    program = mechanism.builder.program({"K": [entry for row in matrix for entry in row]})
    named = f"{equations.scene.name} by {equations.route}: with {words(fixed)} fixed,"
    try:
        other, found = bind(program, _numbers(fixed))
    except ExpressionError:
        raise InputError(
            f"{named} something is divided by zero: leave the parameter free"
        ) from None
    n = len(unknowns)
    table = [found["K"][n * i : n * (i + 1)] for i in range(len(matrix))]
    if Residues(other).rank(table) < n:
        raise SingularError(
            f"{named} the equations do not determine the accelerations: is a body left without"
            " mass?"
        )


def _numbers(fixed: Fixed) -> dict[str, sympy.Expr]:
    return {symbol.name: value for symbol, value in fixed.items()}


@dataclass(frozen=True, eq=False)
class Source:
    """Graphs of the outputs of equations.

    Attributes
    ----------
    equations : Equations
        With the fixed values, as `with_fixed` gives them.
    fixed : mapping of Symbol to Expr
    named : str
        Form of forward dynamics, or ``"auto"``.
    """

    equations: Equations
    fixed: Fixed
    named: str
    arrays: Arrays

    @cached_property
    def matrices(self) -> Textbook | None:
        """Graphs of matrices, where they are written out."""
        if self.equations.textbook is None:
            return None
        return Textbook(self.equations, self.fixed, self.named, self.arrays, self._from_bodies)

    @cached_property
    def programs(self) -> Outputs | None:
        """Programs of the mechanism; None where somebody gave matrices."""
        equations = self.equations
        if equations.mechanism is None:
            return None
        mechanism, rows = equations.program
        # A form of matrices is no form of programs beside them.
        form = "auto" if equations.textbook is not None else self.named
        programs = self._outputs(mechanism, form)
        if not (mechanism.constraints or mechanism.frictions):
            return programs
        choose = tried_pivots(self.arrays.quantities, _numbers(self.fixed))
        return replace(programs, route=rows, choose=choose)

    def _from_bodies(self, form: str) -> list[ca.SX]:
        """Graphs of (u', lambda) in a form that starts from the bodies, where it suits."""
        programs = self.programs
        if programs is None or any(f.name == form and f.unsuited(self.equations) for f in FORMS):
            return []
        graphs = [graphs_of(program, self.arrays) for program in programs.bound_ways(form)]
        return [ca.vertcat(*own.values()) for own in graphs]

    @property
    def form(self) -> str:
        """How forward dynamics is written: the name of one of `mechanics.compiled.FORMS`."""
        if self.matrices is not None:
            return self.matrices.form
        return "" if self.programs is None else self.programs.chosen

    def outputs(self, name: str) -> dict[str, ca.SX]:
        """The graphs of the outputs of a function."""
        if name in OF_BODIES or name in output_functions(mechanism_of(self.equations)):
            programs = self.programs or self._outputs(self.equations.kinematics.mechanism, "auto")
            return graphs_of(programs[name], self.arrays)
        if self.matrices is None:
            return self._from_programs(name, self.arrays)
        own = self.matrices.outputs(name)
        if not (self._tree and name in OF_EVERY_ROUTE | OF_ROWS):
            return own
        if name in OF_ROWS and not self._conjugate:
            return own
        constants = dict(self.arrays.constants)
        other = self._from_programs(name, replace(self.arrays, constants=constants))
        if instructions(other) >= instructions(own):
            return own
        self.arrays.constants.update(constants)
        return other

    def _outputs(self, mechanism: Mechanism, form: str) -> Outputs:
        """The programs of a mechanism in the arrays of the model."""
        known = self.arrays.quantities
        variables = {
            name: tuple(mechanism.builder.input(entry.name) for entry in getattr(known, name))
            for name in STATE
        }
        return Outputs(mechanism, variables, _numbers(self.fixed), form)

    @property
    def _tree(self) -> bool:
        """Whether nothing couples the bodies but their joints: beside matrices programs serve."""
        mechanism = self.equations.mechanism
        return mechanism is not None and not (mechanism.constraints or mechanism.frictions)

    @cached_property
    def _conjugate(self) -> bool:
        """Whether M and f of the rows are those of the programs, by values at a point of a field.

        It proposes only: what is compiled is compared with what was derived, as a proof.
        """
        if self.programs is None or self.equations.textbook is None:
            return False
        build = Builder()
        known = self.arrays.quantities
        groups = (known.q, known.u, known.inputs, known.p)
        inputs = {e.symbol: build.input(e.name) for group in groups for e in group}
        textbook = self.equations.textbook
        own = {"mass_matrix": textbook.mass, "forcing": textbook.forcing}
        filter_ = Residues(build)
        for name, matrix in own.items():
            (other,) = include(build, self.programs[name], {}).values()
            left = read(build, tuple(matrix), inputs)
            if len(left) != len(other) or filter_.values(left) != filter_.values(other):
                return False
        return True

    def _from_programs(self, name: str, arrays: Arrays) -> dict[str, ca.SX]:
        return {} if self.programs is None else graphs_of(self.programs[name], arrays)


def graphs_of(program: Program, arrays: Arrays) -> dict[str, ca.SX]:
    """The graphs of the outputs of a program; numbers that no double holds join the constants."""
    entries = {symbol.name: entry for symbol, entry in arrays.table.items()}
    n, sizes = len(arrays.quantities.ud), {name: arrays.columns[name].numel() for name in GROUPS}
    shapes = {f"ud_{group}": (n, sizes[group]) for group in STATE}
    shapes |= {"mass_matrix": (n, n), "multipliers": (sizes["multipliers"], 1)}
    shapes |= {"rotation": (3, 3), SLOPE: (len(program.outputs.get(SLOPE, ())) // n, n)}
    own = {output: shape for output, shape in shapes.items() if output in program.outputs}
    return print_graphs(program, entries, own, Translator({}, arrays.constants).named)
