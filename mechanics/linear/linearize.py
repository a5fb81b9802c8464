"""Linearization about a state of rest or a steady motion, which is first proved to be one.

    F(q, v, v', w) = 0,   q' = f(q, v),   phi(q) = 0          independent speeds v           (1)
    v' = 0,  q_e' = 0,  F = 0,  phi = 0     there; what drifts has no effect                 (2)

    q_e - q_e0 = G x,     x' = X x + Y dv                     phi and q' to first order      (3)
    (z_1, z_2)' = (X x, 0) + Y dv             z_1 = x, z_2 drifts by itself: Y is square     (4)
    F_v' dv' + F_v dv + F_q G x + F_w dw = 0                  dv = Y^-1 (z' - X x)           (5)

(5) in z is M z'' + C z' + K z = E(w). Rows that are power-conjugate to v are taken times Y^-T and
are then conjugate to z'. At rest every coordinate stays; about a steady motion those without effect
leave, but as many as the speeds need: z_2, of which K has zero columns.
"""

import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, Integer, Symbol, sympify

from mechanics.claims.kinds import angular
from mechanics.equations import Equations
from mechanics.errors import (
    ExpressionError,
    InputError,
    SingularError,
    ZeroDivisorError,
    wanted,
)
from mechanics.kernel import Finding, Statement, Verdict, decide
from mechanics.kinematics.euler_angles import singular_angles
from mechanics.kinematics.printer import symbols
from mechanics.linear.algebra import written
from mechanics.linear.effect import accelerations, depends, effective
from mechanics.linear.form import Linear
from mechanics.linear.nodes import Rows, difference, inverse, padded, product
from mechanics.linear.operating_point import (
    OperatingPoint,
    Place,
    Values,
    missing,
    operating_point,
    pivots,
)
from mechanics.linear.outputs import entries, entry_names, not_linear, output_rows
from mechanics.linear.reduction import Reduction, as_rows, reduction
from mechanics.mechanism import name_of, ranges
from mechanics.program.builder import Node
from mechanics.program.elimination import solve_with_pivots
from mechanics.program.operations import ABS, FLOOR, SIGN
from mechanics.program.program import reachable
from mechanics.program.sympy_printer import expressions
from mechanics.routes.rows import coefficients
from mechanics.scene import Scene
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS
from mechanics.symbolic.arithmetic import range_of


def linearize(
    equations: Equations,
    at: Values,
    inputs: Values | None = None,
    parameters: Mapping[Symbol, Expr] | None = None,
    speeds: Values | None = None,
) -> Linear:
    """Linearize equations of motion about a state of rest or a steady motion.

    Parameters
    ----------
    equations : Equations
        By any route.
    at : mapping
        Values of coordinates, by name, dynamic symbol or plain symbol: of all of them at rest; of a
        steady motion those that have no effect, as the angle of a wheel, may be left out.
    inputs : mapping, optional
        A value for every input of the scene.
    parameters : mapping of Symbol to Expr, optional
        Relations between parameters that hold there, ``{l3: l1}`` for a parallelogram.
    speeds : mapping, optional
        Speeds of a steady motion, or rates of inputs that move something: numbers, or expressions
        in parameters and in symbols of their own, ``{"u2": v / R}``. Speeds that the constraints
        give may be left out; others that are left out are zero.

    Returns
    -------
    Linear

    Raises
    ------
    InputError
        If a value is missing, a name unknown, a constraint broken, or the point neither an
        equilibrium nor a steady motion: the message gives the force or the rate that is left over.
    ExpressionError
        If it cannot be told whether it is one.
    SingularError
        If M is singular there: Euler angles of a top that is upright.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> linear = linearize(derive(rod_pendulum.scene()), {"theta": 0}, {"u": 0})
    >>> linear.mass, linear.stiffness
    (Matrix([[l**2*m/3]]), Matrix([[-g*l*m/2]]))
    """
    wanted(equations, Equations, "linearize", "pass derive(scene, route)")
    scene = equations.scene
    related = {**equations.fixed, **(parameters or {})}
    related = {symbol: sympify(value) for symbol, value in related.items()}
    point = operating_point(scene, at, inputs or {}, speeds or {}, related)
    try:
        expansion = _expansion(equations, point, related)
        expansion.verify()
        return expansion.linear()
    except ZeroDivisorError as error:
        turning = angular(scene)
        where = point.words({q: q in turning for q in scene.q})
        raise InputError(
            f"{scene.name}: the equations divide by zero at {where}: take another place"
        ) from error


def _expansion(
    equations: Equations, point: OperatingPoint, related: Mapping[Symbol, Expr]
) -> "Expansion":
    """The equations with the values of the operating point put in."""
    scene, derived = equations.scene, as_rows(equations)
    builder = derived[0].builder
    # What is not given has no effect, or is refused below: it may have any value.
    table = {q.name: Integer(0) for q in scene.q}
    table |= {s.name: value for s, value in {**related, **point.point}.items()}
    still = [w.name + dots for w in scene.input_symbols for dots in DOTS[1:]]
    table |= dict.fromkeys(still, Integer(0))
    table |= {s.name: value for s, value in point.speeds.items() if s.name in table}
    place = Place(builder, table)
    given = {s.name for s, value in point.speeds.items() if value != 0}
    moving = reduction(equations, derived, place, given)
    table = dict(table) | {name_of(node): Integer(0) for node in (*moving.v, *moving.vd)}
    table |= {symbol.name: value for symbol, value in point.speeds.items()}
    kept = tuple(sorted(effective(moving, related))) if point.moves else tuple(range(len(scene.q)))
    whole = Place(builder, table, place.builder)
    return Expansion(equations, point, moving, whole, kept)


@dataclass(frozen=True, eq=False)
class Expansion:
    """Equations at an operating point, to first order.

    Attributes
    ----------
    place : Place
        Where all values are put in.
    kept : tuple of int
        Coordinates whose deviations count.
    """

    equations: Equations
    point: OperatingPoint
    reduction: Reduction
    place: Place
    kept: tuple[int, ...]

    @property
    def scene(self) -> Scene:
        """The scene of the equations."""
        return self.equations.scene

    @cached_property
    def names(self) -> dict[str, Symbol]:
        """The symbol of each name, those of the given values among them."""
        values = (*self.point.point.values(), *self.point.speeds.values())
        values = (*values, *self.point.parameters.values())
        own = {s.name: s for value in values for s in sympify(value).free_symbols}
        return {**own, **symbols(self.scene)}

    # ------------------------------------------------------------------ the operating point

    def verify(self) -> None:
        """Refuse what is neither a state of rest nor a steady motion."""
        scene, moving = self.scene, self.reduction
        for i in self.kept:
            if scene.q[i] not in self.point.coordinates:
                raise missing(scene, "coordinate", scene.q[i])
        words = (
            "give coordinates that satisfy the constraints exactly (at=, or --at NAME=VALUE once"
            " for each): numbers as 1/3 or pi/2, or formulas in the parameters as l/3"
        )
        holonomic = [c.name for c in self.reduction.mechanism.constraints if c.holonomic]
        broken = [(f"constraint {name}", words) for name in holonomic]
        broken += [(f"the norm of quaternion {r.name}, less 1,", words) for r in scene.rotations]
        broken += [("a redundant constraint", words)] * len(moving.redundant)
        nodes = [*moving.configuration, *moving.redundant]
        for i, (u, value) in enumerate(zip(moving.mechanism.u, moving.speeds, strict=True)):
            if i not in moving.free and name_of(u) in self.place.values:
                broken.append((f"the speed {name_of(u)} less its given value", "leave it out"))
                nodes.append(value - u)
        why = "in a steady motion only ignorable coordinates may change"
        for i in self.kept:
            broken.append((f"the rate {scene.qd[i]}", why if self.point.moves else words))
            nodes.append(moving.rates[i])
        self._regular(moving.configuration, broken[: len(moving.configuration)])
        for k, (subject, cure) in self._left(nodes, broken):
            raise InputError(
                f"{scene.name}: {subject} is {k} at the operating point, not zero: {cure}"
            )
        # Only where the loops close at a regular place are there as many rows as speeds.
        self._steady()
        self._smooth()
        kind = "steady motion" if self.point.moves else "equilibrium"
        turning = angular(scene)
        where = self.point.words({q: q in turning for q in scene.q})
        for left, (subject, unit) in self._left([-row for row in moving.rows], self._forces()):
            raise InputError(
                f"{scene.name}: {where} is no {kind}: {subject} {left}{unit}, not zero"
                f" ({self.equations.route})"
            )

    def _regular(self, holding: Sequence[Node], words: Sequence[tuple[str, str]]) -> None:
        """Refuse a place where fewer constraints are independent than around it."""
        here, nearby = self.reduction.ranks
        if here < nearby and not list(self._left(holding, words)):
            raise InputError(
                f"{self.scene.name}: at the operating point {here} of {nearby} constraints are"
                " independent: a singular configuration, which has no linear equations"
            )

    def _forces(self) -> list[tuple[str, str]]:
        """What each row leaves, and its unit."""
        scene, moving = self.scene, self.reduction
        turning = angular(scene)
        when = "" if self.point.moves else " at rest"
        if moving.conjugate and not scene.speeds:
            along = [scene.q[i] for i in moving.free]
            kinds = [("torque", " N m") if q in turning else ("force", " N") for q in along]
            return [
                (f"the {kind} on {q}{when} is", unit)
                for q, (kind, unit) in zip(along, kinds, strict=True)
            ]
        count = range(1, len(moving.rows) + 1)
        return [(f"row {k} of the equations{when} leaves", "") for k in count]

    def _left(
        self, nodes: Sequence[Node], words: Sequence[tuple[str, str]]
    ) -> Iterator[tuple[Expr, tuple[str, str]]]:
        """What is not zero there, with its words; nothing where the kernel shows that all is."""
        there = self.place(nodes)
        if not there or self._zero(there).shown:
            return
        for node, own in zip(there, words, strict=True):
            finding = self._zero([node])
            if not finding.shown:
                (value,) = self._written([node])
                if finding.verdict is not Verdict.REFUTED:
                    raise ExpressionError(f"it is undecided whether {str(value)[:80]} is zero")
                yield value, own

    def _zero(self, nodes: Sequence[Node]) -> Finding:
        signs = ranges(self.reduction.mechanism)
        signs |= {name: range_of(symbol) for name, symbol in self.names.items()}
        program = self.place.builder.program({"left": nodes, "right": [0] * len(nodes)})
        known = {name: sign for name, sign in signs.items() if name in program.inputs}
        return decide(Statement("operating point", program, known))

    def _written(self, nodes: Sequence[Node]) -> tuple[Expr, ...]:
        program = self.place.builder.program({"nodes": nodes})
        return tuple(map(written, expressions(program, self.names, limit=sys.maxsize)["nodes"]))

    def _steady(self) -> None:
        """Nothing depends on time, nor on an input that drifts."""
        scene, moving = self.scene, self.reduction
        builder, signs = moving.mechanism.builder, ranges(moving.mechanism)
        plain = Place(builder, {s.name: value for s, value in self.point.parameters.items()})
        laws = plain([*moving.rows, *moving.configuration, *(moving.rates[i] for i in self.kept)])
        solved = accelerations(plain, moving)
        time = plain.builder.input(TIME.name)
        if scene.explicit_time and depends(plain, laws, time, signs, solved):
            raise InputError(
                f"{scene.name}: the forces depend on time itself, so that nothing is an equilibrium"
                " or a steady motion: declare what changes as an input"
            )
        for w in scene.input_symbols:
            rate = self.place.values[w.name + DOTS[1]]
            if rate != 0 and depends(plain, laws, plain.builder.input(w.name), signs, solved):
                raise InputError(
                    f"{scene.name}: input {w} changes by {rate} per second, and the equations"
                    " depend on it: this is no steady motion"
                )

    def _smooth(self) -> None:
        """Refuse a point at which a load jumps, as friction does at rest."""
        builder, rows = self.reduction.mechanism.builder, self.reduction.rows
        kinks = [
            Node(builder, number) for number in reachable(builder, [row.number for row in rows])
            if builder.operations[number] in (ABS, SIGN, FLOOR)
        ]  # fmt: skip
        inside = [Node(builder, builder.operands[0][kink.number]) for kink in kinks]
        for kink, node in zip(kinks, self.place(inside), strict=True):
            if node.is_zero or self._zero([node]).verdict is not Verdict.REFUTED:
                program = builder.program({"nodes": [kink]})
                (text,) = expressions(program, self.names, limit=sys.maxsize)["nodes"]
                raise InputError(
                    f"{self.scene.name}: {text} has no slope at the operating point: nothing"
                    " is linear there; linearize a scene without the friction that it comes from"
                )

    # ------------------------------------------------------------------ to first order

    def linear(self) -> Linear:
        """Equation (5)."""
        scene, moving, place = self.scene, self.reduction, self.place
        build, mechanism = place.builder, moving.mechanism
        coordinates = [mechanism.q[i] for i in self.kept]
        holding = coefficients(moving.configuration, coordinates) if moving.configuration else ()
        rates = place.matrix(coefficients(moving.rates, moving.v))
        chosen, drifting, reach = self._independent(place.matrix(holding), rates)
        own = [*chosen, *drifting]
        turn = inverse(build, [rates[i] for i in own])
        # X x, and nothing for what drifts.
        bends = place.matrix(coefficients([moving.rates[i] for i in own], coordinates))
        carried = product(turn, padded(build, product(bends, reach), len(own)))
        by_rates = place.matrix(coefficients(moving.rows, moving.vd))
        if len(pivots(build, by_rates)) < len(own):
            values = {q.name: value for q, value in self.point.coordinates.items()}
            why = singular_angles(scene, values) or "use coordinates that are regular there"
            raise SingularError(
                f"{scene.name}: the mass matrix is singular at the operating point: {why}"
            )
        by_speeds = place.matrix(coefficients(moving.rows, moving.v))
        by_place = place.matrix(coefficients(moving.rows, coordinates))
        mass = product(by_rates, turn)
        damping = difference(product(by_speeds, turn), product(by_rates, carried))
        stiffness = difference(
            padded(build, product(by_place, reach), len(own)), product(by_speeds, carried)
        )
        given = [
            [mechanism.builder.input(w.name + dots) for w in scene.input_symbols] for dots in DOTS
        ]
        self._forced(moving, given)
        drives = [
            [[-entry for entry in row] for row in place.matrix(coefficients(moving.rows, order))]
            for order in given
        ]
        while len(drives) > 1 and all(entry.is_zero for row in drives[-1] for entry in row):
            drives.pop()
        matrices = {"mass": mass, "damping": damping, "stiffness": stiffness}
        matrices |= {f"inputs {k}": drive for k, drive in enumerate(drives)}
        if moving.conjugate:
            across = [list(column) for column in zip(*turn, strict=True)]
            matrices = {name: product(across, matrix) for name, matrix in matrices.items()}
        whole = [[build.zero] * len(own) for _ in scene.q]
        for row, i in enumerate(self.kept):
            whole[i][: len(chosen)] = reach[row]
        for column, i in enumerate(drifting, len(chosen)):
            whole[i][column] = build.one
        matrices["reach"] = whole
        observed = entries(moving)
        why_not = self._not_linear(observed)
        if observed and not why_not:
            driven = [w.name for w in scene.input_symbols]
            matrices |= output_rows(
                moving, place, observed, self.kept, reach, turn, carried, driven
            )  # fmt: skip
        speeds = place(moving.speeds)
        return Linear(
            scene=scene,
            route=self.equations.route,
            point=self.point.point,
            speeds=dict(zip(scene.u, self._written(speeds), strict=True)),
            coordinates=tuple(scene.q[i] for i in own),
            cyclic=tuple(scene.q[i] for i in drifting),
            ignorable=() if self.point.moves else self._ignorable(stiffness, own),
            inputs=scene.input_symbols,
            program=build.program({n: [e for row in m for e in row] for n, m in matrices.items()}),
            names=self.names,
            conjugate=moving.conjugate,
            no_outputs=why_not,
        )

    def _ignorable(self, stiffness: Rows, own: Sequence[int]) -> tuple[Symbol, ...]:
        """Coordinates at rest without effect, whose columns of K are zero."""
        free = [i for k, i in enumerate(own) if all(row[k].is_zero for row in stiffness)]
        acting = effective(self.reduction, self.point.parameters) if free else frozenset()
        return tuple(self.scene.q[i] for i in free if i not in acting)

    def _not_linear(self, observed: Sequence[Node]) -> str:
        """Why the outputs of the scene are no functions of the state and the inputs."""
        scene, moving = self.scene, self.reduction
        plain = Place(
            moving.mechanism.builder, {s.name: value for s, value in self.point.parameters.items()}
        )
        drifts = [q.name for i, q in enumerate(scene.q) if i not in self.kept] + [TIME.name]
        speeds = {s.name for s, value in self.point.speeds.items() if value != 0}
        drifts += [w.name for w in scene.input_symbols if w.name + DOTS[1] in speeds]
        moves = dict.fromkeys(drifts, "which drifts along the motion")
        rates = [w.name + dots for w in scene.input_symbols for dots in DOTS[1:]]
        moves |= dict.fromkeys(rates, "the rate of an input: declare that as the input")
        return not_linear(moving, plain, observed, entry_names(scene), moves)

    def _independent(self, holding: Rows, rates: Rows) -> tuple[list[int], list[int], Rows]:
        """z_1 and z_2, by the places of the coordinates, and G: equations (3) and (4)."""
        place, count = self.place, len(self.scene.q)
        drifts = [i for i in range(count) if i not in self.kept]
        order = [*reversed(self.kept), *reversed(drifts)]
        picked = [order[row] for row, _ in pivots(place.builder, [rates[i] for i in order])]
        chosen = sorted(i for i in picked if i in self.kept)
        drifting = sorted(set(picked) - set(chosen))
        if len(chosen) == len(self.kept) - len(pivots(place.builder, holding)):
            return chosen, drifting, self._dependent(holding, chosen)
        if self.point.moves:
            names = ", ".join(self.scene.q[i].name for i in self.kept)
            raise InputError(
                f"{self.scene.name}: {names} have an effect, and their rates are not independent to"
                " first order: the linear equations are not of second order"
            )
        # At rest, conditions of no slip hold back the deviations, too.
        turn = inverse(place.builder, [rates[i] for i in chosen])
        return chosen, drifting, product([rates[i] for i in self.kept], turn)

    def _dependent(self, holding: Rows, chosen: Sequence[int]) -> Rows:
        """G of J G = 0, the identity for the chosen coordinates."""
        build = self.place.builder
        columns = [column for column, i in enumerate(self.kept) if i in chosen]
        others = [column for column, i in enumerate(self.kept) if i not in chosen]
        reach = [[build.zero] * len(columns) for _ in self.kept]
        for place, column in enumerate(columns):
            reach[column][place] = build.one
        square = [[row[column] for column in others] for row in holding]
        order = pivots(build, square)
        rows = [holding[row] for row, _ in order]
        held = [[row[others[column]] for _, column in order] for row in rows]
        diagonal = [(k, k) for k in range(len(order))]
        for place, column in enumerate(columns):
            side = [-row[column] for row in rows]
            solved = solve_with_pivots(held, side, diagonal) if order else []
            for (_, other), value in zip(order, solved, strict=True):
                reach[others[other]][place] = value
        return reach

    def _forced(self, moving: Reduction, given: Sequence[Sequence[Node]]) -> None:
        """Refuse inputs that change the constraints or the rates: E(w) has no place for that."""
        inputs = [node for order in given for node in order]
        laws = [*moving.configuration, *(moving.rates[i] for i in self.kept)]
        slopes = coefficients(laws, inputs) if laws and inputs else ()
        for row in self.place.matrix(slopes):
            for node, entry in zip(inputs, row, strict=True):
                if not entry.is_zero:
                    raise InputError(
                        f"{self.scene.name}: input {name_of(node)} moves a constraint or a rate of"
                        " the coordinates: linearize a scene in coordinates that it does not hold"
                    )
