"""The outputs of a mechanism as programs, from the cheapest way to its rows.

    inverse dynamics    tau = rows(q, u, u')                 Newton and Euler's recursion, or Kane's
    residual            the same: M u' - f
    mass matrix         M = d tau / d u', or composite bodies
    forcing             f = -tau(q, u, 0)
    forward dynamics    M u' = f, articulated bodies, or Gauss's principle
    outputs of a scene  positions, orientations and velocities composed along the chain
    jacobians           M dx = -(d tau)(q, u, x)             x = u', along each entry of the state,
                        or the derivatives of articulated bodies

With constraints A u' = b, maintained by reactions lambda, M u' = f + B lambda: the residual has the
rows of the constraints, too, x = (u', lambda) is found by `mechanics.compiled.bordered`, and the
inverse dynamics are the forces to be added, tau = rows(q, u, u', lambda(q, u)).

All rows are power-conjugate to u, so that they are equal and not only equivalent: which of them an
output is made from is a matter of operations alone. Friction couples the rows with the reactions
that press, and the rows are those of the route. Each is shown by the laws of
`mechanics.compiled.translation_validation`. Parameters that are fixed are numbers before operations
are counted.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property, partial

from sympy import Expr

from mechanics.compiled.bordered import Bordered, Choose, bind, bordered
from mechanics.compiled.forms.bodies import joint_trees
from mechanics.compiled.forms.members import (
    ARTICULATED,
    COMPOSITE,
    ELIMINATION,
    RECURSIVE,
    SPARSE,
    Form,
)
from mechanics.equations import FEW
from mechanics.equations import Rows as RouteRows
from mechanics.errors import ExpressionError, SingularError
from mechanics.kinematics import chain
from mechanics.kinematics.energy import HALF, kinetic_energies
from mechanics.kinematics.motion import poses
from mechanics.kinematics.outputs import output_functions, output_matrix
from mechanics.mechanism import Mechanism, Output, name_of
from mechanics.program import Program
from mechanics.program.builder import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.differences import with_one_difference
from mechanics.program.elimination import expand_solves
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.program.value_numbering import with_one_value
from mechanics.program.vectors import Vector, add, cross, scale, times, zeros
from mechanics.recursions import constrained_trees, least_constraint, newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import Link
from mechanics.recursions.local_equations import jacobian
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes import free_body, kane
from mechanics.routes.loads import potential
from mechanics.routes.rows import acceleration_forms, coefficients, remainder, substitute

Rows = tuple[Node, ...]
Outcome = dict[str, Sequence[Node]]


def kane_rows(mechanism: Mechanism) -> Rows:
    """Rows by partial velocities, inertial components."""
    return kane.derive(mechanism).values


def plain_recursion(mechanism: Mechanism) -> Rows:
    """Rows by recursion, with masses and inertias as they are declared."""
    return newton_euler.rows(mechanism, moments(mechanism))


def grouped_recursion(mechanism: Mechanism) -> Rows:
    """Rows by recursion, with masses and inertias grouped over the joints."""
    return newton_euler.rows(mechanism, grouped(mechanism))


ROWS: tuple[Callable[[Mechanism], Rows], ...] = (kane_rows, plain_recursion, grouped_recursion)
"""Ways to the same rows."""


@dataclass(frozen=True)
class Solvable:
    """M and f of rows that are linear in u'."""

    mass: Sequence[Sequence[Node]]
    forcing: Sequence[Node]

    def accelerations(self, build: Builder) -> Rows:
        """u' of M u' = f."""
        return build.solve(self.mass, self.forcing, symmetric=True)


def solvable(build: Builder, rows: Sequence[Node], accelerations: Sequence[Node]) -> Solvable:
    """M and f of rows that are linear in u'."""
    rest = remainder(build, rows, accelerations)
    return Solvable(coefficients(rows, accelerations), [-entry for entry in rest])


SAFE = 1.25
"""How many times the operations a way may take that rounds better, where errors are not tried."""


@dataclass(frozen=True, eq=False)
class Outputs:
    """The programs of a mechanism by name, each made when it is first asked for.

    Attributes
    ----------
    mechanism : Mechanism
    variables : mapping of str to tuple of Node
        What the derivatives of accelerations are taken by, by name of the group.
    fixed : mapping of str to Expr
        Exact values of parameters.
    form : str
        Of forward dynamics, the name of one of `mechanics.compiled.FORMS`, or ``"auto"``.
    route : RouteRows or None
        What the route derived; needed for constraints and friction.
    choose : callable or None
        Of pivots at drawn states; needed for these, too.
    """

    mechanism: Mechanism
    variables: Mapping[str, Rows]
    fixed: Mapping[str, Expr] = field(default_factory=dict)
    form: str = "auto"
    route: RouteRows | None = None
    choose: Choose | None = None

    def __getitem__(self, name: str) -> Program:
        """The program of an output; see `mechanics.compiled.Model`."""
        if name not in self._made:
            self._made[name] = self._programs[name]()
        return self._made[name]

    @cached_property
    def _made(self) -> dict[str, Program]:
        return {}

    @cached_property
    def _programs(self) -> dict[str, Callable[[], Program]]:
        mechanism = self.mechanism
        return {
            "forward_dynamics": lambda: self._forward_dynamics[1],
            "mass_matrix": self._mass_matrix,
            "forcing": lambda: self._bound({"forcing": self.system.forcing}),
            "residual": lambda: self._bound({"residual": (*self._rows, *self._closing)}),
            "inverse_dynamics": self._inverse_dynamics,
            "energy": self._energy,
            "momenta": self._momenta,
            "coordinate_rates": lambda: self._bound({"qd": mechanism.q_rates}),
            "jacobians": self._jacobians,
            "reactions": self._reactions,
        } | {name: partial(self._wanted, *of) for name, of in output_functions(mechanism).items()}

    @property
    def chosen(self) -> str:
        """The form of forward dynamics."""
        return self._forward_dynamics[0]

    def _bound(self, outputs: Mapping[str, Sequence[Node]]) -> Program:
        """Nodes as a program, numbers in place of fixed parameters, linear systems written out."""
        program = self.mechanism.builder.program(outputs)
        if self.fixed:
            build, nodes = bind(program, self.fixed)
            program = build.program(nodes)
        return with_one_difference(expand_solves(program))

    def _cheapest(self, candidates: Iterable[Outcome]) -> Program:
        """The program of the fewest operations; the first of several."""
        return min(map(self._bound, candidates), key=operations)

    @cached_property
    def _rows(self) -> Rows:
        mechanism, route = self.mechanism, self.route
        if mechanism.frictions and route is not None:
            return route.values
        ways = [rows(mechanism) for rows in ROWS]
        if route is not None:
            ways = [maintained(mechanism, rows, route) for rows in ways]
        return min(ways, key=lambda rows: operations(self._bound({"rows": rows})))

    @cached_property
    def _closing(self) -> Rows:
        """A u' - b."""
        return tuple(acceleration_forms(self.mechanism))

    @cached_property
    def system(self) -> Solvable:
        """M and f, the multipliers left out."""
        build, route = self.mechanism.builder, self.route
        rows = self._rows
        if route is not None:
            rows = remainder(build, rows, route.multipliers)
        return solvable(build, rows, self.mechanism.ud)

    @cached_property
    def _bordered(self) -> Bordered | None:
        """The system for u' and the multipliers, where there are constraints or friction."""
        mechanism, route = self.mechanism, self.route
        if route is None or self.choose is None:
            return None
        conjugate = not mechanism.frictions or route.conjugate
        return bordered(
            mechanism, self._rows, route.multipliers, conjugate, self.choose, self.fixed
        )

    @cached_property
    def _trees(self) -> list[tuple[Link, ...]]:
        return joint_trees(self.mechanism)

    @cached_property
    def _accelerations(self) -> list[tuple[str, Rows]]:
        """u' and the multipliers in every form that was asked for."""
        chosen = [
            (name, nodes)
            for name in (ELIMINATION.name, *(form.name for form in self._from_bodies))
            if self.form in (name, "auto")
            for nodes in self.ways(name)
        ]
        if not chosen:
            raise SingularError(
                f"form {self.form!r} of {self.mechanism.name} gives no accelerations that satisfy"
                " M u' = f: choose another one, or 'auto'"
            )
        return chosen

    @property
    def _from_bodies(self) -> tuple[Form, ...]:
        """Forms to choose among.

        Gauss's principle is for many bodies in a plane, and for bodies that no joints of one
        freedom hold, where of the others elimination alone is left.
        """
        mechanism = self.mechanism
        flat = all(body.inertia is None or body.scalar for body in mechanism.bodies)
        many = len(mechanism.ud) + len(mechanism.constraints) > FEW
        wanted = self.form != "auto" or (flat and many)
        wanted = wanted or not joint_trees(replace(mechanism, constraints=()))
        least = (RECURSIVE, SPARSE) if wanted else ()
        return (COMPOSITE, ARTICULATED, *least)

    def ways(self, form: str) -> list[Rows]:
        """u' and the multipliers in a form, each way shown to solve the rows at a point of a field.

        It is proved once more when it is compiled.
        """
        ways = self._ways[form]
        return [nodes for nodes in ways() if self._solves(nodes)]

    @cached_property
    def _ways(self) -> dict[str, Callable[[], list[Rows]]]:
        return {
            ELIMINATION.name: self._eliminated,
            COMPOSITE.name: self._composite,
            ARTICULATED.name: self._articulated,
            RECURSIVE.name: lambda: [] if self._constrained else self._least(),
            SPARSE.name: lambda: self._least() if self._constrained else [],
        }

    def _solves(self, nodes: Rows) -> bool:
        mechanism = self.mechanism
        unknowns = mechanism.ud
        if self._bordered is not None and self.route is not None:
            unknowns = (*unknowns, *self.route.multipliers)
        # Rows with the dependent speeds put in hold no multipliers; those that are solved do.
        reduced = self.route is not None and self._constrained and not self.route.multipliers
        rows = self.route.values if reduced and self.route is not None else self._rows
        form = (*rows, *self._closing)
        values = dict(zip(unknowns, nodes, strict=True))
        filter_ = Residues(mechanism.builder)
        return all(map(filter_.is_zero, substitute(mechanism.builder, form, values)))

    @property
    def _constrained(self) -> bool:
        return bool(self.mechanism.constraints)

    def _eliminated(self) -> list[Rows]:
        if self._bordered is not None:
            return [self._bordered.solution] if self._bordered.determined else []
        return [self.system.accelerations(self.mechanism.builder)]

    def _composite(self) -> list[Rows]:
        """With constraints where the tree that remains without loops is one of joints."""
        mechanism, found = self.mechanism, []
        if mechanism.frictions or (self._bordered is not None and not self._bordered.determined):
            return []
        for links in joint_trees(replace(mechanism, constraints=())):
            mass = mass_matrix(mechanism, links)
            if self._bordered is not None:
                found.append(replace(self._bordered, mass=mass).solution)
            else:
                found.append(Solvable(mass, self.system.forcing).accelerations(mechanism.builder))
        return found + self._constrained_trees()

    def _constrained_trees(self) -> list[Rows]:
        """With the constraints composed along the bodies, which their reactions tell."""
        held = self._bordered
        if held is None or not held.symmetric or not self._constrained:
            return []
        return [
            (*ud, *held.multipliers(mu))
            for ud, mu in constrained_trees.forward_dynamics(self.mechanism, self._closing)
        ]

    def _articulated(self) -> list[Rows]:
        bias = [-entry for entry in self.system.forcing]
        return [forward_dynamics(self.mechanism, links, bias) for links in self._trees]

    def _least(self) -> list[Rows]:
        """By Gauss's principle: on the safe side where errors are not tried, unless that costs."""
        mechanism, held, found = self.mechanism, self._bordered, []
        if mechanism.frictions:
            return []
        for way in least_constraint.WAYS:
            try:
                if held is None:
                    nodes = least_constraint.forward_dynamics(mechanism, way)
                else:
                    matrix, bias = held.constraint_matrix, held.constraint_bias
                    nodes = least_constraint.forward_dynamics(mechanism, way, matrix, bias)
                    n = len(mechanism.ud)
                    nodes = (*nodes[:n], *held.multipliers(nodes[n:]))
            except (ExpressionError, SingularError):
                continue  # this way has no solution here; another may have
            found.append((way.inertial, operations(self._bound({"x": nodes})), nodes))
        if len(mechanism.ud) <= FEW or not found:
            return [nodes for _, _, nodes in found]
        few = min(count for _, count, _ in found)
        safe = [nodes for inertial, count, nodes in found if inertial and count <= SAFE * few]
        return safe or [nodes for _, _, nodes in found]

    def bound_ways(self, form: str) -> list[Program]:
        """The programs of `ways`."""
        return [self._solution(nodes) for nodes in self.ways(form)]

    def _solution(self, nodes: Rows) -> Program:
        n = len(self.mechanism.ud)
        program = self._bound({"ud": nodes[:n], "multipliers": nodes[n:]})
        return with_one_difference(with_one_value(program)) if self._constrained else program

    @cached_property
    def _forward_dynamics(self) -> tuple[str, Program]:
        ways = [(form, self._solution(nodes)) for form, nodes in self._accelerations]
        return min(ways, key=lambda way: operations(way[1]))

    def _inverse_dynamics(self) -> Program:
        """The multipliers are those of the motion that the loads alone give."""
        if self._bordered is None or self.route is None or not self.route.multipliers:
            return self._bound({"forces": self._rows})
        n, names = len(self.mechanism.ud), self.route.multipliers
        return self._cheapest(
            {"forces": substitute(
                self.mechanism.builder, self._rows, dict(zip(names, nodes[n:], strict=True)))}
            for _, nodes in self._accelerations
        )  # fmt: skip

    @cached_property
    def _masses(self) -> list[Sequence[Sequence[Node]]]:
        found = [self.system.mass]
        return found + [mass_matrix(self.mechanism, links) for links in self._trees]

    def _mass_matrix(self) -> Program:
        return self._cheapest({"mass_matrix": _flat(mass)} for mass in self._masses)

    def _wanted(self, output: Output, slope: bool) -> Program:
        """What the scene wants computed."""
        motions = chain.motions(self.mechanism)
        name, matrix = output_matrix(self.mechanism, motions, output, slope)
        return self._bound({name: _flat(matrix)})

    def _energy(self) -> Program:
        return self._cheapest(energies(self.mechanism))

    def _momenta(self) -> Program:
        """dT/du, or M u where this is the same: where nothing moves as prescribed."""
        mechanism, own, filter_ = self.mechanism, momenta(self.mechanism), self.mechanism.filters[0]
        masses = replace(self, route=None, choose=None)._masses
        ways = [list(times(mass, mechanism.u)) for mass in masses]
        want = filter_.values(own["generalized"])
        same = [own | {"generalized": way} for way in ways if filter_.values(way) == want]
        return self._cheapest((own, *same))

    def _jacobians(self) -> Program:
        """One group after the other, row by row."""
        mechanism = self.mechanism
        if self._bordered is not None:
            return self._bound(self._constrained_jacobians(self._bordered))
        if not self._trees:
            return self._bound(jacobians(mechanism, self._rows, self.system, self.variables))
        groups = list(self.variables.values())
        every = tuple(node for group in groups for node in group)

        def price(links: tuple[Link, ...]) -> int:
            """Operations of the first columns, which stand for all."""
            rows = jacobian(mechanism, links, groups[0])
            return operations(self._bound({"rows": _flat(rows)}))

        links = min(self._trees, key=price) if len(self._trees) > 1 else self._trees[0]
        return self._bound(self._split(jacobian(mechanism, links, every)))

    def _constrained_jacobians(self, system: Bordered) -> Outcome:
        """K dx = -(dK x - dk) along each entry of the state, x = (u', lambda) as it was solved."""
        assert self.route is not None
        mechanism, unknowns = self.mechanism, (*self.mechanism.ud, *self.route.multipliers)
        form = (*self._rows, *self._closing)
        values = dict(zip(unknowns, system.solution, strict=True))
        found: Outcome = {}
        for name, group in self.variables.items():
            columns = []
            for entry in group:
                slopes = tangent(form, {entry: mechanism.builder.one})
                moved = substitute(mechanism.builder, slopes, values)
                columns.append(system.solve([-slope for slope in moved]))
            n = len(mechanism.ud)
            found[f"ud_{name}"] = [column[i] for i in range(n) for column in columns]
        return found

    def _split(self, rows: Sequence[Sequence[Node]]) -> Outcome:
        found: Outcome = {}
        start = 0
        for name, group in self.variables.items():
            end = start + len(group)
            found[f"ud_{name}"] = [entry for row in rows for entry in row[start:end]]
            start = end
        return found

    def _reactions(self) -> Program:
        """All reactions as functions of the state, by procedure (i), in the order of the scene."""
        mechanism, route = self.mechanism, self.route
        nodes = every_reaction(mechanism)
        unknowns, ways = mechanism.ud, [values for _, values in self._accelerations]
        if route is not None and self.choose is not None:
            names = tuple(map(name_of, route.multipliers))
            if names != tuple(mechanism.reactions[i].name for i in mechanism.multipliers):
                # Multipliers of another kind: those of Kane's rows are the reactions.
                own = kane.derive(mechanism)
                solved = bordered(
                    mechanism, own.values, own.multipliers, own.conjugate, self.choose, self.fixed
                )
                unknowns, ways = (*unknowns, *own.multipliers), [solved.solution]
            else:
                unknowns = (*unknowns, *route.multipliers)
        return self._cheapest(
            {"reactions": substitute(
                mechanism.builder, nodes, dict(zip(unknowns, values, strict=True)))}
            for values in ways
        )  # fmt: skip


def every_reaction(mechanism: Mechanism) -> list[Node]:
    """All reactions by procedure (i) in u' and those that maintain constraints, in their order."""
    told = free_body.derive(mechanism).reactions
    names = [reaction.name for reaction in mechanism.reactions]
    return [told[name] if name in told else mechanism.builder.input(name) for name in names]


def maintained(mechanism: Mechanism, rows: Rows, route: RouteRows) -> Rows:
    """Rows with the multipliers of a route, if it has any: declared reactions, or of A^T lambda."""
    build = mechanism.builder
    declared = [build.input(mechanism.reactions[index].name) for index in mechanism.multipliers]
    if list(route.multipliers) == declared:
        return rows
    free = remainder(build, rows, declared)
    if not route.multipliers:
        return free
    pulls = gradient(acceleration_forms(mechanism), route.multipliers, mechanism.ud)
    return tuple(row - pull for row, pull in zip(free, pulls, strict=True))


def operations(program: Program) -> int:
    """What a program costs: its operations."""
    return program.count


def _flat(matrix: Sequence[Sequence[Node]]) -> list[Node]:
    return [entry for row in matrix for entry in row]


def jacobians(
    mechanism: Mechanism, rows: Rows, system: Solvable, variables: Mapping[str, Rows]
) -> Outcome:
    """Derivatives of u' by groups of variables, row by row.

    One solution of M serves every column: differentiating through it costs more.
    """
    build = mechanism.builder
    accelerations = system.accelerations(build)
    values = dict(zip(mechanism.ud, accelerations, strict=True))
    found: Outcome = {}
    for name, group in variables.items():
        columns = []
        for entry in group:
            slopes = tangent(rows, {entry: build.one})
            right = [-slope for slope in substitute(build, slopes, values)]
            columns.append(build.solve(system.mass, right, symmetric=True))
        found[f"ud_{name}"] = [column[i] for i in range(len(rows)) for column in columns]
    return found


def energies(mechanism: Mechanism) -> list[Outcome]:
    """Kinetic, potential and total energy, in J, in q and u; halved body by body, or at the end."""
    stored = potential(mechanism, poses(mechanism))
    return [
        {"kinetic": [kinetic], "potential": [stored], "total": [kinetic + stored]}
        for kinetic in (_kinetic(mechanism, HALF), _kinetic(mechanism, Fraction(1)) / 2)
    ]


def _kinetic(mechanism: Mechanism, factor: Fraction) -> Node:
    parts = kinetic_energies(mechanism, mechanism.rates, factor)
    return sum((part for body in parts for part in body), mechanism.builder.zero)


def momenta(mechanism: Mechanism) -> Outcome:
    """Linear momentum, angular momentum about the origin, and dT/du."""
    linear: Vector = zeros(mechanism.builder)
    angular = linear
    motions, turning = chain.motions(mechanism), chain.own_rates(mechanism, mechanism.rates)
    for body in mechanism.bodies:
        centre = motions.points[body.centre]
        momentum = scale(body.mass, centre.velocity)
        linear = add(linear, momentum)
        angular = add(angular, cross(centre.position, momentum))
        if body.frame is not None and body.inertia is not None:
            spin = times(body.inertia, turning[body.frame])
            angular = add(angular, times(motions.frames[body.frame].rotation, spin))
    generalized = gradient([_kinetic(mechanism, HALF)], [1], mechanism.u)
    return {"linear": linear, "angular": angular, "generalized": generalized}
