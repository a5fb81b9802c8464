"""Points on constraints: inputs that depend are replaced by what the constraints give.

    a p + d = 0                     p = -d / a                                               (1)
    a p^2 + b p + d = 0             p = (-b + sigma sqrt(b^2 - 4 a d)) / (2 a)               (2)
    a cos t + b sin t + d = 0       cos t = (-a d - sigma b w) / r^2,
                                    sin t = (-b d + sigma a w) / r^2,
                                    r^2 = a^2 + b^2,  w = sqrt(r^2 - d^2)                    (3)
    a_i cos t + b_i sin t + d_i = 0, i = 1, 2
                                    cos t, sin t by Cramer's rule; cos^2 t + sin^2 t = 1     (4)
    two circles: f - lambda g, without its squares, is linear                                (5)
    w = a sin t' - b cos t',  where another angle t' solves (3), too                         (6)

One input at a time, the first way that applies; what is put in is a program like any other, so that
field, normal form and balls know nothing of constraints. (4) takes one angle out of a loop of two
and leaves an equation (3) for the other.

A point certifies its own component, and components meet where a divisor or a radicand vanishes. If
a state on the constraints is known, nothing is divided by what is zero there, and sigma is the sign
that leads to it: a parallelogram and its folded twin are two components, told apart by sigma where
w is a polynomial, of which the radicand is the square, or (6): bars of a rhombus meet where they
met before, or across it. Elsewhere both signs of w may be on one component: a statement of
meromorphic functions continues from one to the other, |y| = y does not.
For those, and without such a state, sigma is the sign of an input of its own: what holds on one
branch only is not shown.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from graphlib import CycleError, TopologicalSorter
from math import comb, cos, isclose, sin

from mechanics.errors import ZeroDivisorError
from mechanics.kernel.angles import Form, Forms, Monomial, accumulate, base_angles, node_of
from mechanics.kernel.balls import enclose
from mechanics.kernel.squares import square_root
from mechanics.kernel.statement import LEFT, POSITIVE, RATES, RIGHT, ZERO, Range, Statement
from mechanics.kernel.trial import FailedError, zeros
from mechanics.program import Builder, Node
from mechanics.program import operations as op
from mechanics.program.interpret import include
from mechanics.program.program import reachable

BITS = 256
NEGLIGIBLE = 2.0**-64
"""What is smaller at a state that is on the constraints to `BITS` digits is taken for zero."""

MEROMORPHIC = {
    *(op.CONSTANT, op.PI, op.INPUT, op.ADD, op.SUBTRACT, op.MULTIPLY, op.DIVIDE, op.NEGATE),
    *(op.EXP, op.SIN, op.COS, op.TAN, op.SINH, op.COSH, op.TANH, op.ERF, op.SOLVE, op.ENTRY),
}
"""Operations of one value everywhere in the complex plane, but for poles."""

COARSE = 1000
"""Largest denominator of the numbers near the start that witnesses are looked for at."""


Solution = Callable[[Node], Node]


@dataclass(frozen=True)
class Replacement:
    """What takes the place of an input: the constraints it comes from, and what is left of them."""

    name: str
    value: Node
    used: tuple[Node, ...]
    left: tuple[Node, ...] = ()


def on_constraints(statement: Statement) -> Statement | None:
    """The statement at points where its constraints hold, or None where no such point is known.

    Parameters
    ----------
    statement : Statement
        Its outputs ``"zero"`` and then ``"rates"`` list the constraints; its `dependent` inputs are
        tried in order.

    Returns
    -------
    Statement
        Without constraints; replaced inputs are outputs of their names, new ones are auxiliary.
    """
    builder = Builder()
    outputs = include(builder, base_angles(statement.program))
    stages = [list(outputs.pop(stage, ())) for stage in (ZERO, RATES)]
    solver = _Solver(builder, statement, Forms(builder))
    solver.start = statement.typical if solver.closed(stages[0]) else {}
    solver.continues = solver.meromorphic([*outputs[LEFT], *outputs[RIGHT]], stages[0])
    if not all(map(solver.solve, stages)):
        return None
    solved = solver.values
    conditions = [-value if statement.range_of(name) is Range.NEGATIVE else value
                  for name, value in solved.items()
                  if statement.range_of(name) is not Range.FREE]  # fmt: skip
    conditions = [*outputs.pop(POSITIVE, ()), *conditions]
    target = Builder()
    names = solver.resolved(target)
    program = builder.program({**outputs, POSITIVE: conditions} if conditions else outputs)
    held = {name: [names[name]] for name in solved}
    program = target.program({**include(target, program, names), **held})
    # What a person reads of a witness: the state on the constraints has all its digits.
    near = {name: statement.typical[name].limit_denominator(COARSE)
            for name in program.inputs if name in statement.typical}  # fmt: skip
    rest = tuple(name for name in statement.dependent if name not in solved)
    own = statement.auxiliary | (set(program.inputs) - set(statement.program.inputs))
    return replace(statement, program=program, typical=near, dependent=rest, auxiliary=own)


@dataclass
class _Solver:
    """Constraints solved one by one, loop by loop.

    Constraints are taken as they stand, with inputs that were replaced as if they were given, so
    that a loop stays as short as it is; only a value that holds an input which is asked for is put
    in, one constraint at a time. `below` has the inputs of each value, through others.
    """

    builder: Builder
    statement: Statement
    forms: Forms
    start: Mapping[str, Fraction] = field(default_factory=dict)
    continues: bool = False
    values: dict[str, Node] = field(default_factory=dict)
    below: dict[str, frozenset[str]] = field(default_factory=dict)
    _held: dict[int, frozenset[str]] = field(default_factory=dict)
    _failed: set[tuple[object, ...]] = field(default_factory=set)
    _alike: list[tuple[str, Node, Node]] = field(default_factory=list)

    def closed(self, constraints: Sequence[Node]) -> bool:
        """Whether the typical values are a state on the constraints."""
        self.start = self.statement.typical
        values = map(self.at_start, constraints)
        return all(value is not None and abs(value) < NEGLIGIBLE for value in values)

    def meromorphic(self, nodes: Sequence[Node], constraints: Sequence[Node]) -> bool:
        """Whether all functions of what moves continue in one way along a component."""
        moving = {name for node in constraints for name in self.held(node.number)
                  if self.statement.range_of(name) is Range.FREE}  # fmt: skip
        operations = self.builder.operations
        return all(operations[n] in MEROMORPHIC or moving.isdisjoint(self.held(n))
                   for n in reachable(self.builder, [node.number for node in nodes]))  # fmt: skip

    def solve(self, constraints: Sequence[Node]) -> bool:
        """Take an input out for each constraint; False where no way applies."""
        left = list(constraints)
        while left:
            if (found := self._step(left)) is not None:
                self._take(found)
                left = [*(node for node in left if node not in found.used), *found.left]
                continue
            before, longer = left, next((n for n in left if self._put_in(n) != n), None)
            left = [self._put_in(node) if node == longer else node for node in left
                    if longer is not None or not self._holds(node, False)]  # fmt: skip
            if left == before:
                return False
        self._tell_apart()
        return True

    def _tell_apart(self) -> None:
        """Equation (6) in the place of roots, where it holds: all constraints are solved by now."""
        for name, remainder, value in self._alike:
            before, self.values[name] = self.values[name], value
            try:
                holds = self._holds(remainder, False)
            except CycleError:  # the other angle is computed from this one
                holds = False
            self.values[name] = value if holds else before

    def _take(self, found: Replacement) -> None:
        held = frozenset[str]().union(*(self.held(node.number) for node in found.used))
        own = (held | self._below(held)) - {found.name, *self.values}
        self.values[found.name], self.below[found.name] = found.value, own
        for name, names in self.below.items():
            if found.name in names:
                self.below[name] = names - {found.name} | own

    def _below(self, names: frozenset[str]) -> frozenset[str]:
        """The inputs that the values of some names are computed from."""
        return frozenset[str]().union(*(self.below[name] for name in names & self.below.keys()))

    def _step(self, left: Sequence[Node]) -> Replacement | None:
        """The first way to take an input out, inputs of few constraints of one loop first."""
        holding: dict[str, list[Node]] = {name: [] for name in self.statement.dependent}
        twice = set(self.values)
        for node in left:
            held = self.held(node.number)
            for name in held & holding.keys():
                holding[name].append(node)
            # What a value in it holds, too, is asked for when that value is put in.
            twice |= held & self._below(held)
        names = [name for name, nodes in holding.items() if nodes and name not in twice]
        sets = {name: [self.held(node.number) for node in holding[name]] for name in names}
        names.sort(key=lambda name: (len(sets[name]), len(
            frozenset.union(*sets[name]) - frozenset.intersection(*sets[name]))))  # fmt: skip
        for way in (_linear, _of_one_angle, _two_circles, _of_two_angles, _quadratic):
            for name in names:
                key = way, name, *(node.number for node in holding[name])
                found = None if key in self._failed else way(self, name, holding[name])
                if found is not None:
                    return found
                self._failed.add(key)
        return None

    def _put_in(self, node: Node) -> Node:
        """A constraint with the values that hold inputs which are still asked for."""
        held = sorted(self.held(node.number) & self.values.keys())
        names = {name: self.values[name] for name in held
                 if not self.below[name].isdisjoint(self.statement.dependent)}  # fmt: skip
        if not names:
            return node
        (put,) = include(self.builder, self.builder.program({"x": [node]}), names)["x"]
        (result,) = include(self.builder, base_angles(self.builder.program({"x": [put]})))["x"]
        return result

    def resolved(self, target: Builder) -> dict[str, Node]:
        """The values in the inputs that are left."""
        graph = {name: sorted(self.held(value.number) & self.values.keys())
                 for name, value in self.values.items()}  # fmt: skip
        nodes: dict[str, Node] = {}
        for name in TopologicalSorter(graph).static_order():
            program = self.builder.program({"x": [self.values[name]]})
            (nodes[name],) = include(target, program, {n: nodes[n] for n in graph[name]})["x"]
        return nodes

    def _holds(self, node: Node, unknown: bool) -> bool:
        """Whether a node is zero wherever it is known by now; `unknown` where no point is found."""
        target, program = Builder(), self.builder.program({"x": [node]})
        names = self.resolved(target)
        outputs = include(target, program, {n: names[n] for n in program.inputs if n in names})
        try:
            return zeros(target, outputs["x"], self.statement.signs)[0]
        except FailedError:
            return unknown

    def held(self, number: int) -> frozenset[str]:
        """Names of the inputs that a node is computed from."""
        if number not in self._held:
            program = self.builder.program({"x": [Node(self.builder, number)]})
            self._held[number] = frozenset(program.inputs)
        return self._held[number]

    def split(
        self, node: Node, atoms: Sequence[Node], name: str, *keys: Monomial
    ) -> list[Node] | None:
        """Coefficients of these powers of the atoms and the rest, none of which holds the input.

        None where there are others, or none of these.
        """
        powers = self.powers(self.forms.of(node.number), atoms)
        if not powers.keys() <= {*keys, ()} or powers.keys().isdisjoint(keys):
            return None
        for form in powers.values():
            if any(name in self.held(number) for monomial in form for number, _ in monomial):
                return None
        return [node_of(self.builder, powers.get(key, {})) for key in (*keys, ())]

    def line(self, node: Node, name: str) -> list[Node] | None:
        """The same for a node that is too large to be expanded: a p + d, by its derivative."""
        builder = self.builder
        slopes = {builder.input(name).number: builder.one}
        for number in reachable(builder, [node.number]):
            below = builder.operands_of(number)
            partials = op.OPERATIONS[builder.operations[number]].partials
            if all(slopes[k].is_zero for k in below):
                slopes.setdefault(number, builder.zero)
            elif partials is None:
                return None
            else:
                nodes = [Node(builder, k) for k in (*below, number)]
                parts = (slopes[k] * part for k, part in zip(below, partials(*nodes), strict=True))
                slopes[number] = sum(parts, builder.zero)
        slope = slopes[node.number]
        if name in self.held(slope.number):
            return None
        try:
            (rest,) = include(builder, builder.program({"x": [node]}), {name: builder.zero})["x"]
        except ZeroDivisorError:
            return None
        return [slope, rest]

    def powers(self, form: Form, atoms: Sequence[Node]) -> dict[Monomial, Form]:
        """A form sorted by powers of atoms; of cosine and sine, the sine at most once."""
        places = {atom.number: k for k, atom in enumerate(atoms)}
        found: dict[Monomial, Form] = {}
        for monomial, factor in form.items():
            powers = {places[n]: power for n, power in monomial if n in places}
            rest = tuple(pair for pair in monomial if pair[0] not in places)
            first, second = powers.get(0, 0), powers.get(1, 0)
            # sin^2 = 1 - cos^2
            squares = max(second, 0) // 2
            for j in range(squares + 1):
                key = tuple((k, p) for k, p in ((0, first + 2 * j), (1, second - 2 * squares)) if p)
                accumulate(found.setdefault(key, {}), rest, factor * comb(squares, j) * (-1) ** j)
        return {key: part for key, part in found.items() if part}

    def at_start(self, node: Node) -> float | None:
        """The value at the state on the constraints, or None where that does not give it."""
        program = self.builder.program({"x": [node]})
        if not self.start.keys() >= set(program.inputs):
            return None
        (value,) = enclose(program, self.start, BITS)["x"]
        return float(value.mid()) if value.is_finite() else None

    def vanishes(self, node: Node) -> bool:
        """Whether a node is zero everywhere, or at the start, so that nothing is divided by it."""
        if node.constant is not None:
            return node.is_zero
        value = self.at_start(node)
        return self._holds(node, True) if value is None else abs(value) < NEGLIGIBLE

    def roots(self, radicand: Node, solution: Solution, name: str, *slopes: Node) -> Node | None:
        """The solution for the root that leads to the start, or for either by a sign that is free.

        None where both roots meet at the start: there the branch cannot be told.
        """
        value = self.at_start(radicand)
        polynomial = square_root(self.builder, self.forms.of(radicand.number))
        root = radicand.sqrt() if polynomial is None else polynomial
        if value is not None and abs(value) < NEGLIGIBLE:
            return None
        if polynomial is None and slopes and value is not None:
            self._compare(name, radicand, solution, *slopes)
        nearest = self.nearest(name, solution, root)
        if nearest is not None and (polynomial is not None or self.continues):
            return nearest
        # No input of the statement has so long a name.
        free = self.builder.input(" ".join(("branch of", name, *self.statement.program.inputs)))
        return solution(root * ((free * free).sqrt() / free))

    def _compare(self, name: str, radicand: Node, solution: Solution, a: Node, b: Node) -> None:
        """Keep the angles that solve (3) at the start, too."""
        square, x, y = (self.at_start(node) or 0.0 for node in (radicand, a, b))
        for other, angle in self.start.items():
            if other != name and isclose((x * sin(angle) - y * cos(angle)) ** 2, square):
                t = self.builder.input(other)
                w = a * t.sin() - b * t.cos()
                if (value := self.nearest(name, solution, w)) is not None:
                    self._alike.append((name, w * w - radicand, value))

    def nearest(self, name: str, solution: Solution, root: Node) -> Node | None:
        """The solution for the root, or for its opposite, whichever is nearer to the start."""
        solutions = [solution(root), solution(-root)]
        one, two = (self.from_start(node, name) for node in solutions)
        return None if one is None or two is None else solutions[two < one]

    def from_start(self, node: Node, name: str) -> float | None:
        """How far a value for an input is from the start; angles by the chord between them."""
        if name not in self.start:
            return None
        apart = node - self.start[name]
        if self.builder.operations[node.number] == op.ATAN2:
            apart = (apart / 2).sin()
        found = self.at_start(apart)
        return None if found is None else abs(found)


_FIRST: Monomial = ((0, 1),)
_SECOND: Monomial = ((1, 1),)
_SQUARE: Monomial = ((0, 2),)


def _linear(solver: _Solver, name: str, holding: Sequence[Node]) -> Replacement | None:
    """Equation (1); a length that stands before all would be 0, which it is not."""
    atom, signed = solver.builder.input(name), solver.statement.range_of(name) is not Range.FREE
    for node in holding:
        line = solver.split(node, [atom], name, _FIRST) or solver.line(node, name)
        if line and not (solver.vanishes(line[0]) or (signed and solver.vanishes(line[1]))):
            return Replacement(name, -line[1] / line[0], (node,))
    return None


def _quadratic(solver: _Solver, name: str, holding: Sequence[Node]) -> Replacement | None:
    """Equation (2)."""
    for node in holding:
        parts = solver.split(node, [solver.builder.input(name)], name, _SQUARE, _FIRST)
        if parts is None:
            continue
        a, b, d = parts
        if not solver.vanishes(a):
            radicand = b * b - 4 * a * d
            if solver.statement.range_of(name) is Range.POSITIVE and b.is_zero:
                root, constant = radicand.sqrt(), a.constant
                if constant is not None and constant < 0:
                    root = -root  # of two opposite solutions, the positive one
                value: Node | None = root / (2 * a)
            else:
                value = solver.roots(radicand, partial(_of_quadratic, a, b), name)
            if value is not None:
                return Replacement(name, value, (node,))
    return None


def _of_quadratic(a: Node, b: Node, root: Node) -> Node:
    return (root - b) / (2 * a)


def _angle_parts(solver: _Solver, name: str, node: Node) -> list[Node] | None:
    """(a, b, d) of a cos t + b sin t + d."""
    angle = solver.builder.input(name)
    return solver.split(node, [angle.cos(), angle.sin()], name, _FIRST, _SECOND)


def _of_one_angle(solver: _Solver, name: str, holding: Sequence[Node]) -> Replacement | None:
    """Equation (3), of an angle that one constraint alone holds."""
    parts = _angle_parts(solver, name, holding[0]) if len(holding) == 1 else None
    if parts is None:
        return None
    a, b, d = parts
    square = a * a + b * b
    if solver.vanishes(square):
        return None

    def solution(root: Node) -> Node:
        c, s = (-(a * d) - b * root) / square, (a * root - b * d) / square
        return solver.builder.call("atan2", s, c)

    value = solver.roots(square - d * d, solution, name, a, b)
    return None if value is None else Replacement(name, value, (holding[0],))


def _of_two_angles(solver: _Solver, name: str, holding: Sequence[Node]) -> Replacement | None:
    """Equation (4), of an angle that two constraints hold."""
    if len(holding) != 2:
        return None
    one, two = (_angle_parts(solver, name, node) for node in holding)
    if one is None or two is None:
        return None
    (a, b, d), (e, f, g) = one, two
    determinant = a * f - b * e
    if solver.vanishes(determinant):
        return None
    c, s = b * g - d * f, d * e - a * g
    circle = c * c + s * s - determinant * determinant
    value = solver.builder.call("atan2", s / determinant, c / determinant)
    return Replacement(name, value, tuple(holding), (circle,))


def _two_circles(solver: _Solver, name: str, holding: Sequence[Node]) -> Replacement | None:
    """Equation (5): the radical axis of two circles takes the place of one of them."""
    point = solver.builder.input(name)
    squares = []
    for node in holding:
        parts = solver.split(node, [point], name, _SQUARE, _FIRST)
        if parts is not None and not parts[0].is_zero:
            squares.append((node, parts[0]))
    for place, (one, a) in enumerate(squares):
        for two, b in squares[:place]:
            axis = one * b - two * a
            found = _linear(solver, name, [axis])
            if found is not None:
                return Replacement(name, found.value, (one, two), (two,))
    return None
