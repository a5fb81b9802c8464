"""The functions of a model from programs, for scenes too large to be written out.

What an output is made from is chosen in `mechanics.compiled.outputs`; numbers that no double holds
stay exact, as named constants.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
import sympy

from mechanics.compiled.bordered import bind, tried_pivots
from mechanics.compiled.fixed import Fixed, words
from mechanics.compiled.outputs import FORMS, Outputs
from mechanics.compiled.quantities import STATE, Quantities
from mechanics.equations import ProgramEquations
from mechanics.errors import ExpressionError, InputError, SingularError
from mechanics.mechanism import Mechanism
from mechanics.program.casadi_printer import print_graphs
from mechanics.program.residues import Residues
from mechanics.routes.rows import Rows, acceleration_forms, coefficients


@dataclass(frozen=True, eq=False)
class ProgramSource:
    """Graphs of the outputs of a mechanism.

    Attributes
    ----------
    equations : ProgramEquations
    fixed : mapping of Symbol to Expr
    named : str
        Form of forward dynamics, or ``"auto"``.
    quantities : Quantities
    columns : mapping of str to casadi.SX
        The arrays.
    constants : dict of Expr to casadi.SX
        Numbers that no double holds, as they are found.

    Raises
    ------
    InputError
        For a form that there is not, and a division by a parameter that is fixed to zero.
    SingularError
        If the rows do not determine the accelerations at the fixed values.
    """

    equations: ProgramEquations
    fixed: Fixed
    named: str
    quantities: Quantities
    columns: Mapping[str, ca.SX]
    constants: dict[sympy.Expr, ca.SX]

    def __post_init__(self) -> None:
        mechanism = self.equations.mechanism
        if self.named not in ("auto", *FORMS):
            raise InputError(
                f"form {self.named!r}: the equations of {mechanism.name} are too long to be written"
                f" out: choose among {', '.join(FORMS)}, or 'auto'"
            )
        if self.fixed:
            self._determined()

    def _determined(self) -> None:
        """Find the system for (u', lambda) regular at the fixed values: at a point of a field."""
        of, mechanism = self.equations, self.equations.mechanism
        unknowns = (*mechanism.ud, *of.multipliers)
        matrix = coefficients([*of.values, *acceleration_forms(mechanism)], unknowns)
        program = mechanism.builder.program({"K": [entry for row in matrix for entry in row]})
        named = f"{of.scene.name} by {of.route}: with {words(self.fixed)} fixed,"
        try:
            other, found = bind(program, self._numbers)
        except ExpressionError:
            raise InputError(
                f"{named} something is divided by zero: leave the parameter free"
            ) from None
        n = len(unknowns)
        filter_ = Residues(other)
        values = filter_.values(found["K"])
        table = [values[n * i : n * (i + 1)] for i in range(len(matrix))]
        if len(filter_.eliminate(table, n)) < n:
            raise SingularError(
                f"{named} the equations do not determine the accelerations: is a body left without"
                " mass?"
            )

    @property
    def _numbers(self) -> dict[str, sympy.Expr]:
        return {symbol.name: value for symbol, value in self.fixed.items()}

    @cached_property
    def programs(self) -> Outputs:
        """What each function computes, exactly."""
        mechanism, numbers = self.equations.mechanism, self._numbers
        programs = outputs_of(mechanism, self.quantities, numbers, self.named)
        if not (mechanism.constraints or mechanism.frictions):
            return programs
        of = self.equations
        rows = Rows(of.route, of.values, of.multipliers, of.conjugate, of.reactions)
        return replace(programs, route=rows, choose=tried_pivots(self.quantities, numbers))

    @property
    def form(self) -> str:
        """How forward dynamics is written: one of `mechanics.compiled.outputs.FORMS`."""
        return self.programs.chosen

    def outputs(self, name: str) -> dict[str, ca.SX]:
        """The graphs of the outputs of a function."""
        return graphs_of(name, self.programs, self.quantities, self.columns, self.constants)


def outputs_of(
    mechanism: Mechanism, quantities: Quantities, fixed: Mapping[str, sympy.Expr], form: str
) -> Outputs:
    """The programs of a mechanism in the arrays of a model."""
    variables = {
        name: tuple(mechanism.builder.input(entry.name) for entry in getattr(quantities, name))
        for name in STATE
    }
    return Outputs(mechanism, variables, fixed, form)


def graphs_of(
    name: str,
    programs: Outputs,
    quantities: Quantities,
    columns: Mapping[str, ca.SX],
    constants: dict[sympy.Expr, ca.SX],
) -> dict[str, ca.SX]:
    """The graphs of the outputs of a function; numbers that no double holds join the constants."""
    groups = {group: getattr(quantities, group) for group in (*STATE, "ud", "multipliers")}
    entries = {
        entry.name: columns[group][i]
        for group, of_group in groups.items()
        for i, entry in enumerate(of_group)
    }
    n = len(quantities.ud)
    shapes = {f"ud_{group}": (n, len(groups[group])) for group in STATE}
    shapes |= {"mass_matrix": (n, n), "multipliers": (len(quantities.multipliers), 1)}
    program = programs[name]

    def named(number: sympy.Expr) -> ca.SX:
        if number not in constants:
            constants[number] = ca.SX.sym(f"c{len(constants)}")
        return constants[number]

    own = {output: shape for output, shape in shapes.items() if output in program.outputs}
    return print_graphs(program, entries, own, named)
