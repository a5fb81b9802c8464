"""The four routes as programs, cross-checked: pairs, laws, and the textbook forms.

scene --> mechanism --> rows of each route --> pairs, laws
                          |
                          +--> the same accelerations as M u' = f + B lambda in SymPy
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from mechanics.checks import laws, reactions
from mechanics.checks.agreement import (
    Derived,
    check_multipliers,
    linear_system,
    maintaining_forces,
)
from mechanics.checks.statements import equal
from mechanics.clock import timed
from mechanics.equations import Equations
from mechanics.kernel import Finding
from mechanics.mechanism import Mechanism, name_of
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import dot
from mechanics.routes.derivation import ROUTES
from mechanics.routes.rows import substitute

DERIVATIONS = {route.name: route.rows for route in ROUTES}
"""By name of a route: what makes its rows."""


@dataclass(frozen=True)
class Programs:
    """What the routes derive from one mechanism, and how long each took, in s."""

    mechanism: Mechanism
    routes: Mapping[str, Derived]
    seconds: Mapping[str, float]

    @property
    def filter_(self) -> Residues:
        """A filter for proposals of pivots, none of which is zero where the constraints hold."""
        return self.mechanism.filters[1]

    def route(self, name: str) -> Derived:
        """A route, derived now if nobody asked for it."""
        if name in self.routes:
            return self.routes[name]
        return linear_system(self.mechanism, DERIVATIONS[name](self.mechanism), self.filter_)

    def operations(self, name: str) -> int:
        """Operations of a route's rows, shared ones once."""
        return self.mechanism.builder.program({"rows": self.routes[name].rows.values}).count


def derive_rows(
    mechanism: Mechanism, names: Sequence[str], stage: Callable[[str], None] | None = None
) -> Programs:
    """Rows by the named routes.

    Raises
    ------
    SingularError
        When the first route does not determine the accelerations.
    """
    _, filter_ = mechanism.filters
    routes: dict[str, Derived] = {}
    seconds = {}
    for name in names:
        if stage is not None:
            stage(f"deriving by {name}")
        rows, seconds[name] = timed(partial(DERIVATIONS[name], mechanism))
        routes[name] = linear_system(mechanism, rows, filter_)
    return Programs(mechanism, routes, seconds)


def check_laws(programs: Programs) -> Iterator[Finding]:
    """Kinematics, loads, reactions, mass matrix and energy.

    Kane's rows serve the checks that need a route whose multipliers are the declared reactions,
    those of procedure (i) the checks that need all reactions.
    """
    mechanism, routes = programs.mechanism, programs.routes
    yield laws.check_kinematics(mechanism)
    yield from laws.check_potentials(mechanism)
    yield from laws.check_dampers(mechanism)
    yield from laws.check_frictions(mechanism)
    yield from laws.check_ideal(mechanism, programs.filter_)
    for derived in routes.values():
        if derived.rows.conjugate:
            yield laws.check_mass_matrix(mechanism, derived.rows)
    driven = laws.is_driven(mechanism)
    balanced = driven or mechanism.constraints or mechanism.frictions
    support = programs.route("free_body") if balanced else None
    for derived in routes.values():
        if derived.rows.conjugate and not driven:
            yield laws.check_energy(mechanism, derived.rows)
        elif support is not None:
            yield laws.check_energy_balance(derived, support)
    if "free_body" in routes and mechanism.reactions:
        yield reactions.check_reactions(routes["free_body"].rows, programs.route("kane"))
    if "lagrange" in routes and mechanism.constraints:
        yield check_multipliers(programs.route("kane"), routes["lagrange"])


def solved(programs: Programs, name: str) -> Program:
    """u' and the reactions of a route as one program, in the scene's plain symbols."""
    mechanism, derived = programs.mechanism, programs.routes[name]
    rows, unknowns, values = derived.rows, derived.unknowns, derived.solution
    outputs: dict[str, Sequence[Node]] = {"ud": values[: len(mechanism.u)]}
    declared = {reaction.name for reaction in mechanism.reactions}
    build = mechanism.builder
    for unknown, value in zip(unknowns, values, strict=True):
        if (own := build.inputs[build.operands[0][unknown.number]]) in declared:
            outputs[own] = [value]
    if rows.reactions:
        told = substitute(
            build, tuple(rows.reactions.values()), dict(zip(unknowns, values, strict=True))
        )
        outputs |= {own: [value] for own, value in zip(rows.reactions, told, strict=True)}
    return build.program(outputs)


def check_textbook(programs: Programs, derived: Mapping[str, Equations]) -> Iterator[Finding]:
    """The matrices of each route, written in SymPy, give the accelerations of its program.

    They give its multipliers, too, where both keep some: by name, or as generalized forces.
    """
    for name, equations in derived.items():
        yield same_motion(f"{name}: program = textbook form", programs, name, equations)


def same_motion(subject: str, programs: Programs, name: str, equations: Equations) -> Finding:
    """Whether matrices in SymPy give the accelerations and multipliers of a route's program."""
    mechanism, own = programs.mechanism, programs.routes[name]
    build, size = mechanism.builder, len(mechanism.u)
    left, right = equations.system
    flat = read(build, [*left, *right])
    matrix = _rows(flat, left.cols)[: left.cols]
    solved = build.solve(matrix, flat[left.cols**2 :])
    one, two = list(own.accelerations), list(solved[:size])
    names = [name_of(multiplier) for multiplier in own.rows.multipliers]
    if names == [symbol.name for symbol in equations.multipliers]:
        one, two = list(own.solution), list(solved)
    elif equations.multipliers and equations.conjugate:
        forces = _rows(read(build, [*equations.reaction_matrix]), left.cols - size)
        one += maintaining_forces(own)
        two += [dot(row, solved[size:]) for row in forces]
    return equal(subject, mechanism, one, two)


def _rows(flat: Sequence[Node], width: int) -> list[Sequence[Node]]:
    return [flat[i : i + width] for i in range(0, len(flat), width)]
